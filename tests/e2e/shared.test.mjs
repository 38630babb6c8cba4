// Share links in a real browser over the real server: made by their owner, opened by a stranger on a desk and on a phone,
// live and ended, taken back. Screenshots are kept in out/e2e. The tests build on each other, in this order.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { describe } from 'node:test';
import { ask, openPage, shoot, waitFor, waitForCalm } from './browser.mjs';
import { root } from './service.mjs';
import { openNewest, setStage } from './stage.mjs';
import { until } from './steps.mjs';

const kPhone = { viewport: { width: 390, height: 844 }, colorScheme: 'dark' };
let browser, page, guest, phone, link;

const sample = (name) => join(root, 'samples/skirt', name);

/** A drape that goes on until it is cancelled. */
async function liveJob() {
  const document = JSON.parse(readFileSync(sample('project.json')));
  document.name = 'A slow skirt';
  Object.assign(document.settings, { time_step_s: 1 / 80000, settle_speed_mm_s: 0.001, max_time_s: 60 });
  const files = {
    'skirt.dxf': await service.upload('dxf', 'skirt.dxf', readFileSync(sample('skirt.dxf'))),
    'body.obj': await service.upload('body', 'body.obj', readFileSync(sample('body.obj'))),
  };
  const project = await service.post('/projects', { document, files });
  return service.post('/jobs', { project_id: project.id, priority: 'interactive' });
}

/** Whether nothing sticks out at the side. */
const fits = (watched) => watched.evaluate(() => document.documentElement.scrollWidth <= innerWidth);

const { service, it } = setStage({
  begin: async (stage) => {
    browser = stage.browser;
    page = await openNewest(stage);
  },
});

describe('share links', () => {
  it('are made in the page, and shown once to be copied', async () => {
    await page.getByRole('button', { name: 'Share' }).click();
    await page.getByLabel('3D models (GLB, OBJ)').check();
    await page.getByLabel('For whom').fill('Atelier');
    await shoot(page, 'share-1-wish');
    await page.getByRole('button', { name: 'Make a link' }).click();
    link = await page.getByLabel('The link').inputValue();
    assert.match(link, /\/#\/shared\/toile_[0-9a-f]{64}$/);
    await page.getByText('Atelier').waitFor();
    await shoot(page, 'share-2-link');
    await page.emulateMedia({ colorScheme: 'dark' });
    await shoot(page, 'share-2-link-dark');
  });

  it('show a stranger the cloth, the stills and the figures', async () => {
    guest = await openPage(browser, link);
    await waitFor(guest, () => window.__toile.drawn() > 0);
    await guest.getByText('Take home').waitFor();
    await waitForCalm(guest);
    await guest.waitForFunction(() => [...document.images].every((image) => image.complete && image.naturalWidth > 0));
    await shoot(guest, 'share-3-guest');
    assert.equal(await guest.locator('.stills img').count(), 4);
    assert.ok(await guest.locator('.fit tbody tr').count());
    const asked = await guest.evaluate(() => performance.getEntriesByType('resource').map(({ name }) => new URL(name).pathname));
    const foreign = asked.filter((path) => path.startsWith('/api/') && !path.startsWith('/api/v1/shared'));
    assert.deepEqual(foreign, []);
    assert.equal(asked.filter((path) => path.includes('toile_')).length, 0, 'the secret is in no address');
    assert.deepEqual(guest.complaints, []);
  });

  it('show the stranger the maps that are measured on the page, and no others', async () => {
    const maps = guest.locator('.map-choice');
    assert.deepEqual(await maps.locator('option').evaluateAll((all) => all.map(({ value }) => value)), ['', 'warp', 'weft', 'shear', 'room']);
    await maps.selectOption('room');
    await guest.locator('.map-legend').getByText('mm').waitFor();
    await waitForCalm(guest);
    await shoot(guest, 'share-3b-room');
    await maps.selectOption('');
    await guest.locator('.map-legend').waitFor({ state: 'detached' });
  });

  it('let the stranger take home what is allowed', async () => {
    const href = await guest.getByRole('link', { name: /GLB/ }).getAttribute('href');
    const bytes = await guest.evaluate(async (url) => (await (await fetch(url)).arrayBuffer()).byteLength, href);
    assert.ok(bytes > 10_000);
    const hung = href.replace('final.glb', 'final.hung');
    assert.equal(await guest.evaluate(async (url) => (await fetch(url)).status, hung), 403);
  });

  it('work on a phone, in the dark', async () => {
    phone = await openPage(browser, link, kPhone);
    await waitFor(phone, () => window.__toile.drawn() > 0);
    await phone.getByText('Take home').waitFor();
    await waitForCalm(phone);
    await shoot(phone, 'share-4-phone');
    assert.ok(await fits(phone));
    await phone.getByText('Take home').scrollIntoViewIfNeeded();
    await shoot(phone, 'share-5-phone-below');
  });

  it('tell a stranger when they are taken back', async () => {
    await page.getByRole('button', { name: 'Take back Atelier' }).click();
    await until(async () => (await page.getByRole('button', { name: 'Take back Atelier' }).count()) === 0, 'it is gone');
    await phone.reload();
    await phone.getByRole('heading', { name: 'This link was taken back' }).waitFor();
    await shoot(phone, 'share-6-phone-revoked');
    await guest.goto(`${service.url}/#/shared/toile_${'0'.repeat(64)}`);
    await guest.getByRole('heading', { name: 'This link opens nothing' }).waitFor();
    await shoot(guest, 'share-7-unknown');
  });

  it('show a live drape as it moves, and end with the link', async () => {
    const job = await liveJob();
    const made = await service.post(`/jobs/${job.id}/links`, {});
    await guest.goto(service.url + made.page);
    await waitFor(guest, () => window.__toile.frames?.() > 3);
    await guest.getByText('You see it live').waitFor();
    await waitFor(guest, () => window.__toile.body() === 'ready' && window.__toile.drawn() > 3);
    await shoot(guest, 'share-8-live');
    await service.get(`/links/${made.link.id}`, { method: 'DELETE' });
    await guest.getByRole('heading', { name: 'This link was taken back' }).waitFor();
    assert.equal((await (await service.get(`/jobs/${job.id}`)).json()).state, 'running');
    await service.post(`/jobs/${job.id}/cancel`);
    assert.deepEqual(guest.complaints, []);
    assert.equal(await ask(guest, 'shared'), null);
  });
});
