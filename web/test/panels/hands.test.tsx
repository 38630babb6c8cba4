// @vitest-environment jsdom
// What a person sees of hands on cloth that drapes.

import { fireEvent, screen } from '@testing-library/dom';
import { beforeEach, describe, expect, it } from 'vitest';
import { click, openPage, type Page } from './page';
import type { Progress } from '../../src/api/types';
import { PinList } from '../../src/panels/PinList';
import { StatusBar } from '../../src/panels/StatusBar';
import { TopBar } from '../../src/panels/TopBar';
import { HandHint, HandTools } from '../../src/scene/HandTools';
import { ScenePane } from '../../src/scene/ScenePane';
import { ready, type AppState } from '../../src/state/AppState';
import { listenForKeys } from '../../src/tools/keys';
import { jobOf, progressOf, projectOf } from '../fakes';

let page: Page;
beforeEach(() => {
  page = openPage();
  page.change(drapes);
});

function drapes(state: AppState): void {
  state.jobs.value = ready([jobOf({ state: 'running', progress: progressOf() })]);
  state.watched.value = 'j_1';
  state.stream.value = { state: 'open' };
  state.tab.value = 'drape';
  state.covered.value = true;
}

const pinned = (state: AppState): void => {
  const pins: Progress['pins'] = [
    { pin: 1, place: [0, 1.2, 0] },
    { pin: 3, place: [0, 0.85, 0.1] },
  ];
  state.progress.value = progressOf({ pins });
};

describe('hand tools', () => {
  it('are there while cloth can be touched, and say what they do', () => {
    page.show(
      <>
        <HandTools />
        <HandHint />
      </>,
    );
    click(screen.getByRole('button', { name: 'Pull' }));
    click(screen.getByRole('button', { name: 'Pin' }));
    expect(page.asked()).toEqual([
      ['live.take', 'pull'],
      ['live.take', 'pin'],
    ]);
    page.change((state) => (state.hands.tool.value = 'pull'));
    expect(screen.getByRole('button', { name: 'Pull' }).getAttribute('aria-pressed')).toBe('true');
    expect(screen.getByRole('status').textContent).toContain('Drag the cloth');
    page.change((state) => (state.stream.value = { state: 'closed' }));
    expect(screen.queryByRole('button')).toBeNull();
    expect(screen.queryByRole('status')).toBeNull();
  });

  it('have keys, as one frame has', () => {
    const stop = listenForKeys(page.commands, page.state);
    for (const key of ['g', 'i', '.']) fireEvent.keyDown(window, { key });
    expect(page.asked()).toEqual([
      ['live.take', 'pull'],
      ['live.take', 'pin'],
      ['act', 'step'],
    ]);
    page.change((state) => (state.hands.held.value = { point: { triangle: 0, shares: [1, 0, 0], at: [0, 0, 0] }, to: [0, 0, 0] }));
    fireEvent.keyDown(window, { key: 'i' });
    expect(page.asked()).toEqual([['live.pinHeld']]);
    stop();
  });
});

describe('the list of pins', () => {
  it('has each with its height and a way to remove it', () => {
    page.show(<PinList />);
    expect(screen.queryByRole('list')).toBeNull();
    page.change(pinned);
    expect(screen.getAllByRole('listitem').map((item) => item.textContent)).toEqual([
      'Pin 1at a height of 120.0 cm',
      'Pin 3at a height of 85.0 cm',
    ]);
    fireEvent.pointerEnter(screen.getAllByRole('listitem')[1]!);
    expect(page.state.hands.litPin.value).toBe(3);
    click(screen.getByRole('button', { name: 'Remove pin 3' }));
    expect(page.asked()).toEqual([['live.unpin', 3]]);
  });
});

describe('a paused drape', () => {
  it('goes on by one frame', () => {
    page.show(<TopBar />);
    expect(screen.queryByRole('button', { name: 'Step' })).toBeNull();
    page.change((state) => (state.progress.value = progressOf({ state: 'paused' })));
    click(screen.getByRole('button', { name: 'Step' }));
    expect(page.asked()).toEqual([['act', 'step']]);
  });
});

describe('the status line', () => {
  it('tells about how long it still takes, while it runs and where that can be said', () => {
    page.show(<StatusBar />);
    expect(screen.queryByText('Time left')).toBeNull();
    page.change((state) => {
      state.history.value = Array.from({ length: 20 }, (_, i) => ({ t: 0.05 * (i + 1), speed: Math.exp(-0.1 * (i + 1)) }));
      state.progress.value = progressOf({ step: 3000, simulated_s: 1, step_ms: 1, fraction: 0.1 });
    });
    expect(screen.getByText('Time left').parentElement?.textContent).toBe('Time leftabout 6.0 s');
    page.change((state) => (state.progress.value = progressOf({ ...state.progress.value, state: 'paused' })));
    expect(screen.queryByText('Time left')).toBeNull();
  });
});

describe('a drape of a pattern that was edited meanwhile', () => {
  const edit = (kind: string) => (state: AppState): void => {
    state.projects.value = ready([projectOf({ revision: 2 })]);
    state.editing.history.value = [{ number: 1, created_ms: 5000, undone: false, edits: [{ edit: kind }] }] as never;
  };
  const scene = (): void => page.show(<ScenePane code={new Promise(() => undefined)} drawn={() => undefined} />);

  it('says that the change is taken over', () => {
    page.change(edit('set_fabric'));
    scene();
    expect(screen.getByText(/is taken over while it drapes/)).toBeTruthy();
    expect(screen.queryByRole('button', { name: 'Go on with the change' })).toBeNull();
  });

  it('asks where cloth cannot simply hang on', () => {
    page.change(edit('reverse_seam'));
    scene();
    click(screen.getByRole('button', { name: 'Go on with the change' }));
    expect(page.asked()).toEqual([['goOn']]);
  });
});
