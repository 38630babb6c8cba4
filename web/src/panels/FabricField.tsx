// What a piece, or the whole garment, is cut of: its card, and the library's cards to choose another from.

import { useComputed, useSignal } from '@preact/signals';
import { useEffect, useId } from 'preact/hooks';
import type { EditOf, Fabric, Piece } from '../api/types';
import { useCommands } from '../commands/context';
import { useAppState } from '../state/context';
import { fabricCard, fabricTitle, fabricsFound, figuresOf, handOf, originOf, stiffness, wordsOf, type Kind } from '../state/fabrics';
import { FabricSwatch } from './FabricSwatch';
import { t } from '../texts/language';

export function FabricField({ pieces }: { pieces: readonly Piece[] }) {
  const { edits, pattern } = useCommands();
  const { editing } = useAppState();
  const isOpen = useSignal(false);
  useEffect(() => void pattern.loadFabrics(), [pattern]);
  const names = [...new Set(pieces.map((piece) => piece.fabric))];
  const [fabrics, own] = [editing.fabrics.value, editing.ownFabrics.value];
  const titles = names.map((name) => fabricTitle(name, fabrics, own));
  const known = names.length === 1 ? fabricCard(names[0]!, fabrics, own) : null;
  const whose = pieces.length === 1 ? t.fabric.fabric : t.fabric.fabricOfAll;
  const choose = (fabric: string): void => {
    isOpen.value = false;
    const cut = cutOf(pieces, fabric);
    if (cut.length > 0) void edits.send(...cut);
  };
  return (
    <section class="fabric" aria-label={t.fabric.cutOf(whose)}>
      <h3>
        {whose}
        {names.length > 1 && <span class="head-note">{t.fabric.differ}</span>}
      </h3>
      <div class="fabric-now">
        {known ? <Card fabric={known} title={titles[0]} /> : <p class="fabric-own">{titles.join(', ') || t.common.nothing}</p>}
        <button class="plain" aria-expanded={isOpen.value} onClick={() => (isOpen.value = !isOpen.value)}>
          {isOpen.value ? t.fabric.keep : t.fabric.change}
        </button>
      </div>
      {isOpen.value && <Library fabrics={fabrics} now={known?.name ?? ''} choose={choose} />}
      {!isOpen.value && known && <Figures fabric={known} />}
    </section>
  );
}

/** Of those that are cut of another one. */
const cutOf = (pieces: readonly Piece[], fabric: string): EditOf<'set_fabric'>[] =>
  pieces.filter((piece) => piece.fabric !== fabric).map(({ id }) => ({ edit: 'set_fabric', piece: id, fabric }));

/** Snippet, name and what it is. */
function Card({ fabric, title = wordsOf(fabric).title }: { fabric: Fabric; title?: string }) {
  const { make } = wordsOf(fabric);
  return (
    <span class="fabric-card">
      <FabricSwatch fabric={fabric} />
      <span>
        <b>{title}</b>
        <small>{`${fabric.areal_mass_g_m2} g/m² · ${make}`}</small>
        <Hand fabric={fabric} />
      </span>
    </span>
  );
}

/** How it falls, from soft to stiff. */
const Hand = ({ fabric }: { fabric: Fabric }) => (
  <span class="fabric-hand">
    <i aria-hidden="true">
      <em style={{ left: `${(100 * stiffness(fabric)).toFixed(0)}%` }} />
    </i>
    <small>{handOf(fabric)}</small>
  </span>
);

function Figures({ fabric }: { fabric: Fabric }) {
  const { use } = wordsOf(fabric);
  return (
    <details class="fabric-figures">
      <summary>{t.fabric.figures}</summary>
      <dl class="facts">
        {figuresOf(fabric).map(({ label, value }) => (
          <div key={label}>
            <dt>{label}</dt>
            <dd>{value}</dd>
          </div>
        ))}
      </dl>
      <p class="selection-facts">
        {use && `${t.fabric.goodFor(use)} `}
        {originOf(fabric)}
      </p>
    </details>
  );
}

const kKinds: readonly Kind[] = ['all', 'woven', 'knit', 'other'];

interface LibraryProps {
  fabrics: readonly Fabric[];
  /** The one that the pieces are cut of. */
  now: string;
  choose(fabric: string): void;
}

function Library({ fabrics, now, choose }: LibraryProps) {
  const text = useSignal('');
  const kind = useSignal<Kind>('all');
  const found = useComputed(() => fabricsFound(fabrics, text.value, kind.value)).value;
  const id = useId();
  return (
    <div class="fabric-library">
      <div class="fabric-find">
        <label class="visually-hidden" for={id}>
          {t.fabric.find}
        </label>
        <input
          id={id}
          type="search"
          placeholder={t.fabric.findWhat}
          value={text.value}
          onInput={(event) => (text.value = event.currentTarget.value)}
        />
        <div class="choice" role="radiogroup" aria-label={t.fabric.kind}>
          {kKinds.map((one) => (
            <button key={one} role="radio" aria-checked={kind.value === one} onClick={() => (kind.value = one)}>
              {t.fabric.kinds[one]}
            </button>
          ))}
        </div>
      </div>
      {found.length === 0 && <p class="hint">{t.fabric.noneSo}</p>}
      <ul>
        {found.map((fabric) => (
          <li key={fabric.name}>
            <button aria-pressed={fabric.name === now} onClick={() => choose(fabric.name)}>
              <Card fabric={fabric} />
            </button>
          </li>
        ))}
      </ul>
    </div>
  );
}
