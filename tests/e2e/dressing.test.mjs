// Bodies and places in a real browser over the real server: a size, a slider, one click that arranges, the list of
// problems, undo, a drape. Screenshots are kept in out/e2e. The tests build on each other, in this order.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { before, describe } from 'node:test';
import { ask, closeAfter, openBrowser, openPage, shoot, shootAll, waitFor, waitForCalm, waitForState } from './browser.mjs';
import { Service, root } from './service.mjs';
import { kPatience, steps } from './steps.mjs';

const service = new Service('');
let browser, page, project;

const sample = (name) => join(root, 'samples/skirt', name);
const measured = async (name) => (await ask(page, 'dressing'))[0].measures.find((one) => one.name === name).cm;
const changed = (hook, was) => waitFor(page, ([key, old]) => window.__toile[key]() !== old, [hook, was]);

/** The sample's pieces in a heap at the origin, and a mannequin. */
async function makeProject() {
  const document = JSON.parse(readFileSync(sample('project.json')));
  for (const piece of document.pieces) piece.placement = { rigid: {} };
  document.bodies = [{ id: 'anna', mannequin: { preset: 'eu36', triangles: 2000 } }];
  document.settings.particle_distance_mm = 25;
  Object.assign(document.settings, { time_step_s: 1 / 80000, settle_speed_mm_s: 0.001, max_time_s: 60 }); // a drape that is not over before it is cancelled
  document.settings.start = 'sewn'; // or it would be arranged for the drape, and nothing be amiss
  const files = { 'skirt.dxf': await service.upload('dxf', 'skirt.dxf', readFileSync(sample('skirt.dxf'))) };
  return service.post('/projects', { document: { ...document, attachments: [] }, files });
}

before(
  async () => {
    await service.start();
    project = await makeProject();
    browser = await openBrowser();
    page = await openPage(browser, `${service.url}/#/projects/${project.id}`);
  },
  { timeout: kPatience },
);

closeAfter(() => browser, service);

describe('bodies and places', () => {
  const it = steps(() => shootAll(browser));

  it('shows the pieces in space before anything is draped', async () => {
    await page.getByRole('heading', { name: 'Not draped yet' }).waitFor();
    await waitFor(page, () => window.__toile.start() > 0 && window.__toile.dressing() !== null);
    assert.notEqual(await ask(page, 'bodyHash'), '');
  });

  it('makes the body of another size', async () => {
    await page.getByRole('tab', { name: 'Body' }).click();
    const was = await ask(page, 'bodyHash');
    await page.getByLabel('Size').selectOption('eu38');
    await changed('bodyHash', was);
    await waitFor(page, () => window.__toile.dressing()[0].mannequin.preset === 'eu38');
    assert.ok(Math.abs((await measured('bust')) - 88) < 0.5);
    await shoot(page, '30-body');
  });

  it('makes the body as a slider says, and as a number in inches says', async () => {
    const slider = page.getByRole('slider', { name: 'Waist' });
    await slider.focus();
    await slider.press('ArrowRight');
    await waitFor(page, () => window.__toile.dressing()[0].mannequin.waist_cm === 72.5);
    assert.ok(Math.abs((await measured('waist')) - 72.5) < 0.5);
    await page.getByRole('radio', { name: 'in', exact: true }).click();
    const field = page.getByRole('textbox', { name: 'Hip' });
    await field.fill('38.5');
    await field.press('Enter');
    await waitFor(page, () => window.__toile.dressing()[0].mannequin.hip_cm === 97.8);
    assert.ok(Math.abs((await measured('hip')) - 97.8) < 0.5);
    await page.getByRole('button', { name: 'Landmarks' }).click();
    await page.getByRole('button', { name: 'Boxes' }).click();
    await shoot(page, '31-measures');
  });

  it('says which measure cannot be', async () => {
    const field = page.getByRole('textbox', { name: 'Waist' });
    await field.fill('12.5');
    await field.press('Enter');
    const refusal = page.locator('.inspector .problem');
    await refusal.waitFor();
    assert.match(await refusal.innerText(), /waist/);
    assert.equal((await ask(page, 'dressing'))[0].mannequin.waist_cm, 72.5);
    await shoot(page, '32-refused');
  });

  it('lists what keeps the drape from beginning and flies to it', async () => {
    await page.getByRole('tab', { name: 'Arrange' }).click();
    await page.locator('.verdict').getByText('Not ready to drape').waitFor();
    await page.locator('.finding.error').first().click();
    await page.locator('.finding[aria-pressed=true]').waitFor();
    await shoot(page, '33-problem');
  });

  it('arranges the pieces with one click', async () => {
    const was = await ask(page, 'startHash');
    await page.getByRole('button', { name: 'Arrange the pieces' }).click();
    await changed('startHash', was);
    await page.locator('.verdict').getByText('Ready to drape').waitFor();
    assert.match(await page.locator('.piece-places').innerText(), /front/);
    await shoot(page, '34-arranged');
  });

  it('puts a piece to another side by hand, and undoes it', async () => {
    const was = await ask(page, 'startHash');
    await page.locator('.piece-row').first().click();
    await page.getByRole('combobox', { name: 'Part' }).selectOption('hips');
    await changed('startHash', was);
    const placed = await ask(page, 'startHash');
    await page.getByRole('radio', { name: 'Left', exact: true }).click();
    await changed('startHash', placed);
    await shoot(page, '35-placed');
    await page.locator('.scene canvas').focus();
    for (const left of [await ask(page, 'startHash'), placed]) {
      await page.keyboard.press('Control+z');
      await changed('startHash', left);
    }
    assert.equal(await ask(page, 'startHash'), was);
  });

  it('takes a piece that is dragged onto a side of a box', async () => {
    const was = await ask(page, 'startHash');
    await page.getByRole('button', { name: 'front view' }).click();
    await waitForCalm(page);
    const scene = await page.locator('.scene canvas').boundingBox();
    const at = (x, y) => [scene.x + x * scene.width, scene.y + y * scene.height];
    await page.mouse.move(...at(0.5, 0.55));
    await page.mouse.down();
    await page.mouse.move(...at(0.5, 0.4), { steps: 4 });
    await page.mouse.move(...at(0.5, 0.3), { steps: 4 });
    await shoot(page, '37-dragged');
    await page.mouse.up();
    await changed('startHash', was);
    const { pieces } = await ask(page, 'check');
    const { by_hand } = pieces.find((piece) => piece.by_hand);
    assert.deepEqual([by_hand.part, by_hand.side], ['torso', 'front']);
    await page.locator('.scene canvas').focus();
    const placed = await ask(page, 'startHash');
    await page.keyboard.press('Control+z');
    await changed('startHash', placed);
    assert.equal(await ask(page, 'startHash'), was);
  });

  it('drapes from there', async () => {
    await page.locator('.actions .primary').click();
    await waitForState(page, 'running');
    await waitFor(page, () => window.__toile.frames() > 2);
    await page.locator('.actions').getByText('Cancel').click();
    await waitForState(page, 'cancelled');
    await page.getByRole('tab', { name: 'Body' }).click();
    await page.getByRole('slider', { name: 'Waist' }).waitFor();
    assert.deepEqual(page.complaints, []);
  });

  it('dresses a mesh of one’s own and says how it was read', async () => {
    const lines = readFileSync(sample('body.obj'), 'utf8')
      .split('\n')
      .map((line) => line.replace(/^v (\S+) (\S+) (\S+)/, (_, x, y, z) => `v ${100 * x} ${-100 * z} ${100 * y}`));
    const was = await ask(page, 'bodyHash');
    await page
      .getByLabel('Mesh of a body')
      .setInputFiles({ name: 'scan.obj', mimeType: 'model/obj', buffer: Buffer.from(lines.join('\n')) });
    await changed('bodyHash', was);
    await page.locator('.own-mesh .sure').getByText('Read as centimetres, z up').waitFor();
    await waitFor(page, () => window.__toile.dressing()[0].file === 'scan.obj');
    assert.ok(Math.abs((await measured('height')) - 170) < 1);
    await shoot(page, '36-own-mesh');
  });
});
