// A section through body and cloth: where it is taken, its drawing from above, and what it measures.

import type { ComponentChildren } from 'preact';
import { measureTitle } from '../state/dressing';
import type { Outline } from '../state/planeCut';
import type { Girths, Level, Section } from '../state/section';
import { useAppState } from '../state/context';
import { lengthWords, patternLength } from '../texts/units';
import { t } from '../texts/language';

/** Null where there is no cloth to cut. */
export function SectionPanel() {
  const { section, cuttable } = useAppState();
  if (!cuttable.value) return null;
  const shown = section.shown.value;
  const cut = section.cut.value;
  return (
    <section class="cut" aria-label={t.section.title}>
      <h3>
        {t.section.title}
        <button
          class="tool"
          aria-pressed={shown}
          title={t.section.key}
          onClick={() => (section.shown.value = !shown)}
        >
          {shown ? t.section.close : t.section.open}
        </button>
      </h3>
      {shown && cut && (
        <>
          <HeightField cut={cut} />
          <Drawing cut={cut} />
          <GirthTable cut={cut} />
        </>
      )}
    </section>
  );
}

/** Steps of the slider, m. */
const kStep = 0.005;
/** A level is where the plane lies to within this, m. */
const kNear = 0.001;

function HeightField({ cut }: { cut: Section }) {
  const { section, dressing } = useAppState();
  const unit = dressing.unit.value;
  const { low, high } = cut.range;
  const share = (100 * (cut.height - low)) / Math.max(high - low, kStep);
  const to = (height: number): void => {
    section.height.value = height;
  };
  return (
    <div class="cut-height">
      <label>
        <span>{t.section.height}</span>
        <input
          type="range"
          min={low}
          max={high}
          step={kStep}
          value={cut.height}
          aria-valuetext={t.section.aboveFloor(lengthWords(100 * cut.height, unit))}
          style={{ '--share': `${share}%` }}
          onInput={(event) => to(event.currentTarget.valueAsNumber)}
        />
        <b>{lengthWords(100 * cut.height, unit)}</b>
      </label>
      <div class="cut-levels">
        {section.levels.value.map((level) => (
          <LevelButton key={level.name} level={level} cut={cut} to={to} />
        ))}
      </div>
    </div>
  );
}

function LevelButton({ level, cut, to }: { level: Level; cut: Section; to: (height: number) => void }) {
  const { low, high } = cut.range;
  const within = level.height > low && level.height < high;
  return (
    <button
      class="tool"
      aria-pressed={Math.abs(cut.height - level.height) < kNear}
      disabled={!within}
      title={within ? undefined : t.section.noClothThere}
      onClick={() => to(level.height)}
    >
      {measureTitle(level.name)}
    </button>
  );
}

// ---- the drawing

const kBar: Record<'cm' | 'in', { mm: number; text: string }> = {
  cm: { mm: 100, text: '10 cm' },
  in: { mm: 101.6, text: '4 in' },
};

/** In millimetres, from above: the wearer's front is below, the wearer's left at the right. */
function Drawing({ cut }: { cut: Section }) {
  const { dressing } = useAppState();
  const unit = dressing.unit.value;
  const frame = frameOf(cut);
  if (!frame) return null;
  const { left, top, width, height, word } = frame;
  const bar = kBar[unit === 'inch' ? 'in' : 'cm'];
  const base = top + height - 0.7 * word;
  return (
    <svg
      class="cut-drawing"
      viewBox={[left, top, width, height].map((mm) => mm.toFixed(1)).join(' ')}
      font-size={word}
      role="img"
      aria-label={t.section.drawing(lengthWords(100 * cut.height, unit))}
    >
      {cut.body.map((outline, i) => (
        <path key={i} class="cut-body" d={pathOf(outline)} />
      ))}
      {cut.cloth.map((outline, i) => (
        <path key={i} class={outline.closed ? 'cut-cloth' : 'cut-cloth open'} d={pathOf(outline)} />
      ))}
      <path class="cut-bar" d={`M${left + word} ${base - 0.4 * word}v${0.4 * word}h${bar.mm}v${-0.4 * word}`} />
      <Word x={left + 1.5 * word + bar.mm} y={base}>
        {bar.text}
      </Word>
      <Word x={left + width - word} y={base} end>
        {t.section.front}
      </Word>
    </svg>
  );
}

/** Height of words, as a share of the drawing's size. */
const kWord = 1 / 28;

/** All of the cloth, and of the body what lies within; all of the body where there is no cloth. */
function frameOf({ cloth, body }: Section) {
  const places = (cloth.length > 0 ? cloth : body).flatMap((outline) => outline.places);
  if (places.length === 0) return null;
  const [x0, x1] = endsOf(places.map(([x]) => 1000 * x));
  const [z0, z1] = endsOf(places.map(([, z]) => 1000 * z));
  const word = kWord * Math.max(x1 - x0, z1 - z0, kBar.in.mm);
  const height = z1 - z0 + 4 * word;
  // A narrow one is as wide as its words need.
  const width = Math.max(x1 - x0 + 2 * word, kBar.in.mm + 10 * word);
  return { left: (x0 + x1 - width) / 2, top: z0 - word, width, height, word };
}

function endsOf(values: readonly number[]): [number, number] {
  return values.reduce<[number, number]>(([low, high], x) => [Math.min(low, x), Math.max(high, x)], [Infinity, -Infinity]);
}

function Word({ x, y, end, children }: { x: number; y: number; end?: boolean; children: ComponentChildren }) {
  return (
    <text x={x} y={y} text-anchor={end ? 'end' : 'start'}>
      {children}
    </text>
  );
}

const pathOf = ({ places, closed }: Outline): string =>
  `M${places.map(([x, z]) => `${(1000 * x).toFixed(1)} ${(1000 * z).toFixed(1)}`).join('L')}${closed ? 'Z' : ''}`;

// ---- the figures

function GirthTable({ cut }: { cut: Section }) {
  const { dressing } = useAppState();
  const words = (metres: number): string => lengthWords(100 * metres, dressing.unit.value);
  return (
    <>
      {cut.girths.length > 0 && (
        <table class="fit">
          <thead>
            <tr>
              <th scope="col">{t.report.fit.girth}</th>
              <th scope="col">{t.report.fit.body}</th>
              <th scope="col">{t.report.fit.garment}</th>
              <th scope="col">{t.report.fit.ease}</th>
            </tr>
          </thead>
          <tbody>
            {cut.girths.map((girths) => (
              <Row key={girths.part} girths={girths} words={words} />
            ))}
          </tbody>
        </table>
      )}
      {cut.open.count > 0 && <p class="hint">{t.section.open_(cut.open.count, words(cut.open.flat))}</p>}
      {cut.cloth.length === 0 && <p class="hint">{t.section.noClothThere}</p>}
    </>
  );
}

function Row({ girths, words }: { girths: Girths; words: (metres: number) => string }) {
  const { room } = girths;
  const ease = girths.flat - girths.body;
  return (
    <>
      <tr>
        <th scope="row">{t.section.parts[girths.part]}</th>
        <td>{words(girths.body)}</td>
        <td>{words(girths.flat)}</td>
        <td>
          <b>
            {ease < 0 ? '−' : '+'}
            {words(Math.abs(ease))}
          </b>
        </td>
      </tr>
      <tr class="cut-more">
        <td colSpan={4}>
          {t.section.hangs(words(girths.worn))}{' '}
          {t.section.room(patternLength(1000 * room.least), patternLength(1000 * room.median))}
          {girths.layers > 1 && ` ${t.section.layers(girths.layers)}`}
        </td>
      </tr>
    </>
  );
}
