import { beforeEach, describe, expect, it, vi } from 'vitest';
import { makeApi, type Api } from '../src/api/Api';
import { ApiError, Http, problemOf } from '../src/api/http';
import { Commands } from '../src/commands/Commands';
import { Poller } from '../src/commands/Poller';
import { Watcher } from '../src/commands/Watcher';
import { AppState, ready } from '../src/state/AppState';
import { parseRoute } from '../src/state/routes';
import type { Edit, Job, SeenPieces } from '../src/api/types';
import { reportOf } from './samples';
import { fakeApi, jobOf, progressOf, projectOf, seenOf, squareOf } from './fakes';

function begin(more: Partial<Api> = {}) {
  const state = new AppState();
  const api = fakeApi(more);
  const order: string[] = [];
  const around = {
    go: (hash: string) => {
      order.push(`go ${hash}`);
      state.route.value = parseRoute(hash);
    },
    follow: (id: string) => void order.push(`follow ${id}`),
    say: (word: { type: string }) => void order.push(`say ${word.type}`),
    save: (name: string, text: string) => void order.push(`save ${name} ${text.length}`),
    newKey: () => 'key',
    anew: () => void order.push('anew'),
  };
  const commands = new Commands(
    state,
    api,
    around,
    () => undefined,
    (id) => order.push(`watch ${id}`),
  );
  state.projects.value = ready([projectOf()]);
  state.jobs.value = ready([]);
  state.route.value = { name: 'project', id: 'p_1' };
  return { state, api, commands, order };
}

const settle = (): Promise<void> => new Promise((done) => setTimeout(done, 0));

describe('starting a drape', () => {
  it('opens the stream before the job is shown', async () => {
    const { commands, order, state } = begin();
    await commands.startDrape();
    expect(order).toEqual(['watch j_new', 'go #/jobs/j_new']);
    expect(state.job.value?.state).toBe('queued');
  });

  it('happens once however often it is asked for while it is under way', async () => {
    const submit = vi.fn(fakeApi().submit);
    const { commands } = begin({ submit });
    await Promise.all([commands.startDrape(), commands.startDrape(), commands.runOrPause()]);
    expect(submit).toHaveBeenCalledTimes(1);
  });

  it('goes on from how the garment hung where it was only cut, lengthened or clothed otherwise', async () => {
    const submit = vi.fn(fakeApi().submit);
    const { commands, state } = begin({ submit });
    const asked = async (edit: Edit, job: Partial<Job> = {}, worn: 'yes' | 'partly' = 'yes') => {
      const hung = { state: 'succeeded', reason_code: 'settled', results: { 'final.hung': 900 } } as const;
      state.projects.value = ready([projectOf({ revision: 2 })]);
      state.jobs.value = ready([jobOf({ ...hung, ...job })]);
      state.route.value = { name: 'job', id: 'j_1' };
      state.report.value = ready(reportOf({ worn }));
      state.editing.history.value = [{ number: 1, created_ms: 2000, undone: false, edits: [edit] }];
      await commands.startDrape();
      return submit.mock.lastCall![2];
    };
    const longer: Edit = { edit: 'move_point', piece: 'front', edge: 'e0', point: 0, to: [0, -20] };
    expect(await asked(longer)).toBe('j_1');
    expect(await asked({ edit: 'set_fabric', piece: 'front', fabric: 'denim' })).toBe('j_1');
    expect(await asked({ edit: 'mirror_piece', piece: 'front' })).toBeUndefined();
    expect(await asked(longer, { reason_code: 'time' })).toBeUndefined();
    expect(await asked(longer, { results: {} })).toBeUndefined();
    expect(await asked(longer, {}, 'partly')).toBeUndefined();
  });

  it('shows the code and the place when it is refused', async () => {
    const { commands, state } = begin({
      submit: () => Promise.reject(new ApiError(422, 'dxf.truncated', 'The file ends early.', 'skirt.dxf:12')),
    });
    await commands.startDrape();
    expect(state.notices.value[0]).toMatchObject({
      tone: 'bad',
      code: 'dxf.truncated',
      where: 'skirt.dxf:12',
      text: 'The file ends early.',
    });
    expect(state.submitting.value).toBe(false);
  });
});

describe('the run key', () => {
  it('pauses what runs, resumes what is paused, and starts when nothing is under way', async () => {
    const act = vi.fn(fakeApi().act);
    const { commands, state, order } = begin({ act });
    state.putJob(jobOf());
    state.route.value = { name: 'job', id: 'j_1' };
    await commands.runOrPause();
    expect(act).toHaveBeenLastCalledWith('j_1', 'pause');
    expect(state.job.value?.state).toBe('paused');
    await commands.runOrPause();
    expect(act).toHaveBeenLastCalledWith('j_1', 'resume');
    state.putJob(jobOf({ state: 'succeeded' }));
    await commands.runOrPause();
    expect(order).toContain('go #/jobs/j_new');
  });
});

describe('a step', () => {
  it('that is over before its answer comes does not leave the drape queued', async () => {
    const stepped = jobOf({ state: 'queued' });
    const begun = begin({
      act: async () => {
        begun.state.progress.value = progressOf({ state: 'paused', step: 60 }); // by the stream
        return stepped;
      },
    });
    const { commands, state } = begun;
    state.putJob(jobOf({ state: 'paused' }));
    state.route.value = { name: 'job', id: 'j_1' };
    state.watched.value = 'j_1';
    state.progress.value = progressOf({ state: 'paused', step: 50 });
    await commands.act('step');
    expect(state.job.value).toMatchObject({ state: 'paused', progress: { step: 60 } });
  });
});

describe('after a drape that failed', () => {
  it('the run key does not start another until something has changed', async () => {
    const { commands, state, order } = begin();
    state.putJob(jobOf({ state: 'failed' }));
    await commands.runOrPause();
    expect(order).toEqual([]);
    expect(state.notices.value[0]?.text).toMatch(/would fail again/);
    state.projects.value = ready([projectOf({ revision: 2 })]);
    await commands.runOrPause();
    expect(order).toContain('go #/jobs/j_new');
  });

  it('a seam is turned over and draped with one click', async () => {
    const edit = vi.fn(async () => projectOf({ revision: 2 }));
    const { commands, order } = begin({ edit });
    await commands.mend({ kind: 'reverse', seam: 's' });
    expect(edit).toHaveBeenCalledWith('p_1', 1, [{ edit: 'reverse_seam', seam: 's' }]);
    expect(order).toEqual(['watch j_new', 'go #/jobs/j_new']);
  });

  it('what was refused is not draped', async () => {
    const { commands, state, order } = begin({
      edit: () => Promise.reject(new ApiError(422, 'edit.seam', 'There is no such seam.')),
    });
    await commands.mend({ kind: 'reverse', seam: 's' });
    expect(order).toEqual([]);
    expect(state.notices.value[0]?.code).toBe('edit.seam');
  });

  it('a drape whose time was up is given more, and is draped again', async () => {
    const edit = vi.fn(async () => projectOf({ revision: 2 }));
    const { commands, order } = begin({ edit });
    await commands.mend({ kind: 'time', max_time_s: 16 });
    expect(edit).toHaveBeenCalledWith('p_1', 1, [{ edit: 'set_max_time', max_time_s: 16 }]);
    expect(order).toEqual(['watch j_new', 'go #/jobs/j_new']);
  });

  it('a seam that does not fit is shown on the pattern', async () => {
    const { commands, state } = begin();
    await commands.mend({ kind: 'seam', seam: 's' });
    expect([state.editing.seam.value, state.tab.value]).toEqual(['s', 'pattern']);
  });

  it('seams are looked for, of a piece that is selected for it', async () => {
    const { commands, state } = begin({ proposals: async () => [] });
    await commands.mend({ kind: 'sew', piece: 'front' });
    expect([state.selected.value, state.tab.value, state.editing.proposals.value]).not.toContain(null);
    await commands.mend({ kind: 'sew' });
    expect(state.selected.value).toBe('front');
  });

  it('a piece is shown where it can be placed by hand', async () => {
    const { commands, state } = begin();
    await commands.mend({ kind: 'place', piece: 'front' });
    expect([state.selected.value, state.tab.value]).toEqual(['front', 'arrange']);
  });
});

describe('removing', () => {
  it('takes a drape from the list and shows its project', async () => {
    const removeJob = vi.fn(async () => undefined);
    const { commands, state, order } = begin({ removeJob });
    state.putJob(jobOf({ state: 'succeeded' }));
    state.route.value = { name: 'job', id: 'j_1' };
    await commands.removeJob('j_1');
    expect(removeJob).toHaveBeenCalledWith('j_1');
    expect(state.allJobs.value).toEqual([]);
    expect(order).toEqual(['go #/projects/p_1']);
  });

  it('goes to the first page from a project that is gone', async () => {
    const { commands, state, order } = begin();
    await commands.removeProject('p_1');
    expect(state.projects.value).toEqual(ready([]));
    expect(order).toEqual(['go #/']);
  });

  it('says what the service said when it refuses', async () => {
    const { commands, state } = begin({
      removeJob: () => Promise.reject(new ApiError(409, 'jobs.state', 'It has not ended.')),
    });
    state.putJob(jobOf());
    await commands.removeJob('j_1');
    expect(state.allJobs.value.length).toBe(1);
    expect(state.notices.value[0]?.code).toBe('jobs.state');
  });
});

describe('a project from files', () => {
  const document = { toile: 1, name: 'Napkin', pieces: [{ from: { dxf: 'n.dxf' } }], bodies: [{ file: 'b.obj' }] };
  const files = [
    { name: 'p.json', blob: new Blob([JSON.stringify(document)]) },
    { name: 'n.dxf', blob: new Blob(['0']) },
    { name: 'b.obj', blob: new Blob(['v']) },
  ];

  it('uploads each file under its kind and names the assets in the project', async () => {
    const createProject = vi.fn(fakeApi().createProject);
    const uploadAsset = vi.fn(fakeApi().uploadAsset);
    const { commands, state, order } = begin({ createProject, uploadAsset });
    await commands.intake.addFiles(files);
    await commands.intake.createProject(false);
    expect(uploadAsset.mock.calls.map(([kind, name]) => [kind, name])).toEqual([
      ['dxf', 'n.dxf'],
      ['body', 'b.obj'],
    ]);
    expect(createProject).toHaveBeenCalledWith(document, { 'n.dxf': 'a_n.dxf', 'b.obj': 'a_b.obj' });
    expect(order).toEqual(['go #/projects/p_new']);
    expect(state.intake.value).toBeNull();
  });

  it('keeps the dialog open with what the service said when it refuses', async () => {
    const { commands, state } = begin({
      uploadAsset: () => Promise.reject(new ApiError(422, 'dxf.truncated', 'The file ends early.', 'n.dxf:3')),
    });
    await commands.intake.addFiles(files);
    await commands.intake.createProject(true);
    expect(state.intake.value).toMatchObject({ busy: '', error: { code: 'dxf.truncated', where: 'n.dxf:3' } });
  });

  it('has the newer one of two files of a name', async () => {
    const { commands, state } = begin();
    await commands.intake.addFiles(files);
    await commands.intake.addFiles([{ name: 'N.dxf', blob: new Blob(['newer']) }]);
    expect(state.intake.value?.files.map((file) => [file.name, file.blob.size])).toContainEqual(['N.dxf', 5]);
    expect(state.intake.value?.files.length).toBe(3);
    expect(state.intake.value?.plan?.ready).toBe(true);
  });

  it('is not made before everything is there', async () => {
    const createProject = vi.fn(fakeApi().createProject);
    const { commands } = begin({ createProject });
    await commands.intake.addFiles(files.slice(0, 2));
    await commands.intake.createProject(false);
    expect(createProject).not.toHaveBeenCalled();
  });
});

describe('a sample', () => {
  const sample = {
    id: 'napkin',
    title: 'Napkin',
    picture: '',
    files: new Map([
      ['project.json', '/napkin/project.json'],
      ['n.dxf', '/napkin/n.dxf'],
    ]),
  };
  const document = { toile: 1, name: 'Napkin', pieces: [{ from: { dxf: 'n.dxf' } }] };
  const answers: Record<string, string> = { '/napkin/project.json': JSON.stringify(document), '/napkin/n.dxf': '0' };

  it('becomes a project that is draped at once', async () => {
    vi.stubGlobal('fetch', async (url: string) => new Response(answers[url]));
    const createProject = vi.fn(fakeApi().createProject);
    const { commands, state, order } = begin({ createProject });
    await commands.intake.startSample(sample);
    expect(createProject).toHaveBeenCalledWith(document, { 'n.dxf': 'a_n.dxf' });
    expect(order).toEqual(['go #/projects/p_new', 'watch j_new', 'go #/jobs/j_new']);
    expect(state.sampling.value).toBe('');
    vi.unstubAllGlobals();
  });

  it('says so when it does not come', async () => {
    vi.stubGlobal('fetch', async () => new Response('', { status: 404 }));
    const { commands, state, order } = begin();
    await commands.intake.startSample(sample);
    expect(order).toEqual([]);
    expect(state.notices.value[0]?.text).toMatch(/did not come: 404/);
    vi.unstubAllGlobals();
  });
});

describe('who asks', () => {
  it('is known by name, and gone with all that was theirs once they log out', async () => {
    const anna = { accounts: true, name: 'anna', scopes: ['read' as const], expires_ms: 0 };
    const { state, commands, order } = begin({ session: async () => anna });
    await commands.lookWhoAsks();
    expect(state.session.value).toEqual(anna);
    expect(state.shut.value).toBe(false);
    await commands.logOut();
    expect(order).toEqual(['anew']);
  });

  it('is asked for where nobody is known, and nothing else is asked before', async () => {
    vi.useFakeTimers();
    const nobody = new ApiError(401, 'auth.required', 'Log in.');
    const { state, commands } = begin({ session: () => Promise.reject(nobody) });
    await commands.lookWhoAsks();
    expect(state.shut.value).toBe(true);
    const jobs = vi.fn(() => Promise.reject(nobody));
    const poller = new Poller(new AppState(), fakeApi({ projects: async () => [], jobs }), () => undefined);
    await poller.refresh();
    await vi.advanceTimersByTimeAsync(60_000);
    expect(jobs).toHaveBeenCalledOnce();
    vi.useRealTimers();
  });
});

describe('the poller', () => {
  it('tells a lost service and calls when it is back', async () => {
    vi.useFakeTimers();
    let answers = true;
    const returned = vi.fn();
    const state = new AppState();
    const jobs = async () =>
      answers ? [jobOf({ state: 'succeeded' })] : Promise.reject(new ApiError(0, 'net.unreachable', 'No answer.'));
    const poller = new Poller(state, fakeApi({ projects: async () => [], jobs }), returned);
    await poller.refresh();
    expect(state.link.value.state).toBe('ok');
    answers = false;
    await poller.refresh();
    expect(state.link.value).toMatchObject({ state: 'lost', attempt: 1 });
    expect(state.jobs.value.state).toBe('ready');
    await vi.advanceTimersByTimeAsync(260);
    expect(state.link.value).toMatchObject({ state: 'lost', attempt: 2 });
    answers = true;
    await vi.advanceTimersByTimeAsync(600);
    expect(state.link.value.state).toBe('ok');
    expect(returned).toHaveBeenCalledTimes(1);
    poller.stop();
    vi.useRealTimers();
  });

  it('keeps what comes again as it was, so that nothing is drawn anew for it', async () => {
    const state = new AppState();
    let step = 1;
    const jobs = async () => [jobOf({ id: 'j_1', progress: progressOf({ step }) }), jobOf({ id: 'j_2' })];
    const poller = new Poller(state, fakeApi({ projects: async () => [projectOf()], jobs }), () => undefined);
    await poller.refresh();
    const before = { projects: state.projects.value, jobs: state.jobs.value, second: state.allJobs.value[1] };
    await poller.refresh();
    expect(state.projects.value).toBe(before.projects);
    expect(state.jobs.value).toBe(before.jobs);
    step = 2;
    await poller.refresh();
    poller.stop();
    expect(state.allJobs.value[0]?.progress?.step).toBe(2);
    expect(state.allJobs.value[1]).toBe(before.second);
  });

  it('says so when the very first answer fails', async () => {
    const state = new AppState();
    const fail = () => Promise.reject(new ApiError(500, 'http.500', 'Broken.'));
    const poller = new Poller(state, fakeApi({ projects: fail, jobs: fail }), () => undefined);
    await poller.refresh();
    poller.stop();
    expect(state.projects.value).toMatchObject({ state: 'failed', error: { code: 'http.500' } });
    expect(state.link.value.state).toBe('ok');
  });
});

describe('the watcher', () => {
  let state: AppState;
  const stream = { watch: vi.fn(), leave: vi.fn(), poke: vi.fn() };
  beforeEach(() => {
    state = new AppState();
    for (const fake of Object.values(stream)) fake.mockClear();
  });

  const ended = jobOf({ state: 'succeeded', results: { 'report.json': 10 } });
  /** A drape under way is shown. */
  const watching = () => {
    const report = vi.fn(async (_: string) => ({ name: 'r' }) as never);
    const watcher = new Watcher(state, fakeApi({ report }), stream, () => undefined);
    state.jobs.value = ready([jobOf()]);
    state.route.value = { name: 'job', id: 'j_1' };
    watcher.start();
    return { watcher, report };
  };

  it('opens the stream of a job’s address before any list has come', () => {
    const watcher = new Watcher(state, fakeApi(), stream, () => undefined);
    state.route.value = { name: 'job', id: 'j_7' };
    watcher.start();
    expect(stream.watch).toHaveBeenCalledWith('ws://here/j_7');
    state.route.value = { name: 'home' };
    expect(stream.leave).toHaveBeenCalled();
    watcher.stop();
  });

  it('keeps the figures of a run over its time, and forgets them for another job', async () => {
    const watcher = new Watcher(state, fakeApi(), stream, () => undefined);
    state.jobs.value = ready([jobOf(), jobOf({ id: 'j_2' })]);
    state.route.value = { name: 'job', id: 'j_1' };
    watcher.start();
    for (const [simulated_s, rms_speed] of [
      [0.1, 1],
      [0.2, 0.5],
      [0.2, 0.4],
    ] as const)
      watcher.handlers().text({ type: 'progress', ...progressOf({ simulated_s, rms_speed }) });
    expect(state.history.value).toEqual([
      { t: 0.1, speed: 1 },
      { t: 0.2, speed: 0.5 },
    ]);
    state.route.value = { name: 'job', id: 'j_2' };
    expect(state.history.value).toEqual([]);
    watcher.stop();
  });

  it('takes the last word of a stream for the job’s row and fetches its report', async () => {
    const { watcher, report } = watching();
    watcher.handlers().text({ type: 'ended', job: ended, ...progressOf({ state: 'succeeded' }) });
    await settle();
    expect(state.job.value?.state).toBe('succeeded');
    expect(report).toHaveBeenCalledTimes(1);
    expect(state.tab.value).toBe('result');
    watcher.stop();
  });

  it('turns to the result also when an older answer came in between', async () => {
    const { watcher, report } = watching();
    state.jobs.value = ready([ended]);
    state.jobs.value = ready([jobOf({ state: 'running' })]);
    await settle();
    expect(state.tab.value).toBe('drape');
    state.jobs.value = ready([ended]);
    await settle();
    expect([state.tab.value, report.mock.calls.length]).toEqual(['result', 1]);
    state.tab.value = 'body';
    state.jobs.value = ready([{ ...ended }]);
    await settle();
    expect(state.tab.value, 'turned to once').toBe('body');
    watcher.stop();
  });

  it('shows no report of a drape that is not watched any more', async () => {
    const { watcher, report } = watching();
    report.mockImplementation(async (id: string) => ({ name: id }) as never);
    state.jobs.value = ready([ended]);
    state.jobs.value = ready([ended, jobOf({ id: 'j_2' })]);
    state.route.value = { name: 'job', id: 'j_2' };
    await settle();
    expect([report.mock.calls.length, state.report.value]).toEqual([1, null]);
    state.jobs.value = ready([ended, { ...ended, id: 'j_2' }]);
    await settle();
    expect(state.report.value).toEqual(ready({ name: 'j_2' }));
    watcher.stop();
  });

  it('leaves the panel of the pattern to whoever works on it when a drape ends', async () => {
    const { watcher, report } = watching();
    state.tab.value = 'pattern';
    state.editing.tool.value = 'sew';
    watcher.handlers().text({ type: 'ended', job: ended, ...progressOf({ state: 'succeeded' }) });
    await settle();
    expect(report).toHaveBeenCalledTimes(1);
    expect(state.tab.value).toBe('pattern');
    watcher.stop();
  });

  it('leaves whoever chooses something for a piece at that', async () => {
    const { watcher, report } = watching();
    state.tab.value = 'pattern';
    state.selected.value = 'front';
    watcher.handlers().text({ type: 'ended', job: ended, ...progressOf({ state: 'succeeded' }) });
    await settle();
    expect(report).toHaveBeenCalledTimes(1);
    expect(state.tab.value).toBe('pattern');
    watcher.stop();
  });

  it('shows an ended drape that nobody streams from its model file', async () => {
    const resultText = async () => 'v 0 0 0\nv 1 0 0\nv 0 1 0\no front\nf 1 2 3\n';
    const watcher = new Watcher(state, fakeApi({ resultText }), stream, () => undefined);
    state.jobs.value = ready([jobOf({ state: 'succeeded', results: { 'final.obj': 10 } })]);
    state.route.value = { name: 'job', id: 'j_1' };
    watcher.start();
    await settle();
    expect(state.cloth.topology?.vertexCount).toBe(3);
    watcher.stop();
  });

  it('fetches that file once, and waits for the colours that the pieces had then', async () => {
    const resultText = vi.fn(async () => 'v 0 0 0\nv 1 0 0\nv 0 1 0\no front\nf 1 2 3\n');
    let come = (_: SeenPieces): void => undefined;
    const seenPieces = () => new Promise<SeenPieces>((done) => (come = done));
    const pieces = async () => ({ pieces: [squareOf('front', 0, 0, 10)], seams: [] });
    const watcher = new Watcher(state, fakeApi({ resultText, pieces, seenPieces }), stream, () => undefined);
    state.projects.value = ready([projectOf()]);
    state.jobs.value = ready([jobOf({ state: 'succeeded', results: { 'final.obj': 10 } })]);
    state.route.value = { name: 'job', id: 'j_1' };
    watcher.start();
    await settle();
    state.putJob(jobOf({ state: 'succeeded', ended_ms: 5, results: { 'final.obj': 10 } }));
    await settle();
    expect(state.cloth.topology).toBeNull();
    come({ pieces: [seenOf('front', { colour: [1, 0, 0] })], fabrics: [] });
    await settle();
    expect(state.cloth.topology?.pieces[0]?.colour).toEqual([1, 0, 0]);
    expect(resultText).toHaveBeenCalledTimes(1);
    watcher.stop();
  });
});

describe('errors of the service', () => {
  const answer = (status: number, body: string) =>
    new Response(body, { status, headers: { 'Content-Type': 'application/problem+json' } });

  it('keep their code, sentence and place', async () => {
    const problem = await problemOf(
      answer(422, '{"code":"project.unknown_edge","detail":"No such edge.","where":"/seams/0/a/0/edge","title":"t"}'),
    );
    expect(problem).toMatchObject({
      status: 422,
      code: 'project.unknown_edge',
      detail: 'No such edge.',
      where: '/seams/0/a/0/edge',
    });
  });

  it('are made of the status where the body is none', async () => {
    expect(await problemOf(answer(502, '<html>'))).toMatchObject({ code: 'http.502', unreachable: true });
  });

  it('say when there was no answer at all', async () => {
    const http = new Http('/api/v1', () => Promise.reject(new TypeError('failed to fetch')));
    await expect(http.get('/jobs')).rejects.toMatchObject({ status: 0, code: 'net.unreachable', unreachable: true });
  });

  it('say so as well when an answer breaks off after its header', async () => {
    const broken = () => new Response(new ReadableStream({ start: (body) => body.error(new TypeError('cut')) }));
    const http = new Http('/api/v1', async () => broken());
    for (const asked of [http.get('/jobs'), http.text('/jobs'), http.bytes('/jobs')])
      await expect(asked).rejects.toMatchObject({ code: 'net.unreachable', unreachable: true });
  });

  it('leave the lists as they were when half an answer comes, until a whole one does', async () => {
    const state = new AppState();
    let text = JSON.stringify({ jobs: [jobOf({ id: 'j_1' })] });
    const api = makeApi(new Http('/api/v1', async () => new Response(text)));
    const poller = new Poller(state, fakeApi({ projects: async () => [projectOf()], jobs: api.jobs }), () => undefined);
    const shown = async () => {
      await poller.refresh();
      return { link: state.link.value.state, jobs: state.allJobs.value.map((job) => job.id) };
    };
    expect(await shown()).toEqual({ link: 'ok', jobs: ['j_1'] });
    const whole = JSON.stringify({ jobs: [jobOf({ id: 'j_1' }), jobOf({ id: 'j_2' })] });
    text = whole.slice(0, -whole.length / 2);
    expect(await shown()).toEqual({ link: 'lost', jobs: ['j_1'] });
    text = whole;
    expect(await shown()).toEqual({ link: 'ok', jobs: ['j_1', 'j_2'] });
    poller.stop();
  });
});
