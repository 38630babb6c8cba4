// Measures the cloth for the map that is shown: at once when it is chosen, then at some of the frames, so that measuring
// takes no more than a part of the time. Maps that ended drapes have left are fetched when one of them is chosen.

import { effect, untracked } from '@preact/signals';
import type { BodyMesh } from '../api/body';
import { readMaps } from '../api/maps';
import { loading, valueOf, type AppState } from '../state/AppState';
import { BodySurface } from '../state/BodySurface';
import { grainsOf, mapOf, measured, type MapKind } from '../state/clothMaps';
import { comparedOf } from '../state/comparison';
import { hasMaps, isKept, keptValues, kMapFile } from '../state/keptMaps';
import { FramePace } from './FramePace';
import { asApiError, notify } from './notices';

export class MapKeeper {
  private surface_: { body: BodyMesh; surface: BodySurface } | null = null;
  private readonly pace_ = new FramePace(() => this.measure());

  /** Drapes whose maps were asked for. */
  private readonly asked_ = new Set<string>();

  /** `fetch_` gives a file that a drape has left; null where nobody may have those. */
  constructor(
    private readonly state_: AppState,
    private readonly fetch_: ((job: string, name: string) => Promise<string>) | null,
  ) {}

  start(): void {
    const { mapKind, mapFiles, body, pieces, seenPieces, cloth } = this.state_;
    effect(() => {
      void mapKind.value;
      void mapFiles.value;
      void body.value;
      void pieces.value;
      void seenPieces.value;
      untracked(() => this.pace_.now());
    });
    effect(() => {
      const wanted = this.wanted();
      untracked(() => wanted.forEach((job) => void this.fetch(job)));
    });
    cloth.listen((event) => {
      if (event !== 'frame') this.state_.clothMap.value = null;
      if (mapKind.value) this.pace_.soon();
    });
  }

  /** Drapes of which a map is to be seen that the service keeps. */
  private wanted(): string[] {
    const { mapKind, job, comparison } = this.state_;
    const shown = isKept(mapKind.value) ? [job.value] : [];
    const compared = isKept(comparison.mapKind.value) ? [comparison.left, comparison.right].map((side) => comparedOf(side.value)?.job ?? null) : [];
    return [...shown, ...compared].flatMap((drape) => (drape && hasMaps(drape) ? [drape.id] : []));
  }

  private async fetch(job: string): Promise<void> {
    if (!this.fetch_ || this.asked_.has(job)) return;
    this.asked_.add(job);
    const { mapFiles } = this.state_;
    try {
      const file = readMaps(await this.fetch_(job, kMapFile));
      mapFiles.value = new Map([...mapFiles.value, [job, file]]);
    } catch (error) {
      const { code, detail } = asApiError(error);
      notify(this.state_, { tone: 'bad', text: detail, code });
    }
  }

  private measure(): void {
    const { mapKind, clothMap, pointedValue } = this.state_;
    const kind = mapKind.value;
    const values = kind && this.values(kind);
    clothMap.value = kind && values ? mapOf(kind, values) : null;
    if (!clothMap.value) pointedValue.value = NaN;
  }

  private values(kind: MapKind): Float32Array | null {
    const { cloth, pieces, seenPieces, job, mapFiles } = this.state_;
    if (isKept(kind)) {
      const file = hasMaps(job.value) ? mapFiles.value.get(job.value?.id ?? '') : undefined;
      return file && cloth.topology ? keptValues(kind, file, cloth.topology) : null;
    }
    // The grain may have been turned since.
    const known = (valueOf(seenPieces.value ?? loading) ?? valueOf(pieces.value ?? loading))?.pieces ?? [];
    return measured(kind, cloth, grainsOf(known), () => this.surface());
  }

  private surface(): BodySurface | null {
    const body = valueOf(this.state_.body.value ?? loading);
    if (!body || body.indices.length === 0) return null;
    if (this.surface_?.body !== body) this.surface_ = { body, surface: new BodySurface(body) };
    return this.surface_.surface;
  }
}
