// What part of the plane is shown: follows its place on the page, wheel and keys.

import { useComputed, useSignal, useSignalEffect, type ReadonlySignal, type Signal } from '@preact/signals';
import { useRef, type MutableRef } from 'preact/hooks';
import type { Point } from '../api/types';
import type { Room } from '../state/packing';
import { joined, type Box } from '../state/patternGeometry';
import { useSizeOf } from './useSizeOf';
import { fit, panned, seenBox, viewBox, zoomed, type Rim, type Viewport } from './Viewport';

const kWheelStep = 1.0015;
/** Clear of the tools above, of the buttons and two lines of the note below, as styles/pattern.css has them. */
const kRim: Rim = { side: 14, top: 50, bottom: 58 };
/** Both are higher where fingers press them, as styles/touch.css says. */
const kFinger = '--finger';
const fingerPx = (of: Element | null): number => (of && parseFloat(getComputedStyle(of).getPropertyValue(kFinger))) || 0;
const kPanKeys: Record<string, [number, number]> = {
  arrowleft: [40, 0],
  arrowright: [-40, 0],
  arrowup: [0, 40],
  arrowdown: [0, -40],
};

/** The plane's place on the page. */
export interface PlaneFrame {
  svg: MutableRef<SVGSVGElement | null>;
  size: ReadonlySignal<Room>;
  rim: ReadonlySignal<Rim>;
}

export function usePlaneFrame(): PlaneFrame {
  const svg = useRef<SVGSVGElement>(null);
  const size = useSizeOf(svg, { width: 400, height: 400 });
  const rim = useComputed((): Rim => {
    void size.value;
    const more = fingerPx(svg.current);
    return { ...kRim, top: kRim.top + more, bottom: kRim.bottom + more };
  });
  return { svg, size, rim };
}

export interface PlaneView {
  svg: PlaneFrame['svg'];
  view: Signal<Viewport>;
  viewBox: string;
  /** What is seen of the plane beside the tools, y up. */
  seen: Box;
  move(next: Viewport): void;
  zoom(factor: number): void;
  fitAll(): void;
  /** The point of the plane under the pointer, mm, y up. */
  worldOf(event: MouseEvent): Point;
  wheel(event: WheelEvent): void;
  keys(event: KeyboardEvent): void;
}

/** `boxes` of all that is shown; the view fits them until it is moved by hand, and again for another `subject`. */
export function usePlaneView({ svg, size, rim }: PlaneFrame, boxes: () => readonly Box[], subject: () => string | null): PlaneView {
  const view = useSignal<Viewport>({ x: 0, y: 0, scale: 0.2 });
  const touched = useRef<string | null | false>(false);

  const fitAll = (): void => {
    const all = boxes();
    if (all.length === 0) return;
    touched.current = false;
    view.value = fit(joined(all), size.value, rim.value);
  };
  useSignalEffect(() => {
    void size.value;
    const now = subject();
    if (boxes().length > 0 && (touched.current === false || touched.current !== now)) fitAll();
  });

  const move = (next: Viewport): void => {
    touched.current = subject();
    view.value = next;
  };
  const zoom = (factor: number): void => move(zoomed(view.value, factor));
  /** Pixels from the view's middle. */
  const fromMiddle = (event: MouseEvent): Point => {
    const box = svg.current!.getBoundingClientRect();
    return [event.clientX - box.left - box.width / 2, event.clientY - box.top - box.height / 2];
  };
  return {
    svg,
    view,
    viewBox: viewBox(view.value, size.value.width, size.value.height),
    seen: seenBox(view.value, size.value, rim.value),
    move,
    zoom,
    fitAll,
    worldOf: (event) => {
      const [px, py] = fromMiddle(event);
      const { x, y, scale } = view.value;
      return [x + px / scale, -(y + py / scale)];
    },
    wheel: (event) => {
      event.preventDefault();
      move(zoomed(view.value, kWheelStep ** -event.deltaY, ...fromMiddle(event)));
    },
    keys: (event) => {
      const key = event.key.toLowerCase();
      const pan = kPanKeys[key];
      if (event.ctrlKey || event.metaKey) return;
      if (pan) move(panned(view.value, ...pan));
      else if (key === '+' || key === '=') zoom(1.25);
      else if (key === '-') zoom(0.8);
      else if (key === 'f' || key === '0') fitAll();
      else return;
      event.preventDefault();
    },
  };
}
