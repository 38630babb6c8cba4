// Debian's Chromium, without a screen and without a graphics card, and what the tests ask of a page.

import assert from 'node:assert/strict';
import { mkdirSync, readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { join } from 'node:path';
import { after } from 'node:test';
import { root } from './service.mjs';
import { kPatience } from './steps.mjs';

const packages = createRequire(join(root, 'web/package.json'));
const { chromium } = packages('playwright-core');
const axe = readFileSync(packages.resolve('axe-core/axe.min.js'), 'utf8');

const flags = [
  '--headless=new',
  '--no-sandbox',
  '--disable-quic',
  '--no-first-run',
  '--disable-background-networking',
  '--disable-component-update',
  '--disable-sync',
  '--use-gl=angle',
  '--use-angle=swiftshader',
  '--enable-unsafe-swiftshader',
];
const pictures = join(root, 'out/e2e');

export async function openBrowser() {
  mkdirSync(pictures, { recursive: true });
  const executablePath = process.env.CHROMIUM ?? '/usr/bin/chromium';
  return chromium.launch({ executablePath, args: flags, headless: true, timeout: kPatience });
}

/** A page that remembers what its scripts complained of. It is no first visit, or the tour would lie over what is pressed. */
export async function openPage(browser, url, { firstVisit = false, ...options } = {}) {
  const page = await browser.newPage({ viewport: { width: 1440, height: 900 }, colorScheme: 'light', ...options });
  page.setDefaultTimeout(kPatience);
  if (!firstVisit) await page.addInitScript(seenBefore);
  page.complaints = [];
  page.on('pageerror', (error) => page.complaints.push(error.message));
  page.on('console', (message) => {
    // While the server is away the browser itself logs each failed request.
    if (message.type() === 'error' && !/Failed to load resource|WebSocket connection/.test(message.text()))
      page.complaints.push(message.text());
  });
  await page.goto(url);
  if (!page.url().startsWith('about:')) await begun(page);
  return page;
}

/** Runs in the page before its own scripts; a page without an address keeps nothing. */
function seenBefore() {
  if (location.protocol !== 'about:') localStorage.setItem('toile.tour', 'seen');
}

/** Until the page's own code has run: what it begins with is fetched after the document has come. */
const begun = (page) => page.waitForFunction(() => window.__toile !== undefined, undefined, { polling: 50 });

/** Ends both after the tests of a file. `opened` gives the browser, or nothing when it never came. */
export function closeAfter(opened, service) {
  after(
    async () => {
      await opened()?.close();
      await service.stop();
    },
    { timeout: kPatience },
  );
}

export const shoot = (page, name) => page.screenshot({ path: join(pictures, `${name}.png`) });

/** That nothing on the page keeps people out, in the light and in the dark: axe finds nothing serious. */
export async function assertOpenToAll(page) {
  // Not as a <script>: the page's own policy lets none in.
  if (!(await page.evaluate(() => 'axe' in window))) await page.evaluate(axe);
  for (const colorScheme of ['light', 'dark']) {
    await page.emulateMedia({ colorScheme });
    const found = await page.evaluate(async () => {
      const { violations } = await window.axe.run(document, { resultTypes: ['violations'] });
      return violations
        .filter(({ impact }) => impact === 'serious' || impact === 'critical')
        .map(({ id, nodes }) => `${id}: ${nodes.map((node) => node.target.join(' ')).join('; ')}`);
    });
    assert.deepEqual(found, [], colorScheme);
  }
}

/** What all pages show, for whoever asks why a step failed. */
export async function shootAll(browser) {
  const pages = browser.contexts().flatMap((context) => context.pages());
  for (const [i, page] of pages.entries()) {
    console.log(`# ${page.url()} as failed-${i}.png`);
    await shoot(page, `failed-${i}`).catch(() => undefined);
  }
}

/** Calls a function of the page's test hook. */
export const ask = (page, name) => page.evaluate((key) => window.__toile[key](), name);

/** Until a function of the page gives something true. */
export const waitFor = async (page, condition, argument = undefined) => {
  if (!page.url().startsWith('about:')) await begun(page);
  return page.waitForFunction(condition, argument, { polling: 50 });
};

export const waitForState = (page, state) => waitFor(page, (wanted) => window.__toile.job()?.state === wanted, state);

/** Until the camera of the 3D view has come where it was sent, and all that there is is drawn. */
export const waitForCalm = (page) => page.locator('.scene canvas:not([aria-busy=true])').waitFor();

/** Until the page has shown so many different places of the cloth. */
export const waitForMoments = (page, count) =>
  waitFor(
    page,
    (wanted) => {
      const seen = (window.__moments ??= new Set());
      seen.add(window.__toile.positionsHash());
      return seen.size >= wanted;
    },
    count,
  );

/** Until the cloth is the same in twenty looks, one after the other. */
export async function waitForStandstill(page) {
  await page.evaluate(() => (window.__stand = { hash: '', looks: 0 }));
  await waitFor(page, () => {
    const hash = window.__toile.positionsHash();
    window.__stand = { hash, looks: window.__stand.hash === hash ? window.__stand.looks + 1 : 0 };
    return window.__stand.looks >= 20;
  });
}

/** Drops a file of this name and text on the page, as from a folder. */
export const dropFile = (page, name, text) =>
  page.evaluate(
    ([file, content]) => {
      const dataTransfer = new DataTransfer();
      dataTransfer.items.add(new File([content], file));
      for (const type of ['dragenter', 'dragover', 'drop'])
        window.dispatchEvent(new DragEvent(type, { dataTransfer, bubbles: true, cancelable: true }));
    },
    [name, text],
  );
