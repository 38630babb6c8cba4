// npm run check: the contract keeps the rules of proto/redocly.yaml, as "redocly lint" would say, and the page's types are
// those that follow from it. Asks nothing of the network.

import { existsSync, readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { formatProblems, getTotals, lint, loadConfig } from '@redocly/openapi-core';
import { typesFile, typesText } from './types.mjs';

const inProto = (name) => fileURLToPath(new URL(`../../proto/${name}`, import.meta.url));

/** How many problems a file has; they are written on stderr. */
async function problemsOf(name, config) {
  const problems = await lint({ ref: inProto(name), config });
  if (problems.length > 0) formatProblems(problems, { format: 'stylish', totals: getTotals(problems), version: '' });
  return problems.length;
}

const config = await loadConfig({ configPath: inProto('redocly.yaml') });
for (const name of ['openapi.yaml', 'asyncapi.yaml'])
  if ((await problemsOf(name, config)) > 0) process.exitCode = 1;

const kept = existsSync(typesFile) ? readFileSync(typesFile, 'utf8') : '';
if (kept !== (await typesText())) {
  console.error(`${fileURLToPath(typesFile)} is not what follows from proto/: npm run generate makes it anew`);
  process.exitCode = 1;
}
