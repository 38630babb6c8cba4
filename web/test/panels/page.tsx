// A part of the page in a document without a browser: tests look at what a person sees there, and at what the page is
// asked to do.

import './browser';
import { configure, fireEvent } from '@testing-library/dom';
import { render, type ComponentChild } from 'preact';
import { act } from 'preact/test-utils';
import { afterEach } from 'vitest';
import type { Commands } from '../../src/commands/Commands';
import { CommandsContext } from '../../src/commands/context';
import { AppState, ready } from '../../src/state/AppState';
import { StateContext } from '../../src/state/context';
import { unit } from '../../src/texts/units';
import { projectOf } from '../fakes';

configure({
  // What a state makes of an event is seen before the test goes on.
  eventWrapper: (happen) => {
    let result: unknown;
    void act(() => void (result = happen()));
    return result;
  },
});

export type Call = [command: string, ...args: unknown[]];

/** Stands for all commands: does nothing and keeps what it was asked, as ['edits.send', …]. */
function recorder(calls: Call[], path = ''): unknown {
  return new Proxy(() => undefined, {
    get: (_, name) => recorder(calls, path === '' ? String(name) : `${path}.${String(name)}`),
    apply: (_, __, args: unknown[]) => {
      calls.push([path, ...args]);
      return Promise.resolve();
    },
  });
}

export interface Page {
  state: AppState;
  commands: Commands;
  /** What was asked since the last look. */
  asked(): Call[];
  show(part: ComponentChild): void;
  /** Changes the state, and what is seen with it. */
  change(how: (state: AppState) => void): void;
}

let root: Element | null = null;

afterEach(() => {
  if (root) void act(() => render(null, root!));
  root?.remove();
  root = null;
  unit.value = 'mm';
});

/** A page on which the project p_1 is open. */
export function openPage(): Page {
  const state = new AppState();
  const calls: Call[] = [];
  const commands = recorder(calls) as Commands;
  state.projects.value = ready([projectOf()]);
  state.jobs.value = ready([]);
  state.route.value = { name: 'project', id: 'p_1' };
  return {
    state,
    commands,
    asked: () => calls.splice(0),
    change: (how) => void act(() => how(state)),
    show: (part) => {
      root ??= document.body.appendChild(document.createElement('div'));
      void act(() =>
        render(
          <StateContext.Provider value={state}>
            <CommandsContext.Provider value={commands}>{part}</CommandsContext.Provider>
          </StateContext.Provider>,
          root!,
        ),
      );
    },
  };
}

/** Types over what stands in a field, and leaves it. */
export function type(field: HTMLElement, text: string): void {
  fireEvent.input(field, { target: { value: text } });
  fireEvent.blur(field);
}

export const click = (thing: Element): boolean => fireEvent.click(thing);

/** Ticks or chooses. */
export function choose(field: HTMLElement, value: string): void {
  fireEvent.change(field, { target: { value } });
}
