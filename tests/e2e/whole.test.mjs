// Whole ways: from a dropped DXF to what one takes home, with nothing but clicks, while a person's day goes on: the
// pattern is edited while it drapes, the page is loaded anew, and the server falls and comes back. Two samples, and
// patterns that nobody here drew, which lie in the reference data, whose folder TOILE_SHARED names; without it those are
// skipped. Many whole drapes: part of ./test --long. Screenshots are kept in out/e2e.

import assert from 'node:assert/strict';
import { existsSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { before, describe, it } from 'node:test';
import { ask, closeAfter, dropFile, openBrowser, openPage, shoot, shootAll, waitFor, waitForCalm } from './browser.mjs';
import { assertValidGlb } from './models.mjs';
import { root, Service } from './service.mjs';
import { kPatience, until } from './steps.mjs';

const shared = join(process.env.TOILE_SHARED ?? '', 'data/freesewing');
const kSkipped = existsSync(shared) ? false : `no reference data: ${shared}`;
/** `worn`: whether a body must wear it. Most of the jacket's seams are proposed too unsurely to be taken. */
const kDesigns = [
  ...['skirt', 'tshirt'].map((name) => ({ name, file: join(root, `samples/${name}/${name}.dxf`), worn: true, skip: false })),
  ...[
    ['teagan-cisFemaleAdult34', true],
    ['penelope-cisFemaleAdult34', true],
    ['brian-cisMaleAdult38', true],
    ['titan-cisMaleAdult38', true],
    ['jaeger-cisMaleAdult38', false],
  ].map(([name, worn]) => ({ name, file: join(shared, `${name}.aama.dxf`), worn, skip: kSkipped })),
];
const kDrape = 4 * kPatience;
const kEnds = ['succeeded', 'failed', 'cancelled'];

const service = new Service('');
let browser;

const jobOf = async (id) => (await service.get(`/jobs/${id}`)).json();

const waitForEnd = (page) =>
  page.waitForFunction((wanted) => wanted.includes(window.__toile.job()?.state), kEnds, {
    polling: 200,
    timeout: kDrape,
  });

/** Drapes that may come to rest before they are held, in a row; the machine may be that fast, but not always. */
const kMissed = 3;

/**
 * Holds a drape once cloth falls, by the page's own button, and gives its id. One that ends well just as it is to be held
 * cannot be edited while it drapes: then the pattern is draped anew, changed, or the old drape would answer for it.
 */
async function hold(page, first) {
  let id = first;
  for (let missed = 0; !(await isHeld(page, id)); ++missed) {
    assert.ok(missed < kMissed, `${id} ended before it was held`);
    const ended = id;
    const { revision } = await ask(page, 'project');
    await grow(page);
    await waitFor(page, (old) => window.__toile.project().revision > old, revision);
    await page.locator('.topbar').getByRole('button', { name: 'Drape again', exact: true }).click();
    await waitFor(page, (old) => ![old, undefined].includes(window.__toile.job()?.id), ended);
    id = (await ask(page, 'job')).id;
  }
  return id;
}

/** Whether the button has held it; false: it had come to its end by then. */
async function isHeld(page, id) {
  const button = page.getByRole('button', { name: 'Pause', exact: true });
  const pressed = () => button.click({ timeout: 1000 }).then(() => true, () => false);
  const hasEnded = async () => kEnds.includes((await ask(page, 'job'))?.state);
  await until(async () => {
    const { state, progress } = await jobOf(id);
    return kEnds.includes(state) || progress?.phase === 'drape' || progress?.phase === 'stills';
  }, `${id} drapes`);
  await until(async () => (await pressed()) || (await hasEnded()), `${id} can be held, or ends`);
  await waitFor(page, (ends) => ['paused', ...ends].includes(window.__toile.job()?.state), kEnds);
  const { state, reason_code, reason } = await jobOf(id);
  if (state !== 'paused') assert.equal(state, 'succeeded', `${reason_code}: ${reason}`);
  return state === 'paused';
}

/** A piece's first edge grows by three millimetres, typed. */
async function grow(page) {
  await page.getByRole('tab', { name: 'Pattern', exact: true }).click();
  await page.locator('.piece-cloth').first().click({ force: true }); // lines that are drawn on it may lie over its middle
  await page.locator('.edge-chips button').first().click();
  const field = page.getByRole('textbox', { name: /^Length/ }).first();
  await field.fill(String(Number((await field.inputValue()).replace(',', '')) + 3));
  await field.press('Enter');
}

/** Gives the drape that goes on with a change. */
async function edit(page, before) {
  await grow(page);
  await waitFor(page, (id) => window.__toile.job()?.id !== id, before);
  // One that came to rest before its pause began was at its pictures, and gets them; the other goes on from its end.
  const { state, reason_code, progress } = await jobOf(before);
  if (progress?.phase !== 'stills' && state !== 'succeeded')
    assert.deepEqual([state, reason_code], ['cancelled', 'superseded']);
  return (await ask(page, 'job')).id;
}

/** What a click on a link of the page brings. */
async function download(page, link) {
  const coming = page.waitForEvent('download');
  await link.click();
  return new Uint8Array(readFileSync(await (await coming).path()));
}

/** Whether it is an MP4 with a track of pictures that lasts. */
function assertMovie(bytes) {
  const text = Buffer.from(bytes).toString('latin1');
  assert.equal(text.slice(4, 8), 'ftyp');
  const at = text.indexOf('mvhd');
  assert.ok(at > 0 && text.includes('vide'), 'no track of pictures');
  const view = new DataView(bytes.buffer, bytes.byteOffset);
  const [scale, length] = [view.getUint32(at + 16), view.getUint32(at + 20)]; // of version 0
  assert.ok(length / scale > 0.2, `it lasts ${length / scale} s`);
}

/** Whether it is a PNG of the 3D view's shape. */
async function assertPicture(bytes, page) {
  assert.equal(Buffer.from(bytes).toString('latin1', 1, 4), 'PNG');
  const view = new DataView(bytes.buffer, bytes.byteOffset);
  const [width, height] = [view.getUint32(16), view.getUint32(20)];
  const scene = await page.locator('.scene canvas').boundingBox();
  assert.equal(Math.max(width, height), 1280);
  assert.ok(Math.abs(width / height - scene.width / scene.height) < 0.02, `${width} x ${height}`);
}

async function walk(page, { name, file, worn }) {
  await page.locator('.rail, .start, .welcome').first().waitFor();
  await dropFile(page, `${name}.dxf`, readFileSync(file, 'utf8'));
  await page.locator('.import-preview .piece').first().waitFor();
  await page.locator('.intake footer .primary').click();
  await page.locator('.intake').waitFor({ state: 'detached' });
  await waitFor(page, () => ['queued', 'running'].includes(window.__toile.job()?.state));
  const first = await hold(page, (await ask(page, 'job')).id);
  await shoot(page, `60-${name}-held`);
  const next = await hold(page, await edit(page, first));
  await page.reload();
  await waitFor(page, (id) => window.__toile.job()?.id === id && window.__toile.job().state === 'paused', next);
  await service.kill();
  await page.locator('.banner').getByText('Connection lost').waitFor();
  await service.start();
  await page.locator('.banner').waitFor({ state: 'detached' });
  await waitFor(page, () => window.__toile.job()?.state !== 'queued');
  const resume = page.getByRole('button', { name: 'Resume', exact: true });
  if ((await jobOf(next)).state === 'paused') await resume.click();
  await waitForEnd(page);
  const job = await jobOf(next);
  assert.equal(job.state, 'succeeded', `${job.reason_code}: ${job.reason}`);
  const report = await (await service.get(`/jobs/${next}/results/report.json`)).json();
  console.log(`# ${name}: ${job.reason_code}, worn: ${report.worn}, ${report.cpu_s.toFixed(1)} s of CPU`);
  if (worn) assert.equal(report.worn, 'yes');
  const { cloth_body, cloth_cloth } = report.intersections;
  assert.deepEqual([cloth_body, cloth_cloth], [0, 0]);
  await page.getByRole('tab', { name: 'Result' }).click();
  await assertValidGlb(await download(page, page.locator('.downloads a[title="final.glb"]')));
  await page.locator('.scene canvas').press('ArrowRight');
  await page.getByRole('button', { name: /^Picture from here/ }).click();
  const picture = page.locator('.stills a[download$=".png"]').first();
  await picture.waitFor({ timeout: kDrape });
  await shoot(page, `60-${name}-picture`);
  await assertPicture(await download(page, picture), page);
  await page.getByRole('button', { name: /^Movie of the drape/ }).click();
  const movie = page.locator('.downloads a[download$=".mp4"]').first();
  await movie.waitFor({ timeout: kDrape });
  assertMovie(await download(page, movie));
  await waitForCalm(page);
  await shoot(page, `61-${name}`);
  assert.deepEqual(page.complaints, []);
}

describe('a whole way', () => {
  before(
    async () => {
      await service.start();
      browser = await openBrowser();
    },
    { timeout: kPatience },
  );
  closeAfter(() => browser, service);

  for (const design of kDesigns)
    it(`leads from ${design.name}.dxf to a model and a movie`, { timeout: 3 * kDrape, skip: design.skip }, async () => {
      const page = await openPage(browser, service.url);
      try {
        await walk(page, design);
      } catch (error) {
        await shootAll(browser);
        throw error;
      } finally {
        await page.close();
      }
    });
});
