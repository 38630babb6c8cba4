// Who is dressed: a size of a table, measures as sliders and numbers, or a mesh of one's own, with what the tape says.

import { useSignal } from '@preact/signals';
import { useEffect, useId, useRef } from 'preact/hooks';
import type { BodyPreset, MeasureRule, ProjectBody, TakenMeasure } from '../api/dressing';
import { acceptOf } from '../api/formats';
import type { ApiError } from '../api/http';
import { useCommands } from '../commands/context';
import { useAppState } from '../state/context';
import {
  centimetres,
  isOwn,
  lengthWords,
  measureTitle,
  nearestPreset,
  presetGroups,
  presetTitle,
  shownLength,
  sliderWay,
  type LengthUnit,
} from '../state/dressing';
import { sentence } from '../state/words';
import { Icon } from '../controls/Icon';
import { NumberField } from '../controls/NumberField';

export function BodyPanel() {
  const { dressing, projectId } = useAppState();
  if (!projectId.value) return <p class="hint">Open a project to dress somebody.</p>;
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
        <p class="hint">{body.file ?? body.id} is no standing person. Cloth falls on it all the same.</p>
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
      <span class="spinner" aria-hidden="true" /> Measuring the body
    </p>
  );
}

export function Refusal({ problem }: { problem: ApiError | null }) {
  if (!problem) return null;
  return (
    <div class="problem" role="alert">
      <Icon name="alert" />
      <div>
        <p>{sentence(problem.detail)}</p>
        {problem.where && <p class="where">{problem.where}</p>}
        <p class="code">{problem.code}</p>
      </div>
    </div>
  );
}

/** The size that a body has, and what is said where it has none. */
function sizeOf(body: ProjectBody | null | undefined): { preset: string; other: string } {
  const mannequin = body?.mannequin;
  if (!mannequin) return { preset: '', other: body?.file ?? 'Nobody' };
  const { preset = '' } = mannequin;
  // A size with a measure of its own is that size no more.
  const own = Object.keys(mannequin).some((key) => key.endsWith('_cm'));
  return { preset: own ? '' : preset, other: own && preset ? `${presetTitle(preset)} with own measures` : 'Own measures' };
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
          aria-label="Body"
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
      <label for={id}>Size</label>
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
    <span class="choice" role="radiogroup" aria-label="Unit">
      {(['cm', 'inch'] as LengthUnit[]).map((unit) => (
        <button
          key={unit}
          role="radio"
          aria-checked={dressing.unit.value === unit}
          onClick={() => commands.dressing.takeUnit(unit)}
        >
          {unit === 'cm' ? 'cm' : 'in'}
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
      {mannequin && <span class="pose">Pose</span>}
      {mannequin && (
        <span class="choice" role="radiogroup" aria-label="Pose">
          {(['a', 't'] as const).map((pose) => (
            <button
              key={pose}
              role="radio"
              aria-checked={(mannequin.pose ?? 'a') === pose}
              title={pose === 'a' ? 'Arms hang at an angle' : 'Arms stand out level'}
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
    <section class="landmarks" aria-label="Landmarks">
      <p class="hint">Drag a point over the body to move it.</p>
      {own.map((one) => (
        <p key={one.name} class="landmark">
          <span>{measureTitle(one.name)}</span>
          <button
            class="plain small"
            aria-label={`Put ${one.name} back`}
            onClick={() => void commands.dressing.unmark(one.name)}
          >
            Put back
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
          <span role="status">Click the body where {picking} is.</span>
        ) : (
          <input
            aria-label="Name of a new landmark"
            placeholder="New landmark"
            value={name.value}
            maxLength={60}
            onInput={(event) => (name.value = event.currentTarget.value)}
          />
        )}
        <button class="plain small" type="submit" disabled={!picking && name.value.trim() === ''}>
          {picking ? 'Cancel' : 'Place'}
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
    <ul class="measures" aria-label="Measures">
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
        unit={unit === 'cm' ? 'cm' : 'in'}
        digits={unit === 'cm' ? 1 : 2}
        take={(shown) => set(centimetres(shown, unit))}
      />
      <button
        class="tool flat free"
        disabled={!own}
        title={own ? 'As the size table and proportions have it' : 'Follows from the size table and proportions'}
        aria-label={`${measureTitle(taken.name)}: follow from the table`}
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
      <span class="measure-at">at {lengthWords(taken.at_cm, dressing.unit.value)}</span>
      <b>{lengthWords(taken.cm, dressing.unit.value)}</b>
    </MeasureRow>
  );
}

function MeasureRow(props: { taken: TakenMeasure; own: boolean; children: preact.ComponentChildren }) {
  const { taken, own, children } = props;
  const { dressing } = useAppState();
  const commands = useCommands();
  const put = (name: string | null): void => commands.dressing.light(name);
  return (
    <li
      class={`measure${own ? ' own' : ''}${dressing.lit.value === taken.name ? ' lit' : ''}`}
      title={taken.rule}
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
      <MeshButton title="Own body…" label="Mesh of a body" beside={false} />
      {body && <MeshButton title="Add object…" label="Mesh of an object" beside={true} />}
      {others && (
        <button class="plain danger" onClick={() => void commands.dressing.undress()}>
          Remove {body?.id}
        </button>
      )}
      {body && (
        <NumberField
          label="Skin offset"
          value={body.skin_offset_mm}
          unit="mm"
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

const kUnitNames: [number, string][] = [
  [1, 'metres'],
  [0.1, 'decimetres'],
  [0.01, 'centimetres'],
  [0.001, 'millimetres'],
];

function StanceWords() {
  const { dressing } = useAppState();
  const commands = useCommands();
  const { file, asset, stance } = dressing.stance.value!;
  const turn = (degrees: number): void => void commands.dressing.dress({ asset, turn: degrees }, 'Turning the body');
  if (!stance) return <p class="sure warn">{file} does not look like a standing person; it lies as its file says.</p>;
  const unit = kUnitNames.find(([metres]) => metres === stance.unit_in_m)?.[1] ?? `${stance.unit_in_m} m`;
  const turned = stance.turned_degrees === 0 ? '' : `, turned by ${stance.turned_degrees}°`;
  return (
    <p class="sure">
      Read as {unit}, {stance.up} up{stance.upside_down ? ', upside down' : ''}
      {turned}. Faces away?{' '}
      <button class="link" onClick={() => turn(180)}>
        Turn it round
      </button>
    </p>
  );
}
