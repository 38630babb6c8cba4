// submit.ts SERVER FOLDER OUT: has FOLDER's project.json draped, waits, and brings every result to OUT. Its types are
// made of proto/openapi.yaml (openapi-typescript; web/src/api/generated/contract.ts is that file): what the contract
// does not say does not compile. Node 18 or later.

import { mkdir, readFile, writeFile } from 'node:fs/promises';
import { join } from 'node:path';
import type { operations } from '../../web/src/api/generated/contract';

type Json<Content> = Content extends { content: { 'application/json': infer Body } } ? Body : never;
type Answer<Name extends keyof operations> = {
  [Status in keyof operations[Name]['responses']]: Status extends 200 | 201 ? Json<operations[Name]['responses'][Status]> : never;
}[keyof operations[Name]['responses']];
type Question<Name extends keyof operations> = operations[Name] extends { requestBody: infer Body } ? Json<Body> : never;

const [server, folder, out] = process.argv.slice(2) as [string, string, string];

async function ask(path: string, init: RequestInit = {}): Promise<Response> {
  const headers = { Authorization: `Bearer ${process.env.TOILE_TOKEN ?? 'none'}`, ...init.headers };
  const response = await fetch(`${server}/api/v1${path}`, { ...init, headers });
  if (!response.ok) throw new Error(`${path}: ${response.status} ${await response.text()}`);
  return response;
}

const get = async <Name extends keyof operations>(path: string): Promise<Answer<Name>> =>
  (await (await ask(path)).json()) as Answer<Name>;

async function post<Name extends keyof operations>(path: string, body: Question<Name>, key: string): Promise<Answer<Name>> {
  const headers = { 'Content-Type': 'application/json', 'Idempotency-Key': key };
  return (await (await ask(path, { method: 'POST', headers, body: JSON.stringify(body) })).json()) as Answer<Name>;
}

async function upload(kind: string, name: string): Promise<string> {
  const headers = { 'Content-Type': 'application/octet-stream' };
  const body = new Uint8Array(await readFile(join(folder, name)));
  const made = await ask(`/assets?kind=${kind}&name=${encodeURIComponent(name)}`, { method: 'POST', headers, body });
  return ((await made.json()) as Answer<'uploadAsset'>).id;
}

type Document = Question<'createProject'>['document'];

async function main(): Promise<number> {
  const document = JSON.parse(await readFile(join(folder, 'project.json'), 'utf8')) as Document;
  const named = new Map<string, string>();
  for (const { from, texture } of document.pieces) {
    if (from) named.set(from.dxf, 'dxf');
    if (texture) named.set(texture.image, 'image');
  }
  for (const { file } of document.bodies ?? []) if (file) named.set(file, 'body');
  const files: Record<string, string> = {};
  for (const [name, kind] of named) files[name] = await upload(kind, name);
  const project = await post<'createProject'>('/projects', { document, files }, String(Date.now()));
  let job: Answer<'showJob'> = await post<'submitJob'>('/jobs', { project_id: project.id }, project.id);
  while (job.state === 'queued' || job.state === 'running' || job.state === 'paused') {
    await new Promise((done) => setTimeout(done, 500));
    job = await get<'showJob'>(`/jobs/${job.id}`);
  }
  await mkdir(out, { recursive: true });
  for (const name of Object.keys(job.results)) {
    const bytes = await (await ask(`/jobs/${job.id}/results/${name}`)).arrayBuffer();
    await writeFile(join(out, name), new Uint8Array(bytes));
  }
  console.log(job.state, job.reason);
  return job.state === 'succeeded' && job.report?.settled ? 0 : 3;
}

process.exit(await main());
