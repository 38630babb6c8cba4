// Versions of a project in a real browser over the real server: a state is named, the pattern changed and named again, the
// first one come back to and draped, undone with a key. Screenshots are kept in out/e2e. The tests build on each other.

import assert from 'node:assert/strict';
import { describe } from 'node:test';
import { ask, shoot, waitFor, waitForState } from './browser.mjs';
import { openNewest, setStage } from './stage.mjs';

let page;
const { service, it } = setStage({
  begin: async (stage) => (page = await openNewest(stage, { viewport: { width: 1280, height: 800 } })),
});

const list = () => page.getByRole('region', { name: 'Versions' });
const line = (name) => list().getByRole('listitem').filter({ hasText: name });
const lengthField = () => page.getByRole('textbox', { name: /^Length/ }).first();
const revision = async () => (await ask(page, 'project')).revision;

async function keepAs(name) {
  await list().getByRole('textbox', { name: 'Name of this state' }).fill(name);
  await page.keyboard.press('Enter');
  await line(name).getByText('as it is now').waitFor();
}

describe('versions', () => {
  it('are named, with the drape that was made of them', async () => {
    await page.getByRole('tab', { name: 'Pattern' }).click();
    await keepAs('As drawn');
    await line('As drawn').getByRole('link', { name: /Done/ }).waitFor();
    await page.locator('.rail').getByText(/Done · As drawn/).waitFor();
    await shoot(page, 'versions-1-named');
  });

  it('stay when the pattern is changed, and a name is taken once', async () => {
    const before = await revision();
    await page.locator('.piece-cloth').first().click();
    await page.locator('.edge-chips button').first().click();
    await lengthField().fill(String(Number(await lengthField().inputValue()) + 30));
    await lengthField().press('Enter');
    await waitFor(page, (was) => window.__toile.project().revision > was, before);
    await line('As drawn').getByRole('button', { name: 'Go back to As drawn' }).waitFor();
    await list().getByRole('textbox').fill('As drawn');
    await page.keyboard.press('Enter');
    await list().getByRole('alert').getByText('versions.taken').waitFor();
    await keepAs('Longer');
    await list().scrollIntoViewIfNeeded();
    await shoot(page, 'versions-2-changed');
  });

  it('are come back to, draped, and left again by undo', async () => {
    await page.keyboard.press('Escape');
    const before = await revision();
    await line('As drawn').getByRole('button', { name: 'Go back to As drawn' }).click();
    await waitFor(page, (was) => window.__toile.project().revision > was, before);
    await line('As drawn').getByText('as it is now').waitFor();
    const old = await ask(page, 'job');
    assert.equal(await page.getByText('The project has changed since this drape.').count(), 0);
    await page.getByRole('button', { name: 'Drape again' }).click();
    await waitFor(page, (id) => window.__toile.job().id !== id, old.id);
    await waitForState(page, 'succeeded');
    const { versions } = await (await service.get(`/projects/${old.project_id}/versions`)).json();
    const [longer, drawn] = versions;
    assert.deepEqual([longer.jobs, drawn.jobs], [[], [(await ask(page, 'job')).id, old.id]]);
    await page.getByRole('tab', { name: 'Pattern' }).click();
    await line('As drawn').getByRole('link').nth(1).waitFor();
    await shoot(page, 'versions-3-back');
    const back = await revision();
    await page.locator('.plane').press('Control+z');
    await waitFor(page, (was) => window.__toile.project().revision > was, back);
    await line('Longer').getByText('as it is now').waitFor();
  });

  it('are removed after a question', async () => {
    await line('Longer').getByRole('button', { name: /Remove/ }).click();
    await line('Longer').getByText('Remove?').click();
    await line('Longer').waitFor({ state: 'detached' });
    assert.deepEqual(page.complaints, []);
  });
});
