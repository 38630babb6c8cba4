// The page of whoever runs a service, in a real browser over the real server with accounts: who comes in, what is seen of
// load, people and drapes, and that who is locked out is out at once. Screenshots are kept in out/e2e. The tests build on
// each other, in this order.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { before, describe } from 'node:test';
import { ask, assertOpenToAll, closeAfter, openBrowser, openPage, shoot, shootAll } from './browser.mjs';
import { passwordOf, root, Service } from './service.mjs';
import { kPatience, steps, until } from './steps.mjs';

const kPhone = { width: 390, height: 844 };
const service = new Service('');
const people = ['ben', 'cleo-from-the-cutting-room', 'dora'];
const tokens = new Map();
let browser, page, guest;
const it = steps(() => shootAll(browser));

const sample = (name) => join(root, 'samples/skirt', name);

/** Has somebody drape a skirt that goes on until it is cancelled. */
async function drapeAs(name, title, priority) {
  service.token = tokens.get(name);
  const document = JSON.parse(readFileSync(sample('project.json')));
  document.name = title;
  Object.assign(document.settings, { time_step_s: 1 / 80000, settle_speed_mm_s: 0.001, max_time_s: 60 });
  const files = {
    'skirt.dxf': await service.upload('dxf', 'skirt.dxf', readFileSync(sample('skirt.dxf'))),
    'body.obj': await service.upload('body', 'body.obj', readFileSync(sample('body.obj'))),
  };
  const project = await service.post('/projects', { document, files });
  return (await service.post('/jobs', { project_id: project.id, priority })).id;
}

before(
  async () => {
    tokens.set('anna', service.addAccount('anna', { flags: ['--admin'], scopes: 'read,submit,admin' }));
    for (const name of people) tokens.set(name, service.addAccount(name));
    await service.start();
    browser = await openBrowser();
  },
  { timeout: kPatience },
);
closeAfter(() => browser, service);

/** The page's door: a name and its password. */
async function logIn(watched, name, password = passwordOf(name)) {
  await watched.getByRole('dialog', { name: 'Log in' }).waitFor();
  await watched.getByLabel('Name').fill(name);
  await watched.getByLabel('Password').fill(password);
  await watched.getByRole('dialog').getByRole('button', { name: 'Log in' }).click();
}

const region = (name) => page.getByRole('region', { name, exact: true });
/** A row of a table by what stands at its head. */
const row = (table, head) => region(table).getByRole('row').filter({ has: page.getByRole('rowheader', { name: head }) });
/** Whether nothing sticks out at the side. */
const fits = () => page.evaluate(() => document.documentElement.scrollWidth <= innerWidth);

describe('the service for whoever runs it', () => {
  it('lets in who says the right password, and says so of a wrong one', async () => {
    page = await openPage(browser, `${service.url}/#/admin`);
    await logIn(page, 'anna', 'not hers');
    await page.getByRole('alert').waitFor();
    await assertOpenToAll(page);
    assert.equal(await page.getByRole('alert').count(), 1, 'nothing is said twice');
    await shoot(page, 'admin-1-door-dark');
    await logIn(page, 'anna');
    await page.getByRole('heading', { name: 'The service' }).waitFor();
    await page.getByText('Nothing is draped, and nothing waits.').waitFor();
    await assertOpenToAll(page);
    await page.emulateMedia({ colorScheme: 'light' });
    await shoot(page, 'admin-2-quiet');
  });

  it('shows whose drapes are under way and wait, as they come', async () => {
    await drapeAs('ben', 'Wool skirt, second toile', 'interactive');
    await drapeAs('cleo-from-the-cutting-room', 'Panelled skirt with a long hem for the autumn show', 'batch');
    await drapeAs('dora', 'Skirt', 'batch');
    const drapes = region('Drapes that have not ended');
    await drapes.getByRole('rowheader', { name: 'Skirt', exact: true }).waitFor();
    assert.equal(await drapes.getByRole('row').count(), 4);
    await row('Drapes that have not ended', 'Wool skirt').getByText('Running').waitFor();
    await row('Drapes that have not ended', 'Wool skirt').getByText('ben').waitFor();
    await shoot(page, 'admin-3-busy');
    await assertOpenToAll(page);
    await shoot(page, 'admin-3-busy-dark');
  });

  it('is read on a phone', async () => {
    await page.setViewportSize(kPhone);
    await page.getByRole('button', { name: 'Project list', exact: true }).click();
    await shoot(page, 'admin-4-phone-dark');
    await page.emulateMedia({ colorScheme: 'light' });
    await shoot(page, 'admin-4-phone');
    assert.ok(await fits());
    await region('Drapes that have not ended').scrollIntoViewIfNeeded();
    await shoot(page, 'admin-5-phone-below');
    await assertOpenToAll(page);
    await page.emulateMedia({ colorScheme: 'light' });
    await page.setViewportSize({ width: 1440, height: 900 });
  });

  it('shuts somebody out at once, and lets them in again', async () => {
    const stranger = await browser.newContext();
    guest = await openPage(stranger, service.url);
    await logIn(guest, 'ben');
    await guest.getByText('Wool skirt, second toile').first().waitFor();
    assert.equal(await guest.getByRole('link', { name: 'Service' }).count(), 0);
    await page.getByRole('button', { name: 'Lock out: ben' }).click();
    await row('Accounts', 'ben').getByText('locked out').waitFor();
    await guest.getByText('You are logged out.').waitFor();
    await shoot(page, 'admin-6-locked');
    await shoot(guest, 'admin-7-shut-out');
    await page.getByRole('button', { name: 'Let in again: ben' }).click();
    await page.getByRole('button', { name: 'Lock out: ben' }).waitFor();
    await guest.reload();
    await guest.getByText('Wool skirt, second toile').first().waitFor();
  });

  it('is nobody else’s', async () => {
    await guest.goto(`${service.url}/#/admin`);
    await guest.getByText('ben is none of them').waitFor();
    await shoot(guest, 'admin-8-not-yours');
    await assertOpenToAll(guest);
  });

  it('comes back by itself after the service was away', async () => {
    await service.kill();
    await page.locator('.banner').getByText('Connection lost').waitFor();
    await shoot(page, 'admin-9-away');
    await service.start();
    await page.locator('.banner').waitFor({ state: 'detached' });
    await row('Drapes that have not ended', 'Wool skirt').waitFor();
    const shown = async () => (await ask(page, 'route')) === '#/admin';
    await until(shown, 'the address stays');
  });

  it('has complained of nothing', () => assert.deepEqual([...page.complaints, ...guest.complaints], []));
});
