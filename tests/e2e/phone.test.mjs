// A phone, from a drape to what one takes home: all that is pressed is large enough for a finger and in the window, nothing
// lies over the cloth, and two drapes stand side by side. Screenshots are kept in out/e2e. The tests build on each other.

import assert from 'node:assert/strict';
import { describe } from 'node:test';
import { ask, shoot, waitFor, waitForCalm, waitForState } from './browser.mjs';
import { openNewest, setStage } from './stage.mjs';

const kPhone = { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true };
/** What a finger meets, px. */
const kFinger = 44;

const stage = setStage({ begin: async (ready) => (page = await openNewest(ready, kPhone)) });
const { it } = stage;
let page;

/** What is pressed or typed in and is too small, or beside the window. A box with words beside it is pressed by them. */
const tooSmall = () =>
  page.evaluate((finger) => {
    const controls = 'button, select, summary, [role=tab], .topbar a, .downloads a, .scene-caption, label.check, .number-field input';
    const bad = [...document.querySelectorAll(controls)].filter((one) => {
      const { width, height, left, right } = one.getBoundingClientRect();
      if (width < 2 || !one.checkVisibility({ opacityProperty: true, visibilityProperty: true })) return false;
      return height < finger - 0.5 || width < finger - 0.5 || left < 0 || right > innerWidth;
    });
    return bad.map((one) => `${one.className} ${one.textContent.trim()}`);
  }, kFinger);

/** Whether it is what a finger at its middle meets. */
const isFree = (locator) =>
  locator.evaluate((one) => {
    const { x, y, width, height } = one.getBoundingClientRect();
    return one.contains(document.elementFromPoint(x + width / 2, y + height / 2));
  });

const tab = (name) => page.getByRole('tab', { name, exact: true });

async function looks(name) {
  assert.deepEqual(await tooSmall(), []);
  assert.equal(await page.evaluate(() => document.documentElement.scrollWidth > innerWidth), false);
  await shoot(page, name);
}

describe('a phone', () => {
  it('has all panels within reach of a finger, and leaves the cloth free', async () => {
    for (const name of ['Pattern', 'Body', 'Arrange', 'Drape', 'Result']) {
      await tab(name).tap();
      if (name !== 'Pattern') await waitForCalm(page);
      await looks(`phone-1-${name.toLowerCase()}`);
    }
    const [tools, canvas] = await Promise.all(['.scene-top > .scene-tools', '.scene canvas'].map((one) => page.locator(one).boundingBox()));
    assert.ok(tools.y + tools.height <= canvas.y + 1, 'the bar stands above the cloth');
    await page.getByRole('button', { name: 'back view' }).tap();
    await waitForCalm(page);
  });

  it('offers everything that is taken home', async () => {
    const links = page.locator('.downloads a');
    assert.ok((await links.count()) > 4);
    for (const link of await links.all()) {
      await link.scrollIntoViewIfNeeded();
      assert.ok(await isFree(link), await link.textContent());
    }
    const coming = page.waitForEvent('download');
    await page.locator('.downloads a[title="final.glb"]').tap();
    assert.match((await coming).suggestedFilename(), /\.glb$/);
  });

  it('edits, and says that the cloth is older without lying over it', async () => {
    await tab('Pattern').tap();
    await page.locator('.piece-cloth').first().tap({ force: true });
    await page.locator('.edge-chips button').first().tap();
    await looks('phone-2-edge');
    const field = page.getByRole('textbox', { name: /^Length/ }).first();
    await field.fill('820');
    await field.press('Enter');
    await waitFor(page, () => window.__toile.project().revision > 1);
    await tab('Result').tap();
    const strip = page.locator('.scene-message.docked');
    await strip.getByText('The project has changed since this drape.').waitFor();
    await waitForCalm(page);
    const [below, canvas] = await Promise.all([strip.boundingBox(), page.locator('.scene canvas').boundingBox()]);
    assert.ok(canvas.y + canvas.height <= below.y + 1, 'the strip stands below the cloth');
    await looks('phone-3-older');
  });

  it('drapes again, with all that is done meanwhile in the bar', async () => {
    const before = (await ask(page, 'job')).id;
    await page.locator('.actions .primary').tap();
    await waitFor(page, (id) => window.__toile.job()?.id !== id, before);
    await page.locator('.actions').getByRole('button', { name: 'Cancel' }).waitFor();
    await looks('phone-4-drapes');
    await waitForState(page, 'succeeded');
  });

  it('sets both side by side, each with its name', async () => {
    await tab('Result').tap();
    await page.locator('.report').waitFor();
    await page.getByLabel('Compare with').selectOption({ index: 1 });
    await page.locator('.comparison table').waitFor();
    await waitFor(page, () => document.querySelectorAll('canvas[aria-busy=false]').length === 2);
    for (const caption of await page.locator('.scene-half .scene-caption').all())
      assert.ok(await caption.evaluate((one) => one.scrollWidth <= one.clientWidth), 'its words are in it');
    await looks('phone-5-compared');
    await page.goBack();
  });

  it('chooses a fabric, lists the projects, and is shown around again', async () => {
    await tab('Pattern').tap();
    await page.getByRole('region', { name: /^Fabric/ }).getByRole('button', { name: 'Change' }).tap();
    await page.locator('.fabric-library li button').first().waitFor();
    await looks('phone-6-fabrics');
    await page.locator('.fabric-library li button').nth(1).tap();
    await page.getByText('History', { exact: true }).tap();
    await page.locator('.history li').getByText(/^Change fabric .*: \w/).first().waitFor();
    await page.getByRole('button', { name: 'Project list' }).tap();
    await page.locator('.rail .row').first().waitFor();
    await looks('phone-7-list');
    await page.getByRole('button', { name: 'Project list' }).tap();
    await page.getByRole('button', { name: 'Language and units' }).tap();
    await looks('phone-8-settings');
    await page.getByRole('button', { name: 'Take the tour' }).tap();
    await page.locator('.tour').waitFor();
    assert.deepEqual(page.complaints, []);
  });
});
