// Ranges that are drawn along outlines to be sewn: where the pointer is, where a range begins, where it ends.

import type { Piece, Point } from '../api/types';
import { loading, valueOf, type AppState } from '../state/AppState';
import { lengthOfSeries } from '../state/seamView';
import {
  begunAt,
  kShortest,
  ledTo,
  placeAlong,
  placeNear,
  seriesOf,
  snapped,
  withSeries,
  type Around,
  type LoopPlace,
  type RangeDraft,
} from '../state/seamRange';

/** Where the pointer is on the plane, mm. */
export interface PlaneSpot {
  at: Point;
  /** How near it has to come to an edge. */
  catches: number;
  /** How far it jumps along one; 0: it stays where it is. */
  reach: number;
}

export class RangeCommands {
  constructor(private readonly state_: AppState) {}

  private get around(): Around {
    const known = valueOf(this.state_.pieces.value ?? loading);
    return { pieces: known?.pieces ?? [], offsets: this.state_.editing.offsets.value, seams: known?.seams ?? [] };
  }

  private pieceOf(place: LoopPlace): Piece | undefined {
    return this.around.pieces.find(({ id }) => id === place.piece);
  }

  /** The pointer moved: the place under it, or the range up to there, is shown. */
  point(spot: PlaneSpot | null): void {
    const { range, place } = this.state_.editing;
    const drawn = range.value;
    if (!spot) return void (place.value = null);
    if (!drawn) {
      const near = placeNear(this.around, spot.at, spot.catches);
      return void (place.value = near && snapped(this.around, near, { reach: spot.reach }));
    }
    const led = this.led(drawn, spot);
    if (led) range.value = led;
    place.value = led?.end ?? null;
  }

  /** The pointer came down: a range begins there, or ends. False where there is neither an edge nor a range. */
  press(spot: PlaneSpot, stay: boolean): boolean {
    const { range, place, problem } = this.state_.editing;
    const near = placeNear(this.around, spot.at, spot.catches);
    const drawn = range.value;
    const elsewhere = drawn && near && (near.piece !== drawn.start.piece || near.loop !== drawn.start.loop);
    if (drawn && !elsewhere) {
      this.point(spot);
      this.end(stay);
      return true;
    }
    if (!near) return false;
    const start = snapped(this.around, near, { reach: spot.reach });
    problem.value = null;
    range.value = begunAt(start);
    place.value = start;
    return true;
  }

  /** The pointer was let go of: what it has drawn meanwhile is a range. */
  release(spot: PlaneSpot, stay: boolean): void {
    if (!this.state_.editing.range.value) return;
    this.point(spot);
    const { way } = this.state_.editing.range.value;
    if (Math.abs(way) > Math.max(kShortest, spot.catches)) this.end(stay);
  }

  /** Takes the range into the seam that is being made; the other side is next unless more is to come on this one. */
  private end(stay: boolean): void {
    const { range, draft } = this.state_.editing;
    const drawn = range.value;
    if (!drawn) return;
    const series = seriesOf(this.pieceOf(drawn.start), drawn);
    if (series.length === 0) return;
    range.value = null;
    const next = withSeries(draft.value, series);
    draft.value = next.side === 'a' && next.b.length === 0 && !stay ? { ...next, side: 'b' } : next;
  }

  private led(drawn: RangeDraft, spot: PlaneSpot): RangeDraft | null {
    const piece = this.pieceOf(drawn.start);
    const free = piece && placeAlong(this.around, drawn.start, spot.at);
    if (!free) return null;
    const equal = { start: drawn.start, length: this.missing() };
    return ledTo(piece, drawn, snapped(this.around, free, { reach: spot.reach, equal }));
  }

  /** By how much the other side is longer so far. */
  private missing(): number {
    const { side, ...draft } = this.state_.editing.draft.value;
    const { pieces } = this.around;
    return lengthOfSeries(pieces, draft[side === 'a' ? 'b' : 'a']) - lengthOfSeries(pieces, draft[side]);
  }
}
