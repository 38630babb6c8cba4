// Tests that build on each other, and how long they wait. Nothing here is measured against the clock: a bound is only
// there so that what never comes ends, and is far beyond what the slowest machine with other work on it needs.

import { it } from 'node:test';

/** For one thing to come, ms; whoever writes a test says less. */
export const kPatience = Number(process.env.TOILE_PATIENCE_MS ?? 300_000);
/** For all that a step waits for. */
const kStep = 3 * kPatience;

/** Makes tests of one order: once one has failed, `look` is called and those after it are not tried. */
export function steps(look) {
  let fallen = '';
  return (name, body) =>
    it(name, { timeout: kStep }, async (test) => {
      if (fallen) return test.skip(`"${fallen}" failed`);
      fallen = name;
      try {
        await body();
      } catch (error) {
        await look();
        throw error;
      }
      fallen = '';
    });
}

/** Resolves once `look` gives something true. */
export async function until(look, what) {
  const end = performance.now() + kPatience;
  while (!(await look())) {
    if (performance.now() > end) throw new Error(`it never came: ${what}`);
    await new Promise((done) => setTimeout(done, 50));
  }
}
