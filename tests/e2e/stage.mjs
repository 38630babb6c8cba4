// What every file of tests begins and ends with: a server, a browser over it, and tests that build on each other.

import { before } from 'node:test';
import { closeAfter, openBrowser, openPage, shootAll, waitForState } from './browser.mjs';
import { Service } from './service.mjs';
import { kPatience, steps } from './steps.mjs';

/**
 * Starts both before the tests of a file and ends them after. `begin` is awaited with the stage before the first test. Of
 * the stage: the service, the browser once it is there, and `it`, which shows all pages where a test fails.
 */
export function setStage({ service = new Service(), begin = async () => {} } = {}) {
  const stage = { service, browser: undefined, it: steps(() => shootAll(stage.browser)) };
  before(
    async () => {
      await service.start();
      stage.browser = await openBrowser();
      await begin(stage);
    },
    { timeout: kPatience },
  );
  closeAfter(() => stage.browser, service);
  return stage;
}

/** A page at the newest drape, once that has ended well. `options` as of openPage. */
export async function openNewest({ service, browser }, options) {
  const { jobs } = await (await service.get('/jobs')).json();
  const page = await openPage(browser, `${service.url}/#/jobs/${jobs[0].id}`, options);
  await waitForState(page, 'succeeded');
  return page;
}
