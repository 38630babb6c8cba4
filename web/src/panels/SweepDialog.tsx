// Who is to wear the shown garment, and what it is to be cut of: a sweep over both.

import { useSignal } from '@preact/signals';
import { useEffect } from 'preact/hooks';
import type { Fabric } from '../api/types';
import { useCommands } from '../commands/context';
import { Icon } from '../controls/Icon';
import { Sheet } from '../controls/Sheet';
import { useAppState } from '../state/context';
import { presetGroups, presetTitle } from '../state/dressing';
import { fabricsFound, wordsOf } from '../state/fabrics';
import { kMostSwept } from '../state/sweeps';
import { t } from '../texts/language';
import { FabricSwatch } from './FabricSwatch';

export function SweepDialog() {
  const { sweeps, projectId } = useAppState();
  return sweeps.choosing.value && projectId.value ? <Dialog /> : null;
}

/** The project's own body, and the fabric that it is cut of. */
const kOwn = '';

function Dialog() {
  const state = useAppState();
  const { sweeps, pattern, dressing } = useCommands();
  const bodies = useSignal<readonly string[]>([kOwn]);
  const fabrics = useSignal<readonly string[]>([kOwn]);
  useEffect(() => {
    void pattern.loadFabrics();
    void dressing.loadTables();
  }, [pattern, dressing]);
  const count = bodies.value.length * fabrics.value.length;
  const submit = (event: Event): void => {
    event.preventDefault();
    void sweeps.begin(bodies.value, fabrics.value);
  };
  return (
    <Sheet
      class="wide sweep-choice"
      id="sweep-title"
      title={t.sweep.title(state.project.value?.name ?? '')}
      close={() => (state.sweeps.choosing.value = false)}
    >
      <form onSubmit={submit}>
        <div class="sweep-sides">
          <Bodies chosen={bodies.value} choose={(names) => (bodies.value = names)} />
          <Fabrics chosen={fabrics.value} choose={(names) => (fabrics.value = names)} />
        </div>
        <footer>
          <p class="hint" role="status">
            {count > kMostSwept ? t.sweep.tooMany(count, kMostSwept) : t.sweep.product(bodies.value.length, fabrics.value.length)}
          </p>
          <button class="primary" type="submit" disabled={count === 0 || count > kMostSwept || state.sweeps.busy.value}>
            <Icon name="play" /> {t.sweep.start(count)}
          </button>
        </footer>
      </form>
    </Sheet>
  );
}

interface Side {
  chosen: readonly string[];
  choose(names: readonly string[]): void;
}

const flipped = (names: readonly string[], name: string): readonly string[] =>
  names.includes(name) ? names.filter((one) => one !== name) : [...names, name];

function Check({ name, side, children }: { name: string; side: Side; children: preact.ComponentChildren }) {
  return (
    <label class="check">
      <input type="checkbox" checked={side.chosen.includes(name)} onChange={() => side.choose(flipped(side.chosen, name))} />
      {children}
    </label>
  );
}

function Bodies(side: Side) {
  const { tables } = useAppState().dressing;
  return (
    <fieldset>
      <legend>{t.sweep.bodies}</legend>
      <Check name={kOwn} side={side}>
        {t.sweep.ownBody}
      </Check>
      {presetGroups(tables.value?.presets ?? []).map((group) => (
        <section key={group.title} aria-label={group.title}>
          <h3>{group.title}</h3>
          <div class="sweep-sizes">
            {group.presets.map((preset) => (
              <Check key={preset.name} name={preset.name} side={side}>
                {presetTitle(preset.name)}
              </Check>
            ))}
          </div>
        </section>
      ))}
    </fieldset>
  );
}

function Fabrics(side: Side) {
  const { fabrics } = useAppState().editing;
  const text = useSignal('');
  const isChosen = ({ name }: Fabric): boolean => side.chosen.includes(name);
  const found = fabricsFound(fabrics.value, text.value, 'all');
  // What is ticked stays in sight, whatever is looked for next.
  const listed = [...fabrics.value.filter(isChosen), ...found.filter((fabric) => !isChosen(fabric))];
  return (
    <fieldset>
      <legend>{t.sweep.fabrics}</legend>
      <Check name={kOwn} side={side}>
        {t.sweep.ownFabric}
      </Check>
      <input
        type="search"
        aria-label={t.fabric.find}
        placeholder={t.fabric.findWhat}
        value={text.value}
        onInput={(event) => (text.value = event.currentTarget.value)}
      />
      <div class="sweep-cloths">
        {listed.map((fabric) => (
          <Check key={fabric.name} name={fabric.name} side={side}>
            <FabricSwatch fabric={fabric} />
            <span>
              <b>{wordsOf(fabric).title}</b>
              <small>{`${fabric.areal_mass_g_m2} g/m² · ${wordsOf(fabric).make}`}</small>
            </span>
          </Check>
        ))}
      </div>
    </fieldset>
  );
}
