// Pieces that no seam holds, as chips: one that is chosen is lit, and what is proposed for it stands alone.

import { t } from '../texts/language';

export interface UnsewnPiecesProps {
  pieces: readonly string[];
  chosen: string | null;
  choose(piece: string | null): void;
  light(piece: string | null): void;
}

export function UnsewnPieces({ pieces, chosen, choose, light }: UnsewnPiecesProps) {
  if (pieces.length === 0) return null;
  return (
    <>
      <p class="hint">{t.pattern.unsewn(pieces.length)}</p>
      <p class="sewn-in unsewn">
        {pieces.map((piece) => (
          <button
            key={piece}
            class="seam-chip"
            aria-pressed={piece === chosen}
            onPointerEnter={() => light(piece)}
            onPointerLeave={() => light(null)}
            onClick={() => choose(piece === chosen ? null : piece)}
          >
            {piece}
          </button>
        ))}
      </p>
    </>
  );
}
