// What lies under the pointer in the 3D view: a ray from the camera through it.

import { Plane, Raycaster, Vector2, Vector3, type Intersection, type PerspectiveCamera } from 'three';
import type { OrbitControls } from 'three/examples/jsm/controls/OrbitControls.js';
import type { Place } from '../api/dressing';
import type { ClothPoint } from '../state/hands';
import type { BoxPlace } from '../tools/SceneTool';
import type { BodyMarks } from './BodyMarks';
import type { BodyObject } from './BodyObject';
import { clothPoint } from './clothPoint';
import type { ClothObject } from './ClothObject';
import type { Ray } from './SceneHands';

/** How far from a landmark a hand may press, as a share of the distance to what is looked at. */
const kGrab = 0.012;

/** What there is to touch. */
export interface Touchable {
  camera: PerspectiveCamera;
  controls: OrbitControls;
  cloth: ClothObject;
  body: BodyObject;
  marks: BodyMarks;
}

export class PointerRay implements Ray {
  private readonly raycaster_ = new Raycaster();

  constructor(
    private readonly canvas_: HTMLCanvasElement,
    private readonly scene_: Touchable,
  ) {}

  /** Sends the ray through the pointer; what is asked afterwards lies there. */
  through(event: PointerEvent): this {
    const box = this.canvas_.getBoundingClientRect();
    const pointer = new Vector2(
      ((event.clientX - box.left) / box.width) * 2 - 1,
      1 - ((event.clientY - box.top) / box.height) * 2,
    );
    this.raycaster_.setFromCamera(pointer, this.scene_.camera);
    return this;
  }

  /** Where the ray meets the cloth; null where the body is in the way. */
  private hit(): Intersection | null {
    const { cloth, body } = this.scene_;
    const { mesh } = cloth;
    if (!mesh || !cloth.positions) return null;
    const hit = this.raycaster_.intersectObjects(body.mesh.visible ? [mesh, body.mesh] : [mesh], false)[0];
    return hit?.object === mesh ? hit : null;
  }

  piece(): string | null {
    const hit = this.hit();
    return hit && this.scene_.cloth.pieceAt(hit);
  }

  mapValue(): number {
    const hit = this.hit();
    return hit ? this.scene_.cloth.valueAt(hit) : NaN;
  }

  cloth(): ClothPoint | null {
    const hit = this.hit();
    const { topology, positions } = this.scene_.cloth;
    return hit && topology && positions && clothPoint(hit, topology, positions);
  }

  beside(at: Place): Place {
    const ahead = this.scene_.camera.getWorldDirection(new Vector3());
    const plane = new Plane().setFromNormalAndCoplanarPoint(ahead, new Vector3(...at));
    return this.raycaster_.ray.intersectPlane(plane, new Vector3())?.toArray() ?? at;
  }

  landmark(): string | null {
    const { camera, controls, marks } = this.scene_;
    return marks.landmarkAt(this.raycaster_, kGrab * camera.position.distanceTo(controls.target));
  }

  skin(): Place | null {
    const { mesh } = this.scene_.body;
    if (!mesh.visible) return null;
    return this.raycaster_.intersectObject(mesh, false)[0]?.point.toArray() ?? null;
  }

  box(): BoxPlace | null {
    return this.scene_.marks.aim(this.raycaster_);
  }

  openBoxes(open: boolean): void {
    this.scene_.marks.setDragging(open);
  }

  moveLandmark(name: string, to: Place): void {
    this.scene_.marks.moveLandmark(name, new Vector3(...to));
  }
}
