// Stand-ins of the surroundings, driven by the tests by hand.

import type { Api } from '../src/api/Api';
import { ApiError } from '../src/api/http';
import type { Clock, Socket } from '../src/api/JobStream';
import type { Asset, Curve, Job, Piece, Point, Progress, Project, Seam, SeenPiece } from '../src/api/types';
import { straight } from '../src/state/outline';

export class FakeClock implements Clock {
  now = 0;
  private waiting_: { id: number; at: number; what: () => void }[] = [];
  private last_ = 0;

  after(ms: number, what: () => void): number {
    this.waiting_.push({ id: ++this.last_, at: this.now + ms, what });
    return this.last_;
  }

  cancel(id: number): void {
    this.waiting_ = this.waiting_.filter((one) => one.id !== id);
  }

  random(): number {
    return 0.5;
  }

  advance(ms: number): void {
    this.now += ms;
    const due = this.waiting_.filter((one) => one.at <= this.now);
    this.waiting_ = this.waiting_.filter((one) => one.at > this.now);
    for (const one of due) one.what();
  }

  get waiting(): number {
    return this.waiting_.length;
  }
}

export class FakeSocket implements Socket {
  binaryType = '';
  onopen: Socket['onopen'] = null;
  onmessage: Socket['onmessage'] = null;
  onclose: Socket['onclose'] = null;
  onerror: Socket['onerror'] = null;
  closedByUs = false;
  /** What was said to the service. */
  sent: unknown[] = [];

  constructor(readonly url: string) {}

  send(data: string): void {
    this.sent.push(JSON.parse(data));
  }

  close(): void {
    this.closedByUs = true;
  }

  open(): void {
    this.onopen?.(undefined as never);
  }

  say(data: object | Uint8Array): void {
    if (data instanceof Uint8Array) this.onmessage?.({ data: data.slice().buffer });
    else this.onmessage?.({ data: JSON.stringify(data) });
  }

  breakOff(code = 1006, reason = ''): void {
    this.onclose?.({ code, reason });
  }
}

/** Puts one more into a list and hands it on. */
export function kept<T>(list: T[], one: T): T {
  list.push(one);
  return one;
}

export const progressOf = (more: Partial<Progress> = {}): Progress => ({
  state: 'running',
  phase: 'drape',
  fraction: 0.5,
  step: 100,
  simulated_s: 0.1,
  rms_speed: 0.2,
  seam_gap_mm: 0,
  cloth_body: 0,
  cloth_cloth: 0,
  step_ms: 0.7,
  pulls: 0,
  pins: [],
  ...more,
});

export const jobOf = (more: Partial<Job> = {}): Job => ({
  id: 'j_1',
  project_id: 'p_1',
  project_revision: 1,
  priority: 'interactive',
  name: 'Skirt',
  state: 'running',
  reason_code: '',
  reason: '',
  reason_where: '',
  notes: [],
  attempt: 1,
  created_ms: 1000,
  started_ms: 1100,
  ended_ms: 0,
  worked_s: 0,
  results: {},
  progress: null,
  ...more,
});

export const projectOf = (more: Partial<Project> = {}): Project => ({
  id: 'p_1',
  name: 'Skirt',
  revision: 1,
  files: {},
  created_ms: 1,
  updated_ms: 1,
  ...more,
});

export const assetOf = (more: Partial<Asset> = {}): Asset => ({
  id: 'a_1',
  kind: 'body',
  name: 'body.obj',
  size: 1,
  created_ms: 1,
  info: { vertices: 3, triangles: 1, width_m: 1, height_m: 1, depth_m: 1 },
  ...more,
});

const missing = (): Promise<never> => Promise.reject(new ApiError(404, 'store.not_found', 'Not there.'));

/** A service that answers everything; tests put in what they look at. */
export function fakeApi(more: Partial<Api> = {}): Api {
  return {
    session: async () => ({ accounts: false, name: null, scopes: ['read', 'submit', 'admin'], expires_ms: 0 }),
    logIn: async () => undefined,
    logInByToken: async () => undefined,
    logOut: async () => undefined,
    projects: async () => [projectOf()],
    project: async () => projectOf(),
    createProject: async () => projectOf({ id: 'p_new', name: 'New' }),
    removeProject: async () => undefined,
    removeJob: async () => undefined,
    pieces: async () => ({ pieces: [], seams: [] }),
    edit: async (id, revision) => projectOf({ id, revision: revision + 1 }),
    turn: async (id, revision) => projectOf({ id, revision: revision + 1 }),
    history: async () => [],
    proposals: async () => [],
    importPattern: missing,
    layers: async () => [],
    bodies: async () => [],
    images: async () => [],
    fabrics: async () => [],
    bodyPresets: async () => [],
    arrange: async (id, revision) => projectOf({ id, revision: revision + 1 }),
    uploadAsset: async (kind, name) => assetOf({ id: `a_${name}`, kind, name }),
    jobs: async () => [jobOf()],
    job: async () => jobOf(),
    submit: async () => jobOf({ id: 'j_new', state: 'queued', created_ms: 5000 }),
    goOn: async () => jobOf({ id: 'j_next', state: 'queued', project_revision: 2, created_ms: 6000 }),
    act: async (id, action) => jobOf({ id, state: action === 'pause' ? 'paused' : 'running' }),
    seenPieces: async () => ({ pieces: [], fabrics: [] }),
    report: missing,
    resultText: missing,
    body: missing,
    makeMovie: missing,
    movies: async () => [],
    takeStill: missing,
    takenStills: async () => [],
    links: async () => [],
    share: missing,
    revoke: async () => undefined,
    adminAccounts: async () => [],
    adminJobs: async () => [],
    adminLoad: missing,
    lockAccount: async () => undefined,
    sweeps: async () => [],
    versions: async () => [],
    nameVersion: missing,
    restoreVersion: missing,
    removeVersion: async () => undefined,
    sweep: missing,
    submitSweep: missing,
    cancelSweep: missing,
    removeSweep: async () => undefined,
    sweepUrl: (id, file) => `sweeps/${id}/${file}`,
    resultUrl: (id, name) => `${id}/${name}`,
    patternPdfUrl: (id, paper) => `pattern/${id}.pdf?paper=${paper}`,
    patternSvgUrl: (id) => `pattern/${id}.svg`,
    patternDxfUrl: (id) => `pattern/${id}.dxf`,
    assetUrl: (id) => `assets/${id}`,
    streamUrl: (id) => `ws://here/${id}`,
    ...more,
  };
}

/** A piece with straight edges e0, e1, … between its corners. */
export function pieceOf(id: string, corners: Point[]): Piece {
  const edges = corners.map((from, i) => {
    const to = corners[(i + 1) % corners.length]!;
    const curves: Curve[] = [straight(from, to)];
    return {
      id: `e${i}`,
      points: [from, to],
      curves,
      length_mm: Math.hypot(to[0] - from[0], to[1] - from[1]),
      loop: 0,
    };
  });
  return {
    id,
    outline: corners,
    holes: [],
    grain: [0, 1],
    fabric: 'f',
    colour: [1, 1, 1],
    edges,
    notches: [],
    texture: null,
    lines: [],
  };
}

/** A piece as a drape has kept it. */
export const seenOf = (id: string, more: Partial<SeenPiece> = {}): SeenPiece => ({
  id,
  fabric: 'f',
  colour: [1, 1, 1],
  grain: [0, 1],
  texture: null,
  ...more,
});

export const squareOf = (id: string, x: number, y: number, size: number): Piece =>
  pieceOf(id, [
    [x, y],
    [x + size, y],
    [x + size, y + size],
    [x, y + size],
  ]);

export const seamOf = (id: string, a: [string, string], b: [string, string], more: Partial<Seam> = {}): Seam => ({
  id,
  a: [{ piece: a[0], edge: a[1], reversed: false }],
  b: [{ piece: b[0], edge: b[1], reversed: false }],
  same_direction: false,
  length_a_mm: 0,
  length_b_mm: 0,
  issues: [],
  ...more,
});
