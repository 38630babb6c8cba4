// Hands on the T-shirt while it drapes, in a real browser over the real server: a pull, a pin, single frames, and what the
// end tells of it. Screenshots are kept in out/e2e. The tests build on each other.

import assert from 'node:assert/strict';
import { cpSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, describe } from 'node:test';
import { ask, openPage, shoot, waitFor, waitForCalm, waitForState } from './browser.mjs';
import { Service, root } from './service.mjs';
import { setStage } from './stage.mjs';
import { until } from './steps.mjs';

/** The sample T-shirt, which never seems at rest: its time begins anew with each hand that lets go. */
function lastingShirt() {
  const folder = mkdtempSync(join(tmpdir(), 'toile-hands-'));
  cpSync(join(root, 'samples/tshirt'), folder, { recursive: true });
  const path = join(folder, 'project.json');
  const document = JSON.parse(readFileSync(path, 'utf8'));
  document.settings = { ...document.settings, settle_speed_mm_s: 0.001, max_time_s: 25 };
  writeFileSync(path, JSON.stringify(document));
  return folder;
}

const shirt = lastingShirt();
let page, id;

const button = (name) => page.getByRole('button', { name, exact: true });
const progress = async () => (await ask(page, 'job')).progress;
const waitForProgress = (holds) => waitFor(page, holds);

/**
 * Has a drape wait once it hangs. Asked of the service: a page without a graphics card may be so late that a quick
 * drape has ended before a button of it is found.
 */
async function holdOnceDraping(job) {
  const draping = async () => (await (await service.get(`/jobs/${job}`)).json()).progress?.phase === 'drape';
  await until(draping, `${job} drapes`);
  await service.post(`/jobs/${job}/pause`);
}

/** Where a place in space is seen, as shares of the 3D view: the cloth's middle and its lowest front. */
const middleOfCanvas = async (dx, dy) => {
  const box = await page.locator('.scene canvas').boundingBox();
  return [box.x + box.width * dx, box.y + box.height * dy];
};

const stage = setStage({ service: new Service(shirt) });
const { service, it } = stage;

after(() => rmSync(shirt, { recursive: true, force: true }));

describe('hands on the cloth', () => {
  it('have tools while the T-shirt drapes', async () => {
    const { jobs } = await (await service.get('/jobs')).json();
    id = jobs[0].id;
    await holdOnceDraping(id);
    page = await openPage(stage.browser, `${service.url}/#/jobs/${id}`);
    await waitForState(page, 'paused');
    await page.keyboard.press('1');
    await waitForCalm(page);
    await button('Pull').waitFor();
    await shoot(page, 'hands-1-paused');
  });

  it('lets it go on by single frames', async () => {
    for (let i = 0; i < 2; ++i) {
      const { step } = await progress();
      await button('Step').click();
      await waitFor(page, (before) => window.__toile.job().progress.step > before && window.__toile.job().state === 'paused', step);
    }
  });

  it('pull at it, and it follows', async () => {
    await page.keyboard.press('g');
    await page.getByText('Drag the cloth.').waitFor();
    const [x, y] = await middleOfCanvas(0.5, 0.52);
    await page.mouse.move(x, y);
    await page.mouse.down();
    await page.mouse.move(x + 60, y + 10, { steps: 5 });
    await waitForProgress(() => window.__toile.job().progress.pulls === 1);
    const { simulated_s: before } = await progress();
    await service.post(`/jobs/${id}/resume`); // the hand is on the cloth
    await page.mouse.move(x + 180, y + 30, { steps: 10 });
    await waitFor(page, (from) => window.__toile.job().progress.simulated_s > from + 0.6, before);
    await service.post(`/jobs/${id}/pause`);
    await waitForState(page, 'paused');
    await shoot(page, 'hands-2-pulled');
    assert.equal((await progress()).cloth_body, 0);
    assert.equal((await progress()).cloth_cloth, 0);
    await page.mouse.up();
    await waitForProgress(() => window.__toile.job().progress.pulls === 0);
  });

  it('pin it where it is, and the pin is listed and can be removed', async () => {
    await button('Resume').click();
    await waitForState(page, 'running');
    await button('Pause').click();
    await waitForState(page, 'paused');
    await page.keyboard.press('i');
    const [x, y] = await middleOfCanvas(0.5, 0.6);
    await page.mouse.click(x, y);
    await page.mouse.click(x + 40, y);
    await waitForProgress(() => window.__toile.job().progress.pins.length === 2);
    await page.getByRole('region', { name: 'Pins' }).getByText('Pin 1').waitFor();
    await waitForCalm(page);
    await shoot(page, 'hands-3-pinned');
    await button('Remove pin 2').click();
    await waitForProgress(() => window.__toile.job().progress.pins.length === 1);
    await page.keyboard.press('Escape');
    await button('Resume').click();
  });

  it('leave a log at the end, and nothing went through anything', async () => {
    await waitForState(page, 'succeeded');
    const report = await (await service.get(`/jobs/${id}/results/report.json`)).json();
    assert.equal(report.intersections.cloth_body + report.intersections.cloth_cloth, 0);
    assert.equal(report.intersections.worst_frame.cloth_body + report.intersections.worst_frame.cloth_cloth, 0);
    assert.ok(report.findings.some((finding) => finding.code === 'live.touched'));
    const log = await (await service.get(`/jobs/${id}/results/drape.log`)).json();
    assert.ok(log.touches.length > 5, `${log.touches.length} touches`);
    assert.deepEqual([...new Set(log.touches.map((one) => one.touch))].sort(), ['let_go', 'pin', 'pull', 'unpin']);
    await waitForCalm(page);
    await shoot(page, 'hands-4-end');
    assert.deepEqual(page.complaints, []);
  });

  it('edit the pattern while it drapes, and the drape goes on from how it hangs', async () => {
    const { project_id } = await ask(page, 'job');
    const { id: first } = await service.post('/jobs', { project_id, anew: true, priority: 'interactive' });
    await holdOnceDraping(first);
    await page.goto(`${service.url}/#/jobs/${first}`);
    await waitFor(page, (wanted) => window.__toile.job()?.id === wanted && window.__toile.job().state === 'paused', first);
    await waitFor(page, () => window.__toile.positions().length > 0); // its frame comes after the word that it is paused
    await page.evaluate(() => {
      window.__lost = 0;
      const look = () => {
        if (window.__toile.positions().length === 0) window.__lost += 1;
        requestAnimationFrame(look);
      };
      look();
    });
    await page.getByRole('tab', { name: 'Pattern', exact: true }).click();
    await page.locator('.piece-cloth').first().click();
    await page.locator('.edge-chips button').first().click();
    const field = page.getByRole('textbox', { name: /^Length/ }).first();
    await field.fill(String(Number(await field.inputValue()) + 8));
    await field.press('Enter');
    await waitFor(page, (before) => window.__toile.job()?.id !== before, first);
    await waitFor(page, () => (window.__toile.job().progress?.simulated_s ?? 0) > 0.1);
    await shoot(page, 'hands-5-edited');
    assert.equal(await page.evaluate(() => window.__lost), 0, 'the cloth stays in view');
    const before = await (await service.get(`/jobs/${first}`)).json();
    const next = await ask(page, 'job');
    assert.deepEqual([before.state, before.reason_code, before.reason_where], ['cancelled', 'superseded', next.id]);
    await waitForState(page, 'succeeded');
    const report = await (await service.get(`/jobs/${next.id}/results/report.json`)).json();
    assert.equal(report.intersections.worst_frame.cloth_body + report.intersections.worst_frame.cloth_cloth, 0);
    assert.ok(report.findings.some((finding) => finding.code === 'start.goes_on'), JSON.stringify(report.findings));
    assert.deepEqual(page.complaints, []);
  });
});
