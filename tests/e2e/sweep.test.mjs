// A sweep in a real browser over the real server: chosen from a project, its table filled as drapes end, each picture
// leading to its drape; files taken home, the sweep removed. Screenshots are kept in out/e2e. The tests build on each
// other, in this order.

import assert from 'node:assert/strict';
import { describe } from 'node:test';
import { openPage, shoot, waitForCalm, waitForState } from './browser.mjs';
import { openNewest, setStage } from './stage.mjs';
import { kPatience } from './steps.mjs';

let browser, page, sweep;

const { service, it } = setStage({
  begin: async (stage) => {
    browser = stage.browser;
    page = await openNewest(stage);
  },
});

const cells = () => page.locator('a.sweep-cell');
const shown = async () => (await service.get(`/sweeps/${sweep}`)).json();

describe('sweeps', () => {
  it('are chosen from a project by bodies and fabrics', async () => {
    await page.getByRole('button', { name: 'Try others' }).click();
    await page.getByLabel('EU 38').check();
    await page.getByLabel('Find a fabric').fill('denim');
    await page.getByLabel(/Denim.*10/).first().check();
    await page.getByLabel('Find a fabric').fill('');
    await page.getByText('2 bodies × 2 fabrics').waitFor();
    await shoot(page, 'sweep-1-choice');
    await page.emulateMedia({ colorScheme: 'dark' });
    await shoot(page, 'sweep-1-choice-dark');
    await page.emulateMedia({ colorScheme: 'light' });
    await page.getByRole('button', { name: 'Start 4 drapes' }).click();
    await page.waitForURL(/#\/sweeps\/s_/, { timeout: kPatience });
    await page.getByRole('heading', { name: 'A-line skirt', level: 1 }).waitFor();
    sweep = /#\/sweeps\/(s_\w+)$/.exec(page.url())[1];
    await cells().nth(3).waitFor();
    assert.equal(await cells().count(), 4);
  });

  it('fill with pictures as drapes end; what was draped before is there at once', async () => {
    await page.locator('a.sweep-cell img').first().waitFor();
    assert.equal((await shown()).cells[0].state, 'succeeded', 'the sample has been draped');
    await page.getByText(/of 4 ended|4 drapes, all ended/).first().waitFor();
    await shoot(page, 'sweep-2-under-way');
    await page.getByText('4 drapes, all ended').waitFor({ timeout: kPatience });
    await page.waitForFunction(() => document.querySelectorAll('a.sweep-cell img').length === 4);
    await page.waitForFunction(() => [...document.images].every((image) => image.complete && image.naturalWidth > 0));
    await shoot(page, 'sweep-3-ended');
    const { cells: told } = await shown();
    assert.deepEqual(told.map(({ state }) => state), Array(4).fill('succeeded'));
    for (const { figures } of told) assert.equal(figures.cloth_body + figures.cloth_cloth + figures.worst_body + figures.worst_cloth, 0);
    assert.equal(new Set(told.map(({ figures }) => figures.hash)).size, 4, 'no two hang alike');
  });

  it('lead from each picture to its drape, and back', async () => {
    await cells().nth(3).click();
    await waitForState(page, 'succeeded');
    const { cells: told } = await shown();
    assert.ok(page.url().endsWith(`#/jobs/${told[3].job}`));
    await waitForCalm(page);
    await shoot(page, 'sweep-4-drape');
    await page.getByRole('link', { name: 'Sweep', exact: true }).click();
    await page.getByText('4 drapes, all ended').waitFor();
  });

  it('are taken home as a sheet and a table', async () => {
    const sheet = await service.get(`/sweeps/${sweep}/sheet.png`);
    assert.equal(sheet.status, 200);
    assert.ok((await sheet.arrayBuffer()).byteLength > 50_000);
    const table = await (await service.get(`/sweeps/${sweep}/table.csv`)).text();
    assert.equal(table.trim().split('\r\n').length, 5);
    const download = page.waitForEvent('download');
    await page.getByText('Table (CSV)').click();
    assert.equal((await download).suggestedFilename(), 'A-line_skirt.csv');
  });

  it('fit a phone, and speak German', async () => {
    const phone = await openPage(browser, `${service.url}/#/sweeps/${sweep}`, {
      viewport: { width: 390, height: 844 },
      colorScheme: 'dark',
      locale: 'de-DE',
    });
    await phone.getByText('4 Drapierungen, alle beendet').waitFor();
    await phone.waitForFunction(() => document.images.length > 0 && [...document.images].some((image) => image.complete && image.naturalWidth > 0));
    assert.ok(await phone.evaluate(() => document.documentElement.scrollWidth <= innerWidth), 'nothing sticks out');
    await shoot(phone, 'sweep-5-phone-german');
    await phone.context().close();
  });

  it('are removed as a whole', async () => {
    await page.getByRole('button', { name: /Remove the sweep/ }).click();
    await page.getByRole('button', { name: /Really remove the sweep/ }).click();
    await page.waitForFunction(() => location.hash === '#/');
    await assert.rejects(service.get(`/sweeps/${sweep}`), /404/);
    assert.deepEqual(page.complaints, []);
  });
});
