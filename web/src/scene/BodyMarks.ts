// What is drawn on and around a body: the tape where it lies, landmarks, the boxes of its parts, and the place of what the
// look before a drape found.

import {
  BoxGeometry,
  BufferGeometry,
  CanvasTexture,
  EdgesGeometry,
  Float32BufferAttribute,
  Group,
  LineBasicMaterial,
  LineSegments,
  Matrix4,
  DoubleSide,
  Mesh,
  MeshBasicMaterial,
  PlaneGeometry,
  Points,
  PointsMaterial,
  type Raycaster,
  Sprite,
  SpriteMaterial,
  Vector3,
} from 'three';
import type { BoxSide, Finding, PartBox, Place, ProjectBody } from '../api/dressing';
import type { Marks } from '../state/dressing';
import type { BoxPlace } from '../tools/SceneTool';
import { faceOf, onFace } from './boxFaces';
import { disposeLines, fatLines, fitLines, setSegments } from './fatLines';

const kTape = '#b3261e';
const kLit = '#ffb300';
const kBox = '#2e9e5b';
const kPoint = '#1f6feb';
const kTapePx = 1.8;
const kLitPx = 4;
const kPointPx = 7;
const kMarkPx = 0.055; // of the picture's height
const kMarkColours: Record<Finding['severity'], string> = { error: '#d32f2f', warning: '#e08a00', note: '#1f6feb' };

export class BodyMarks {
  readonly group = new Group();
  private readonly tape_ = fatLines(kTape, kTapePx);
  private readonly lit_ = fatLines(kLit, kLitPx);
  private readonly landmarks_ = new Points(
    new BufferGeometry(),
    new PointsMaterial({ color: kPoint, size: kPointPx, sizeAttenuation: false, map: disc(), alphaTest: 0.5 }),
  );
  private readonly boxes_ = new Group();
  private readonly boxFill_ = new MeshBasicMaterial({
    color: kBox,
    transparent: true,
    opacity: 0.13,
    depthWrite: false,
  });
  private readonly boxEdge_ = new LineBasicMaterial({ color: kBox, transparent: true, opacity: 0.75 });
  private readonly mark_ = new Sprite(
    new SpriteMaterial({ map: ring(), depthTest: false, sizeAttenuation: false, transparent: true }),
  );
  /** The side that a dragged piece would come to. */
  private readonly target_ = new Mesh(
    new PlaneGeometry(1, 1),
    new MeshBasicMaterial({ color: kBox, transparent: true, opacity: 0.5, depthTest: false, side: DoubleSide }),
  );
  private dragging_ = false;
  private bodies_: ProjectBody[] = [];
  /** Of the landmarks, in the order in which they are drawn. */
  private names_: string[] = [];
  private marks_: Marks = { tape: false, landmarks: false, boxes: false };
  private litMeasure_: string | null = null;

  constructor() {
    this.mark_.scale.setScalar(kMarkPx);
    this.mark_.renderOrder = 10;
    this.lit_.renderOrder = 9;
    this.lit_.material.depthTest = false; // seen through the body: what is lit is looked for
    this.mark_.visible = false;
    this.target_.visible = false;
    this.target_.renderOrder = 8;
    this.group.add(this.boxes_, this.target_, this.tape_, this.lit_, this.landmarks_, this.mark_);
    this.draw();
  }

  setBodies(bodies: ProjectBody[]): void {
    this.bodies_ = bodies;
    const places = bodies.flatMap((body) => body.landmarks.flatMap((landmark) => landmark.place));
    this.names_ = bodies.flatMap((body) => body.landmarks.map((landmark) => landmark.name));
    this.landmarks_.geometry.dispose();
    this.landmarks_.geometry = new BufferGeometry();
    this.landmarks_.geometry.setAttribute('position', new Float32BufferAttribute(places, 3));
    this.clearBoxes();
    for (const box of bodies.flatMap((body) => body.boxes)) this.addBox(box);
    this.draw();
  }

  show(marks: Marks, lit: string | null): void {
    this.marks_ = marks;
    this.litMeasure_ = lit;
    this.draw();
  }

  /** Puts the mark to what was found, or takes it away. */
  mark(finding: Finding | null): void {
    this.mark_.visible = finding !== null;
    if (!finding) return;
    this.mark_.position.set(...finding.place);
    this.mark_.material.color.set(finding.repaired ? kBox : kMarkColours[finding.severity]);
  }

  /** While a piece is dragged the boxes are seen, whatever is switched on. */
  setDragging(dragging: boolean): void {
    this.dragging_ = dragging;
    this.target_.visible = false;
    this.draw();
  }

  /** The place on a side of a box that the ray meets first, which is lit up; null where there is none. */
  aim(raycaster: Raycaster): BoxPlace | null {
    this.boxes_.updateMatrixWorld();
    const volumes = this.boxes_.children.filter((part) => part instanceof Mesh);
    for (const hit of raycaster.intersectObjects(volumes, false)) {
      const box = hit.object.userData as PartBox;
      const side = hit.face ? faceOf(hit.face.normal.toArray()) : null;
      if (!side) continue;
      const local = hit.object.worldToLocal(hit.point.clone()).toArray();
      this.light(hit.object as Mesh, box, side);
      return { part: box.part, side, at_mm: onFace(side, local) };
    }
    this.target_.visible = false;
    return null;
  }

  private light(volume: Mesh, box: PartBox, side: BoxSide): void {
    const across = side === 'front' || side === 'back';
    const far = across ? box.half[2] : box.half[0];
    const local = new Matrix4()
      .makeRotationY(across ? 0 : Math.PI / 2)
      .setPosition(across ? 0 : side === 'left' ? far : -far, 0, across ? (side === 'front' ? far : -far) : 0)
      .scale(new Vector3(2 * (across ? box.half[0] : box.half[2]), 2 * box.half[1], 1));
    this.target_.matrixAutoUpdate = false;
    this.target_.matrix.multiplyMatrices(volume.matrix, local);
    this.target_.visible = true;
  }

  /** Lines are as wide as they are said in pixels of this picture. */
  resize(width: number, height: number): void {
    for (const lines of [this.tape_, this.lit_]) fitLines(lines, width, height);
  }

  dispose(): void {
    this.clearBoxes();
    for (const lines of [this.tape_, this.lit_]) disposeLines(lines);
    this.landmarks_.geometry.dispose();
    this.target_.geometry.dispose();
    for (const material of [this.boxFill_, this.boxEdge_, this.target_.material]) material.dispose();
    for (const mapped of [this.landmarks_.material, this.mark_.material]) {
      mapped.map?.dispose();
      mapped.dispose();
    }
  }

  /** The landmark that the ray meets, at most `near` metres off it; null where they are not shown. */
  landmarkAt(raycaster: Raycaster, near: number): string | null {
    if (!this.landmarks_.visible) return null;
    raycaster.params.Points.threshold = near;
    const hits = raycaster.intersectObject(this.landmarks_, false);
    const hit = hits.sort((a, b) => (a.distanceToRay ?? 0) - (b.distanceToRay ?? 0))[0];
    return hit?.index === undefined ? null : (this.names_[hit.index] ?? null);
  }

  /** Shows a landmark elsewhere while it is dragged. */
  moveLandmark(name: string, place: Vector3): void {
    const positions = this.landmarks_.geometry.getAttribute('position');
    const at = this.names_.indexOf(name);
    if (at < 0) return;
    positions.setXYZ(at, place.x, place.y, place.z);
    positions.needsUpdate = true;
  }

  private draw(): void {
    const lines = this.bodies_.flatMap((body) => body.measures);
    setSegments(this.tape_, this.marks_.tape ? lines.flatMap((one) => segmentsOf(one.line, one.girth)) : []);
    const lit = lines.filter((one) => one.name === this.litMeasure_);
    setSegments(
      this.lit_,
      lit.flatMap((one) => segmentsOf(one.line, one.girth)),
    );
    this.landmarks_.visible = this.marks_.landmarks;
    this.boxes_.visible = this.marks_.boxes || this.dragging_;
  }

  private addBox(box: PartBox): void {
    const geometry = new BoxGeometry(2 * box.half[0], 2 * box.half[1], 2 * box.half[2]);
    const place = new Matrix4()
      .makeBasis(...(box.axes.map((axis) => new Vector3(...axis)) as [Vector3, Vector3, Vector3]))
      .setPosition(...box.centre);
    const volume = new Mesh(geometry, this.boxFill_);
    const edges = new LineSegments(new EdgesGeometry(geometry), this.boxEdge_);
    for (const part of [volume, edges]) {
      part.applyMatrix4(place);
      part.renderOrder = 4;
      part.userData = box;
      this.boxes_.add(part);
    }
  }

  private clearBoxes(): void {
    for (const part of this.boxes_.children) (part as Mesh).geometry.dispose();
    this.boxes_.clear();
  }
}

/** From each point of a tape to the next, around when it closes; x y z of both ends, one after the other. */
export function segmentsOf(line: Place[], closed: boolean): number[] {
  const points: number[] = [];
  for (let i = 0; i + 1 < line.length; ++i) points.push(...line[i]!, ...line[i + 1]!);
  if (closed && line.length > 2) points.push(...line[line.length - 1]!, ...line[0]!);
  return points;
}

function drawn(size: number, draw: (pen: CanvasRenderingContext2D) => void): CanvasTexture {
  const canvas = document.createElement('canvas');
  canvas.width = size;
  canvas.height = size;
  draw(canvas.getContext('2d')!);
  return new CanvasTexture(canvas);
}

const disc = (): CanvasTexture =>
  drawn(32, (pen) => {
    pen.fillStyle = '#fff';
    pen.beginPath();
    pen.arc(16, 16, 15, 0, 2 * Math.PI);
    pen.fill();
  });

/** A ring with a dot in it, white so that the material colours it. */
const ring = (): CanvasTexture =>
  drawn(128, (pen) => {
    pen.strokeStyle = '#fff';
    pen.fillStyle = '#fff';
    pen.lineWidth = 9;
    pen.beginPath();
    pen.arc(64, 64, 54, 0, 2 * Math.PI);
    pen.stroke();
    pen.beginPath();
    pen.arc(64, 64, 11, 0, 2 * Math.PI);
    pen.fill();
  });
