// Modal dialogs: shown while they stand in the page, and left by Escape or their cross.

import type { ComponentChildren, RefObject } from 'preact';
import { useEffect, useRef } from 'preact/hooks';
import { t } from '../texts/language';
import { Icon } from './Icon';

export interface Modal {
  ref: RefObject<HTMLDialogElement>;
  leave(): void;
  onCancel(event: Event): void;
  onClose(): void;
}

/**
 * A dialog element that is modal as long as it is rendered. `close` ends what the dialog stands for, and does so before
 * leave() returns: the browser's own close event comes in a later task, and a key pressed in between (O, right after
 * Escape) would find the old state still there and be lost. `mayLeave` answers whether Escape leaves now.
 */
export function useModal(close: () => void, mayLeave: () => boolean = () => true): Modal {
  const ref = useRef<HTMLDialogElement>(null);
  // After every rendering: a dialog that was left and asked for again at once is rendered by the same component.
  useEffect(() => {
    if (ref.current && !ref.current.open) ref.current.showModal();
  });
  const leave = (): void => {
    ref.current?.close(); // gives the focus back to where it was
    close();
  };
  const onCancel = (event: Event): void => {
    event.preventDefault();
    if (mayLeave()) leave();
  };
  // The browser closes by itself where it finds that a page holds its reader back.
  const onClose = (): void => {
    if (ref.current && !ref.current.open) close();
  };
  return { ref, leave, onCancel, onClose };
}

interface SheetProps {
  /** Classes beside `sheet`. */
  class: string;
  /** The title's id in the document. */
  id: string;
  title: string;
  /** What stands in the head between the title and the cross. */
  beside?: ComponentChildren;
  close(): void;
  mayLeave?: () => boolean;
  children: ComponentChildren;
}

/** A modal dialog with a title and a cross. */
export function Sheet({ class: kind, id, title, beside, close, mayLeave, children }: SheetProps) {
  const { leave, ...modal } = useModal(close, mayLeave);
  return (
    <dialog class={`sheet ${kind}`} {...modal} aria-labelledby={id}>
      <header>
        <h2 id={id}>{title}</h2>
        {beside}
        <button type="button" class="tool flat" aria-label={t.common.close} onClick={leave}>
          <Icon name="cross" />
        </button>
      </header>
      {children}
    </dialog>
  );
}
