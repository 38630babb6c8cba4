// The pieces of a file as they will be, with the seams that are ticked.

import { useRef } from 'preact/hooks';
import type { Import, Piece } from '../api/types';
import { useCommands } from '../commands/context';
import { PieceShape } from './PieceShape';
import { PieceTags } from './PieceTags';
import { SeamShapes, Threads, type ShownSeam } from './SeamShapes';
import { useSizeOf } from './useSizeOf';
import { fit, roomWithin, seenBox, viewBox, type Rim } from './Viewport';
import { piecesDrawn, seamsInReach, sourceNames, type ImportDraft, type PreviewProps } from '../state/importDraft';
import { layOut, type PlacedPiece } from '../state/layout';
import { joined } from '../state/patternGeometry';
import { seamParts } from '../state/seamView';
import { t } from '../texts/language';

const kRim: Rim = { side: 20, top: 20, bottom: 20 };
const kNoRim: Rim = { side: 2, top: 2, bottom: 2 };

/** The ticked seams and the lit one. */
function seamsShown(draft: ImportDraft, report: Import, lit: string | null, pictures: readonly Piece[]): ShownSeam[] {
  return seamsInReach(report, draft.left)
    .filter((seam) => draft.chosen.has(seam.id) || seam.id === lit)
    .map((seam) => ({
      seam,
      index: report.seams.indexOf(seam),
      parts: seamParts(pictures, seam),
    }));
}

export function ImportPreview({ draft, report, lit, onLight, piece, onPiece }: PreviewProps) {
  const svg = useRef<SVGSVGElement>(null);
  const view = useSizeOf(svg, { width: 600, height: 500 }).value;
  const placed = layOut(piecesDrawn(report), roomWithin(view, kRim));
  const sources = sourceNames(report);
  if (placed.length === 0) {
    return (
      <div class="import-preview">
        <svg ref={svg} class="plane" />
        <p class="hint">{t.imports.nothingToCut}</p>
      </div>
    );
  }
  const port = fit(joined(placed.map((one) => one.box)), view, kRim);
  const pictures = placed.map((one) => one.piece);
  const seams = seamsShown(draft, report, lit, pictures);
  const told = pictures.flatMap(({ id }) => ((sources.get(id) ?? id) === piece ? [id] : []));
  const shown = seams.find((one) => one.seam.id === lit);
  return (
    <div class="import-preview">
      <svg
        ref={svg}
        class="plane"
        viewBox={viewBox(port, view.width, view.height)}
        role="group"
        aria-label={t.imports.preview(placed.length)}
      >
        {placed.map((one) => (
          <FilePiece
            key={one.piece.id}
            placed={one}
            source={sources.get(one.piece.id) ?? one.piece.id}
            draft={draft}
            scale={port.scale}
            lit={piece}
            onLight={onPiece}
          >
            <SeamShapes
              shown={seams}
              piece={one.piece.id}
              scale={port.scale}
              lit={lit}
              onLight={onLight}
              onSelect={null}
            />
          </FilePiece>
        ))}
        {shown && <Threads shown={shown} placed={placed} scale={port.scale} />}
        <PieceTags placed={placed} told={told} scale={port.scale} seen={seenBox(port, view, kNoRim)} />
      </svg>
    </div>
  );
}

interface FilePieceProps {
  placed: PlacedPiece;
  /** Its name in the file. */
  source: string;
  draft: ImportDraft;
  scale: number;
  /** The piece of the file that is pointed at. */
  lit: string | null;
  onLight(piece: string | null): void;
  children: preact.ComponentChildren;
}

/** A piece of the file: a click leaves it out, or takes it in again. */
function FilePiece({ placed, source, draft, scale, lit, onLight, children }: FilePieceProps) {
  const { imports } = useCommands();
  const out = draft.left.has(source);
  const turn = (): void => imports.takePiece(source, out);
  return (
    <g class={out ? 'left-out' : ''} onClick={turn}>
      <PieceShape
        placed={placed}
        scale={scale}
        selected={false}
        hovered={lit === source}
        onSelect={turn}
        onHover={(on) => onLight(on ? source : null)}
      >
        {children}
      </PieceShape>
    </g>
  );
}
