// Pins in the cloth, and the line from what a hand holds to where it draws it. Seen through everything: what is looked for
// may be behind a fold.

import {
  BufferGeometry,
  CanvasTexture,
  Float32BufferAttribute,
  Group,
  Line,
  LineBasicMaterial,
  Points,
  PointsMaterial,
  Vector3,
} from 'three';
import type { ClothTopology } from '../api/frames';
import type { Progress } from '../api/types';
import type { Held } from '../state/hands';
import { placeOf } from './clothPoint';

type Pin = Progress['pins'][number];

const kPin = '#c2410c';
const kLit = '#ffb300';
const kHand = '#1f6feb';
const kPinPx = 13;

export class HandMarks {
  readonly group = new Group();
  private readonly pins_ = dots(kPin, kPinPx);
  private readonly lit_ = dots(kLit, kPinPx + 5);
  private readonly ends_ = dots(kHand, kPinPx);
  private readonly leash_ = new Line(
    new BufferGeometry().setAttribute('position', new Float32BufferAttribute(6, 3)),
    new LineBasicMaterial({ color: kHand, depthTest: false, transparent: true }),
  );
  private held_: Held | null = null;
  private readonly from_ = new Vector3();

  constructor() {
    this.leash_.renderOrder = 9;
    this.leash_.frustumCulled = false;
    this.group.add(this.lit_, this.pins_, this.leash_, this.ends_);
    this.setHeld(null);
  }

  setPins(pins: readonly Pin[], lit: number | null): void {
    place(this.pins_, pins.flatMap((pin) => pin.place));
    place(this.lit_, pins.filter(({ pin }) => pin === lit).flatMap((pin) => pin.place));
  }

  setHeld(held: Held | null): void {
    this.held_ = held;
    this.leash_.visible = held !== null;
    this.ends_.visible = held !== null;
  }

  /** The cloth has moved, or the hand. */
  follow(topology: ClothTopology | null, positions: Float32Array | null): void {
    if (!this.held_ || !topology || !positions) return;
    const { x, y, z } = placeOf(this.held_.point, topology, positions, this.from_);
    const ends = [x, y, z, ...this.held_.to];
    place(this.leash_, ends);
    place(this.ends_, ends);
  }

  dispose(): void {
    for (const part of [this.pins_, this.lit_, this.ends_, this.leash_]) {
      part.geometry.dispose();
      part.material.dispose();
    }
  }
}

/** Puts a drawing's vertices there. */
function place(what: Points | Line, places: number[]): void {
  what.geometry.dispose();
  what.geometry = new BufferGeometry().setAttribute('position', new Float32BufferAttribute(places, 3));
}

function dots(colour: string, size: number): Points<BufferGeometry, PointsMaterial> {
  const points = new Points(
    new BufferGeometry().setAttribute('position', new Float32BufferAttribute([], 3)),
    new PointsMaterial({ color: colour, size, sizeAttenuation: false, map: disc(), alphaTest: 0.4, depthTest: false, transparent: true }),
  );
  points.renderOrder = 10;
  points.frustumCulled = false;
  return points;
}

/** White with a dark rim, to be coloured. */
function disc(): CanvasTexture {
  const canvas = document.createElement('canvas');
  canvas.width = 32;
  canvas.height = 32;
  const pen = canvas.getContext('2d');
  if (pen) {
    pen.arc(16, 16, 13, 0, 2 * Math.PI);
    pen.fillStyle = '#fff';
    pen.fill();
    pen.lineWidth = 3;
    pen.strokeStyle = '#333';
    pen.stroke();
  }
  return new CanvasTexture(canvas);
}
