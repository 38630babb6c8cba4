// Keys and what they do, in one table: the help reads it, and remapping will write it.

import type { Commands } from '../commands/Commands';
import type { AppState } from '../state/AppState';
import { nextMap } from '../state/clothMaps';
import type { PatternTool } from './PatternTool';
import { patternTools } from './table';
import { t } from '../texts/language';
import type { Texts } from '../texts/en';

export interface Binding {
  /** KeyboardEvent.key, lower case. */
  key: string;
  shown: string;
  /** What it does, in the list of keys. */
  title(): string;
  /** Where it stands there. */
  group: keyof Texts['keys']['groups'];
  /** With Ctrl, or the command key. */
  ctrl?: boolean;
  shift?: boolean;
  /** It is for the project that is open, and does nothing on the first page. */
  work?: boolean;
  run(commands: Commands, state: AppState): void;
}

/** The key that takes a tool. */
function taking(tool: PatternTool): Binding {
  const { key: shown } = tool;
  return { key: shown.toLowerCase(), shown, title: () => tool.words().help, group: 'pattern', work: true, run: (c) => c.pattern.takeTool(tool) };
}

export const bindings: Binding[] = [
  { key: ' ', shown: 'Space', title: () => t.keys.does.run, group: 'drape', work: true, run: (c) => void c.runOrPause() },
  { key: '.', shown: '.', title: () => t.keys.does.step, group: 'drape', work: true, run: (c) => void c.act('step') },
  {
    key: 'g',
    shown: 'G',
    title: () => t.keys.does.pull,
    group: 'drape',
    work: true,
    run: (c, s) => s.touchable.value && c.live.take('pull'),
  },
  {
    key: 'i',
    shown: 'I',
    title: () => t.keys.does.pin,
    group: 'drape',
    work: true,
    run: (c, s) => {
      if (s.hands.held.value) c.live.pinHeld();
      else if (s.touchable.value) c.live.take('pin');
    },
  },
  { key: 'o', shown: 'O', title: () => t.keys.does.newProject, group: 'drape', run: (c) => c.intake.open() },
  ...patternTools.map(taking),
  {
    key: 'enter',
    shown: 'Enter',
    title: () => t.keys.does.finishSide,
    group: 'pattern',
    work: true,
    run: (c) => void c.seams.finishSide(),
  },
  {
    key: 'delete',
    shown: 'Del',
    title: () => t.keys.does.delete,
    group: 'pattern',
    work: true,
    run: (c) => void c.pattern.remove(),
  },
  {
    key: 'e',
    shown: 'E',
    title: () => t.keys.does.large,
    group: 'pattern',
    work: true,
    run: (_, s) => void (s.editing.large.value = !s.editing.large.value),
  },
  {
    key: 'z',
    shown: 'Ctrl Z',
    title: () => t.keys.does.undo,
    group: 'pattern',
    work: true,
    ctrl: true,
    run: (c) => void c.edits.undo(),
  },
  {
    key: 'z',
    shown: 'Ctrl Shift Z',
    title: () => t.keys.does.redo,
    group: 'pattern',
    work: true,
    ctrl: true,
    shift: true,
    run: (c) => void c.edits.redo(),
  },
  { key: '1', shown: '1', title: () => t.keys.does.front, group: 'view', run: (c) => c.showView('front') },
  { key: '2', shown: '2', title: () => t.keys.does.back, group: 'view', run: (c) => c.showView('back') },
  { key: '3', shown: '3', title: () => t.keys.does.side, group: 'view', run: (c) => c.showView('side') },
  { key: '4', shown: '4', title: () => t.keys.does.threeQuarter, group: 'view', run: (c) => c.showView('three-quarter') },
  {
    key: 'b',
    shown: 'B',
    title: () => t.keys.does.body,
    group: 'view',
    run: (_, s) => void (s.bodyShown.value = !s.bodyShown.value),
  },
  {
    key: 'w',
    shown: 'W',
    title: () => t.keys.does.mesh,
    group: 'view',
    run: (_, s) => void (s.meshShown.value = !s.meshShown.value),
  },
  {
    key: 'x',
    shown: 'X',
    title: () => t.keys.does.map,
    group: 'view',
    work: true,
    run: (_, s) => (s.mapKind.value = nextMap(s.mapKind.value, (kind) => s.missingMaps.value[kind] !== undefined)),
  },
  {
    key: 'c',
    shown: 'C',
    title: () => t.keys.does.section,
    group: 'view',
    work: true,
    run: (_, s) => s.cuttable.value && s.turnToSection(),
  },
  {
    key: 'l',
    shown: 'L',
    title: () => t.keys.does.rail,
    group: 'view',
    run: (_, s) => void (s.railShown.value = !s.railShown.value),
  },
  {
    key: '?',
    shown: '?',
    title: () => t.keys.does.help,
    group: 'help',
    run: (_, s) => void (s.helpShown.value = !s.helpShown.value),
  },
  {
    key: 'escape',
    shown: 'Esc',
    title: () => t.keys.does.escape,
    group: 'help',
    run: (c, s) => {
      if (s.helpShown.value) s.helpShown.value = false;
      else if (!c.tours.end() && !c.live.putAway() && !c.pattern.cancel()) c.select(null);
    },
  },
];

/** "Ctrl Shift Z" as the reader's keyboard has it. */
export const shownKey = ({ shown }: Pick<Binding, 'shown'>): string =>
  shown
    .split(' ')
    .map((key) => (t.keys.names as Record<string, string>)[key] ?? key)
    .join(' ');

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
