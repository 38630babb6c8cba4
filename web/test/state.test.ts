import { describe, expect, it } from 'vitest';
import type { ClothTopology } from '../src/api/frames';
import { AppState, ready } from '../src/state/AppState';
import {
  activity,
  commandsOf,
  jobAtHome,
  newestJobOf,
  overall,
  placeInQueue,
  thumbnailOf,
} from '../src/state/jobs';
import { kRestingTool } from '../src/state/editing';
import { LiveCloth, positionsHash } from '../src/state/LiveCloth';
import { formatRoute, parseRoute } from '../src/state/routes';
import { ago, bytes, duration, sentence, speed } from '../src/state/words';
import { jobOf, progressOf, projectOf } from './fakes';

describe('routes', () => {
  it('read what they write', () => {
    for (const hash of ['#/', '#/projects/p_abc', '#/jobs/j_0-9_Z', '#/nowhere'])
      expect(formatRoute(parseRoute(hash))).toBe(hash);
    expect(parseRoute('')).toEqual({ name: 'home' });
  });

  it('take nothing for an id that is none', () => {
    for (const hash of ['#/jobs/', '#/jobs/a/b', '#/jobs/../x', '#/jobs/' + 'a'.repeat(65), '#/jobs/<b>'])
      expect(parseRoute(hash).name).toBe('unknown');
  });
});

describe('the state', () => {
  it('begins anew with another project, but for what a person likes', () => {
    const { dressing, editing } = new AppState();
    dressing.picking.value = 'navel';
    dressing.shown.value = 2;
    dressing.unit.value = 'inch';
    editing.tool.value = 'pen';
    editing.offsets.value = new Map([['front', [1, 2]]]);
    editing.large.value = true;
    dressing.clear();
    editing.clear();
    expect([dressing.picking.value, dressing.shown.value, editing.tool.value]).toEqual([null, 0, kRestingTool]);
    expect(editing.offsets.value.size).toBe(0);
    expect([dressing.unit.value, editing.large.value]).toEqual(['inch', true]);
  });

  it('shows the job of the route, and of a project its newest job', () => {
    const state = new AppState();
    state.projects.value = ready([projectOf()]);
    state.jobs.value = ready([
      jobOf({ id: 'j_2', created_ms: 9 }),
      jobOf({ id: 'j_3', created_ms: 12 }),
      jobOf({ id: 'j_4', project_id: 'p_2', created_ms: 20 }),
    ]);
    state.route.value = { name: 'job', id: 'j_2' };
    expect(state.job.value?.id).toBe('j_2');
    expect(state.project.value?.id).toBe('p_1');
    state.route.value = { name: 'project', id: 'p_1' };
    expect(state.job.value?.id).toBe('j_3');
    state.route.value = { name: 'job', id: 'j_9' };
    expect(state.job.value).toBeNull();
  });

  it('believes the stream while a job runs, and the list once it has ended', () => {
    const state = new AppState();
    state.jobs.value = ready([jobOf()]);
    state.route.value = { name: 'job', id: 'j_1' };
    state.watched.value = 'j_1';
    state.progress.value = progressOf({ state: 'paused', step: 777 });
    expect(state.job.value).toMatchObject({ state: 'paused', progress: { step: 777 } });
    state.putJob(jobOf({ state: 'succeeded' }));
    expect(state.job.value?.state).toBe('succeeded');
  });

  it('does not lend one job’s progress to another', () => {
    const state = new AppState();
    state.jobs.value = ready([jobOf(), jobOf({ id: 'j_2', state: 'queued' })]);
    state.watched.value = 'j_1';
    state.progress.value = progressOf();
    state.route.value = { name: 'job', id: 'j_2' };
    expect(state.job.value).toMatchObject({ state: 'queued', progress: null });
  });

  it('keeps its jobs newest first', () => {
    const state = new AppState();
    for (const [id, created_ms] of [
      ['j_1', 5],
      ['j_3', 9],
      ['j_2', 7],
    ] as const)
      state.putJob(jobOf({ id, created_ms }));
    expect(state.allJobs.value.map((job) => job.id)).toEqual(['j_3', 'j_2', 'j_1']);
  });
});

describe('facts about jobs', () => {
  it('allow what the state allows', () => {
    expect(commandsOf('running')).toEqual({ pause: true, resume: false, step: false, cancel: true });
    expect(commandsOf('paused')).toEqual({ pause: false, resume: true, step: true, cancel: true });
    expect(commandsOf('succeeded')).toEqual({ pause: false, resume: false, step: false, cancel: false });
  });

  it('count those before it in the queue', () => {
    const queue = [
      jobOf({ id: 'a', state: 'queued', created_ms: 3 }),
      jobOf({ id: 'b', state: 'queued', created_ms: 1 }),
      jobOf({ id: 'c', state: 'running', created_ms: 0 }),
    ];
    expect(placeInQueue(queue, 'a')).toBe(1);
    expect(placeInQueue(queue, 'b')).toBe(0);
    const atOnce = queue.map((job) => ({ ...job, state: 'queued' as const, created_ms: 5 }));
    expect(['a', 'b', 'c'].map((id) => placeInQueue(atOnce, id))).toEqual([0, 1, 2]);
  });

  it('are seen on the first page while one is under way, or the newest that came to an end', () => {
    const jobs = [
      jobOf({ id: 'a', state: 'succeeded', created_ms: 9 }),
      jobOf({ id: 'b', created_ms: 2 }),
      jobOf({ id: 'c', state: 'failed', created_ms: 10 }),
    ];
    expect(jobAtHome(jobs)?.id).toBe('b');
    expect(jobAtHome([jobs[0]!, jobs[2]!])?.id).toBe('a');
    expect(jobAtHome([jobs[2]!])).toBeNull();
    expect(newestJobOf(jobs, 'p_1')?.id).toBe('c');
  });

  it('say what is going on', () => {
    expect(activity('running', 'sew')).toBe('Sewing');
    expect(activity('paused', 'sew')).toBe('Paused');
  });

  it('never let the progress fall back from one phase to the next', () => {
    const course = ['queued', 'mesh', 'place', 'dress', 'sew', 'drape', 'check', 'stills'].flatMap((phase) =>
      [0, 0.5, 1].map((fraction) => overall(phase, fraction)),
    );
    expect(course.every((value, i) => i === 0 || value >= course[i - 1]!)).toBe(true);
    expect(course[course.length - 1]).toBeCloseTo(1, 9);
    expect([overall('sew', -1), overall('sew', 7)]).toEqual([overall('sew', 0), overall('sew', 1)]);
  });

  it('prefer the small picture', () => {
    expect(thumbnailOf(jobOf({ results: { 'three-quarter.png': 9, 'thumbnail.png': 1 } }))).toBe('thumbnail.png');
    expect(thumbnailOf(jobOf({ results: { 'final.obj': 9 } }))).toBeNull();
  });
});

describe('words', () => {
  it('tell numbers as people do', () => {
    expect([bytes(999), bytes(1500), bytes(262888), bytes(12.34e6)]).toEqual(['999 B', '1.5 kB', '263 kB', '12.3 MB']);
    expect([duration(7.45), duration(59.6), duration(125), duration(7300), duration(-1)]).toEqual([
      '7.5 s',
      '60 s',
      '2 min 5 s',
      '2 h 1 min',
      '–',
    ]);
    expect([sentence('the file ends early'), sentence('Where?'), sentence('')]).toEqual([
      'The file ends early.',
      'Where?',
      '',
    ]);
    expect([speed(0.00297), speed(1.5)]).toEqual(['3.0 mm/s', '1,500 mm/s']);
        expect([ago(0, 1000), ago(0, 120e3), ago(0, 7200e3), ago(0, 3 * 86400e3)]).toEqual([
      'just now',
      '2 min ago',
      '2 h ago',
      '3 days ago',
    ]);
  });
});

describe('the live cloth', () => {
  const topology = (vertexCount: number, epoch = 1) => ({ vertexCount, epoch }) as ClothTopology;
  const moment = { epoch: 1, seq: 1, step: 1, time: 0 };

  it('gives back the buffer that a newer one replaces', () => {
    const cloth = new LiveCloth();
    cloth.setTopology(topology(1));
    const a = new Float32Array(3);
    const b = new Float32Array(3);
    expect(cloth.setPositions(a, moment)).toBeNull();
    expect(cloth.setPositions(b, moment)).toBe(a);
  });

  it('keeps the last picture when the same cloth comes again after a loss', () => {
    const cloth = new LiveCloth();
    cloth.setTopology(topology(1));
    cloth.setPositions(new Float32Array(3), moment);
    cloth.setTopology(topology(1));
    expect(cloth.positions).not.toBeNull();
  });

  it('keeps it as well until the first frame of another cloth, and then has both at once', () => {
    const cloth = new LiveCloth();
    cloth.setTopology(topology(1));
    const old = new Float32Array(3);
    cloth.setPositions(old, moment);
    const seen: unknown[] = [];
    cloth.listen((event) => seen.push([event, cloth.topology?.epoch, cloth.positions?.length]));
    cloth.setTopology(topology(2, 2));
    expect([cloth.topology?.epoch, cloth.positions]).toEqual([1, old]);
    expect(cloth.setPositions(new Float32Array(6), { ...moment, epoch: 2 })).toBeNull();
    expect(seen).toEqual([
      ['topology', 2, 6],
      ['frame', 2, 6],
    ]);
  });

  it('tells its listeners until they leave', () => {
    const cloth = new LiveCloth();
    const heard: string[] = [];
    const leave = cloth.listen((event) => heard.push(event));
    cloth.setTopology(topology(1));
    cloth.setPositions(new Float32Array(3), moment);
    leave();
    cloth.clear();
    expect(heard).toEqual(['topology', 'frame']);
  });

  it('has another hash when one coordinate moves by the least', () => {
    const positions = new Float32Array([0.1, 0.2, 0.3]);
    const before = positionsHash(positions);
    positions[2] = 0.3 + 3e-8;
    expect(positionsHash(positions)).not.toBe(before);
  });
});
