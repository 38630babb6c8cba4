// The pieces of a file as they will be, with the seams that are ticked.

import { useComputed, useSignal } from '@preact/signals';
import { useEffect, useRef } from 'preact/hooks';
import type { Import } from '../api/types';
import { useCommands } from '../commands/context';
import { PieceShape } from './PieceShape';
import { SeamShapes, Threads, type ShownSeam } from './SeamShapes';
import { fit, viewBox } from './Viewport';
import { pictureOf, seamsInReach, sourceNames, type ImportDraft } from '../state/importDraft';
import { joined, layOut } from '../state/patternGeometry';
import { seamParts } from '../state/seamView';

export interface ImportPreviewProps {
  draft: ImportDraft;
  report: Import;
  lit: string | null;
  onLight(seam: string | null): void;
}

export function ImportPreview({ draft, report, lit, onLight }: ImportPreviewProps) {
  const { imports } = useCommands();
  const svg = useRef<SVGSVGElement>(null);
  const size = useSignal({ width: 600, height: 500 });
  const hovered = useSignal<string | null>(null);
  useEffect(() => {
    const element = svg.current!;
    const watcher = new ResizeObserver(
      () => (size.value = { width: element.clientWidth || 1, height: element.clientHeight || 1 }),
    );
    watcher.observe(element);
    return () => watcher.disconnect();
  }, []);
  const placed = layOut(report.pieces.filter((piece) => piece.points.length > 2).map(pictureOf));
  const view = useComputed(() => size.value).value;
  if (placed.length === 0) {
    return (
      <div class="import-preview">
        <svg ref={svg} class="plane" />
        <p class="hint">No piece of this file can be cut.</p>
      </div>
    );
  }
  const port = fit(joined(placed.map((one) => one.box)), view.width, view.height, 24);
  const sources = sourceNames(report);
  const pictures = placed.map((one) => one.piece);
  const named = (side: Import['seams'][number]['a']) =>
    side.map((use) => ({ ...use, piece: sources.get(use.piece) ?? use.piece }));
  const seams: ShownSeam[] = seamsInReach(report, draft.left)
    .filter((seam) => draft.chosen.has(seam.id) || seam.id === lit)
    .map((seam) => ({
      seam,
      index: report.seams.indexOf(seam),
      parts: seamParts(pictures, { ...seam, a: named(seam.a), b: named(seam.b) }),
    }));
  const shown = seams.find((one) => one.seam.id === lit);
  return (
    <div class="import-preview">
      <svg
        ref={svg}
        class="plane"
        viewBox={viewBox(port, view.width, view.height)}
        role="group"
        aria-label={`Preview of ${placed.length} pieces`}
      >
        {placed.map((one) => {
          const { id } = one.piece;
          const out = draft.left.has(id);
          return (
            <g key={id} class={out ? 'left-out' : ''} onClick={() => imports.takePiece(id, out)}>
              <PieceShape
                placed={one}
                scale={port.scale}
                selected={false}
                hovered={hovered.value === id}
                onSelect={() => imports.takePiece(id, out)}
                onHover={(on) => (hovered.value = on ? id : null)}
              >
                <SeamShapes shown={seams} piece={id} scale={port.scale} lit={lit} onLight={onLight} onSelect={null} />
              </PieceShape>
            </g>
          );
        })}
        {shown && <Threads shown={shown} placed={placed} scale={port.scale} />}
      </svg>
    </div>
  );
}
