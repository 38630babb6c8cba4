// Sections through body and cloth in a real browser over the real server: at heights with names and by the slider, beside the
// service's own figures, in inches, and while a drape is under way. Screenshots are kept in out/e2e. The tests build on
// each other, in this order.

import assert from 'node:assert/strict';
import { join } from 'node:path';
import { describe } from 'node:test';
import { ask, openPage, shoot, waitFor, waitForCalm, waitForState } from './browser.mjs';
import { Service, root } from './service.mjs';
import { setStage, openNewest } from './stage.mjs';
import { until } from './steps.mjs';

const stage = setStage({
  service: new Service(join(root, 'samples/blouse')),
  begin: async (ready) => (page = await openNewest(ready, { viewport: { width: 1440, height: 900 } })),
});
const { service, it } = stage;
let page;

const panel = (watched = page) => watched.getByRole('region', { name: 'Section and ease' });
const level = (name) => panel().getByRole('button', { name, exact: true });
const shown = () => ask(page, 'section');

/** What stands on the 3D view and is cut off by its edge, or lies under something else there. */
const outOfView = (watched) =>
  watched.evaluate(() => {
    const view = document.querySelector('.scene').getBoundingClientRect();
    const things = [...document.querySelectorAll('.scene-tools > :is(button, select), .scene-hint, .map-legend')];
    return things
      .filter((thing) => {
        const { left, right, top, bottom } = thing.getBoundingClientRect();
        const within = left >= view.left && right <= view.right && top >= view.top && bottom <= view.bottom;
        const above = document.elementFromPoint((left + right) / 2, (top + bottom) / 2);
        return !within || (thing.closest('.scene-top') && !thing.contains(above));
      })
      .map((thing) => thing.textContent);
  });

describe('a section', () => {
  it('is shown by a key, at the waist, on body and cloth', async () => {
    await panel().waitFor(); // it is there once there is cloth, and the key does nothing before
    await page.keyboard.press('c');
    await panel().getByRole('slider', { name: 'Height' }).waitFor();
    await waitFor(page, () => window.__toile.section()?.girths[0]?.part === 'trunk');
    await level('Waist').and(page.locator('[aria-pressed=true]')).waitFor();
    await waitForCalm(page);
    await panel().scrollIntoViewIfNeeded();
    await shoot(page, 'section-1-waist');
  });

  it('measures what the service’s own report says', async () => {
    const { id } = await ask(page, 'job');
    const { fit } = await (await service.get(`/jobs/${id}/results/report.json`)).json();
    for (const name of ['bust', 'waist', 'hip']) {
      await level(name[0].toUpperCase() + name.slice(1)).click();
      await panel().locator('button[aria-pressed=true]', { hasText: new RegExp(name, 'i') }).waitFor();
      const { girths } = await shown();
      const { ease_mm, body_mm, garment_mm } = fit.find(({ at }) => at === name);
      const trunk = girths.find(({ part }) => part === 'trunk' || part === 'both_legs' || part === 'trunk_and_arm');
      assert.ok(Math.abs(1000 * trunk.body - body_mm) < 15, `${name}: body ${1000 * trunk.body}, ${body_mm}`);
      assert.ok(Math.abs(1000 * trunk.flat - garment_mm) < 15, `${name}: cloth ${1000 * trunk.flat}, ${garment_mm}`);
      assert.ok(Math.abs(1000 * (trunk.flat - trunk.body) - ease_mm) < 20, `${name}: ease ${ease_mm}`);
      assert.ok(trunk.room.least > 0 && trunk.room.least < trunk.room.median, `${name}: room from ${trunk.room.least}`);
    }
  });

  it('goes through the sleeves where they are, by the slider and its keys', async () => {
    const slider = panel().getByRole('slider', { name: 'Height' });
    await level('Waist').click(); // long sleeves hang clear of the trunk there, and are cut across whole
    await slider.focus();
    const before = (await shown()).height;
    await page.keyboard.press('ArrowUp');
    await waitFor(page, (from) => window.__toile.section().height > from, before);
    await waitFor(page, () => window.__toile.section().girths.some(({ part }) => part.endsWith('_arm')));
    await waitForCalm(page);
    await shoot(page, 'section-2-sleeves');
  });

  it('is told in inches, and fits in a small window', async () => {
    await page.setViewportSize({ width: 1280, height: 720 });
    await page.getByRole('button', { name: 'Language and units' }).click();
    await page.getByRole('radio', { name: 'Everything in inches' }).click();
    await page.keyboard.press('Escape');
    await panel().getByText(/^\d+\.\d\d in$/).first().waitFor();
    assert.equal(await page.evaluate(() => document.documentElement.scrollWidth > innerWidth), false);
    await shoot(page, 'section-3-inches');
  });

  it('follows a drape that is under way', async () => {
    const project = await (await service.get(`/projects/${(await ask(page, 'job')).project_id}`)).json();
    const { document, files } = project;
    document.name = 'A shirt that is watched';
    document.settings = { ...document.settings, settle_speed_mm_s: 0.001, max_time_s: 60 };
    const { id: other } = await service.post('/projects', { document, files });
    const { id } = await service.post('/jobs', { project_id: other, priority: 'interactive' });
    const draping = async () => (await (await service.get(`/jobs/${id}`)).json()).progress?.phase === 'drape';
    await until(draping, `${id} drapes`);
    await service.post(`/jobs/${id}/pause`);
    const watched = await openPage(stage.browser, `${service.url}/#/jobs/${id}`);
    await waitForState(watched, 'paused');
    await panel(watched).waitFor();
    await watched.keyboard.press('c');
    await waitFor(watched, () => window.__toile.section() !== null);
    await watched.setViewportSize({ width: 1280, height: 720 });
    await watched.keyboard.press('e');
    await watched.getByLabel('Colour the cloth by').selectOption('room');
    await watched.getByRole('button', { name: 'Pin', exact: true }).click();
    await watched.locator('.map-legend').waitFor();
    await waitForCalm(watched);
    await shoot(watched, 'section-5-small-view');
    assert.deepEqual(await outOfView(watched), []);
    await watched.keyboard.press('e');
    await watched.setViewportSize({ width: 1440, height: 900 });
    const first = JSON.stringify((await ask(watched, 'section')).cloth);
    await service.post(`/jobs/${id}/resume`);
    await waitFor(watched, (was) => JSON.stringify(window.__toile.section().cloth) !== was, first);
    await service.post(`/jobs/${id}/cancel`);
    await waitForState(watched, 'cancelled');
    await shoot(watched, 'section-4-live');
    assert.deepEqual(watched.complaints, []);
  });

  it('has complained of nothing', () => assert.deepEqual(page.complaints, []));
});
