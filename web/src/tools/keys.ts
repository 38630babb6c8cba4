// Keys and what they do, in one table: the help reads it, and remapping will write it.

import type { Commands } from '../commands/Commands';
import type { AppState } from '../state/AppState';
import { nextMap } from '../state/clothMaps';
import type { PatternTool } from './PatternTool';
import { patternTools } from './table';

export interface Binding {
  /** KeyboardEvent.key, lower case. */
  key: string;
  shown: string;
  title: string;
  group: string;
  /** With Ctrl, or the command key. */
  ctrl?: boolean;
  shift?: boolean;
  /** It is for the project that is open, and does nothing on the first page. */
  work?: boolean;
  run(commands: Commands, state: AppState): void;
}

/** The key that takes a tool. */
function taking(tool: PatternTool): Binding {
  const { key: shown, help: title } = tool;
  return { key: shown.toLowerCase(), shown, title, group: 'Pattern', work: true, run: (c) => c.pattern.takeTool(tool) };
}

export const bindings: Binding[] = [
  { key: ' ', shown: 'Space', title: 'Start, pause or go on', group: 'Drape', work: true, run: (c) => void c.runOrPause() },
  { key: 'o', shown: 'O', title: 'New project from files', group: 'Drape', run: (c) => c.openIntake() },
  ...patternTools.map(taking),
  {
    key: 'enter',
    shown: 'Enter',
    title: 'Other side, then sew',
    group: 'Pattern',
    work: true,
    run: (c) => void c.pattern.finishSide(),
  },
  {
    key: 'delete',
    shown: 'Del',
    title: 'Delete what is selected',
    group: 'Pattern',
    work: true,
    run: (c) => void c.pattern.remove(),
  },
  {
    key: 'e',
    shown: 'E',
    title: 'Large or small pattern',
    group: 'Pattern',
    work: true,
    run: (_, s) => void (s.editing.large.value = !s.editing.large.value),
  },
  {
    key: 'z',
    shown: 'Ctrl Z',
    title: 'Undo',
    group: 'Pattern',
    work: true,
    ctrl: true,
    run: (c) => void c.pattern.undo(),
  },
  {
    key: 'z',
    shown: 'Ctrl Shift Z',
    title: 'Redo',
    group: 'Pattern',
    work: true,
    ctrl: true,
    shift: true,
    run: (c) => void c.pattern.redo(),
  },
  { key: '1', shown: '1', title: 'Front view', group: 'View', run: (c) => c.showView('front') },
  { key: '2', shown: '2', title: 'Back view', group: 'View', run: (c) => c.showView('back') },
  { key: '3', shown: '3', title: 'Side view', group: 'View', run: (c) => c.showView('side') },
  { key: '4', shown: '4', title: 'Three-quarter view', group: 'View', run: (c) => c.showView('three-quarter') },
  {
    key: 'b',
    shown: 'B',
    title: 'Body on or off',
    group: 'View',
    run: (_, s) => void (s.bodyShown.value = !s.bodyShown.value),
  },
  {
    key: 'm',
    shown: 'M',
    title: 'Mesh on or off',
    group: 'View',
    run: (_, s) => void (s.meshShown.value = !s.meshShown.value),
  },
  {
    key: 'x',
    shown: 'X',
    title: 'Next map of the cloth',
    group: 'View',
    work: true,
    run: (_, s) => (s.mapKind.value = nextMap(s.mapKind.value)),
  },
  {
    key: 'l',
    shown: 'L',
    title: 'Project list on or off',
    group: 'View',
    run: (_, s) => void (s.railShown.value = !s.railShown.value),
  },
  {
    key: '?',
    shown: '?',
    title: 'This list',
    group: 'Help',
    run: (_, s) => void (s.helpShown.value = !s.helpShown.value),
  },
  {
    key: 'escape',
    shown: 'Esc',
    title: 'Select nothing, close',
    group: 'Help',
    run: (c, s) => {
      if (s.helpShown.value) s.helpShown.value = false;
      else if (!c.pattern.cancel()) c.select(null);
    },
  },
];

/** A key that belongs to the element that has the focus: typing, or pressing a button with Space. */
function belongsTo(target: EventTarget | null, key: string): boolean {
  const element = target instanceof Element ? target : null;
  if (!element) return false;
  if (element.closest('input, textarea, select, dialog, [contenteditable]')) return true;
  return (key === ' ' || key === 'enter') && element.closest('button, a, summary, [role=button], [role=tab]') !== null;
}

/** Listens on the window; returns how to stop. */
export function listenForKeys(commands: Commands, state: AppState, target: Window = window): () => void {
  const listener = (event: KeyboardEvent): void => {
    if (event.altKey || event.isComposing) return;
    const key = event.key.toLowerCase();
    const ctrl = event.ctrlKey || event.metaKey;
    const binding = bindings.find(
      (candidate) =>
        candidate.key === key &&
        (candidate.ctrl ?? false) === ctrl &&
        (!ctrl || (candidate.shift ?? false) === event.shiftKey),
    );
    if (!binding || (binding.work && state.atHome.value)) return;
    if (belongsTo(event.target, key) || (event.repeat && key === ' ')) return;
    event.preventDefault();
    binding.run(commands, state);
  };
  target.addEventListener('keydown', listener);
  return () => target.removeEventListener('keydown', listener);
}
