// Measures the cloth for the map that is shown: at once when it is chosen, then at some of the frames, so that measuring
// takes no more than a part of the time.

import { effect, untracked } from '@preact/signals';
import { loading, valueOf, type AppState } from '../state/AppState';
import { BodySurface } from '../state/BodySurface';
import { grainsOf, mapOf, measured, type MapKind } from '../state/clothMaps';
import type { BodyMesh } from '../api/body';

/** Between two measurements at least, ms; and so many times as long as one takes. */
const kPauseMs = 200;
const kShare = 4;

export class MapKeeper {
  private surface_: { body: BodyMesh; surface: BodySurface } | null = null;
  /** The last measurement, ms. */
  private took_ = 0;
  private timer_: ReturnType<typeof setTimeout> | undefined;

  constructor(private readonly state_: AppState) {}

  start(): void {
    const { mapKind, body, pieces, cloth } = this.state_;
    effect(() => {
      void mapKind.value;
      void body.value;
      void pieces.value;
      untracked(() => this.measure());
    });
    cloth.listen((event) => {
      if (event !== 'frame') this.state_.clothMap.value = null;
      if (mapKind.value) this.timer_ ??= setTimeout(() => this.measure(), Math.max(kPauseMs, kShare * this.took_));
    });
  }

  private measure(): void {
    clearTimeout(this.timer_);
    this.timer_ = undefined;
    const { mapKind, clothMap, pointedValue } = this.state_;
    const kind = mapKind.value;
    const begun = performance.now();
    const values = kind && this.values(kind);
    clothMap.value = kind && values ? mapOf(kind, values) : null;
    if (!clothMap.value) pointedValue.value = NaN;
    this.took_ = performance.now() - begun;
  }

  private values(kind: MapKind): Float32Array | null {
    const { cloth, pieces } = this.state_;
    const known = valueOf(pieces.value ?? loading)?.pieces ?? [];
    return measured(kind, cloth, grainsOf(known), () => this.surface());
  }

  private surface(): BodySurface | null {
    const body = valueOf(this.state_.body.value ?? loading);
    if (!body || body.indices.length === 0) return null;
    if (this.surface_?.body !== body) this.surface_ = { body, surface: new BodySurface(body) };
    return this.surface_.surface;
  }
}
