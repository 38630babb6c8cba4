// The page in a real browser over the real server: what a person does, from the first look to the downloads.
// Screenshots are kept in out/e2e. The tests build on each other, in this order.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { before, describe } from 'node:test';
import {
  ask,
  closeAfter,
  dropFile,
  openBrowser,
  openPage,
  shoot,
  shootAll,
  waitFor,
  waitForCalm,
  waitForMoments,
  waitForStandstill,
  waitForState,
} from './browser.mjs';
import { assertValidGlb } from './models.mjs';
import { checks, shareOfBlue } from './pictures.mjs';
import { Service, root } from './service.mjs';
import { kPatience, steps, until } from './steps.mjs';

const service = new Service();
let browser, page;

const sample = (name) => join(root, 'samples/skirt', name);

/** Vertices of an OBJ text, metres. */
const verticesOf = (obj) => [...obj.matchAll(/^v (\S+) (\S+) (\S+)/gm)].flatMap((line) => line.slice(1).map(Number));

function largestDistance(a, b) {
  let largest = 0;
  for (let i = 0; i < a.length; i += 3)
    largest = Math.max(largest, Math.hypot(a[i] - b[i], a[i + 1] - b[i + 1], a[i + 2] - b[i + 2]));
  return largest;
}

/** Until the page shows these vertices, to a tenth of a millimetre. */
const waitForPositions = (watched, vertices) =>
  until(async () => {
    const shown = await ask(watched, 'positions');
    return shown.length === vertices.length && largestDistance(shown, vertices) <= 1e-4;
  }, 'the cloth as the file has it');

/** The sample's document, with changes. */
const sampleDocument = (more) => ({ ...JSON.parse(readFileSync(sample('project.json'), 'utf8')), ...more });

/** With small steps it moves long enough for pauses, breaks and looks, however fast the machine is. */
function slowDocument() {
  const { settings } = sampleDocument();
  return sampleDocument({ name: 'Slow', settings: { ...settings, time_step_s: 1 / 80000, settle_speed_mm_s: 0.001, max_time_s: 60 } });
}

/** A project of such a document. */
async function makeProject(document) {
  const files = {
    'skirt.dxf': await service.upload('dxf', 'skirt.dxf', readFileSync(sample('skirt.dxf'))),
    'body.obj': await service.upload('body', 'body.obj', readFileSync(sample('body.obj'))),
  };
  return service.post('/projects', { document, files });
}

/** A job as the service has it. */
const jobOf = async (id) => (await service.get(`/jobs/${id}`)).json();

/** The project on the page, with its document, as the service has it. */
async function shownProject() {
  const id = (await ask(page, 'project'))?.id ?? (await ask(page, 'route')).split('/').at(-1);
  return (await service.get(`/projects/${id}`)).json();
}

/** The project once it has come further, and the page shows that. */
async function revisionAfter(revision) {
  await waitFor(page, (before) => window.__toile.project().revision > before, revision);
  return shownProject();
}

/** Runs in a page before its own scripts: counts the frames that it asks for and what it draws in 3D. */
function countDrawing() {
  const counted = (window.__drawing = { frames: 0, pictures: 0 });
  const counting = (owner, name, what) => {
    const own = owner[name];
    owner[name] = function (...given) {
      counted[what] += 1;
      return own.apply(this, given);
    };
  };
  counting(window, 'requestAnimationFrame', 'frames');
  for (const name of ['clear', 'drawArrays', 'drawElements'])
    counting(WebGL2RenderingContext.prototype, name, 'pictures');
}

/** For pages that draw beside others. */
const kSmall = { viewport: { width: 1000, height: 700 } };

let sampleJob;

before(
  async () => {
    await service.start();
    browser = await openBrowser();
    page = await openPage(browser, service.url);
  },
  { timeout: kPatience },
);

closeAfter(() => browser, service);

describe('the page', () => {
  const it = steps(() => shootAll(browser));

  it('says to a newcomer what it is, while the sample is draped as an ordinary job', async () => {
    await page.getByRole('heading', { name: 'See your pattern on a body' }).waitFor();
    await waitFor(page, () => window.__toile.job());
    const { jobs } = await (await service.get('/jobs')).json();
    assert.equal(jobs.length, 1);
    await page.locator('.rail .row').nth(1).waitFor();
    assert.equal(await page.locator('.rail .row').count(), 2);
    await waitFor(page, () => window.__toile.drawn() > 0);
    await shoot(page, '00-start');
    await page.locator('.scene-caption').click();
    await waitFor(page, (id) => window.__toile.route() === `#/jobs/${id}`, jobs[0].id);
    sampleJob = jobs[0].id;
  });

  it('moves the cloth', async () => {
    const slow = await makeProject(slowDocument());
    await page.goto(`${service.url}/#/projects/${slow.id}`);
    await page.getByRole('heading', { name: 'Not draped yet' }).waitFor();
    await page.locator('.actions .primary').click();
    await waitFor(page, () => window.__toile.job()?.state === 'running' && window.__toile.frames() > 0);
    await waitForMoments(page, 10);
    await shoot(page, '01-running');
  });

  it('pauses and goes on with the space bar', async () => {
    await page.locator('body').press(' ');
    await waitForState(page, 'paused');
    await waitForStandstill(page);
    const { id } = await ask(page, 'job');
    const held = { hash: await ask(page, 'positionsHash'), job: await jobOf(id) };
    assert.equal(held.job.state, 'paused');
    await waitForStandstill(page);
    assert.deepEqual({ hash: await ask(page, 'positionsHash'), job: await jobOf(id) }, held);
    await shoot(page, '02-paused');
    await page.locator('.actions').getByText('Resume').click();
    await waitFor(page, (before) => window.__toile.positionsHash() !== before, held.hash);
  });

  it('comes back by itself after the server was killed and started again', async () => {
    const id = (await ask(page, 'job')).id;
    await service.kill();
    await page.locator('.banner').getByText('Connection lost').waitFor();
    await shoot(page, '03-lost');
    assert.notEqual(await ask(page, 'positionsHash'), '', 'the last picture stays');
    await service.start();
    await page.locator('.banner').waitFor({ state: 'detached' });
    assert.equal((await ask(page, 'job')).id, id);
    await waitForState(page, 'running');
    const frames = await ask(page, 'frames');
    await waitFor(page, (before) => window.__toile.frames() > before, frames);
    await page.locator('.actions').getByText('Cancel').click();
    await waitForState(page, 'cancelled');
  });

  it('ends where the report says', async () => {
    await page.goto(`${service.url}/#/jobs/${sampleJob}`);
    await waitForState(page, 'succeeded');
    const { id } = await ask(page, 'job');
    await page.locator('.report').waitFor();
    const final = verticesOf(await (await service.get(`/jobs/${id}/results/final.obj`)).text());
    const report = await (await service.get(`/jobs/${id}/results/report.json`)).json();
    assert.equal(final.length, 3 * report.particles);
    await waitForPositions(page, final);
    assert.match(
      await page.locator('.report').innerText(),
      new RegExp(`Settled at ${report.simulated_s.toFixed(2)} s`),
    );
    assert.ok(report.settled);
  });

  it('shows the stills and offers models, report and pictures with their sizes', async () => {
    const { id } = await ask(page, 'job');
    await waitFor(
      page,
      () =>
        [...document.querySelectorAll('.stills img')].length >= 4 &&
        [...document.querySelectorAll('.stills img')].every((image) => image.naturalWidth > 0),
    );
    const links = await page
      .locator('.downloads a')
      .evaluateAll((all) => all.map((link) => ({ href: link.href, size: link.querySelector('em').textContent })));
    for (const name of [
      'final.glb',
      'final.obj',
      'report.json',
      'front.png',
      'back.png',
      'side.png',
      'three-quarter.png',
    ]) {
      const link = links.find((one) => one.href.endsWith(`/jobs/${id}/results/${name}`));
      assert.ok(link, `${name} is offered`);
      assert.match(link.size, /^[\d.]+ (B|kB|MB)$/);
      const file = await fetch(link.href);
      assert.equal(file.status, 200);
      if (name === 'final.glb') await assertValidGlb(new Uint8Array(await file.arrayBuffer()));
    }
    await page.locator('.rail .thumb img').first().waitFor();
    await waitForCalm(page);
    await shoot(page, '04-result');
    await page.locator('.stills button').first().click();
    await page.locator('dialog.enlarged[open]').waitFor();
    await shoot(page, '05-still');
    await page.keyboard.press('Escape');
    await page.locator('dialog.enlarged').waitFor({ state: 'detached' });
  });

  it('colours the cloth by all its maps, on the flat pieces too', async () => {
    for (const [kind, title] of [
      ['weft', 'Stretch along the weft'],
      ['curvature', 'Curvature'],
      ['pressure', 'Pressure on the skin'],
      ['room', 'Room to the body'],
    ]) {
      await page.getByLabel('Colour the cloth by').selectOption(kind);
      await page.getByRole('figure', { name: title }).waitFor();
      assert.ok((await page.locator('.plane .piece-map path').count()) >= 4, 'each piece has its colours');
      await waitForCalm(page);
      await shoot(page, `07-map-${kind}`);
    }
    const values = Object.values((await ask(page, 'map')).values);
    assert.ok(values.every((mm) => mm >= 0 && mm <= 150));
    await page.locator('.plane [data-piece=front]').hover();
    await page.locator('.map-legend b').getByText(/ mm$/).waitFor();
    await page.getByLabel('Colour the cloth by').selectOption('');
    await page.locator('.map-legend').waitFor({ state: 'detached' });
  });

  it('still has the cloth of an ended drape when it is opened anew', async () => {
    const again = await openPage(browser, page.url());
    await waitFor(again, () => window.__toile.job() && window.__toile.drawn() > 0);
    const { id } = await ask(again, 'job');
    await waitForPositions(again, verticesOf(await (await service.get(`/jobs/${id}/results/final.obj`)).text()));
    await again.close();
  });

  it('sets two drapes side by side with one camera', async () => {
    const { id } = await ask(page, 'job');
    const other = await openPage(browser, `${service.url}/#/compare/${id}/${id}`, kSmall);
    await other.getByText('its vertices lie 0.00 mm apart').waitFor();
    const halves = other.locator('.scene-half canvas');
    assert.equal(await halves.count(), 2);
    const calm = () => waitFor(other, () => document.querySelectorAll('canvas[aria-busy=false]').length === 2);
    const pictures = async () => {
      await calm();
      // Buttons, legend and captions lie over the top and the bottom.
      const middle = async (i) => {
        const { x, y, width, height } = await halves.nth(i).boundingBox();
        const clip = { x: x + 2, y: y + height * 0.3, width: width - 4, height: height * 0.4 };
        return (await other.screenshot({ clip })).toString('base64');
      };
      return [await middle(0), await middle(1)];
    };
    const bothTurn = async (turn) => {
      const before = await pictures();
      await turn();
      await until(async () => (await pictures()).every((picture, i) => picture !== before[i]), 'a turn of both');
    };
    await bothTurn(() => other.getByRole('button', { name: 'back view' }).click());
    await bothTurn(() => halves.first().press('+'));
    await other.getByRole('combobox', { name: 'Colour the cloth by' }).selectOption('warp');
    await other.locator('.map-legend').waitFor();
    await calm();
    await shoot(other, '07-compared');
    assert.deepEqual(other.complaints, []);
    await other.close();
  });

  it('draws nothing while nothing changes, however often it asks the service', async () => {
    const again = await openPage(browser, 'about:blank', kSmall);
    await again.addInitScript(countDrawing);
    await again.goto(page.url());
    await waitFor(again, () => window.__toile?.job() && window.__toile.drawn() > 0 && window.__drawing.pictures > 0);
    const asked = () => again.waitForResponse((response) => response.url().includes('/api/v1/jobs?'));
    const counts = () => again.evaluate(() => ({ ...window.__drawing }));
    let before;
    // What the first answers bring is drawn; how long they take nobody knows. A page that drew for each would never be quiet.
    await until(async () => {
      await waitForCalm(again);
      before = await counts();
      for (let i = 0; i < 3; ++i) await asked();
      const { frames, pictures } = await counts();
      return frames === before.frames && pictures === before.pictures;
    }, 'three questions to the service without a picture');
    await again.keyboard.press('2');
    await waitFor(again, (pictures) => window.__drawing.pictures > pictures, before.pictures);
    await again.close();
  });

  it('draws the cloth of every new start, and tells after what time', async () => {
    const slow = await makeProject(slowDocument());
    await page.goto(`${service.url}/#/projects/${slow.id}`);
    await waitFor(page, (id) => window.__toile.project()?.id === id && !window.__toile.job(), slow.id);
    for (let i = 0; i < 3; ++i) {
      const [there, drawn] = await page.evaluate(async () => {
        const old = window.__toile.job()?.id;
        const drawnBefore = window.__toile.drawn();
        const start = performance.now();
        document.querySelector('.actions .primary').click();
        const until = (condition) =>
          new Promise((done) => {
            const look = () => (condition() ? done(performance.now() - start) : setTimeout(look, 2));
            look();
          });
        const came = await until(() => {
          const job = window.__toile.job();
          return job && job.id !== old && window.__toile.frames() > 0;
        });
        return [came, await until(() => window.__toile.drawn() > drawnBefore)];
      });
      console.log(`# first frame ${there.toFixed(0)} ms after a start, drawn after ${drawn.toFixed(0)} ms`);
      if (i === 0) await shoot(page, '06-sewing');
      await page.locator('.actions').getByText('Cancel').click();
      await waitForState(page, 'cancelled');
    }
    await shoot(page, '07-cancelled');
  });

  it('shows two viewers the same drape at the same step', async () => {
    const slow = await makeProject(slowDocument());
    const first = await openPage(browser, `${service.url}/#/projects/${slow.id}`, kSmall);
    await first.getByRole('heading', { name: 'Not draped yet' }).waitFor();
    await first.keyboard.press(' ');
    await waitFor(first, () => window.__toile.job()?.state === 'running' && window.__toile.frames() > 0);
    const pause = first.locator('.actions').getByText('Pause');
    await pause.click();
    await waitForState(first, 'paused');
    // It comes while nothing moves: without a graphics card, a page that draws leaves little to one that begins.
    const other = await openPage(browser, first.url(), kSmall);
    await waitFor(other, () => window.__toile.frames() > 0);
    const both = [first, other];
    const shown = (one) =>
      one.evaluate(() => `step ${window.__toile.moment().step}: ${window.__toile.positionsHash()}`);
    const seen = new Set();
    for (let i = 0; i < 2; ++i) {
      await Promise.all(both.map((one) => waitForState(one, 'paused')));
      await Promise.all(both.map((one) => waitForStandstill(one)));
      await until(async () => (await shown(first)) === (await shown(other)), 'the same step on both pages');
      seen.add(await shown(first));
      const { step } = await ask(first, 'moment');
      await other.locator('.actions').getByText('Resume').click();
      await Promise.all(both.map((one) => waitFor(one, (before) => window.__toile.moment().step > before, step)));
      await pause.click();
    }
    assert.equal(seen.size, 2);
    await first.locator('.actions').getByText('Cancel').click();
    await waitForState(first, 'cancelled');
    await first.close();
    await other.close();
  });

  it('selects a piece from either side', async () => {
    await page.locator('.plane [data-piece=back] .piece-cloth').press('Enter');
    await page.locator('.plane [data-piece=back] [aria-pressed=true]').waitFor();
    await page.keyboard.press('Escape');
    await page.locator('.plane .selected').waitFor({ state: 'detached' });
    await page.keyboard.press('1');
    await waitForCalm(page);
    const box = await page.locator('.scene canvas').boundingBox();
    await page.mouse.click(box.x + box.width / 2, box.y + box.height / 2);
    await page.locator('.plane [data-piece=front] [aria-pressed=true]').waitFor();
    await waitForCalm(page);
    await shoot(page, '08-selected');
    await page.keyboard.press('Escape');
  });

  it('puts a picture on a piece and on all, in both views, and undoes it', async () => {
    await page.keyboard.press('1');
    await page.getByRole('tab', { name: 'Pattern' }).click();
    await page.locator('.plane [data-piece=front] .piece-cloth').press('Enter');
    const scene = page.locator('.scene canvas');
    const plane = page.locator('.plane');
    await waitForCalm(page);
    const plain = { scene: await shareOfBlue(page, scene), plane: await shareOfBlue(page, plane) };
    const before = await shownProject();
    await page.getByLabel('Picture file').setInputFiles({ name: 'checks.png', mimeType: 'image/png', buffer: checks });
    const first = await revisionAfter(before.revision);
    const texture = { image: 'checks.png', scale_mm: 100, offset: [0, 0], angle: 0 };
    assert.deepEqual(first.document.pieces[0].texture, texture);
    await waitFor(page, () => window.__toile.looks().includes('front'));
    const repeat = page.getByRole('textbox', { name: /^Repeat/ });
    await repeat.fill('40');
    await repeat.press('Enter');
    await revisionAfter(first.revision);
    await page.getByRole('button', { name: 'Same on all pieces' }).click();
    const all = await revisionAfter(first.revision + 1);
    for (const piece of all.document.pieces) assert.equal(piece.texture.scale_mm, 40);
    await waitFor(page, () => window.__toile.looks().length === 4);
    await until(async () => (await shareOfBlue(page, scene)) > plain.scene + 0.05, `blue in 3D beyond ${plain.scene}`);
    await until(async () => (await shareOfBlue(page, plane)) > plain.plane + 0.1, `blue in 2D beyond ${plain.plane}`);
    await shoot(page, '27-picture');
    for (let turn = 0; turn < 3; ++turn) {
      await page.locator('.plane').press('Control+z');
      await revisionAfter(all.revision + turn);
    }
    await waitFor(page, () => window.__toile.looks().length === 0);
    assert.deepEqual((await shownProject()).document, before.document);
    await until(async () => (await shareOfBlue(page, scene)) < plain.scene + 0.02, 'the cloth as it was');
    await page.keyboard.press('Escape');
  });

  it('goes back where it came from, and says so where there is nothing', async () => {
    const at = await ask(page, 'route');
    await page.locator('a.crumb').click();
    await waitFor(page, () => window.__toile.route().startsWith('#/projects/p_'));
    await page.goBack();
    await waitFor(page, (route) => window.__toile.route() === route, at);
    await page.evaluate(() => (location.hash = '#/jobs/j_doesnotexist'));
    await page.getByText('Nothing is here').waitFor();
    await shoot(page, '09-nothing');
    await page.goBack();
    await page.getByText('Nothing is here').waitFor({ state: 'detached' });
  });

  it('reads a DXF that comes alone: pieces, unit, seams, and what became of every entity', async () => {
    await page.locator('.rail .row').first().waitFor();
    await dropFile(page, 'skirt.dxf', readFileSync(sample('skirt.dxf'), 'utf8'));
    await page.locator('.import-preview [data-piece=front]').waitFor();
    assert.equal(await page.locator('.import-preview .piece').count(), 4);
    await page.locator('.import-pieces').getByText('780 × 595 mm').first().waitFor();
    assert.equal(await page.getByRole('radio', { name: 'mm', exact: true }).getAttribute('aria-checked'), 'true');
    await shoot(page, '10-import');
    await page.getByRole('radio', { name: 'cm', exact: true }).click();
    await page.locator('.import-pieces').getByText('7,803 × 5,950 mm').first().waitFor();
    await page.getByText('The largest piece would measure 7,803 mm.').waitFor();
    await page.getByText('back to the guess').click();
    await page.locator('.import-pieces').getByText('780 × 595 mm').first().waitFor();
    await page.getByRole('tab', { name: /^Seams/ }).click();
    assert.ok((await page.locator('.import .proposal input:checked').count()) >= 4, 'sure seams are ticked');
    await page.locator('.import .proposal').first().hover();
    await page.locator('.import-preview .threads').waitFor();
    await shoot(page, '20-import-seams');
    await page.getByRole('tab', { name: /^Report/ }).click();
    await page.getByText('Every one is accounted for.').waitFor();
    await shoot(page, '21-import-report');
  });

  it('makes a project of the DXF with the ticked seams and a mannequin', async () => {
    await page.getByLabel('Name', { exact: true }).fill('From a DXF');
    const ticked = await page
      .locator('.import-side')
      .getByText(/^Seams \d+ of/)
      .innerText();
    await page.locator('.intake footer').getByText('Create', { exact: true }).click();
    await page.locator('.intake').waitFor({ state: 'detached' });
    await page.locator('.plane [data-piece=front]').waitFor();
    const { document } = await shownProject();
    assert.equal(document.name, 'From a DXF');
    assert.equal(document.seams.length, Number(/\d+/.exec(ticked)[0]));
    assert.equal(document.pieces.length, 4);
    assert.equal(
      await page
        .locator('.pattern .plane .seam')
        .evaluateAll((all) => new Set(all.map((one) => one.dataset.seam)).size),
      document.seams.length,
    );
    await shoot(page, '22-project');
  });

  it('edits the outline by hand, each change one step at the service', async () => {
    await page.keyboard.press('e');
    await page.keyboard.press('z');
    await page.locator('.plane [data-piece=front] .piece-cloth').click();
    const grip = page.locator('.plane [data-piece=front] .grip.point').first();
    await grip.waitFor();
    const before = await shownProject();
    const box = await grip.locator('.grip-dot').boundingBox();
    await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
    await page.mouse.down();
    await page.mouse.move(box.x + 40, box.y + 30, { steps: 4 });
    await shoot(page, '23-drag');
    await page.mouse.up();
    await revisionAfter(before.revision);
    const [step] = (await (await service.get(`/projects/${before.id}/edits`)).json()).edits;
    assert.equal(step.edits.length, 1);
    assert.equal(step.edits[0].edit, 'move_point');
    await page.locator('.edge[data-edge]').first().press('Enter');
    const length = page.getByRole('textbox', { name: /^Length/ });
    await length.fill('640,5');
    await length.press('Enter');
    await revisionAfter(before.revision + 1);
    await page.locator('.selection').getByText('Edge').first().waitFor();
    const { pieces } = await (await service.get(`/projects/${before.id}/pieces`)).json();
    assert.ok(pieces.some((piece) => piece.edges.some((edge) => Math.abs(edge.length_mm - 640.5) < 0.01)));
    await shoot(page, '24-edited');
  });

  it('says what the service refuses, and where', async () => {
    const { revision } = await shownProject();
    await page.getByRole('textbox', { name: /^Length/ }).fill('0.05');
    await page.getByRole('textbox', { name: /^Length/ }).press('Enter');
    await page.locator('.pattern-note.bad .code').waitFor();
    assert.match(await page.locator('.pattern-note.bad .code').innerText(), /^\w+\.\w+ · \/edits\/0/);
    assert.equal((await shownProject()).revision, revision);
    await shoot(page, '25-refused');
    await page.locator('.plane').press('Escape');
    await page.locator('.pattern-note.bad').waitFor({ state: 'detached' });
  });

  it('takes the pattern home on paper', async () => {
    const taking = page.getByRole('region', { name: 'Take out the pattern' });
    await taking.getByLabel('Paper of the PDF').selectOption('a3');
    const saved = page.waitForEvent('download');
    await taking.getByRole('link', { name: 'PDF' }).focus();
    await page.keyboard.press('Enter');
    const file = await saved;
    assert.match(file.suggestedFilename(), /\.pdf$/);
    const bytes = readFileSync(await file.path());
    assert.equal(bytes.subarray(0, 5).toString(), '%PDF-');
    assert.match(bytes.toString('latin1'), /MediaBox \[ 0 0 841\.88/, 'A3 is 297 mm wide');
    await shoot(page, '19-pattern-files');
  });

  it('undoes and redoes with the keys', async () => {
    const edited = await shownProject();
    await page.locator('.plane').press('Control+z');
    await revisionAfter(edited.revision);
    await page.locator('.plane').press('Control+z');
    const first = await revisionAfter(edited.revision + 1);
    assert.ok(
      first.document.pieces.every((piece) => piece.from),
      'the pieces are those of the file again',
    );
    await page.locator('.plane').press('Control+Shift+z');
    await revisionAfter(first.revision);
    await page.locator('.plane').press('Control+Shift+z');
    const again = await revisionAfter(first.revision + 1);
    assert.deepEqual(again.document, edited.document);
  });

  it('takes a seam away and sews it again by clicks', async () => {
    const before = await shownProject();
    await page.locator('.seam-main').first().click();
    await page.getByText('Remove seam').click();
    const without = await revisionAfter(before.revision);
    assert.equal(without.document.seams.length, before.document.seams.length - 1);
    const gone = before.document.seams[0];
    await page.locator('.plane').press('Escape');
    await page.locator('.plane').press('n');
    for (const side of ['a', 'b']) {
      for (const { piece, edge } of gone[side])
        await page.locator(`[data-piece="${piece}"] [data-edge="${edge}"]`).press(' ');
      if (side === 'b') await shoot(page, '26-sewing');
      await page.locator('.plane').press('Enter');
    }
    const sewn = await revisionAfter(without.revision);
    const added = sewn.document.seams.at(-1);
    assert.deepEqual(
      [added.a, added.b].map((s) => s.map(({ piece, edge }) => `${piece} ${edge}`)),
      [gone.a, gone.b].map((s) => s.map(({ piece, edge }) => `${piece} ${edge}`)),
    );
    await page.locator('.plane').press('Escape');
    await page.locator('.plane').press('Escape');
    await page.keyboard.press('e');
    await page.locator('.plane').press('o');
  });

  it('takes a GarmentCode specification with its stitches', async () => {
    const panel = (x) => ({
      translation: [x, 0, 0],
      rotation: [0, 0, 0],
      vertices: [
        [0, 0],
        [30, 0],
        [30, 40],
        [0, 40],
      ],
      edges: [0, 1, 2, 3].map((i) => ({ endpoints: [i, (i + 1) % 4] })),
    });
    const stitches = [
      [
        { panel: 'left', edge: 1 },
        { panel: 'right', edge: 3 },
      ],
    ];
    const specification = {
      pattern: { panels: { left: panel(0), right: panel(40) }, stitches },
      properties: { units_in_meter: 100 },
    };
    await page.locator('.intake input[type=file]').setInputFiles({
      name: 'apron.json',
      mimeType: 'application/json',
      buffer: Buffer.from(JSON.stringify(specification)),
    });
    await page.getByRole('tab', { name: 'Seams 1 of 1' }).waitFor();
    await page.locator('.import-pieces').getByText('300 × 400 mm').first().waitFor();
    assert.ok(await page.getByRole('radio', { name: 'inch', exact: true }).isDisabled(), 'it says its unit');
    await page.getByRole('button', { name: 'Remove apron.json' }).click();
    await page.locator('.import').waitFor({ state: 'detached' });
  });

  it('shows the code and the place of a broken file', async () => {
    const broken = {
      name: 'skirt.dxf',
      mimeType: 'image/vnd.dxf',
      buffer: Buffer.from('a letter to the pattern maker, and no drawing\n'),
    };
    await page.locator('.intake input[type=file]').setInputFiles([broken]);
    await page.locator('.intake .problem').waitFor();
    assert.match(await page.locator('.intake .problem .code').innerText(), /^dxf\.\w+ · .*skirt\.dxf/);
    await page.locator('.intake input[type=file]').setInputFiles([
      { name: 'project.json', mimeType: 'application/json', buffer: Buffer.from(JSON.stringify(slowDocument())) },
      { name: 'body.obj', mimeType: 'model/obj', buffer: readFileSync(sample('body.obj')) },
    ]);
    await page.getByText('Everything is there').waitFor();
    await page.locator('.intake footer .primary').click();
    await page.locator('.intake .problem').waitFor();
    assert.match(await page.locator('.intake .problem .code').innerText(), /^dxf\.\w+ · .*skirt\.dxf/);
    await shoot(page, '11-broken-file');
  });

  it('makes a project of dropped files and drapes it', async () => {
    const before = await ask(page, 'route');
    const countProjects = async () => (await (await service.get('/projects')).json()).projects.length;
    const projects = await countProjects();
    await page.locator('.intake input[type=file]').setInputFiles(sample('skirt.dxf'));
    await page.locator('.intake .problem').waitFor({ state: 'detached' });
    await shoot(page, '12-intake');
    await page.locator('.intake footer .primary').click();
    await page.locator('.intake').waitFor({ state: 'detached' });
    await waitFor(
      page,
      (old) => window.__toile.route() !== old && window.__toile.route().startsWith('#/jobs/'),
      before,
    );
    assert.equal(await countProjects(), projects + 1);
    await waitFor(page, () => window.__toile.frames() > 0);
    await page.locator('.actions').getByText('Cancel').click();
    await waitForState(page, 'cancelled');
  });

  it('tells a queued drape its place', async () => {
    const slow = await makeProject(slowDocument());
    const jobs = [];
    for (let i = 0; i < 4; ++i) jobs.push(await service.post('/jobs', { project_id: slow.id }));
    const other = await openPage(browser, `${service.url}/#/jobs/${jobs[3].id}`);
    await other.getByText('In the queue').waitFor();
    await other.getByText('1 drape before it').waitFor();
    await shoot(other, '16-queued');
    await Promise.all(jobs.map((job) => service.post(`/jobs/${job.id}/cancel`)));
    await waitForState(other, 'cancelled');
    await other.close();
  });

  it('says why a drape failed, where, and what to do', async () => {
    const document = sampleDocument({ name: 'Too tight' });
    for (const piece of document.pieces) piece.placement.wrapped.radius = 0.09; // inside the body
    document.settings.start = 'sewn'; // or it would be put on from there
    const project = await makeProject(document);
    const other = await openPage(browser, `${service.url}/#/projects/${project.id}`);
    await other.getByRole('heading', { name: 'Not draped yet' }).waitFor();
    await shoot(other, '17-not-draped');
    await other.keyboard.press(' ');
    await waitForState(other, 'failed');
    const failed = await ask(other, 'job');
    await other.locator('.reason .code').getByText('start.crosses_body').waitFor();
    await waitFor(other, () => window.__toile.start() > 0);
    await waitForCalm(other);
    await shoot(other, '18-failed');
    await other.keyboard.press(' ');
    await other.locator('.notices').getByText('would fail again').waitFor();
    await other.locator('.reason').getByRole('button', { name: 'Arrange anew and drape' }).click();
    await waitFor(other, (id) => window.__toile.project().revision > 1 && window.__toile.job().id !== id, failed.id);
    await other.close();
  });

  it('drapes a sample with one click where there is nothing yet', async () => {
    const empty = new Service('');
    await empty.start();
    const other = await openPage(browser, empty.url);
    const sampleCard = other.getByRole('button', { name: 'T-shirt' });
    await sampleCard.waitFor();
    await waitFor(other, () => [...document.querySelectorAll('.card img')].every((image) => image.naturalWidth > 0));
    await shoot(other, '19-empty');
    await sampleCard.click();
    await waitFor(other, () => window.__toile.job()?.name === 'T-shirt' && window.__toile.frames() > 0);
    await other.close();
    await empty.stop();
  });

  it('can be used by keyboard alone, each control with a name', async () => {
    const nameless = await page
      .locator('button, a, [role=button], [role=tab], [tabindex="0"]')
      .evaluateAll((all) =>
        all
          .filter(
            (one) => !(one.getAttribute('aria-label') || one.getAttribute('aria-labelledby') || one.textContent.trim()),
          )
          .map((one) => one.outerHTML.slice(0, 120)),
      );
    assert.deepEqual(nameless, []);
    await page.locator('.topbar .brand').focus();
    const reached = new Set();
    for (let i = 0; i < 100; ++i) {  // more than there are controls
      await page.keyboard.press('Tab');
      reached.add(
        await page.evaluate(
          () =>
            document.activeElement?.closest(
              '.rail, .scene-tools, .scene-canvas, .plane, .plane-tools, .tabs, .tab-panel, .actions',
            )?.classList[0],
        ),
      );
    }
    for (const region of [
      'rail',
      'scene-canvas',
      'scene-tools',
      'plane',
      'plane-tools',
      'tabs',
      'tab-panel',
      'actions',
    ])
      assert.ok(reached.has(region), `${region} is reached`);
    await page.locator('.topbar .brand').focus(); // a field would take the key for its own
    await page.keyboard.press('?');
    await page.locator('.help').waitFor();
    await shoot(page, '13-keys');
    await page.keyboard.press('Escape');
  });

  it('is dark for those who want it so, and fits a small screen', async () => {
    const done = (await (await service.get('/jobs')).json()).jobs.find((job) => job.state === 'succeeded');
    for (const [name, options] of [
      ['14-dark', { colorScheme: 'dark' }],
      ['15-small', { viewport: { width: 820, height: 1000 } }],
      ['15-phone', { viewport: { width: 390, height: 844 } }],
    ]) {
      const other = await openPage(browser, `${service.url}/#/jobs/${done.id}`, options);
      await waitFor(other, () => window.__toile.drawn() > 0 && document.querySelector('.report'));
      await waitForCalm(other);
      await shoot(other, name);
      const wide = await other.evaluate(() => document.documentElement.scrollWidth > innerWidth);
      assert.equal(wide, false, 'nothing hangs over the edge');
      await other.close();
    }
  });

  it('has complained of nothing', () => {
    assert.deepEqual(page.complaints, []);
  });
});
