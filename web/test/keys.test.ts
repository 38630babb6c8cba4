import { describe, expect, it } from 'vitest';
import type { Commands } from '../src/commands/Commands';
import { bindings, listenForKeys } from '../src/tools/keys';
import { AppState } from '../src/state/AppState';
import type { ToolFacts } from '../src/state/editing';

/** A window that hands its key listener out. */
function begin() {
  const called: string[] = [];
  const edits = { undo: () => called.push('undo'), redo: () => called.push('redo') };
  const seams = { finishSide: () => called.push('finish') };
  const pattern = {
    takeTool: (tool: ToolFacts) => called.push(tool.id),
    remove: () => called.push('remove'),
    cancel: () => called.push('cancel') > 0,
  };
  let press: (event: KeyboardEvent) => void = () => undefined;
  const target = {
    addEventListener: (_: string, listener: typeof press) => (press = listener),
    removeEventListener: () => undefined,
  };
  const state = new AppState();
  state.route.value = { name: 'project', id: 'p_1' };
  const stop = listenForKeys(
    { edits, pattern, seams } as unknown as Commands,
    state,
    target as unknown as Window & typeof globalThis,
  );
  let taken = 0;
  const key = (name: string, more: Partial<KeyboardEvent> = {}): void =>
    press({
      key: name,
      target: null,
      shiftKey: false,
      ctrlKey: false,
      metaKey: false,
      preventDefault: () => ++taken,
      ...more,
    } as KeyboardEvent);
  return { called, key, state, stop, taken: () => taken };
}

describe('keys', () => {
  // There is no DOM here: the listener asks whether the target is an Element.
  (globalThis as { Element?: unknown }).Element ??= class {};

  it('tell Z from Ctrl+Z and Ctrl+Shift+Z', () => {
    const { called, key } = begin();
    key('z');
    key('z', { ctrlKey: true });
    key('Z', { ctrlKey: true, shiftKey: true });
    key('z', { metaKey: true });
    expect(called).toEqual(['points', 'undo', 'redo', 'undo']);
  });

  it('change nothing from the first page, where no project is open', () => {
    const { called, key, state, taken } = begin();
    state.route.value = { name: 'home' };
    for (const name of ['z', 'Delete', ' ', 'Enter']) key(name);
    expect(called).toEqual([]);
    expect(taken()).toBe(0);
    key('?');
    expect(state.helpShown.value).toBe(true);
  });

  it('leave what the browser has on Ctrl and Alt alone', () => {
    const { called, key, taken } = begin();
    key('n', { ctrlKey: true });
    key('a', { ctrlKey: true });
    key('z', { altKey: true });
    expect(called).toEqual([]);
    expect(taken()).toBe(0);
  });

  it('have one meaning each, and a name for the help', () => {
    const pressed = bindings.map((one) => `${one.ctrl ?? false} ${one.shift ?? false} ${one.key}`);
    expect(new Set(pressed).size).toBe(bindings.length);
    expect(new Set(bindings.map((one) => one.shown)).size).toBe(bindings.length);
    expect(bindings.every((one) => one.title() !== '')).toBe(true);
  });
});
