// What an ended drape keeps while its project goes on, in a real browser over the real server: the colours of its fabrics, and
// pictures of a map that is shown. What stands over cloth and pieces leaves them free. Screenshots are kept in out/e2e. The
// tests build on each other, in this order.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { describe } from 'node:test';
import { ask, dropFile, openPage, shoot, waitFor, waitForCalm } from './browser.mjs';
import { Service, root } from './service.mjs';
import { openNewest, setStage } from './stage.mjs';
import { colourAtMiddle } from './pictures.mjs';

const kSmall = { viewport: { width: 1280, height: 720 } };
const kPhone = { viewport: { width: 390, height: 844 } };
const sample = join(root, 'samples/skirt');

const stage = setStage({
  service: new Service(sample),
  begin: async (ready) => (page = await openNewest(ready, kSmall)),
});
const { service, it } = stage;
let page;

const isRed = ([red, green, blue]) => red > 1.6 * green && red > 1.6 * blue;
const scene = (watched) => watched.locator('.scene canvas');

describe('an ended drape', () => {
  it('keeps the colours of its fabric when the pieces are cut of another', async () => {
    await waitForCalm(page);
    assert.ok(isRed(await colourAtMiddle(page, scene(page))), 'the sample is red');
    const { project_id } = await ask(page, 'job');
    const { revision } = await (await service.get(`/projects/${project_id}`)).json();
    const pieces = ['front', 'back', 'band_front', 'band_back'];
    const edits = pieces.map((piece) => ({ edit: 'set_fabric', piece, fabric: 'denim-10oz' }));
    const headers = { 'Content-Type': 'application/json', 'If-Match': `"${revision}"` };
    await service.get(`/projects/${project_id}/edits`, { method: 'POST', headers, body: JSON.stringify({ edits }) });
    await page.reload();
    await waitFor(page, () => window.__toile.positions().length > 0);
    await page.getByText('The project has changed since this drape.').waitFor();
    await waitForCalm(page);
    await shoot(page, 'kept-1-colours');
    const [strip, view] = await Promise.all([page.locator('.scene-message.docked').boundingBox(), scene(page).boundingBox()]);
    assert.ok(view.y + view.height <= strip.y + 1, 'what says so stands below the cloth');
    assert.ok(isRed(await colourAtMiddle(page, scene(page))), 'and stays so');
  });

  it('has pictures taken of the map that is shown, whose legend leaves the cloth free', async () => {
    await page.getByLabel('Colour the cloth by').selectOption('room');
    await page.locator('.map-legend').waitFor();
    await waitForCalm(page);
    const [legend, view] = await Promise.all([page.locator('.map-legend').boundingBox(), scene(page).boundingBox()]);
    // The skirt's hem, three quarters from the front, begins a quarter across the view.
    assert.ok(legend.x + legend.width < view.x + 0.25 * view.width, `the legend ends at ${legend.x + legend.width}`);
    await page.getByRole('tab', { name: 'Result' }).click();
    const asked = page.waitForRequest((request) => request.method() === 'POST' && request.url().endsWith('/stills'));
    await page.getByRole('button', { name: 'Picture from here' }).click();
    assert.equal((await asked).postDataJSON().map, 'ease');
    await page.getByText('Picture 1').waitFor();
    await page.getByText('Picture 1').scrollIntoViewIfNeeded();
    await shoot(page, 'kept-2-map');
  });
});

describe('an import on a phone', () => {
  it('has all its pages within reach', async () => {
    const phone = await openPage(stage.browser, service.url, kPhone);
    await phone.getByText('Drop a DXF pattern here').waitFor();  // from then on the page takes what is dropped
    await dropFile(phone, 'skirt.dxf', readFileSync(join(sample, 'skirt.dxf'), 'utf8'));
    const tabs = phone.locator('.import .tabs button');
    await tabs.first().waitFor();
    assert.equal(await tabs.count(), 4);
    for (const tab of await tabs.all()) {
      const { x, width } = await tab.boundingBox();
      assert.ok(x >= 0 && x + width <= 390, await tab.textContent());
      await tab.click();
    }
    await shoot(phone, 'kept-3-import');
    await phone.getByRole('button', { name: 'Create', exact: true }).click();
    for (const button of await phone.locator('.intake footer button').all()) {
      const box = await button.boundingBox();
      assert.ok(!box || box.x + box.width <= 390, 'what is done meanwhile leaves room for the buttons');
    }
    await phone.locator('.plane .piece').first().waitFor();
    await phone.close();
  });
});
