// The tour in a real browser over the real server: it greets a first visit of a project, is skipped, stays away, and is
// taken again. Screenshots are kept in out/e2e. The tests build on each other, in this order.

import assert from 'node:assert/strict';
import { describe } from 'node:test';
import { openPage, shoot, waitFor, waitForState } from './browser.mjs';
import { setStage } from './stage.mjs';

const kDesk = { viewport: { width: 1280, height: 800 }, firstVisit: true };
const kPhone = { viewport: { width: 390, height: 844 }, colorScheme: 'dark', locale: 'de-DE', firstVisit: true };
let browser, page, project;

const { service, it } = setStage({
  begin: async (stage) => {
    browser = stage.browser;
    project = (await (await stage.service.get('/projects')).json()).projects[0].id;
    page = await openPage(browser, stage.service.url, kDesk);
  },
});

const card = (watched = page) => watched.locator('.tour');

/** Whether the card lies within the window. */
async function isInside(watched) {
  const { x, y, width, height } = await card(watched).boundingBox();
  const size = watched.viewportSize();
  return x >= 0 && y >= 0 && x + width <= size.width && y + height <= size.height;
}

describe('the tour', () => {
  it('leaves the first page alone and greets in a project, in five stops', async () => {
    await page.getByRole('heading', { name: 'See your pattern on a body' }).waitFor();
    assert.equal(await card().count(), 0);
    await page.goto(`${service.url}/#/projects/${project}`);
    await waitForState(page, 'succeeded');
    for (let stop = 1; stop <= 5; ++stop) {
      await card().getByText(`${stop} of 5`).waitFor();
      await page.locator('.tour-ring').waitFor();
      assert.ok(await isInside(page), `the card of stop ${stop} is in the window`);
      await shoot(page, `tour-${stop}`);
      if (stop < 5) await card().getByRole('button', { name: 'Next' }).click();
    }
    await card().getByRole('button', { name: 'Back' }).click();
    await card().getByText('4 of 5').waitFor();
  });

  it('keeps nobody from working, and is skipped by Escape', async () => {
    await page.locator('.plane [data-piece=front] .piece-cloth').press('Enter');
    await page.locator('.plane [data-piece=front] [aria-pressed=true]').waitFor();
    await page.keyboard.press('Escape');
    await card().waitFor({ state: 'detached' });
    assert.equal(await page.locator('.plane .selected').count(), 1, 'what is selected stays so');
  });

  it('does not come back by itself, but when it is asked for', async () => {
    await page.reload();
    await waitFor(page, () => window.__toile.project() !== null);
    await page.locator('.plane [data-piece=front]').waitFor();
    assert.equal(await card().count(), 0);
    await page.keyboard.press('?');
    await page.getByRole('button', { name: 'Take the tour' }).click();
    await card().getByText('1 of 5').waitFor();
    await card().getByRole('button', { name: 'Skip' }).click();
    await card().waitFor({ state: 'detached' });
    assert.deepEqual(page.complaints, []);
  });

  it('fits a phone, and speaks German', async () => {
    const phone = await openPage(browser, `${service.url}/#/projects/${project}`, kPhone);
    for (let stop = 1; stop <= 5; ++stop) {
      await card(phone).getByText(`${stop} von 5`).waitFor();
      assert.ok(await isInside(phone), `the card of stop ${stop} is in the window`);
      await shoot(phone, `tour-phone-${stop}`);
      await card(phone).getByRole('button', { name: stop < 5 ? 'Weiter' : 'Fertig' }).click();
    }
    await card(phone).waitFor({ state: 'detached' });
    assert.deepEqual(phone.complaints, []);
  });
});
