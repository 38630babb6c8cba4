// Which map the cloth is coloured by, and what its colours say.

import type { Signal } from '@preact/signals';
import { useAppState } from '../state/context';
import { bandEnds, bandFigure, bandOf, kBands, kMaps, mapUnit, valueText, type ClothMap, type MapKind } from '../state/clothMaps';
import { t } from '../texts/language';

/** Only where there is cloth of a drape. */
export function MapChoice() {
  const { mapKind, covered, beforeDrape, atHome } = useAppState();
  if (!covered.value || beforeDrape.value || atHome.value) return null;
  return <MapSelect mapKind={mapKind} />;
}

export function MapSelect({ mapKind }: { mapKind: Signal<MapKind | null> }) {
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
        {(Object.keys(kMaps) as MapKind[]).map((kind) => (
          <option key={kind} value={kind}>
            {t.scene.maps[kind].title}
          </option>
        ))}
      </select>
    </>
  );
}

export function MapLegend() {
  const { clothMap, pointedValue, beforeDrape, atHome } = useAppState();
  const map = clothMap.value;
  if (!map || beforeDrape.value || atHome.value) return null;
  return <Legend map={map} pointed={pointedValue.value} />;
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


