// The layers of a DXF: what stands on each, what it is read as, and what a person says that it is.

import type { Layer, LayerRole } from '../api/types';
import { useCommands } from '../commands/context';
import type { ImportDraft } from '../state/importDraft';
import { count } from '../state/words';
import { t } from '../texts/language';

/** In the order in which a person would look for them. */
const kRoles: readonly LayerRole[] = [
  'cut',
  'sew',
  'internal',
  'cutout',
  'mirror',
  'grain',
  'notch',
  'drill',
  'turn',
  'curve',
  'ignore',
];

export function ImportLayers({ draft, layers }: { draft: ImportDraft; layers: readonly Layer[] }) {
  const { imports } = useCommands();
  const told = Object.keys(draft.layers).length;
  return (
    <section class="import-layers" aria-label={t.imports.layers.title} aria-busy={draft.rereading}>
      <p class="hint">{t.imports.layers.hint}</p>
      <ul>
        {layers.map((layer) => (
          <Row key={layer.name} layer={layer} given={draft.layers[layer.name] ?? ''} />
        ))}
      </ul>
      {told > 0 && (
        <button class="link" onClick={() => void imports.takeNoLayers()}>
          {t.imports.layers.allAsUsual}
        </button>
      )}
    </section>
  );
}

function Row({ layer, given }: { layer: Layer; given: LayerRole | '' }) {
  const { imports } = useCommands();
  const kinds = layer.kinds.map((kind) => `${count(kind.count)} ${kind.type}`).join(', ');
  const usual = layer.given ? t.imports.layers.usual : t.imports.layers.usualRole(t.imports.layers.roles[layer.read_as]);
  return (
    <li class={given ? 'told-layer' : ''}>
      <label>
        <b>{layer.name}</b>
        <small>{kinds}</small>
        <select
          aria-label={t.imports.layers.isRead(layer.name)}
          value={given}
          onChange={(event) => void imports.takeLayer(layer.name, event.currentTarget.value as LayerRole | '')}
        >
          <option value="">{usual}</option>
          {kRoles.map((role) => (
            <option key={role} value={role}>
              {t.imports.layers.roles[role]}
            </option>
          ))}
        </select>
      </label>
    </li>
  );
}
