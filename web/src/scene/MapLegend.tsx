// Which map the cloth is coloured by, and what its colours say.

import type { Signal } from '@preact/signals';
import { useAppState } from '../state/context';
import { bandEnds, bandFigure, bandOf, kBands, kMapKinds, mapUnit, valueText, type ClothMap, type MapKind } from '../state/clothMaps';
import type { MissingMaps } from '../state/keptMaps';
import { t } from '../texts/language';

/** Only where there is cloth of a drape. */
export function MapChoice() {
  const { mapKind, missingMaps, covered, beforeDrape, atHome } = useAppState();
  if (!covered.value || beforeDrape.value || atHome.value) return null;
  return <MapSelect mapKind={mapKind} missing={missingMaps.value} />;
}

/** A map that cannot be shown says why. */
function titleOf(kind: MapKind, missing: MissingMaps): string {
  const why = missing[kind];
  const { title } = t.scene.maps[kind];
  return why && why !== 'never' ? t.scene.missing[why](title) : title;
}

export function MapSelect({ mapKind, missing }: { mapKind: Signal<MapKind | null>; missing: MissingMaps }) {
  return (
    <>
      <span class="tool-gap" />
      <select
        class="tool map-choice"
        aria-label={t.scene.colourBy}
        title={t.scene.colourByKey}
        value={mapKind.value ?? ''}
        onChange={(event) => (mapKind.value = (event.currentTarget.value || null) as MapKind | null)}
      >
        <option value="">{t.scene.cloth}</option>
        {kMapKinds.filter((kind) => missing[kind] !== 'never').map((kind) => (
          <option key={kind} value={kind} disabled={missing[kind] !== undefined}>
            {titleOf(kind, missing)}
          </option>
        ))}
      </select>
    </>
  );
}

export function MapLegend() {
  const { mapKind, missingMaps, clothMap, pointedValue, covered, beforeDrape, atHome } = useAppState();
  const [kind, map] = [mapKind.value, clothMap.value];
  if (beforeDrape.value || atHome.value) return null;
  if (map) return <Legend map={map} pointed={pointedValue.value} />;
  // One that was chosen before stays chosen until it can be had again.
  if (!covered.value || !kind || missingMaps.value[kind] === undefined) return null;
  return (
    <p class="map-legend" role="status">
      {titleOf(kind, missingMaps.value)}
    </p>
  );
}

export function Legend({ map, pointed }: { map: ClothMap; pointed: number }) {
  const { title, words } = t.scene.maps[map.kind];
  const ends = bandEnds(map);
  const lit = Number.isFinite(pointed) ? bandOf(map, pointed) : -1;
  return (
    <figure class="map-legend" aria-label={`${title}: ${words}`}>
      <figcaption>
        {title} <b>{Number.isFinite(pointed) ? valueText(map, pointed) : mapUnit(map.kind)}</b>
      </figcaption>
      <ol>
        {kBands.map((colour, i) => (
          <li key={colour} class={i === lit ? 'lit' : ''}>
            <i style={{ background: colour }} aria-hidden="true" />
            <span>{bandFigure(map.kind, ends[i]!)}</span>
          </li>
        ))}
        <li class="end">
          <span>{bandFigure(map.kind, ends[ends.length - 1]!)}</span>
        </li>
      </ol>
      <small>{words}</small>
    </figure>
  );
}


