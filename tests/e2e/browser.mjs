// Debian's Chromium, without a screen and without a graphics card, and what the tests ask of a page.

import { mkdirSync } from 'node:fs';
import { createRequire } from 'node:module';
import { join } from 'node:path';
import { root } from './service.mjs';

const { chromium } = createRequire(join(root, 'web/package.json'))('playwright-core');

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
  return chromium.launch({ executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium', args: flags, headless: true });
}

/** A page that remembers what its scripts complained of. */
export async function openPage(browser, url, options = {}) {
  const page = await browser.newPage({ viewport: { width: 1440, height: 900 }, colorScheme: 'light', ...options });
  page.complaints = [];
  page.on('pageerror', (error) => page.complaints.push(error.message));
  page.on('console', (message) => {
    // While the server is away the browser itself logs each failed request.
    if (message.type() === 'error' && !/Failed to load resource|WebSocket connection/.test(message.text()))
      page.complaints.push(message.text());
  });
  await page.goto(url);
  return page;
}

export const shoot = (page, name) => page.screenshot({ path: join(pictures, `${name}.png`) });

/** Calls a function of the page's test hook. */
export const ask = (page, name) => page.evaluate((key) => window.__toile[key](), name);

export const waitFor = (page, condition, timeout = 60_000, argument = undefined) =>
  page.waitForFunction(condition, argument, { timeout, polling: 50 });

export const waitForState = (page, state, timeout = 120_000) =>
  page.waitForFunction((wanted) => window.__toile.job()?.state === wanted, state, { timeout, polling: 50 });
