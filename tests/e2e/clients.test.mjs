// The clients of docs/clients against the real server: each has a napkin draped and brings home the same cloth.

import assert from 'node:assert/strict';
import { execFile } from 'node:child_process';
import { existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, describe, it } from 'node:test';
import { promisify } from 'node:util';
import { Service, root } from './service.mjs';
import { kPatience } from './steps.mjs';

const run = promisify(execFile);
const service = new Service('');
const folder = mkdtempSync(join(tmpdir(), 'toile-clients-'));
const line = (id, from, to) => ({ id, points: [from, to] });
const napkin = (maxTime) => ({
  toile: 1,
  name: 'Napkin',
  pieces: [
    {
      id: 'napkin',
      outline: [
        line('south', [0, 0], [300, 0]),
        line('east', [300, 0], [300, 300]),
        line('north', [300, 300], [0, 300]),
        line('west', [0, 300], [0, 0]),
      ],
      fabric: 'poplin',
      placement: { rigid: { translation: [-0.15, 0.52, 0.15], rotation: [-90, 0, 0] } },
    },
  ],
  seams: [],
  bodies: [{ id: 'post', file: 'post.obj', unit: 'm' }],
  settings: { particle_distance_mm: 25, sew_time_s: 0, max_time_s: maxTime },
});
const kPost =
  'v -0.1 0 -0.1\nv 0.1 0 -0.1\nv 0.1 0 0.1\nv -0.1 0 0.1\nv -0.1 0.5 -0.1\nv 0.1 0.5 -0.1\nv 0.1 0.5 0.1\nv -0.1 0.5 0.1\n' +
  'f 1 2 3 4\nf 8 7 6 5\nf 1 5 6 2\nf 2 6 7 3\nf 3 7 8 4\nf 4 8 5 1\n';

const clients = {
  'submit.sh': ['sh', join(root, 'docs/clients/submit.sh')],
  'submit.py': ['python3', join(root, 'docs/clients/submit.py')],
  'submit.ts': [process.execPath, join(root, 'web/node_modules/vite-node/vite-node.mjs'), join(root, 'docs/clients/submit.ts')],
};

/** With its exit code in place of an error for one. */
const outcome = async ([program, ...given], out) => {
  try {
    return { code: 0, ...(await run(program, [...given, service.url, folder, out], { cwd: root, timeout: kPatience })) };
  } catch (error) {
    return error;
  }
};

before(async () => {
  writeFileSync(join(folder, 'post.obj'), kPost);
  await service.start();
}, { timeout: kPatience });

after(async () => {
  await service.stop();
  rmSync(folder, { recursive: true });
});

describe('clients', () => {
  const hashes = new Set();

  for (const [name, command] of Object.entries(clients)) {
    it(`${name} has a project draped and brings its results home`, { timeout: kPatience }, async () => {
      writeFileSync(join(folder, 'project.json'), JSON.stringify(napkin(8)));
      const out = join(folder, name);
      const { code, stdout, stderr } = await outcome(command, out);
      assert.equal(code, 0, stderr);
      assert.match(stdout, /succeeded/);
      hashes.add(JSON.parse(readFileSync(join(out, 'report.json'))).hash);
      assert.ok(existsSync(join(out, 'front.png')));
    });

    it(`${name} says by its exit code that a drape has not settled`, { timeout: kPatience }, async () => {
      writeFileSync(join(folder, 'project.json'), JSON.stringify(napkin(0.02)));
      assert.notEqual((await outcome(command, join(folder, `${name}-short`))).code, 0);
    });

    it(`${name} fails where the project is wrong`, { timeout: kPatience }, async () => {
      writeFileSync(join(folder, 'project.json'), JSON.stringify({ ...napkin(8), colour: 'red' }));
      const { code, stdout, stderr } = await outcome(command, join(folder, `${name}-wrong`));
      assert.notEqual(code, 0);
      assert.match(stdout + stderr, /unknown_key|422|400/);
    });
  }

  it('bring home the same cloth', () => assert.equal(hashes.size, 1));
});
