// What the page asks of the service is in proto/openapi.yaml. (What it takes and gets is held against it by the types.)

import { parseYaml } from '@redocly/openapi-core';
import { describe, expect, it } from 'vitest';
import openapi from '../../proto/openapi.yaml?raw';
import { makeApi } from '../src/api/Api';
import { makeDressingApi } from '../src/api/dressing';
import { Http } from '../src/api/http';
import { makeSharedApi } from '../src/api/links';
import { projectOf } from './fakes';

interface Parameter {
  $ref?: string;
  name: string;
  in: string;
}
interface Contract {
  paths: Record<string, Record<string, { parameters?: Parameter[] }>>;
  components: { parameters: Record<string, Parameter> };
}
type Call = (...given: unknown[]) => unknown;

const contract = parseYaml(openapi) as Contract;

/** What is asked where an argument is a part of the address and may not be any word. */
const kChosen: Record<string, unknown[][]> = {
  turn: [
    ['p_1', 1, 'undo'],
    ['p_1', 1, 'redo'],
  ],
  act: [
    ['j_1', 'pause'],
    ['j_1', 'resume'],
    ['j_1', 'cancel'],
  ],
  sweepUrl: [
    ['s_1', 'table.csv'],
    ['s_1', 'sheet.png'],
  ],
};

/** The requests of all functions of an API, as "POST /api/v1/jobs"; `first` is their first argument. */
async function requestsOf(make: (http: Http) => object, first: unknown): Promise<string[]> {
  const asked: string[] = [];
  const http = new Http('/api/v1', (url, init) => {
    asked.push(`${init?.method ?? 'GET'} ${url}`);
    return Promise.reject(new Error('nobody is there'));
  });
  for (const [name, call] of Object.entries(make(http)) as [string, Call][]) {
    for (const given of kChosen[name] ?? [[first, 'one', 'two', 'three']]) {
      const answer = await Promise.resolve(call(...given)).catch(() => null);
      // An address, for an image, a link or a WebSocket.
      if (typeof answer === 'string') asked.push(`GET ${answer.replace(/^ws:\/\/[^/]*/, '')}`);
    }
  }
  return asked;
}

/** The parameters that stand beside the methods of an address. */
const ofAll = (item: object): Parameter[] => ('parameters' in item ? (item.parameters as Parameter[]) : []);

/** The operation that a request is one of, and the parameters it names that the operation does not have. */
function described(request: string): { operation: string | null; strange: string[] } {
  const [method, address] = request.split(' ') as [string, string];
  const url = new URL(address, 'http://localhost');
  for (const [path, item] of Object.entries(contract.paths)) {
    const operation = item[method.toLowerCase()];
    if (!operation || !new RegExp(`^${path.replace(/{\w+}/g, '[^/]+')}$`).test(url.pathname)) continue;
    const known = [...ofAll(item), ...(operation.parameters ?? [])]
      .map((one) => (one.$ref ? contract.components.parameters[one.$ref.split('/').at(-1)!]! : one))
      .filter((one) => one.in === 'query')
      .map((one) => one.name);
    const strange = [...url.searchParams.keys()].filter((name) => !known.includes(name));
    return { operation: `${method} ${path}`, strange };
  }
  return { operation: null, strange: [] };
}

describe('the contract', () => {
  it('describes every request that the page makes', async () => {
    const asked = [
      ...(await requestsOf(makeApi, 'first')),
      ...(await requestsOf(makeDressingApi, 'first')),
      ...(await requestsOf(makeSharedApi, 'first')),
      ...(await requestsOf(makeDressingApi, projectOf())),
    ];
    expect(asked.length).toBeGreaterThan(30);
    expect(asked.filter((request) => described(request).operation === null)).toEqual([]);
    expect(asked.filter((request) => described(request).strange.length > 0)).toEqual([]);
  });
});
