// What a piece, or the whole garment, is cut of: a fabric of the library, or one of the project's own.

import { useEffect } from 'preact/hooks';
import type { Fabric, Piece } from '../api/types';
import { useCommands } from '../commands/context';
import { useAppState } from '../state/context';

export function FabricField({ pieces }: { pieces: readonly Piece[] }) {
  const { pattern } = useCommands();
  const { fabrics } = useAppState().editing;
  useEffect(() => void pattern.loadFabrics(), [pattern]);
  const names = [...new Set(pieces.map((piece) => piece.fabric))];
  const now = names.length === 1 ? names[0]! : '';
  const known = fabrics.value.find((fabric) => fabric.name === now);
  const choose = (fabric: string): void =>
    void pattern.edit(...pieces.map((piece) => ({ edit: 'set_fabric' as const, piece: piece.id, fabric })));
  return (
    <section class="fabric" aria-label={pieces.length === 1 ? 'Fabric of the piece' : 'Fabric of all pieces'}>
      <h3>
        {pieces.length === 1 ? 'Fabric' : 'Fabric of all pieces'}
        {names.length > 1 && <span class="head-note">pieces differ</span>}
      </h3>
      <label class="select-field">
        <span>Cut of</span>
        <select value={now} onChange={(event) => choose(event.currentTarget.value)}>
          {!known && (
            <option value={now} disabled={now === ''}>
              {now === '' ? 'Different ones' : now}
            </option>
          )}
          {fabrics.value.map((fabric) => (
            <option key={fabric.name} value={fabric.name}>
              {fabric.title}
            </option>
          ))}
        </select>
      </label>
      {known && <p class="selection-facts">{factsOf(known)}</p>}
    </section>
  );
}

const factsOf = ({ areal_mass_g_m2, thickness_mm, fibre, weave }: Fabric): string =>
  `${areal_mass_g_m2} g/m² · ${thickness_mm} mm · ${fibre}, ${weave}`;
