// A stand-in of the service for work on the page alone: plays one recorded drape at its own speed. Not shipped, not tested
// against. Usage: npm run mock -- FOLDER, where `toile drape samples/skirt/project.json --out FOLDER --trace FOLDER/t.trace`
// has been run; then TOILE_SERVER=http://127.0.0.1:8090 npm run dev.

import { existsSync, readdirSync, readFileSync, statSync } from 'node:fs';
import { createServer, type IncomingMessage, type ServerResponse } from 'node:http';
import { extname, join } from 'node:path';
import { accept, type MockSocket } from './socket';
import { readRecording } from './recording';

const [folder = 'out/mock', port = '8090', pace = '40'] = process.argv.slice(2);
const root = new URL('..', import.meta.url).pathname;
const recording = readRecording(folder, [0.62, 0.16, 0.14]);
const kFrameMs = Number(pace);
const types: Record<string, string> = {
  '.html': 'text/html',
  '.js': 'text/javascript',
  '.css': 'text/css',
  '.svg': 'image/svg+xml',
  '.png': 'image/png',
  '.json': 'application/json',
};

interface MockJob {
  id: string;
  project_id: string;
  project_revision: number;
  name: string;
  state: string;
  reason_code: string;
  reason: string;
  reason_where: string;
  notes: { code: string; message: string }[];
  attempt: number;
  created_ms: number;
  started_ms: number;
  ended_ms: number;
  results: Record<string, number>;
  at: number;
  viewers: Map<MockSocket, { seq: number; topology: boolean }>;
}

const project = {
  id: 'p_mockmockmockmockmock',
  name: 'A-line skirt',
  revision: 1,
  created_ms: Date.now(),
  updated_ms: Date.now(),
  files: {},
};
const jobs: MockJob[] = [];
const resultsIn = (): Record<string, number> =>
  Object.fromEntries(
    readdirSync(folder)
      .filter((name) => /\.(png|obj|glb|json)$/.test(name))
      .map((name) => [name, statSync(join(folder, name)).size]),
  );

function submit(): MockJob {
  const job: MockJob = {
    id: `j_mock${String(jobs.length).padStart(16, '0')}`,
    project_id: project.id,
    project_revision: 1,
    name: project.name,
    state: 'running',
    reason_code: '',
    reason: '',
    reason_where: '',
    notes: [],
    attempt: 1,
    created_ms: Date.now(),
    started_ms: Date.now(),
    ended_ms: 0,
    results: {},
    at: 0,
    viewers: new Map(),
  };
  jobs.unshift(job);
  const timer = setInterval(() => {
    if (job.state === 'running') job.at += 1;
    if (job.at >= recording.frames.length - 1) end(job, 'succeeded', 'settled');
    for (const viewer of job.viewers.keys()) feed(job, viewer);
    if (job.ended_ms) clearInterval(timer);
  }, kFrameMs);
  return job;
}

function end(job: MockJob, state: string, code: string): void {
  job.at = Math.min(job.at, recording.frames.length - 1);
  Object.assign(job, {
    state,
    reason_code: code,
    ended_ms: Date.now(),
    results: state === 'succeeded' ? resultsIn() : {},
  });
}

function progressOf(job: MockJob): object {
  const frame = recording.frames[job.at]!;
  return {
    state: job.state,
    phase: frame.gap > 1 ? 'sew' : 'drape',
    fraction: job.at / recording.frames.length,
    step: frame.step,
    simulated_s: frame.time,
    rms_speed: frame.speed,
    seam_gap_mm: frame.gap,
    cloth_body: 0,
    cloth_cloth: 0,
    step_ms: 0.71,
  };
}

const shown = ({ at: _, viewers: __, ...job }: MockJob, full = true): object => ({
  ...job,
  progress: full && !job.ended_ms ? progressOf({ ...job, at: _, viewers: __ }) : null,
});

function feed(job: MockJob, viewer: MockSocket): void {
  const had = job.viewers.get(viewer);
  if (!had || viewer.waiting() > 0) return;
  if (!had.topology) viewer.send(recording.topology);
  had.topology = true;
  const frame = recording.frames[job.at]!;
  if (had.seq !== job.at + 1)
    viewer.send(had.seq === job.at && frame.delta && job.at % 30 !== 0 ? frame.delta : frame.key);
  had.seq = job.at + 1;
  viewer.send(JSON.stringify({ type: 'progress', ...progressOf(job) }));
  if (!job.ended_ms) return;
  viewer.send(JSON.stringify({ type: 'ended', ...progressOf(job), job: shown(job) }));
  job.viewers.delete(viewer);
  viewer.close();
}

function act(job: MockJob, verb: string): void {
  if (verb === 'pause' && job.state === 'running') job.state = 'paused';
  else if (verb === 'resume' && job.state === 'paused') job.state = 'running';
  else if (verb === 'cancel' && !job.ended_ms) end(job, 'cancelled', 'cancelled');
}

function bodyBytes(): Buffer {
  const xyz: number[] = [];
  const corners: number[] = [];
  for (const line of readFileSync(new URL('../../samples/skirt/body.obj', import.meta.url), 'utf8').split('\n')) {
    const words = line.trim().split(/\s+/);
    if (words[0] === 'v') xyz.push(...words.slice(1, 4).map(Number));
    if (words[0] === 'f') corners.push(...words.slice(1, 4).map((word) => parseInt(word, 10) - 1));
  }
  return Buffer.concat([
    Buffer.from(new Uint32Array([xyz.length / 3, corners.length / 3]).buffer),
    Buffer.from(new Float32Array(xyz).buffer),
    Buffer.from(new Uint32Array(corners).buffer),
  ]);
}

function pieces(): object {
  const line = (id: string, ...points: number[][]): object => {
    const [[x0, y0], [x1, y1]] = points as [[number, number], [number, number]];
    const at = (t: number): number[] => [x0 + t * (x1 - x0), y0 + t * (y1 - y0)];
    return { id, points, curves: [[0, 1 / 3, 2 / 3, 1].map(at)], length_mm: Math.hypot(x1 - x0, y1 - y0), loop: 0 };
  };
  const panel = (id: string, x: number, names: string[], p: number[][]): object => ({
    id,
    fabric: 'cotton',
    colour: [0.62, 0.16, 0.14],
    grain: [0, 1],
    holes: [],
    notches: [],
    texture: null,
    lines: [],
    outline: p.map(([a, b]) => [a! + x, b]),
    edges: names.map((name, i) =>
      line(name, [p[i]![0]! + x, p[i]![1]!], [p[(i + 1) % p.length]![0]! + x, p[(i + 1) % p.length]![1]!]),
    ),
  });
  const skirt = [
    [-380, -560],
    [380, -560],
    [190, 0],
    [-190, 0],
  ];
  const band = [
    [-190, 40],
    [190, 40],
    [190, 80],
    [-190, 80],
  ];
  const seam = (id: string, a: string[], b: string[]): object => ({
    id,
    a: [{ piece: a[0], edge: a[1] }],
    b: [{ piece: b[0], edge: b[1] }],
    same_direction: false,
    length_a_mm: 0,
    length_b_mm: 0,
    issues: [],
  });
  return {
    pieces: [
      panel('front', 0, ['hem', 'side_left', 'waist', 'side_right'], skirt),
      panel('back', 860, ['hem', 'side_right', 'waist', 'side_left'], skirt),
      panel('band_front', 0, ['skirt', 'end_left', 'top', 'end_right'], band),
      panel('band_back', 860, ['skirt', 'end_right', 'top', 'end_left'], band),
    ],
    seams: [
      seam('side_left', ['front', 'side_left'], ['back', 'side_left']),
      seam('side_right', ['front', 'side_right'], ['back', 'side_right']),
      seam('band_left', ['band_front', 'end_left'], ['band_back', 'end_left']),
      seam('band_right', ['band_front', 'end_right'], ['band_back', 'end_right']),
      seam('waist_front', ['front', 'waist'], ['band_front', 'skirt']),
      seam('waist_back', ['back', 'waist'], ['band_back', 'skirt']),
    ],
  };
}

function answer(response: ServerResponse, status: number, body: object | Buffer, type = 'application/json'): void {
  response.writeHead(status, { 'Content-Type': type }).end(Buffer.isBuffer(body) ? body : JSON.stringify(body));
}

const missing = (response: ServerResponse): void =>
  answer(
    response,
    404,
    { code: 'store.not_found', detail: 'There is nothing of that name.', where: '' },
    'application/problem+json',
  );

function file(response: ServerResponse, path: string): void {
  if (!existsSync(path)) return missing(response);
  answer(response, 200, readFileSync(path), types[extname(path)] ?? 'application/octet-stream');
}

function ofProjects(response: ServerResponse, id: string | undefined, verb: string | undefined): void {
  if (!id) return answer(response, 200, { projects: [project], next: null });
  if (verb === 'pieces') return answer(response, 200, pieces());
  if (verb === 'edits') return answer(response, 200, { edits: [], next: null });
  missing(response);
}

function ofJob(response: ServerResponse, job: MockJob, verb: string | undefined, name: string | undefined): void {
  if (verb === 'body') return answer(response, 200, bodyBytes(), 'application/octet-stream');
  if (verb === 'results' && name) return file(response, join(folder, name));
  if (verb) act(job, verb);
  answer(response, 200, shown(job));
}

function api(request: IncomingMessage, response: ServerResponse, words: string[]): void {
  const [noun, id, verb, name] = words;
  const everything = ['read', 'submit', 'admin'];
  if (noun === 'session') return answer(response, 200, { accounts: false, name: null, scopes: everything, expires_ms: 0 });
  if (noun === 'projects') return ofProjects(response, id, verb);
  if (noun === 'jobs' && !id && request.method === 'POST') return answer(response, 201, shown(submit()));
  if (noun === 'jobs' && !id) return answer(response, 200, { jobs: jobs.map((one) => shown(one)), next: null });
  const job = jobs.find((one) => one.id === id);
  if (job) return ofJob(response, job, verb, name);
  missing(response);
}

const server = createServer((request, response) => {
  const path = new URL(request.url!, 'http://x').pathname;
  if (path.startsWith('/api/v1/')) return api(request, response, path.slice(8).split('/'));
  file(response, join(root, 'dist', path === '/' ? 'index.html' : path));
});
server.on('upgrade', (request: IncomingMessage, wire) => {
  const job = jobs.find((one) => one.id === request.url!.split('/')[4]);
  if (!job) return wire.destroy();
  const viewer = accept(
    request,
    wire,
    (text) => act(job, (JSON.parse(text) as { type: string }).type),
    () => job.viewers.delete(viewer),
  );
  viewer.send(JSON.stringify({ type: 'job', ...shown(job) }));
  job.viewers.set(viewer, { seq: 0, topology: false });
  feed(job, viewer);
});
server.listen(Number(port), '127.0.0.1', () =>
  console.log(`http://127.0.0.1:${port}/ plays ${recording.frames.length} frames`),
);
submit();
