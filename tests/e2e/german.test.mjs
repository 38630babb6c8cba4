// The page in German and in inches, in a real browser over the real server: the browser's language, the switch without a
// reload, the main states on a desk and on a phone. Screenshots are kept in out/e2e. The tests build on each other.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { describe } from 'node:test';
import { shoot, waitFor } from './browser.mjs';
import { root } from './service.mjs';
import { openNewest, setStage } from './stage.mjs';

const kDesk = { viewport: { width: 1280, height: 720 }, locale: 'de-DE' };
const kPhone = { viewport: { width: 390, height: 844 }, locale: 'de-DE' };
let page;

const button = (name) => page.getByRole('button', { name, exact: true });
const tab = (name) => page.getByRole('tab', { name, exact: true });

/** What sticks out: of the window at its side, and of a button its own words. */
const overflowing = (watched) =>
  watched.evaluate(() => {
    const out = document.documentElement.scrollWidth > innerWidth ? ['the page'] : [];
    const seen = (element) => element.checkVisibility() && element.getBoundingClientRect().width > 1;
    for (const element of document.querySelectorAll('button, [role=tab], h1, h2, h3')) {
      const cut = element.scrollWidth > element.clientWidth + 1 && getComputedStyle(element).textOverflow !== 'ellipsis';
      if (seen(element) && cut && getComputedStyle(element).display !== 'inline') out.push(element.textContent);
    }
    return out;
  });

/** English words that stay behind where the page speaks German: the service's own words and names are marked or data. */
const english = (watched) =>
  watched.evaluate(() => {
    const texts = [];
    const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
    while (walker.nextNode()) if (!walker.currentNode.parentElement.closest('[lang=en], script, noscript')) texts.push(walker.currentNode.data);
    for (const element of document.querySelectorAll('[aria-label], [title], [placeholder]'))
      for (const name of ['aria-label', 'title', 'placeholder']) texts.push(element.getAttribute(name) ?? '');
    return texts.filter((text) => text !== 'Kim and Park 2003' && !/^\S+\.\w+$/.test(text) && /\b(the|and|with|from|this|drape|piece|seam|edge)\b/i.test(text));
  });

async function looks(name) {
  assert.deepEqual(await overflowing(page), []);
  assert.deepEqual(await english(page), []);
  await shoot(page, name);
}

async function openAt(options) {
  page = await openNewest(stage, options);
}

const stage = setStage();
const { service, it } = stage;

describe('the page in German', () => {
  it('speaks the browser’s language', async () => {
    await openAt(kDesk);
    assert.equal(await page.evaluate(() => document.documentElement.lang), 'de');
    await button('Neu drapieren').waitFor();
    await tab('Ergebnis').click();
    await page.getByText('Passform').first().waitFor();
    await looks('de-1-result');
  });

  it('says all that stands beside the cloth', async () => {
    for (const [name, file] of [['Schnitt', 'de-2-pattern'], ['Körper', 'de-3-body'], ['Anordnen', 'de-4-arrange'], ['Verlauf', 'de-5-drape']]) {
      await tab(name).click();
      if (name === 'Körper') await page.getByRole('list', { name: 'Maße' }).or(page.getByText('stehende Person')).waitFor();
      if (name === 'Anordnen') await page.locator('.verdict').waitFor();
      await looks(file);
    }
  });

  it('holds the unit that was chosen for what is shown and typed, also after a reload', async () => {
    await tab('Schnitt').click();
    await page.locator('.piece-cloth').first().click();
    await button('Sprache und Einheiten').click();
    await looks('de-6-settings');
    await page.getByRole('radio', { name: 'Alles in Zoll' }).click();
    await page.getByRole('button', { name: 'Schließen' }).click();
    await page.getByText(/\d,\d{3} × \d+,\d{3} in/).waitFor();
    await page.reload();
    await waitFor(page, () => window.__toile.project() !== null);
    await tab('Schnitt').click();
    await page.locator('.piece-cloth').first().click();
    const width = await page.locator('.selection-facts').first().textContent();
    assert.match(width, /^\d+,\d{3} × \d+,\d{3} in · \d+ Kanten/);
    await looks('de-7-inches');
  });

  it('takes a decimal comma', async () => {
    await page.locator('.edge-chips button').first().click();
    const field = page.getByRole('textbox', { name: /^Länge/ }).first();
    const before = Number((await field.inputValue()).replace(',', '.'));
    const wanted = (before + 0.5).toFixed(4).replace('.', ',');
    await field.fill(wanted);
    await field.press('Enter');
    await waitFor(page, () => window.__toile.project().revision > 1);
    await page.waitForFunction((text) => [...document.querySelectorAll('.number-field input')].some((one) => one.value === text), wanted);
    await looks('de-8-comma');
    await page.getByRole('button', { name: /^Rückgängig: Länge festlegen/ }).click();
  });

  it('calls the fabrics of the library by German names, and finds them by those', async () => {
    await page.locator('.plane').press('Escape');
    await button('Ändern').click();
    await page.getByRole('searchbox', { name: 'Stoff suchen' }).fill('seide kleider');
    await page.locator('.fabric-library').getByText('Seidencharmeuse, 19 Momme').waitFor();
    assert.ok((await page.locator('.fabric-library li b').allTextContents()).every((title) => title.startsWith('Seide')));
    await looks('de-8b-fabrics');
    await page.getByRole('button', { name: 'Behalten', exact: true }).click();
  });

  it('goes through the start page, the keys, an import and what went wrong', async () => {
    await page.getByRole('link', { name: 'Toile, Startseite' }).click();
    await page.getByRole('heading', { name: 'Sehen Sie Ihren Schnitt am Körper' }).waitFor();
    await looks('de-9-start');
    await page.keyboard.press('?');
    await page.getByRole('heading', { name: 'Tasten und Maus' }).waitFor();
    await looks('de-10-keys');
    await page.keyboard.press('Escape');
    await page.keyboard.press('o');
    await page.locator('dialog input[type=file]').setInputFiles(join(root, 'samples/tshirt/tshirt.dxf'));
    await page.getByRole('tab', { name: /^Nähte \d+ von \d+$/ }).click();
    await looks('de-11-import');
    await page.getByRole('tab', { name: /^Bericht/ }).click();
    await looks('de-12-import-report');
    await page.keyboard.press('Escape');
    await page.keyboard.press('Escape');
    const bad = readFileSync(join(root, 'samples/skirt/skirt.dxf'), 'utf8').slice(0, 900);
    await page.keyboard.press('o');
    await page.locator('dialog input[type=file]').setInputFiles({ name: 'kaputt.dxf', mimeType: 'image/vnd.dxf', buffer: Buffer.from(bad) });
    await page.locator('dialog [role=alert] .told[lang=en]').waitFor();
    await looks('de-13-refused');
    await page.keyboard.press('Escape');
    await page.keyboard.press('Escape');
    await page.goto(`${service.url}/#/nirgends`);
    await page.getByRole('heading', { name: 'Hier ist nichts' }).waitFor();
    await looks('de-14-nowhere');
  });

  it('turns to English and back without a reload', async () => {
    await page.evaluate(() => (window.__stays = true));
    await button('Sprache und Einheiten').click();
    await page.getByRole('radio', { name: 'English' }).click();
    await page.getByRole('heading', { name: 'Language and units' }).waitFor();
    await page.getByRole('heading', { name: 'Nothing is here' }).waitFor();
    await page.getByRole('radio', { name: 'Deutsch' }).click();
    await page.getByRole('heading', { name: 'Hier ist nichts' }).waitFor();
    assert.equal(await page.evaluate(() => window.__stays), true);
    assert.deepEqual(page.complaints, []);
    await page.close();
  });

  it('fits on a phone', async () => {
    await openAt(kPhone);
    for (const [name, file] of [['Schnitt', 'de-15-phone-pattern'], ['Körper', 'de-16-phone-body'], ['Ergebnis', 'de-17-phone-result']]) {
      await tab(name).click();
      await looks(file);
    }
    await button('Sprache und Einheiten').click();
    await looks('de-18-phone-settings');
    assert.deepEqual(page.complaints, []);
  });
});
