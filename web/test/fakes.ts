// Stand-ins of the surroundings, driven by the tests by hand.

import type { Clock, Socket } from '../src/api/JobStream';
import type { Job, Progress, Project } from '../src/api/types';

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
  readyState = 0;
  onopen: Socket['onopen'] = null;
  onmessage: Socket['onmessage'] = null;
  onclose: Socket['onclose'] = null;
  onerror: Socket['onerror'] = null;
  sent: string[] = [];
  closedByUs = false;

  constructor(readonly url: string) {}

  send(data: string): void {
    this.sent.push(data);
  }

  close(): void {
    this.closedByUs = true;
  }

  open(): void {
    this.readyState = 1;
    this.onopen?.(undefined as never);
  }

  say(data: object | Uint8Array): void {
    if (data instanceof Uint8Array) this.onmessage?.({ data: data.slice().buffer });
    else this.onmessage?.({ data: JSON.stringify(data) });
  }

  breakOff(code = 1006, reason = ''): void {
    this.readyState = 3;
    this.onclose?.({ code, reason });
  }
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
  ...more,
});

export const jobOf = (more: Partial<Job> = {}): Job => ({
  id: 'j_1',
  project_id: 'p_1',
  project_revision: 1,
  name: 'Skirt',
  state: 'running',
  reason_code: '',
  reason: '',
  reason_where: '',
  attempt: 1,
  created_ms: 1000,
  started_ms: 1100,
  ended_ms: 0,
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
