// What a hand does in the 3D view besides turning it: clicks, hovers, drags pieces to boxes and landmarks over the body.

import { Raycaster, Vector2, type PerspectiveCamera, type Vector3 } from 'three';
import type { OrbitControls } from 'three/examples/jsm/controls/OrbitControls.js';
import type { BodyMarks } from './BodyMarks';
import type { BodyObject } from './BodyObject';
import type { BoxPlace } from './boxFaces';
import type { ClothObject } from './ClothObject';

/** A press that moves less than this, in pixels, is a click. */
const kClickPx = 4;
/** How far from a landmark a hand may press, as a share of the distance to what is looked at. */
const kGrab = 0.012;

export interface HandEvents {
  select(piece: string | null): void;
  hover(piece: string | null): void;
  /** A piece was let go over a side of a box. */
  place(piece: string, at: BoxPlace): void;
  /** A landmark was dragged to a place on the body, or picked there; without a name it is the one that is awaited. */
  mark(landmark: string | null, place: [number, number, number]): void;
}

/** What there is to touch. */
export interface Touchable {
  camera: PerspectiveCamera;
  controls: OrbitControls;
  cloth: ClothObject;
  body: BodyObject;
  marks: BodyMarks;
}

export class SceneHands {
  private readonly raycaster_ = new Raycaster();
  private press_: [number, number] | null = null;
  private draggable_ = false;
  private drag_: { piece: string; at: BoxPlace | null } | null = null;
  /** A landmark on its way over the body. */
  private pull_: { landmark: string; at: Vector3 | null } | null = null;
  private markable_ = false;
  private picking_ = false;

  /** Listens to the canvas before the camera's own listeners do; `changed` asks for another picture. */
  constructor(
    private readonly canvas_: HTMLCanvasElement,
    private readonly scene_: Touchable,
    private readonly events_: HandEvents,
    private readonly changed_: () => void,
  ) {
    this.listen();
  }

  setDraggable(draggable: boolean): void {
    this.draggable_ = draggable;
    if (!draggable) this.endDrag();
  }

  setMarkable(markable: boolean, picking: boolean): void {
    this.markable_ = markable;
    this.picking_ = picking;
    this.canvas_.style.cursor = picking ? 'crosshair' : '';
    if (!markable) this.endPull();
  }

  private listen(): void {
    const at = (event: PointerEvent): [number, number] => [event.clientX, event.clientY];
    const still = (event: PointerEvent): boolean =>
      this.press_ !== null && Math.hypot(event.clientX - this.press_[0], event.clientY - this.press_[1]) < kClickPx;
    // Before the camera's own listeners, which a dragged piece keeps from turning.
    const down = (event: PointerEvent): void => {
      this.press_ = at(event);
      if (event.button !== 0) return;
      const landmark = this.markable_ && !this.picking_ ? this.landmarkUnder(event) : null;
      const piece = this.draggable_ && !landmark ? this.pieceUnder(event) : null;
      if (landmark) this.beginPull(landmark, event);
      else if (piece) this.beginDrag(piece, event);
    };
    this.canvas_.addEventListener('pointerdown', down, { capture: true });
    this.canvas_.addEventListener('pointerup', (event) => {
      const click = still(event),
        drag = this.drag_,
        pull = this.pull_;
      this.press_ = null;
      this.endDrag();
      this.endPull();
      if (pull) {
        if (pull.at && !click) this.events_.mark(pull.landmark, pull.at.toArray());
        return;
      }
      const picked = click && event.button === 0 && this.picking_ ? this.skinUnder(event) : null;
      if (picked) this.events_.mark(null, picked.toArray());
      else if (click && event.button === 0) this.events_.select(this.pieceUnder(event));
      else if (drag?.at) this.events_.place(drag.piece, drag.at);
    });
    this.canvas_.addEventListener('pointercancel', () => {
      this.endDrag();
      this.endPull();
    });
    this.canvas_.addEventListener('pointermove', (event) => {
      if (this.pull_ && !still(event)) this.pull(event);
      if (this.drag_ && !still(event)) this.aim(event);
      if (event.buttons === 0 && event.pointerType === 'mouse') this.events_.hover(this.pieceUnder(event));
    });
    this.canvas_.addEventListener('pointerleave', () => this.events_.hover(null));
  }

  private beginDrag(piece: string, event: PointerEvent): void {
    this.drag_ = { piece, at: null };
    this.scene_.controls.enabled = false;
    this.canvas_.setPointerCapture(event.pointerId);
  }

  private aim(event: PointerEvent): void {
    if (!this.drag_) return;
    if (!this.drag_.at) this.scene_.marks.setDragging(true);
    this.point(event);
    this.drag_.at = this.scene_.marks.aim(this.raycaster_) ?? null;
    this.canvas_.style.cursor = this.drag_.at ? 'copy' : 'not-allowed';
    this.events_.hover(this.drag_.piece);
    this.changed_();
  }

  private endDrag(): void {
    if (!this.drag_) return;
    this.drag_ = null;
    this.scene_.controls.enabled = true;
    this.canvas_.style.cursor = '';
    this.scene_.marks.setDragging(false);
    this.changed_();
  }

  private beginPull(landmark: string, event: PointerEvent): void {
    this.pull_ = { landmark, at: null };
    this.scene_.controls.enabled = false;
    this.canvas_.setPointerCapture(event.pointerId);
    this.canvas_.style.cursor = 'grabbing';
  }

  private pull(event: PointerEvent): void {
    const at = this.skinUnder(event);
    if (!this.pull_ || !at) return;
    this.pull_.at = at;
    this.scene_.marks.moveLandmark(this.pull_.landmark, at);
    this.changed_();
  }

  private endPull(): void {
    if (!this.pull_) return;
    this.pull_ = null;
    this.scene_.controls.enabled = true;
    this.canvas_.style.cursor = '';
    this.changed_();
  }

  private landmarkUnder(event: PointerEvent): string | null {
    this.point(event);
    const away = this.scene_.camera.position.distanceTo(this.scene_.controls.target);
    return this.scene_.marks.landmarkAt(this.raycaster_, kGrab * away);
  }

  /** Where the ray through the pointer meets the body, cloth or not. */
  private skinUnder(event: PointerEvent): Vector3 | null {
    if (!this.scene_.body.mesh.visible) return null;
    this.point(event);
    return this.raycaster_.intersectObject(this.scene_.body.mesh, false)[0]?.point.clone() ?? null;
  }

  /** Sends the ray through the pointer. */
  private point(event: PointerEvent): void {
    const box = this.canvas_.getBoundingClientRect();
    const pointer = new Vector2(
      ((event.clientX - box.left) / box.width) * 2 - 1,
      1 - ((event.clientY - box.top) / box.height) * 2,
    );
    this.raycaster_.setFromCamera(pointer, this.scene_.camera);
  }

  private pieceUnder(event: PointerEvent): string | null {
    const mesh = this.scene_.cloth.mesh;
    if (!mesh || !this.scene_.cloth.positions) return null;
    this.point(event);
    const hit = this.raycaster_.intersectObjects(this.scene_.body.mesh.visible ? [mesh, this.scene_.body.mesh] : [mesh], false)[0];
    return hit && hit.object === mesh ? this.scene_.cloth.pieceAt(hit) : null;
  }
}
