// Measures the cloth for the map that is shown: at once when it is chosen, then at some of the frames, so that measuring
// takes no more than a part of the time.

import { effect, untracked } from '@preact/signals';
import { loading, valueOf, type AppState } from '../state/AppState';
import { BodySurface } from '../state/BodySurface';
import { grainsOf, mapOf, measured, type MapKind } from '../state/clothMaps';
import type { BodyMesh } from '../api/body';
import { FramePace } from './FramePace';

export class MapKeeper {
  private surface_: { body: BodyMesh; surface: BodySurface } | null = null;
  private readonly pace_ = new FramePace(() => this.measure());

  constructor(private readonly state_: AppState) {}

  start(): void {
    const { mapKind, body, pieces, seenPieces, cloth } = this.state_;
    effect(() => {
      void mapKind.value;
      void body.value;
      void pieces.value;
      void seenPieces.value;
      untracked(() => this.pace_.now());
    });
    cloth.listen((event) => {
      if (event !== 'frame') this.state_.clothMap.value = null;
      if (mapKind.value) this.pace_.soon();
    });
  }

  private measure(): void {
    const { mapKind, clothMap, pointedValue } = this.state_;
    const kind = mapKind.value;
    const values = kind && this.values(kind);
    clothMap.value = kind && values ? mapOf(kind, values) : null;
    if (!clothMap.value) pointedValue.value = NaN;
  }

  private values(kind: MapKind): Float32Array | null {
    const { cloth, pieces, seenPieces } = this.state_;
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
