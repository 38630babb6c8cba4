// The pins that hold the cloth of the drape under way, each with a way to remove it.

import { Icon } from '../controls/Icon';
import { useCommands } from '../commands/context';
import { useAppState } from '../state/context';
import { t } from '../texts/language';
import { lengthWords, unit } from '../texts/units';

export function PinList() {
  const state = useAppState();
  const commands = useCommands();
  const pins = state.job.value?.progress?.pins ?? [];
  const { litPin } = state.hands;
  if (!state.touchable.value || pins.length === 0) return null;
  return (
    <section class="pins" aria-label={t.drape.pins.title}>
      <h3>{t.drape.pins.title}</h3>
      <ul>
        {pins.map(({ pin, place }) => (
          <li key={pin} onPointerEnter={() => (litPin.value = pin)} onPointerLeave={() => (litPin.value = null)}>
            <span>{t.drape.pins.one(pin)}</span>
            <small>{t.drape.pins.height(lengthWords(100 * place[1], unit.value))}</small>
            <button
              class="tool flat"
              aria-label={t.drape.pins.remove(pin)}
              title={t.drape.pins.remove(pin)}
              onFocus={() => (litPin.value = pin)}
              onBlur={() => (litPin.value = null)}
              onClick={() => commands.live.unpin(pin)}
            >
              <Icon name="cross" />
            </button>
          </li>
        ))}
      </ul>
    </section>
  );
}
