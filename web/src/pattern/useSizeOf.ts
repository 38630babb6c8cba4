// How large an element is on the page, as it changes.

import { useSignal, type Signal } from '@preact/signals';
import { useLayoutEffect, type MutableRef } from 'preact/hooks';
import type { Room } from '../state/packing';

/** Pixels. `first` until the element has been laid out, and what it was last while it is hidden: scales are made from it. */
export function useSizeOf(element: MutableRef<Element | null>, first: Room): Signal<Room> {
  const size = useSignal(first);
  // Before anything is painted at a size that it has not.
  useLayoutEffect(() => {
    const watched = element.current!;
    const measure = (): void => {
      const { clientWidth: width, clientHeight: height } = watched;
      if (width > 0 && height > 0) size.value = { width, height };
    };
    measure();
    const watcher = new ResizeObserver(measure);
    watcher.observe(watched);
    return () => watcher.disconnect();
  }, [element, size]);
  return size;
}
