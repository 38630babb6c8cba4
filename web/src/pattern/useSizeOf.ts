// How large an element is on the page, as it changes.

import { useSignal, type Signal } from '@preact/signals';
import { useEffect, type MutableRef } from 'preact/hooks';

export interface Size {
  /** Pixels. */
  width: number;
  height: number;
}

/** `first` until the element has been laid out; never zero, since scales are made from it. */
export function useSizeOf(element: MutableRef<Element | null>, first: Size): Signal<Size> {
  const size = useSignal(first);
  useEffect(() => {
    const watched = element.current!;
    const watcher = new ResizeObserver(
      () => (size.value = { width: watched.clientWidth || 1, height: watched.clientHeight || 1 }),
    );
    watcher.observe(watched);
    return () => watcher.disconnect();
  }, [element, size]);
  return size;
}
