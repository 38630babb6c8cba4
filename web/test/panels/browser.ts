// What the document without a browser lacks, as far as the page looks for it. Import it before anything of the page.

import { vi } from 'vitest';

/** Preact listens to the events that an element has a handler for, and jsdom has none for pointers. */
const kPointerEvents = ['down', 'move', 'up', 'cancel', 'enter', 'leave'];

class PointerEventHere extends MouseEvent {
  readonly pointerId: number;
  readonly pointerType: string;

  constructor(type: string, init: PointerEventInit = {}) {
    super(type, init);
    this.pointerId = init.pointerId ?? 1;
    this.pointerType = init.pointerType ?? 'mouse';
  }
}

/** Elements have no size here, so nothing is ever observed. */
class ResizeObserverHere {
  observe(): void {}
  unobserve(): void {}
  disconnect(): void {}
}

for (const name of kPointerEvents) {
  Object.defineProperty(Element.prototype, `onpointer${name}`, { value: null, writable: true, configurable: true });
}
Object.assign(Element.prototype, { scrollIntoView: () => undefined, setPointerCapture: () => undefined });
Object.assign(HTMLDialogElement.prototype, {
  showModal(this: HTMLDialogElement) {
    this.open = true;
  },
  close(this: HTMLDialogElement) {
    this.open = false;
    setTimeout(() => this.dispatchEvent(new Event('close'))); // browsers tell it in a later task, too
  },
});
Blob.prototype.text = function text(this: Blob): Promise<string> {
  return new Promise((done) => {
    const reader = new FileReader();
    reader.onload = () => done(reader.result as string);
    reader.readAsText(this);
  });
};
vi.stubGlobal('PointerEvent', PointerEventHere);
vi.stubGlobal('ResizeObserver', ResizeObserverHere);
