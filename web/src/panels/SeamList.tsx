// All seams with both lengths and their difference; the one that is selected can be turned or taken away.

import { useEffect, useRef } from 'preact/hooks';
import type { Pieces, Seam } from '../api/types';
import { useCommands } from '../commands/context';
import { useAppState } from '../state/context';
import { seamTitle, seriesText } from '../state/seamNames';
import { lengthsText, seamColour } from '../state/seamView';
import { Icon } from '../controls/Icon';
import { t } from '../texts/language';
import { Told } from '../texts/Message';

export function SeamList({ pieces }: { pieces: Pieces }) {
  const state = useAppState();
  const wrong = pieces.seams.filter((seam) => seam.issues.length > 0).length;
  return (
    <section class="seams" aria-label={t.pattern.seams}>
      <h3>
        {t.pattern.seams} <span class="head-note">{pieces.seams.length}</span>
        {wrong > 0 && <span class="head-note warn">{t.arrange.warnings(wrong)}</span>}
      </h3>
      {pieces.seams.length === 0 && <p class="hint">{t.pattern.nothingSewn}</p>}
      <ul>
        {pieces.seams.map((seam, index) => (
          <Row key={seam.id} seam={seam} index={index} title={seamTitle(pieces, seam.id)} chosen={state.editing.seam.value === seam.id} />
        ))}
      </ul>
    </section>
  );
}

/** Two edges of one piece, named as add_dart names a dart's legs. */
const isDart = ({ id, a, b }: Seam): boolean =>
  a.length === 1 && b.length === 1 && a[0]!.edge === `${id}_a` && b[0]!.edge === `${id}_b`;

interface RowProps {
  seam: Seam;
  index: number;
  title: string;
  chosen: boolean;
}

function Row({ seam, index, title, chosen }: RowProps) {
  const state = useAppState();
  const commands = useCommands();
  const { pattern } = commands;
  const row = useRef<HTMLLIElement>(null);
  const lit = state.editing.litSeam.value === seam.id;
  const { lengths, difference } = lengthsText(seam.length_a_mm, seam.length_b_mm);
  useEffect(() => {
    if (chosen) row.current?.scrollIntoView({ block: 'nearest' });
  }, [chosen]);
  // A row that goes away under the pointer is never left by it.
  useEffect(() => () => void (state.editing.litSeam.peek() === seam.id && commands.pattern.lightSeam(null)), [state, commands, seam.id]);
  return (
    <li
      ref={row}
      class={`seam-row${lit ? ' lit' : ''}${chosen ? ' chosen' : ''}`}
      onPointerEnter={() => pattern.lightSeam(seam.id)}
      onPointerLeave={() => pattern.lightSeam(null)}
    >
      <button
        class="seam-main"
        aria-expanded={chosen}
        onFocus={() => pattern.lightSeam(seam.id)}
        onBlur={() => pattern.lightSeam(null)}
        onClick={() => pattern.selectSeam(chosen ? null : seam.id)}
      >
        <i style={{ background: seamColour(index) }} aria-hidden="true" />
        <b>
          {title}
        </b>
        <span>{lengths}</span>
        {seam.issues.length > 0 && <Icon name="alert" />}
      </button>
      {chosen && <Chosen seam={seam} difference={difference} />}
    </li>
  );
}

/** Both sides of the seam that is selected, what is wrong with it, and what can be done. */
function Chosen({ seam, difference }: { seam: Seam; difference: string }) {
  const { edits, pattern } = useCommands();
  const { pieces } = useAppState().sewn.value;
  const edit = (kind: 'reverse_seam' | 'remove_dart' | 'remove_seam'): void => void edits.send({ edit: kind, seam: seam.id });
  const remove = (): void => {
    edit('remove_seam');
    pattern.selectSeam(null);
  };
  return (
    <div class="seam-more">
      <p>
        <em>A</em> {seriesText(seam.a, pieces)}
      </p>
      <p>
        <em>B</em> {seriesText(seam.b, pieces)}
      </p>
      <p>
        {t.pattern.difference} <b>{difference}</b>
        {seam.same_direction && t.pattern.sameDirection}
      </p>
      {seam.issues.map((issue, i) => (
        <p key={i} class={issue.error ? 'bad' : 'warn'}>
          <Told code={issue.code} detail={issue.message} /> <span class="code">{issue.code}</span>
        </p>
      ))}
      <div class="button-row">
        <button class="plain" onClick={() => edit('reverse_seam')}>
          {t.pattern.reverse}
        </button>
        {isDart(seam) && (
          <button class="plain" title={t.pattern.wedgeTip} onClick={() => edit('remove_dart')}>
            {t.pattern.removeDart}
          </button>
        )}
        <button class="plain danger" onClick={remove}>
          {t.pattern.removeSeam}
        </button>
      </div>
    </div>
  );
}
