// The page's types as they follow from proto/openapi.yaml and proto/asyncapi.yaml.

import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { bundle, createConfig, parseYaml } from '@redocly/openapi-core';
import openapiTS, { astToString } from 'openapi-typescript';

const proto = new URL('../../proto/', import.meta.url);

/** Where the types are kept. */
export const typesFile = new URL('../src/api/generated/contract.ts', import.meta.url);

const heading = `// Made from proto/openapi.yaml and proto/asyncapi.yaml by "npm run generate"; "npm run check" fails when it is out
// of date. The names that the page uses stand in ../types.ts.

`;

/** openapi.yaml with all that it refers to in other files among its components. */
async function bundledOpenapi() {
  const ref = fileURLToPath(new URL('openapi.yaml', proto));
  const { bundle: whole } = await bundle({ ref, config: await createConfig({}) });
  // What is used of a JSON schema's definitions has become components; left there, they would be taken for a property.
  for (const schema of Object.values(whole.parsed.components.schemas)) delete schema.$defs;
  return whole.parsed;
}

/** asyncapi.yaml's schemas; what they take from openapi.yaml is "here". */
function messageSchemas() {
  const asyncapi = readFileSync(new URL('asyncapi.yaml', proto), 'utf8');
  return parseYaml(asyncapi.replaceAll('openapi.yaml#/', '#/')).components.schemas;
}

/** One OpenAPI document of both: openapi-typescript reads no AsyncAPI. */
async function wholeContract() {
  const contract = await bundledOpenapi();
  const { schemas } = contract.components;
  for (const [name, schema] of Object.entries(messageSchemas())) {
    if (name in schemas) throw new Error(`openapi.yaml and asyncapi.yaml both have a schema ${name}`);
    schemas[name] = schema;
  }
  return contract;
}

/** The text of `typesFile`. */
export async function typesText() {
  const tree = await openapiTS(await wholeContract(), {
    arrayLength: true, // [x, y] and [x, y, z] are tuples
    defaultNonNullable: false, // what has a default may be left out
  });
  return heading + astToString(tree);
}
