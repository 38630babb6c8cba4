// What the hand holds on the 2D view. It is shown as it will be while the pointer moves, and until the service has answered.

import { useSignal, useSignalEffect } from '@preact/signals';
import { useRef } from 'preact/hooks';
import { useAppState } from '../state/context';
import type { Drag, Held } from '../tools/PatternTool';

export interface HeldState {
  /** As it is at the moment, also between two pictures. */
  now(): Held | null;
  show(held: Held | null): void;
  /** Nothing else can be taken before the answer has come. */
  isOnItsWay(): boolean;
  send(drag: Drag, held: Held): Promise<void>;
}

export function useHeld(): HeldState {
  const state = useAppState();
  const held = useSignal<Held | null>(null);
  const sent = useRef(false);

  // What was let go of stays where it was put until the pieces come anew.
  useSignalEffect(() => {
    void state.pieces.value;
    if (sent.current) {
      sent.current = false;
      held.value = null;
    }
  });
  useSignalEffect(() => {
    if (state.editing.problem.value) held.value = null;
  });

  return {
    now: () => held.value,
    show: (next) => (held.value = next),
    isOnItsWay: () => sent.current,
    send: async (drag, now) => {
      sent.current = true;
      const before = state.project.value?.revision;
      await drag.drop(now);
      if (state.project.value?.revision !== before) return;
      // No new revision, no new pieces: nothing else would put it back.
      sent.current = false;
      held.value = null;
    },
  };
}
