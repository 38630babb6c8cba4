// The flat pieces beside the 3D view: pan, zoom, fit; names, sizes, grain; seams in pairs of one colour; selecting.

import { useComputed, useSignal, useSignalEffect } from '@preact/signals';
import { useEffect, useRef } from 'preact/hooks';
import type { Pieces } from '../api/types';
import { useCommands } from '../commands/context';
import { valueOf } from '../state/AppState';
import { useAppState } from '../state/context';
import { joined, layOut, seamLines } from '../state/patternGeometry';
import { sentence } from '../state/words';
import { PieceShape } from './PieceShape';
import { fit, panned, viewBox, zoomed, type Viewport } from './Viewport';

const kWheelStep = 1.0015;
const kPanKeys: Record<string, [number, number]> = {
  arrowleft: [40, 0],
  arrowright: [-40, 0],
  arrowup: [0, 40],
  arrowdown: [0, -40],
};

export function PatternPane() {
  const state = useAppState();
  const pieces = state.pieces.value;
  return (
    <section class="pattern" aria-label="Pattern">
      {pieces === null && <p class="hint">The flat pieces of the garment appear here.</p>}
      {pieces?.state === 'loading' && (
        <div class="skeleton-pieces" role="status" aria-label="Loading the pattern">
          <i />
          <i />
          <i />
          <i />
        </div>
      )}
      {pieces?.state === 'failed' && (
        <div class="pane-error" role="alert">
          <h3>The pattern cannot be shown</h3>
          <p>{sentence(pieces.error.detail)}</p>
          <p class="code">
            {pieces.error.code}
            {pieces.error.where && <> · {pieces.error.where}</>}
          </p>
        </div>
      )}
      {pieces?.state === 'ready' && <Plane pieces={pieces.value} />}
    </section>
  );
}

function Plane({ pieces }: { pieces: Pieces }) {
  const state = useAppState();
  const commands = useCommands();
  const svg = useRef<SVGSVGElement>(null);
  const size = useSignal({ width: 400, height: 400 });
  const view = useSignal<Viewport>({ x: 0, y: 0, scale: 0.2 });
  const touched = useRef(false);
  const seam = useSignal<string | null>(null);
  const placed = useComputed(() => layOut(valueOf(state.pieces.value ?? { state: 'loading' })?.pieces ?? []));
  const lines = seamLines(pieces.pieces, pieces.seams);

  const fitAll = (): void => {
    if (placed.value.length === 0) return;
    touched.current = false;
    view.value = fit(joined(placed.value.map((piece) => piece.box)), size.value.width, size.value.height);
  };
  useEffect(() => {
    const element = svg.current!;
    const watcher = new ResizeObserver(
      () => (size.value = { width: element.clientWidth || 1, height: element.clientHeight || 1 }),
    );
    watcher.observe(element);
    return () => watcher.disconnect();
  }, []);
  useSignalEffect(() => {
    void size.value;
    void placed.value;
    if (!touched.current) fitAll();
  });

  const move = (next: Viewport): void => {
    touched.current = true;
    view.value = next;
  };
  const wheel = (event: WheelEvent): void => {
    event.preventDefault();
    const box = svg.current!.getBoundingClientRect();
    const px = event.clientX - box.left - box.width / 2,
      py = event.clientY - box.top - box.height / 2;
    move(zoomed(view.value, kWheelStep ** -event.deltaY, px, py));
  };
  const keys = (event: KeyboardEvent): void => {
    const key = event.key.toLowerCase();
    const pan = kPanKeys[key];
    if (pan) move(panned(view.value, ...pan));
    else if (key === '+' || key === '=') move(zoomed(view.value, 1.25));
    else if (key === '-') move(zoomed(view.value, 0.8));
    else if (key === 'f' || key === '0') fitAll();
    else return;
    event.preventDefault();
  };

  return (
    <>
      <svg
        ref={svg}
        class="plane"
        tabindex={0}
        viewBox={viewBox(view.value, size.value.width, size.value.height)}
        onWheel={wheel}
        onKeyDown={keys}
        {...dragging(
          () => view.value,
          move,
          () => commands.select(null),
        )}
        aria-label={`${pieces.pieces.length} pieces; arrow keys move, plus and minus zoom, F fits`}
        role="group"
      >
        <Paper scale={view.value.scale} />
        {placed.value.map((piece) => (
          <PieceShape
            key={piece.piece.id}
            placed={piece}
            scale={view.value.scale}
            lines={lines.filter((line) => line.piece === piece.piece.id)}
            selected={state.selected.value === piece.piece.id}
            hovered={state.hovered.value === piece.piece.id}
            seam={seam.value}
            onSeam={(id) => (seam.value = id)}
            onSelect={() => commands.select(state.selected.value === piece.piece.id ? null : piece.piece.id)}
            onHover={(on) => commands.hover(on ? piece.piece.id : null)}
          />
        ))}
      </svg>
      <div class="plane-tools" role="toolbar" aria-label="Pattern view">
        <button class="tool" title="Zoom out (−)" aria-label="Zoom out" onClick={() => move(zoomed(view.value, 0.8))}>
          −
        </button>
        <button class="tool wide" title="Fit all pieces (F)" onClick={fitAll}>
          Fit
        </button>
        <button class="tool" title="Zoom in (+)" aria-label="Zoom in" onClick={() => move(zoomed(view.value, 1.25))}>
          +
        </button>
      </div>
      {seam.value && (
        <p class="seam-note" role="status">
          Seam <b>{seam.value}</b>
        </p>
      )}
    </>
  );
}

/** Drags with the left button on empty paper or the middle one anywhere; a press that does not move is a click. */
function dragging(view: () => Viewport, move: (next: Viewport) => void, click: () => void) {
  let last: { x: number; y: number; far: boolean } | null = null;
  const onPaper = (event: PointerEvent): boolean => !(event.target as Element).closest('.piece');
  return {
    onPointerDown: (event: PointerEvent) => {
      if (event.button !== 1 && !(event.button === 0 && onPaper(event))) return;
      last = { x: event.clientX, y: event.clientY, far: false };
      (event.currentTarget as Element).setPointerCapture(event.pointerId);
    },
    onPointerMove: (event: PointerEvent) => {
      if (!last || event.buttons === 0) return;
      const dx = event.clientX - last.x,
        dy = event.clientY - last.y;
      if (!last.far && Math.hypot(dx, dy) < 4) return;
      last = { x: event.clientX, y: event.clientY, far: true };
      move(panned(view(), dx, dy));
    },
    onPointerUp: (event: PointerEvent) => {
      if (last && !last.far && event.button === 0) click();
      last = null;
    },
  };
}

/** Squares of 10 cm behind the pieces, of 1 cm when near. */
function Paper({ scale }: { scale: number }) {
  const cell = scale > 1.2 ? 10 : 100;
  return (
    <>
      <defs>
        <pattern id="paper" width={cell} height={cell} patternUnits="userSpaceOnUse">
          <path class="paper-line" d={`M${cell} 0H0V${cell}`} stroke-width={1 / scale} />
        </pattern>
      </defs>
      <rect class="paper" x={-1e5} y={-1e5} width={2e5} height={2e5} fill="url(#paper)" />
    </>
  );
}
