// Who is dressed: a size of a table, measures as sliders and numbers, or a mesh of one's own, with what the tape says.

import { useSignal } from '@preact/signals';
import { useEffect, useId, useRef } from 'preact/hooks';
import type { BodyPreset, MeasureRule, ProjectBody, TakenMeasure } from '../api/dressing';
import { acceptOf } from '../api/formats';
import type { ApiError } from '../api/http';
import { useCommands } from '../commands/context';
import { useAppState } from '../state/context';
import {
  isOwn,
  measureTitle,
  nearestPreset,
  presetGroups,
  presetTitle,
  sliderWay,
} from '../state/dressing';
import type { Texts } from '../texts/en';
import { plain } from '../texts/numbers';
import { bodyDigits, bodySign, centimetres, lengthWords, shownLength } from '../texts/units';
import { Icon } from '../controls/Icon';
import { NumberField } from '../controls/NumberField';
import { t } from '../texts/language';
import { Told } from '../texts/Message';
import { told } from '../texts/told';

export function BodyPanel() {
  const { dressing, projectId } = useAppState();
  if (!projectId.value) return <p class="hint">{t.body.openProject}</p>;
  const bodies = dressing.bodies.value;
  if (!bodies) return <Waiting />;
  const body = bodies[dressing.shown.value] ?? null;
  return (
    <>
      <Chooser bodies={bodies} body={body} />
      <Refusal problem={dressing.problem.value} />
      {body && <Marks body={body} />}
      {body && dressing.marks.value.landmarks && <Landmarks body={body} />}
      {body?.stands && <Measures body={body} />}
      {body && !body.stands && (
        <p class="hint">{t.body.notStanding(body.file ?? body.id)}</p>
      )}
      <OwnMesh body={body} />
    </>
  );
}

function Waiting() {
  const { dressing } = useAppState();
  if (dressing.problem.value) return <Refusal problem={dressing.problem.value} />;
  return (
    <p class="busy" role="status">
      <span class="spinner" aria-hidden="true" /> {t.body.measuring}
    </p>
  );
}

export function Refusal({ problem }: { problem: ApiError | null }) {
  if (!problem) return null;
  return (
    <div class="problem" role="alert">
      <Icon name="alert" />
      <div>
        <p>
          <Told code={problem.code} detail={problem.detail} />
        </p>
        {problem.where && <p class="where">{problem.where}</p>}
        <p class="code">{problem.code}</p>
      </div>
    </div>
  );
}

/** The size that a body has, and what is said where it has none. */
function sizeOf(body: ProjectBody | null | undefined): { preset: string; other: string } {
  const mannequin = body?.mannequin;
  if (!mannequin) return { preset: '', other: body?.file ?? t.body.nobody };
  const { preset = '' } = mannequin;
  // A size with a measure of its own is that size no more.
  const own = Object.keys(mannequin).some((key) => key.endsWith('_cm'));
  return { preset: own ? '' : preset, other: own && preset ? t.body.sizeWithOwn(presetTitle(preset)) : t.body.ownMeasures };
}

function Chooser({ bodies, body }: { bodies: ProjectBody[]; body: ProjectBody | null }) {
  const { dressing } = useAppState();
  const commands = useCommands();
  const id = useId();
  const groups = presetGroups(dressing.tables.value?.presets ?? []);
  const { preset, other } = sizeOf(body);
  return (
    <div class="body-head">
      {bodies.length > 1 && (
        <select
          aria-label={t.common.body}
          value={String(dressing.shown.value)}
          onChange={(event) => (dressing.shown.value = Number(event.currentTarget.value))}
        >
          {bodies.map((one, i) => (
            <option key={one.id} value={String(i)}>
              {one.id}
            </option>
          ))}
        </select>
      )}
      <label for={id}>{t.common.size}</label>
      <select
        id={id}
        value={preset}
        disabled={groups.length === 0}
        onChange={(event) => void commands.dressing.choosePreset(event.currentTarget.value)}
      >
        <option value="" disabled>
          {other}
        </option>
        {groups.map((group) => (
          <optgroup key={group.title} label={group.title}>
            {group.presets.map((one) => (
              <option key={one.name} value={one.name}>
                {presetTitle(one.name)} · {one.measures_cm.bust?.toFixed(0)}-{one.measures_cm.waist?.toFixed(0)}-
                {one.measures_cm.hip?.toFixed(0)}
              </option>
            ))}
          </optgroup>
        ))}
      </select>
      <Units />
    </div>
  );
}

function Units() {
  const commands = useCommands();
  const { dressing } = useAppState();
  return (
    <span class="choice" role="radiogroup" aria-label={t.common.unit}>
      {(['mm', 'inch'] as const).map((unit) => (
        <button
          key={unit}
          role="radio"
          aria-checked={(dressing.unit.value === 'inch') === (unit === 'inch')}
          onClick={() => commands.dressing.takeUnit(unit)}
        >
          {bodySign(unit)}
        </button>
      ))}
    </span>
  );
}

function Marks({ body }: { body: ProjectBody }) {
  const { dressing } = useAppState();
  const commands = useCommands();
  const marks = dressing.marks.value;
  const mannequin = body.mannequin;
  return (
    <div class="body-marks">
      {(['tape', 'landmarks', 'boxes'] as const).map((kind) => (
        <button
          key={kind}
          class="plain small"
          aria-pressed={marks[kind]}
          onClick={() => commands.dressing.showMarks({ [kind]: !marks[kind] })}
        >
          {measureTitle(kind)}
        </button>
      ))}
      {mannequin && <span class="pose">{t.body.pose}</span>}
      {mannequin && (
        <span class="choice" role="radiogroup" aria-label={t.body.pose}>
          {(['a', 't'] as const).map((pose) => (
            <button
              key={pose}
              role="radio"
              aria-checked={(mannequin.pose ?? 'a') === pose}
              title={pose === 'a' ? t.body.poseA : t.body.poseT}
              onClick={() => void commands.dressing.setMannequin({ pose })}
            >
              {pose.toUpperCase()}
            </button>
          ))}
        </span>
      )}
    </div>
  );
}

/** What is said of landmarks by hand: they are dragged in 3D, or named here and placed by a click. */
function Landmarks({ body }: { body: ProjectBody }) {
  const { dressing } = useAppState();
  const commands = useCommands();
  const name = useSignal('');
  const picking = dressing.picking.value;
  const own = body.landmarks.filter((one) => one.own);
  return (
    <section class="landmarks" aria-label={t.body.landmarks}>
      <p class="hint">{t.body.dragPoint}</p>
      {own.map((one) => (
        <p key={one.name} class="landmark">
          <span>{measureTitle(one.name)}</span>
          <button
            class="plain small"
            aria-label={t.body.putBackWhat(measureTitle(one.name))}
            onClick={() => void commands.dressing.unmark(one.name)}
          >
            {t.body.putBack}
          </button>
        </p>
      ))}
      <form
        class="landmark"
        onSubmit={(event) => {
          event.preventDefault();
          commands.dressing.pick(picking ? '' : name.value);
          name.value = '';
        }}
      >
        {picking ? (
          <span role="status">{t.body.clickBody(picking)}</span>
        ) : (
          <input
            aria-label={t.body.nameNew}
            placeholder={t.body.newLandmark}
            value={name.value}
            maxLength={60}
            onInput={(event) => (name.value = event.currentTarget.value)}
          />
        )}
        <button class="plain small" type="submit" disabled={!picking && name.value.trim() === ''}>
          {picking ? t.common.cancel : t.body.place}
        </button>
      </form>
    </section>
  );
}

function Measures({ body }: { body: ProjectBody }) {
  const { dressing } = useAppState();
  const tables = dressing.tables.value;
  const { mannequin } = body;
  const base = mannequin && tables ? nearestPreset(tables.presets, mannequin, body.measures) : null;
  return (
    <ul class="measures" aria-label={t.body.measures}>
      {body.measures.map((taken) => {
        const rule = tables?.measures.find((one) => one.name === taken.name);
        return mannequin && rule ? (
          <MeasureSlider key={taken.name} body={body} taken={taken} rule={rule} base={base} />
        ) : (
          <MeasureFigure key={taken.name} taken={taken} />
        );
      })}
    </ul>
  );
}

interface SliderProps {
  body: ProjectBody;
  taken: TakenMeasure;
  rule: MeasureRule;
  base: BodyPreset | null;
}

function MeasureSlider({ body, taken, rule, base }: SliderProps) {
  const { dressing } = useAppState();
  const commands = useCommands();
  const wish = useSignal<number | null>(null);
  const unit = dressing.unit.value;
  const now = taken.asked_cm !== null && isOwn(body.mannequin!, taken.name) ? taken.asked_cm : taken.cm;
  const value = wish.value ?? now;
  const way = sliderWay(rule, base?.measures_cm[taken.name] ?? now, now);
  const own = isOwn(body.mannequin!, taken.name);
  const set = (cm: number): void => {
    wish.value = cm;
    void commands.dressing.setMeasure(taken.name, cm).then(() => dressing.problem.value && (wish.value = null));
  };
  // The wish stands until the tape has taken the new body.
  useEffect(() => void (wish.value = null), [taken, wish]);
  return (
    <MeasureRow taken={taken} own={own}>
      <input
        type="range"
        min={way.least}
        max={way.most}
        step={0.5}
        value={value}
        aria-label={measureTitle(taken.name)}
        aria-valuetext={lengthWords(value, unit)}
        style={{ '--share': `${(100 * (value - way.least)) / (way.most - way.least)}%` }}
        onInput={(event) => (wish.value = Number(event.currentTarget.value))}
        onChange={(event) => set(Number(event.currentTarget.value))}
      />
      <NumberField
        label={measureTitle(taken.name)}
        value={shownLength(value, unit)}
        unit={bodySign(unit)}
        digits={bodyDigits(unit)}
        take={(shown) => set(centimetres(shown, unit))}
      />
      <button
        class="tool flat free"
        disabled={!own}
        title={own ? t.body.asTable : t.body.fromTable}
        aria-label={t.body.follow(measureTitle(taken.name))}
        onClick={() => void commands.dressing.freeMeasure(taken.name)}
      >
        {own && <Icon name="cross" />}
      </button>
    </MeasureRow>
  );
}

function MeasureFigure({ taken }: { taken: TakenMeasure }) {
  const { dressing } = useAppState();
  return (
    <MeasureRow taken={taken} own={false}>
      <span class="measure-at">{t.body.at(lengthWords(taken.at_cm, dressing.unit.value))}</span>
      <b>{lengthWords(taken.cm, dressing.unit.value)}</b>
    </MeasureRow>
  );
}

/** How the tape is laid. */
const ruleOf = ({ name, rule }: TakenMeasure): string => told(`measure.${name}`, rule).text;

function MeasureRow(props: { taken: TakenMeasure; own: boolean; children: preact.ComponentChildren }) {
  const { taken, own, children } = props;
  const { dressing } = useAppState();
  const commands = useCommands();
  const put = (name: string | null): void => commands.dressing.light(name);
  return (
    <li
      class={`measure${own ? ' own' : ''}${dressing.lit.value === taken.name ? ' lit' : ''}`}
      title={ruleOf(taken)}
      onPointerEnter={() => put(taken.name)}
      onPointerLeave={() => put(null)}
      onFocusIn={() => put(taken.name)}
      onFocusOut={() => put(null)}
    >
      <span class="measure-name">{measureTitle(taken.name)}</span>
      {children}
    </li>
  );
}

/** A mesh of one's own, how it stood in its file, and how to say otherwise. */
function OwnMesh({ body }: { body: ProjectBody | null }) {
  const { dressing } = useAppState();
  const commands = useCommands();
  const others = (dressing.bodies.value?.length ?? 0) > 1;
  return (
    <div class="own-mesh">
      <MeshButton title={t.body.own} label={t.body.ownLabel} beside={false} />
      {body && <MeshButton title={t.body.addObject} label={t.body.objectLabel} beside={true} />}
      {others && (
        <button class="plain danger" onClick={() => void commands.dressing.undress()}>
          {t.body.removeBody(body?.id ?? '')}
        </button>
      )}
      {body && (
        <NumberField
          label={t.body.skinOffset}
          value={body.skin_offset_mm}
          length
          take={(mm) => void commands.dressing.setSkinOffset(mm)}
        />
      )}
      {dressing.stance.value && body?.file && <StanceWords />}
    </div>
  );
}

function MeshButton({ title, label, beside }: { title: string; label: string; beside: boolean }) {
  const { dressing } = useAppState();
  const commands = useCommands();
  const input = useRef<HTMLInputElement>(null);
  const take = (file: File | undefined): void => {
    if (file) void commands.dressing.takeFile(file.name, file, beside);
    if (input.current) input.current.value = '';
  };
  return (
    <>
      <button class="plain" onClick={() => input.current?.click()}>
        <Icon name={beside ? 'plus' : 'file'} /> {title}
      </button>
      <input
        ref={input}
        class="visually-hidden"
        type="file"
        accept={acceptOf(dressing.meshEndings.value)}
        aria-label={label}
        tabIndex={-1}
        onChange={(event) => take(event.currentTarget.files?.[0])}
      />
    </>
  );
}

const kUnitNames: [metres: number, name: keyof Texts['body']['metres']][] = [
  [1, 'm'],
  [0.1, 'dm'],
  [0.01, 'cm'],
  [0.001, 'mm'],
];

function StanceWords() {
  const { dressing } = useAppState();
  const commands = useCommands();
  const { file, asset, stance } = dressing.stance.value!;
  const turn = (degrees: number): void => void commands.dressing.dress({ asset, turn: degrees }, t.body.turning);
  if (!stance) return <p class="sure warn">{t.body.lies(file)}</p>;
  const known = kUnitNames.find(([metres]) => metres === stance.unit_in_m)?.[1];
  const unit = known ? t.body.metres[known] : `${plain(stance.unit_in_m)} m`;
  return (
    <p class="sure">
      {t.body.readAs(unit, stance.up, stance.upside_down, stance.turned_degrees)}{' '}
      <button class="link" onClick={() => turn(180)}>
        {t.body.turnRound}
      </button>
    </p>
  );
}
