// Maps that the page does not measure itself: the service leaves them with a drape that has ended. Which maps can be shown,
// and why others cannot. Pure.

import type { ClothTopology } from '../api/frames';
import type { MapFile } from '../api/maps';
import type { Job } from '../api/types';
import { kMapKinds, kMaps, kServiceMaps, type MapKind } from './clothMaps';
import { isActive, kLinkedProject } from './jobs';

export const kMapFile = 'maps.json';

/** That it can be asked for. */
export const hasMaps = (job: Job | null): boolean => job !== null && !isActive(job.state) && kMapFile in (job.results ?? {});

export const isKept = (kind: MapKind | null): kind is MapKind => kind !== null && kMaps[kind].kept;

/** Why a map cannot be shown: `never` where nobody could do anything about it. */
export type Missing = 'live' | 'none' | 'bodyless' | 'never';
export type MissingMaps = Readonly<Partial<Record<MapKind, Missing>>>;

/** A link shows a drape without what it has left. `bodyless`: nobody wears the cloth. */
export function missingMaps(job: Job | null, bodyless: boolean): MissingMaps {
  const missing: Partial<Record<MapKind, Missing>> = {};
  for (const kind of kMapKinds) {
    const rule = kMaps[kind];
    if (rule.kept && (!job || job.project_id === kLinkedProject)) missing[kind] = 'never';
    else if (rule.toBody && bodyless) missing[kind] = 'bodyless';
    else if (rule.kept && !hasMaps(job)) missing[kind] = job && isActive(job.state) ? 'live' : 'none';
  }
  return missing;
}

/** Of two drapes side by side: what neither has. */
export const missingInBoth = (one: MissingMaps, other: MissingMaps): MissingMaps =>
  Object.fromEntries(Object.entries(one).filter(([kind]) => other[kind as MapKind] !== undefined));

/** The values of a map for cloth of this topology; null where the file has none for it. */
export function keptValues(kind: MapKind, file: MapFile, topology: ClothTopology): Float32Array | null {
  const map = file.maps.find((one) => one.map === kServiceMaps[kind]);
  if (!map) return null;
  const values = new Float32Array(topology.vertexCount).fill(NaN);
  for (const { id, firstVertex, vertexCount } of topology.pieces) {
    const piece = file.pieces.find((one) => one.id === id && one.vertex_count === vertexCount);
    if (!piece) return null;
    values.set(map.values.slice(piece.first_vertex, piece.first_vertex + vertexCount), firstVertex);
  }
  return values;
}
