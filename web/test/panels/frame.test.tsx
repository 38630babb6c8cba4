// @vitest-environment jsdom
import { fireEvent, screen, within } from '@testing-library/dom';
import { beforeEach, describe, expect, it, vi } from 'vitest';
import { click, openPage, type Page } from './page';
import { ApiError } from '../../src/api/http';
import { speak } from '../../src/texts/language';
import type { Sample } from '../../src/api/samples';
import type { Job } from '../../src/api/types';
import { Banner } from '../../src/panels/Banner';
import { DropTarget } from '../../src/panels/DropTarget';
import { Dropzone } from '../../src/panels/Dropzone';
import { HelpDialog } from '../../src/panels/HelpDialog';
import { Inspector } from '../../src/panels/Inspector';
import { Notices } from '../../src/panels/Notices';
import { Rail } from '../../src/panels/Rail';
import { Splitter } from '../../src/panels/Splitter';
import { StartPage } from '../../src/panels/StartPage';
import { StateChip } from '../../src/panels/StateChip';
import { StatusBar } from '../../src/panels/StatusBar';
import { TopBar } from '../../src/panels/TopBar';
import { Welcome } from '../../src/panels/Welcome';
import { ready } from '../../src/state/AppState';
import { bindings } from '../../src/tools/keys';
import { jobOf, progressOf, projectOf } from '../fakes';
import { reportOf } from '../samples';

const button = (name: string | RegExp): HTMLElement => screen.getByRole('button', { name });
const noButton = (name: string | RegExp): boolean => screen.queryByRole('button', { name }) === null;
const lost = { state: 'lost', since: 0, attempt: 1, retryAt: 8_000 } as const;
const resultUrl = (job: string, name: string): string => `/results/${job}/${name}`;

let page: Page;
beforeEach(() => {
  page = openPage();
});

const drape = (more: Partial<Job> = {}): void => page.change((state) => (state.jobs.value = ready([jobOf(more)])));

describe('the top bar', () => {
  it('starts a drape of the project that is open', () => {
    page.show(<TopBar />);
    expect(screen.getByTitle('Project').textContent).toBe('Skirt');
    click(button('Start drape'));
    expect(page.asked()).toEqual([['startDrape']]);
  });

  it('pauses and cancels one that runs', () => {
    drape();
    page.show(<TopBar />);
    expect(screen.getByText('Running')).toBeTruthy();
    click(button('Pause'));
    click(button('Cancel'));
    expect(noButton(/Drape again|Resume/)).toBe(true);
    expect(page.asked()).toEqual([
      ['act', 'pause'],
      ['act', 'cancel'],
    ]);
  });

  it('goes on with one that is paused, and drapes again after one that ended', () => {
    drape({ state: 'paused' });
    page.show(<TopBar />);
    click(button('Resume'));
    drape({ state: 'succeeded' });
    click(button('Drape again'));
    expect(page.asked()).toEqual([['act', 'resume'], ['startDrape']]);
  });

  it('asks for nothing while the service does not answer', () => {
    drape();
    page.change((state) => (state.link.value = lost));
    page.show(<TopBar />);
    expect(button('Pause').hasAttribute('disabled')).toBe(true);
    expect(button('Cancel').hasAttribute('disabled')).toBe(true);
  });

  it('has nothing to run on the first page', () => {
    drape();
    page.change((state) => (state.route.value = { name: 'home' }));
    page.show(<TopBar />);
    expect(noButton(/Pause|Cancel|drape/i)).toBe(true);
    expect(screen.queryByTitle('Project')).toBeNull();
  });

  it('opens the list of projects and the list of keys', () => {
    page.show(<TopBar />);
    const before = page.state.railShown.value;
    click(button('Project list'));
    click(button('Keyboard shortcuts'));
    expect(page.state.railShown.value).toBe(!before);
    expect(page.state.helpShown.value).toBe(true);
  });
});

describe('the banner', () => {
  it('is away while all is well', () => {
    page.show(<Banner retry={() => undefined} />);
    expect(screen.queryByRole('alert')).toBeNull();
    expect(screen.queryByRole('status')).toBeNull();
  });

  it('counts down to the next try, and tries now', () => {
    const retry = vi.fn();
    page.change((state) => {
      state.now.value = 5_000;
      state.link.value = lost;
    });
    page.show(<Banner retry={retry} />);
    expect(screen.getByRole('alert').textContent).toContain('Trying again in 3 s.');
    click(button('Try now'));
    expect(retry).toHaveBeenCalledOnce();
  });

  it('tells a live view that is interrupted', () => {
    page.change((state) => (state.stream.value = { state: 'lost', attempt: 2, retryMs: 0 }));
    page.show(<Banner retry={() => undefined} />);
    expect(screen.getByRole('status').textContent).toContain('The live view is interrupted.');
  });
});

describe('notices', () => {
  it('say what happened, with code and place, until they are put away', () => {
    page.change(
      (state) =>
        (state.notices.value = [
          { id: 1, tone: 'good', text: 'it is there' },
          { id: 2, tone: 'bad', text: 'no such edge', code: 'edit.unknown', where: 'piece a' },
        ]),
    );
    page.show(<Notices />);
    expect(screen.getByRole('status').textContent).toBe('It is there.');
    const bad = screen.getByRole('alert');
    expect(bad.textContent).toBe('No such edge.edit.unknown · piece a');
    click(within(bad).getByRole('button', { name: 'Dismiss' }));
    expect(screen.queryByRole('alert')).toBeNull();
  });
});

describe('the status line', () => {
  const figures = (): string[] => [...document.querySelectorAll('.figure')].map((one) => one.textContent ?? '');

  it('is ready where nothing is draped', () => {
    page.show(<StatusBar />);
    expect(screen.getByText('Ready')).toBeTruthy();
  });

  it('has no figures of a drape that waits', () => {
    drape({ state: 'queued' });
    page.show(<StatusBar />);
    expect(screen.getByText('Waiting for a worker')).toBeTruthy();
    expect(figures()).toEqual(['Step–', 'Simulated–', 'A step–', 'Speed–', 'Seam gap–', 'Intersections–']);
    expect(screen.getByRole('progressbar').className).toContain('idle');
  });

  it('follows a drape under way, and marks intersections', () => {
    drape();
    page.change((state) => {
      state.watched.value = 'j_1';
      state.progress.value = progressOf({ step: 1200, seam_gap_mm: 12.34, cloth_body: 1, cloth_cloth: 2 });
    });
    page.show(<StatusBar />);
    expect(figures()).toEqual([
      'Step1,200',
      'Simulated0.10 s',
      'A step0.70 ms',
      'Speed200 mm/s',
      'Seam gap12.3 mm',
      'Intersections3',
    ]);
    expect(screen.getByText('Intersections').parentElement!.className).toContain('bad');
    expect(screen.getByRole('progressbar').getAttribute('aria-valuenow')).toBe('64');
  });

  it('takes the report of one that ended, and its mean step', () => {
    drape({ state: 'succeeded' });
    page.change((state) => (state.report.value = ready(reportOf({ steps: 10_000, wall_s: 8 }))));
    page.show(<StatusBar />);
    expect(figures()).toContain('Step10,000');
    expect(figures()).toContain('A step0.80 ms');
    expect(screen.getByText('100 %')).toBeTruthy();
  });
});

describe('the state of a job', () => {
  it('is a word', () => {
    page.show(<StateChip state="succeeded" />);
    expect(screen.getByText('Done').className).toBe('chip state-succeeded');
  });
});

describe('the start page', () => {
  it('says what this is, takes a pattern, and offers samples and what was begun', () => {
    page.change((state) => {
      state.route.value = { name: 'home' };
      state.jobs.value = ready([jobOf({ state: 'succeeded', results: { 'thumbnail.png': 9 } })]);
    });
    page.show(<StartPage resultUrl={resultUrl} />);
    expect(screen.getByRole('heading', { level: 1 }).textContent).toBe('See your pattern on a body');
    expect(button(/Drop a DXF pattern here/)).toBeTruthy();
    click(button('T-shirt'));
    const [[command, sample]] = page.asked() as [[string, Sample]];
    expect(command).toBe('intake.startSample');
    expect([...sample.files.keys()].sort()).toEqual(['project.json', 'tshirt.dxf']);
    expect(sample.picture).toMatch(/picture/);
    const project = screen.getByRole('link', { name: /Skirt/ });
    expect(project.getAttribute('href')).toBe('#/projects/p_1');
    expect(project.querySelector('img')?.getAttribute('src')).toBe('/results/j_1/thumbnail.png');
  });

  it('takes files that are chosen, as those that are dropped', () => {
    page.show(<Dropzone title="Choose" />);
    const field = document.querySelector('input[type=file]')!;
    Object.defineProperty(field, 'files', { value: [new File(['0'], 'shirt.dxf')] });
    fireEvent.change(field);
    expect(page.asked()).toMatchObject([['intake.addFiles', [{ name: 'shirt.dxf' }]]]);
  });

  it('makes one sample at a time, and says of which a project is being made', () => {
    page.change((state) => {
      state.route.value = { name: 'home' };
      state.sampling.value = 'tshirt';
    });
    page.show(<Welcome resultUrl={resultUrl} />);
    expect(button('T-shirt').getAttribute('aria-busy')).toBe('true');
    expect(button('Slacks').hasAttribute('disabled')).toBe(true);
  });

  it('says that an address leads nowhere', () => {
    page.change((state) => (state.route.value = { name: 'job', id: 'j_gone' }));
    page.show(<StartPage resultUrl={resultUrl} />);
    expect(screen.getByRole('heading').textContent).toBe('Nothing is here');
    expect(screen.getByRole('link', { name: 'To the start page' }).getAttribute('href')).toBe('#/');
  });

  it('says that the service is not there', () => {
    const failed = { state: 'failed', error: new ApiError(0, 'net.unreachable', 'The server does not answer.') } as const;
    page.change((state) => {
      state.projects.value = failed;
      state.jobs.value = failed;
    });
    page.show(<StartPage resultUrl={resultUrl} />);
    expect(screen.getByRole('heading').textContent).toBe('The server does not answer');
    expect(screen.getByText('net.unreachable')).toBeTruthy();
  });

  it('is away where there is something to show, and while nothing is known', () => {
    page.show(<StartPage resultUrl={resultUrl} />);
    expect(screen.queryByRole('heading')).toBeNull();
    page.change((state) => (state.projects.value = { state: 'loading' }));
    expect(screen.queryByRole('heading')).toBeNull();
  });
});

describe('the list of projects and drapes', () => {
  it('has a way to the first project', () => {
    page.change((state) => (state.projects.value = ready([])));
    page.show(<Rail resultUrl={resultUrl} />);
    expect(screen.getByText(/No projects yet/)).toBeTruthy();
    expect(screen.getByText(/What you drape is listed here/)).toBeTruthy();
    click(button('choose files'));
    click(button('New project'));
    expect(page.asked()).toEqual([['intake.open'], ['intake.open']]);
  });

  it('shows that it is loading, and why it could not be', () => {
    page.change((state) => {
      state.projects.value = { state: 'loading' };
      state.jobs.value = { state: 'loading' };
    });
    page.show(<Rail resultUrl={resultUrl} />);
    expect(screen.getAllByRole('list', { name: 'Loading' }).length).toBe(2);
    const error = new ApiError(500, 'store.broken', 'The disk is full.');
    page.change((state) => (state.projects.value = { state: 'failed', error }));
    expect(screen.getByText('The disk is full.')).toBeTruthy();
  });

  it('asks once more before it removes a drape or a project', () => {
    drape({ state: 'succeeded' });
    page.show(<Rail resultUrl={resultUrl} />);
    click(button('Remove this drape of Skirt'));
    expect(page.asked()).toEqual([]);
    click(button('Really remove this drape of Skirt'));
    click(button('Remove the project Skirt and its drapes'));
    click(button('Really remove the project Skirt and its drapes'));
    expect(page.asked()).toEqual([
      ['removeJob', 'j_1'],
      ['removeProject', 'p_1'],
    ]);
  });

  it('folds away what failed before a newer drape of its project', () => {
    page.change((state) => {
      state.jobs.value = ready([
        jobOf({ id: 'j_3', state: 'failed', created_ms: 3 }),
        jobOf({ id: 'j_2', state: 'failed', created_ms: 2 }),
        jobOf({ id: 'j_1', state: 'succeeded', created_ms: 1 }),
      ]);
    });
    page.show(<Rail resultUrl={resultUrl} />);
    const folded = screen.getByText('1 earlier without a result').closest('details')!;
    expect(within(folded).getByRole('link').getAttribute('href')).toBe('#/jobs/j_2');
  });

  it('leads to each project and drape, with picture, state and progress', () => {
    page.change((state) => {
      state.now.value = 3_600_000;
      state.jobs.value = ready([
        jobOf({ id: 'j_2', name: 'Second', created_ms: 2000, progress: progressOf({ phase: 'sew', fraction: 0.5 }) }),
        jobOf({ state: 'succeeded', ended_ms: 3_000_000, results: { 'thumbnail.png': 9 } }),
      ]);
    });
    page.show(<Rail resultUrl={resultUrl} />);
    const links = screen.getAllByRole('link');
    expect(links.map((link) => link.getAttribute('href'))).toEqual(['#/projects/p_1', '#/jobs/j_2', '#/jobs/j_1']);
    expect(links.map((link) => link.textContent)).toEqual([
      'Skirt2 drapes · rev 1',
      'SecondSewing · 23 %',
      'SkirtDone · rev 1 · 10 min ago',
    ]);
    expect(links[0]!.getAttribute('aria-current')).toBe('true');
    expect(links[1]!.getAttribute('aria-current')).toBe('page');
    expect(links[2]!.querySelector('img')!.getAttribute('src')).toBe('/results/j_1/thumbnail.png');
  });

  it('shows how far a drape is in every language: CSS knows no decimal comma', async () => {
    page.change((state) => (state.jobs.value = ready([jobOf({ progress: progressOf({ phase: 'sew', fraction: 0.5 }) })])));
    await speak('de');
    page.show(<Rail resultUrl={resultUrl} />);
    expect(document.querySelector<HTMLElement>('.hairbar i')!.style.width).toBe('22.5%');
    await speak('en');
  });

  it('says of a project that it was not draped', () => {
    page.change((state) => (state.projects.value = ready([projectOf({ revision: 4 })])));
    page.show(<Rail resultUrl={resultUrl} />);
    expect(screen.getByRole('link').textContent).toBe('SkirtNot draped yet · rev 4');
  });
});

describe('the help', () => {
  it('lists every key under its group, and closes', () => {
    page.show(<HelpDialog />);
    expect(screen.queryByRole('dialog')).toBeNull();
    page.change((state) => (state.helpShown.value = true));
    for (const { title, shown } of bindings) {
      expect(screen.getByText(title()).parentElement!.textContent).toBe(shown + title());
    }
    click(button('Close'));
    expect(page.state.helpShown.value).toBe(false);
  });
});

describe('the inspector', () => {
  it('shows the panel of the tab that is chosen', () => {
    page.show(<Inspector resultUrl={resultUrl} />);
    expect(screen.getByRole('tab', { selected: true }).textContent).toBe('Pattern');
    const texts = new Map([
      ['Body', 'Measuring the body'],
      ['Arrange', 'Arrange the pieces'],
      ['Result', 'Nothing has been draped yet.'],
      ['Pattern', 'The pattern of the project is edited here.'],
    ]);
    for (const [name, text] of texts) {
      click(screen.getByRole('tab', { name }));
      expect(within(screen.getByRole('tabpanel', { name })).getByText(text)).toBeTruthy();
    }
  });

  it('begins each panel at its top', () => {
    page.show(<Inspector resultUrl={resultUrl} />);
    screen.getByRole('tabpanel').scrollTop = 300;
    click(screen.getByRole('tab', { name: 'Result' }));
    expect(screen.getByRole('tabpanel', { name: 'Result' }).scrollTop).toBe(0);
  });

  it('goes round its tabs by arrow keys', () => {
    page.show(<Inspector resultUrl={resultUrl} />);
    fireEvent.keyDown(screen.getByRole('tablist'), { key: 'ArrowLeft' });
    expect(page.state.tab.value).toBe('result');
    fireEvent.keyDown(screen.getByRole('tablist'), { key: 'ArrowRight' });
    expect(page.state.tab.value).toBe('pattern');
    expect(document.activeElement?.id).toBe('tab-pattern');
  });
});

describe('the bar beside the 3D view', () => {
  it('is moved by arrow keys within bounds, and remembers its place', () => {
    localStorage.clear();
    page.show(<Splitter />);
    const bar = screen.getByRole('separator', { name: 'Width of the pattern' });
    expect(bar.getAttribute('aria-valuenow')).toBe('400');
    fireEvent.keyDown(bar, { key: 'ArrowLeft' });
    expect(bar.getAttribute('aria-valuenow')).toBe('424');
    expect(bar.parentElement!.style.getPropertyValue('--side')).toBe('424px');
    for (let i = 0; i < 10; ++i) fireEvent.keyDown(bar, { key: 'ArrowRight' });
    expect(bar.getAttribute('aria-valuenow')).toBe('280');
    expect(localStorage.getItem('toile.side')).toBe('280');
  });
});

describe('files that are dragged over the page', () => {
  const carried = (...files: File[]) => ({ dataTransfer: { types: ['Files'], files } });

  it('are taken where they are dropped', () => {
    page.show(<DropTarget />);
    const file = new File(['x'], 'skirt.dxf');
    fireEvent.dragEnter(window, carried(file));
    expect(screen.getByText('Drop to make a project')).toBeTruthy();
    fireEvent.drop(window, carried(file));
    expect(screen.queryByText('Drop to make a project')).toBeNull();
    expect(page.asked()).toEqual([['intake.addFiles', [{ name: 'skirt.dxf', blob: file }]]]);
  });

  it('may leave again, and what is no file is left alone', () => {
    page.show(<DropTarget />);
    fireEvent.dragEnter(window, { dataTransfer: { types: ['text/plain'], files: [] } });
    expect(screen.queryByText('Drop to make a project')).toBeNull();
    fireEvent.dragEnter(window, carried());
    fireEvent(window, Object.assign(new Event('dragleave'), { relatedTarget: null }));
    expect(screen.queryByText('Drop to make a project')).toBeNull();
  });
});
