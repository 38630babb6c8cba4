// Seams that are proposed too unsurely to be taken, in a real browser over the real server: told in an import, lit where they
// are pointed at, also in 3D, and sewn one by one; a small piece's name. Screenshots are kept in out/e2e. The tests build on each other.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { describe } from 'node:test';
import { ask, dropFile, openPage, shoot, waitFor, waitForCalm } from './browser.mjs';
import { root, Service } from './service.mjs';
import { setStage } from './stage.mjs';

/** Two pieces whose edges fit each other in more than one way: nothing is sure. */
const cushion = readFileSync(join(root, 'samples/cushion/cushion.dxf'), 'utf8');
let page;

const { it } = setStage({
  service: new Service(''),
  begin: async ({ browser, service }) => {
    page = await openPage(browser, service.url);
  },
});

/** The 3D view as it stands. */
async function picture() {
  await waitForCalm(page);
  return page.locator('.scene canvas').screenshot();
}

describe('unsure seams', () => {
  it('are told in an import, with the pieces that nothing holds, and lit on them', async () => {
    await page.locator('.welcome').waitFor();
    await dropFile(page, 'cushion.dxf', cushion);
    await page.locator('.import-preview .piece').first().waitFor();
    await page.locator('#import-seams').click();
    await page.getByText('2 pieces are sewn to nothing').waitFor();
    const unsure = page.getByRole('list', { name: 'Unsure proposals' });
    await unsure.getByRole('listitem').first().hover();
    await page.locator('.import-preview .seam.lit').first().waitFor();
    await shoot(page, 'proposals-1-import');
  });

  it('are lit in both views of the project, and sewn by a button of their own', async () => {
    await page.getByRole('button', { name: 'Create', exact: true }).click();
    await page.locator('.intake').waitFor({ state: 'detached' });
    await page.getByRole('tab', { name: 'Pattern', exact: true }).click();
    await page.getByRole('button', { name: 'Look for seams' }).click();
    const row = page.getByRole('list', { name: 'Unsure proposals' }).getByRole('listitem').first();
    await row.waitFor();
    await page.mouse.move(0, 0);
    const dark = await picture();
    await row.hover();
    await page.locator('.pattern .seam.lit').first().waitFor();
    assert.notDeepEqual(await picture(), dark, 'it is lit in 3D');
    await shoot(page, 'proposals-2-lit');
    const { revision } = await ask(page, 'project');
    await row.getByRole('button', { name: /^Sew / }).click();
    await waitFor(page, (before) => window.__toile.project().revision === before + 1, revision);
    await page.getByRole('button', { name: /^1 / }).waitFor();
    assert.equal(await page.getByText('sewn to nothing').count(), 0);
    await shoot(page, 'proposals-3-sewn');
  });

  it('have pieces that tell their name where they are too small for it', async () => {
    await page.locator('.plane').press('Escape');
    for (let i = 0; i < 8; ++i) await page.getByRole('button', { name: 'Zoom out' }).click();
    await page.locator('.piece-cloth').first().hover({ force: true });
    const name = await page.locator('.piece.hovered').getAttribute('data-piece');
    await page.locator('.piece-tag').getByText(name).waitFor();
    await shoot(page, 'proposals-4-name');
    assert.deepEqual(page.complaints, []);
  });
});
