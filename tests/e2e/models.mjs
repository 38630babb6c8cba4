// Khronos's validator over the models that a drape leaves.

import assert from 'node:assert/strict';
import { createRequire } from 'node:module';
import { join } from 'node:path';

import { root } from './service.mjs';

const validator = createRequire(join(root, 'web/package.json'))('gltf-validator');

/** Fails where a .glb breaks a rule of glTF 2.0; `bytes` is a Uint8Array. */
export async function assertValidGlb(bytes) {
  const { issues, info } = await validator.validateBytes(bytes);
  const told = JSON.stringify(issues.messages.filter((message) => message.severity < 2));
  assert.deepEqual([issues.numErrors, issues.numWarnings], [0, 0], told);
  assert.ok(info.totalTriangleCount > 0);
}
