// Free-range sewing in a real browser over the real server: a skirt gets a slit, because its side is sewn for a part only,
// and is draped so. Screenshots are kept in out/e2e. The tests build on each other, in this order.

import assert from 'node:assert/strict';
import { describe } from 'node:test';
import { ask, openPage, shoot, waitFor, waitForCalm, waitForState } from './browser.mjs';
import { setStage } from './stage.mjs';
import { steps } from './steps.mjs';

const kDesk = { viewport: { width: 1280, height: 800 } };
const kPhone = { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true };
let browser, page, project;

const { service, it } = setStage({
  begin: async (stage) => {
    browser = stage.browser;
    project = (await (await stage.service.get('/projects')).json()).projects[0].id;
    page = await openPage(browser, `${stage.service.url}/#/projects/${project}`, kDesk);
    await waitForState(page, 'succeeded'); // of the sample
  },
});

const shown = async () => (await service.get(`/projects/${project}`)).json();
const changedFrom = async (revision) => {
  await waitFor(page, (before) => window.__toile.project().revision > before, revision);
  return shown();
};

/** Where an edge is on the page, at a fraction of its length; `aside`: so many pixels beside it. */
const placeOf = (watched, piece, edge, at, aside = 0) =>
  watched.evaluate(
    ([p, e, fraction, off]) => {
      const line = document.querySelector(`.plane [data-piece="${p}"] [data-edge="${e}"] .edge-line`);
      const { x, y } = line.getPointAtLength(fraction * line.getTotalLength()).matrixTransform(line.getScreenCTM());
      return [x + off, y];
    },
    [piece, edge, at, aside],
  );

const moveTo = async (watched, ...place) => watched.mouse.move(...(await placeOf(watched, ...place)), { steps: 6 });
const clickAt = async (watched, ...place) => watched.mouse.click(...(await placeOf(watched, ...place)));
const chip = () => page.locator('.range-chip text');

describe('free-range sewing', () => {
  it('takes a range by two clicks, which meet corners', async () => {
    await waitFor(page, () => window.__toile.project() !== null);
    await page.getByRole('tab', { name: 'Pattern' }).click();
    const first = await shown();
    await page.locator('.seam-main').first().click();
    await page.getByText('Remove seam').click();
    await changedFrom(first.revision);
    await page.keyboard.press('Escape');
    await page.keyboard.press('e');
    await page.locator('.plane-tools').getByText('Fit').click();
    await page.keyboard.press('m');
    await page.getByText('Click where one side begins, and where it ends').waitFor();
    await moveTo(page, 'front', 'side_left', 0.99, 3);
    await chip().getByText('corner').waitFor();
    await clickAt(page, 'front', 'side_left', 0.99, 3);
    await moveTo(page, 'front', 'side_left', 0.5);
    await chip().getByText(/280\.0 mm, middle/).waitFor();
    await shoot(page, 'range-1-first-side');
    await moveTo(page, 'front', 'side_left', 0.35);
    assert.match(await chip().textContent(), /^36\d\.\d mm$/);
    await clickAt(page, 'front', 'side_left', 0.35);
    await page.getByText('Click where the other side begins').waitFor();
  });

  it('meets the first side’s length on the other', async () => {
    await clickAt(page, 'back', 'side_left', 0);
    await moveTo(page, 'back', 'side_left', 0.64);
    await chip().getByText('as long as the other side').waitFor();
    await page.locator('.threads').waitFor();
    await shoot(page, 'range-2-other-side');
    await clickAt(page, 'back', 'side_left', 0.64);
    await page.locator('.pattern-note').getByText('Enter').waitFor();
    await page.locator('.seam-draft').getByText('equal').waitFor();
    await shoot(page, 'range-3-both');
    const before = await shown();
    await page.keyboard.press('Enter');
    const { document } = await changedFrom(before.revision);
    const { a, b, same_direction } = document.seams.at(-1);
    assert.deepEqual([a.length, b.length, same_direction ?? false], [1, 1, false]);
    assert.deepEqual([a[0].edge, b[0].edge], ['side_left', 'side_left']);
    assert.ok(Math.abs(a[0].from - 0.35) < 0.01 && (a[0].to ?? 1) === 1, `${a[0].from}`);
    assert.ok((b[0].from ?? 0) === 0 && Math.abs(b[0].to - (1 - a[0].from)) < 0.0005, `${b[0].to}`);
    await shoot(page, 'range-4-sewn');
  });

  it('goes around a corner by a drag, and is given up with Escape', async () => {
    await page.mouse.move(...(await placeOf(page, 'front', 'hem', 0.3)));
    await page.mouse.down();
    await moveTo(page, 'front', 'hem', 0.1);
    await moveTo(page, 'front', 'side_right', 0.8);
    await page.mouse.up();
    await page.locator('.seam-draft').getByText('front · hem (0–30 %) + front · side_right').waitFor();
    await page.locator('.seam-draft .draft-side').first().click();
    const to = page.getByRole('textbox', { name: /^to mm/ }).first();
    await to.fill('200');
    await to.press('Enter');
    await page.locator('.seam-draft').getByText('front · hem (0–25 %)').waitFor();
    await shoot(page, 'range-5-corner');
    await page.locator('.plane').press('Escape');
    await page.locator('.draft-side').getByText('Click edges on the pieces').nth(1).waitFor();
    await page.locator('.plane').press('e');
  });

  it('leaves a slit in the draped skirt, open below where it is sewn', async () => {
    const old = await ask(page, 'job');
    await page.locator('.plane').press(' ');
    await waitFor(page, (id) => window.__toile.job().id !== id, old.id);
    await waitForState(page, 'succeeded');
    const { id } = await ask(page, 'job');
    const { settled, simulated_s, intersections } = await (await service.get(`/jobs/${id}/results/report.json`)).json();
    assert.deepEqual([settled, intersections.cloth_body, intersections.cloth_cloth], [true, 0, 0]);
    await page.getByRole('tab', { name: 'Result', selected: true }).waitFor();
    await page.locator('.report').getByText(`Settled at ${simulated_s.toFixed(2)} s`).waitFor();
    await page.getByRole('button', { name: 'side view' }).click();
    await waitForCalm(page);
    await shoot(page, 'range-6-slit');
  });

  it('works by touch on a phone', async () => {
    const phone = await openPage(browser, `${service.url}/#/projects/${project}`, kPhone);
    await waitFor(phone, () => window.__toile.project() !== null);
    await phone.getByRole('tab', { name: 'Pattern' }).click();
    await phone.getByRole('button', { name: 'Free sew' }).click();
    await phone.touchscreen.tap(...(await placeOf(phone, 'front', 'hem', 0.2)));
    await phone.touchscreen.tap(...(await placeOf(phone, 'front', 'hem', 0.7)));
    await phone.getByText('Click where the other side begins').waitFor();
    await shoot(phone, 'range-7-phone');
    assert.equal(await phone.evaluate(() => document.documentElement.scrollWidth > innerWidth), false);
    await phone.context().close();
  });

  it('has complained of nothing', () => assert.deepEqual(page.complaints, []));
});
