// A pattern whose CAD uses other layers than AAMA's, in a real browser over the real server: nothing can be made of it
// until a person says what its layers are; then it is a project like any other, also after the server has come back.
// Screenshots are kept in out/e2e. The tests build on each other, in this order.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { describe } from 'node:test';
import { ask, dropFile, openPage, shoot, waitFor, waitForState } from './browser.mjs';
import { root, Service } from './service.mjs';
import { setStage } from './stage.mjs';

const skirt = readFileSync(join(root, 'samples/skirt/skirt.dxf'), 'utf8');
/** The skirt with its outlines where grain lines belong, those where outlines belong, and corners where notches do. */
const kSwapped = { 1: '7', 7: '1', 2: '4' };
const swapped = skirt.replace(/^(\s*8\r?\n)(\d+)/gm, (_, code, layer) => code + (kSwapped[layer] ?? layer));
let page, project;

const { service, it } = setStage({
  service: new Service(''),
  begin: async (stage) => {
    page = await openPage(stage.browser, stage.service.url);
    await page.locator('.rail, .start, .welcome').first().waitFor();
  },
});

const layer = (name) => page.getByRole('combobox', { name: `Layer ${name} is` });
const shown = async () => (await service.get(`/projects/${project}`)).json();
/** What a piece is, but for how its file was read. */
const shapes = async (asset, layers) => {
  const { pieces } = await service.post('/imports', { asset, ...(layers && { layers }) });
  return pieces.map(({ name, points, grain_deg, edge_list }) => ({ name, points, grain_deg, edges: edge_list.length }));
};

describe('a pattern of other layers', () => {
  it('says why nothing can be made of it, and which layers it has', async () => {
    assert.notEqual(swapped, skirt);
    await dropFile(page, 'odd.dxf', swapped);
    await page.locator('.import-unread .problem .code').getByText(/^dxf\.\w+_outline/).waitFor();
    await page.locator('.import-unread').getByText('Perhaps the outlines stand on another layer').waitFor();
    await layer('7').waitFor();
    assert.equal(await layer('1').evaluate((one) => one.selectedOptions[0].text), 'as usual: cut line');
    assert.equal(await page.locator('.intake footer .primary').isDisabled(), true);
    await shoot(page, 'layers-1-nothing');
  });

  it('is shown as soon as a layer is said to be the cut line, and follows each further word', async () => {
    await layer('7').selectOption('cut');
    await page.locator('.import-preview [data-piece=front]').waitFor();
    assert.equal(await page.locator('.import-preview .piece').count(), 4);
    await page.getByRole('tab', { name: 'Layers 3', selected: true }).waitFor();
    await layer('1').selectOption('grain');
    await page.locator('.import[aria-busy=false]').waitFor();
    await layer('4').selectOption('turn');
    await page.locator('.import[aria-busy=false]').waitFor();
    await shoot(page, 'layers-2-told');
  });

  it('becomes a project that keeps what was said', async () => {
    await page.locator('.intake footer').getByText('Create', { exact: true }).click();
    await page.locator('.intake').waitFor({ state: 'detached' });
    await waitFor(page, () => window.__toile.project() !== null);
    project = (await ask(page, 'project')).id;
    const { document, files } = await shown();
    const told = document.pieces.filter((piece) => piece.from).map((piece) => piece.from.layers);
    assert.deepEqual(told, Array(4).fill({ 1: 'grain', 4: 'turn', 7: 'cut' }));
    const usual = await shapes(await service.upload('dxf', 'skirt.dxf', skirt));
    assert.deepEqual(await shapes(files['odd.dxf'], told[0]), usual);
  });

  it('drapes after the server has come back, by the same map', async () => {
    await service.kill();
    await service.start();
    await page.reload();
    await waitFor(page, () => window.__toile.project() !== null);
    await page.locator('.topbar').getByRole('button', { name: 'Start drape' }).click();
    await waitForState(page, 'succeeded');
    const { id } = await ask(page, 'job');
    const { worn, intersections } = await (await service.get(`/jobs/${id}/results/report.json`)).json();
    assert.deepEqual([worn, intersections.cloth_body, intersections.cloth_cloth], ['yes', 0, 0]);
    await shoot(page, 'layers-3-draped');
  });

  it('has complained of nothing', () => assert.deepEqual(page.complaints, []));
});
