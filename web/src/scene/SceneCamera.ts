// The camera and its ways: by hand, by keys, in a swift turn to a pose, or behind another view's camera.

import { PerspectiveCamera, Vector3 } from 'three';
import { OrbitControls } from 'three/examples/jsm/controls/OrbitControls.js';
import { eased, kFov, type Pose, type Vec3 } from './framing';

const kTurnMs = 320;

export class SceneCamera {
  readonly camera = new PerspectiveCamera(kFov, 1, 0.05, 40);
  readonly controls: OrbitControls;
  private turn_: { from: Pose; to: Pose; start: number } | null = null;
  /** Told of every turn that a person makes here. */
  private onTurn_: ((pose: Pose) => void) | null = null;
  private following_ = false;

  constructor(
    canvas: HTMLCanvasElement,
    /** It has moved, or wants to. */
    private readonly moved_: () => void,
  ) {
    this.controls = this.makeControls(canvas);
  }

  get pose(): Pose {
    return { eye: this.camera.position.toArray(), target: this.controls.target.toArray() };
  }

  /** Whether a turn is under way. */
  get turning(): boolean {
    return this.turn_ !== null;
  }

  apply({ eye, target }: Pose): void {
    this.camera.position.set(...eye);
    this.controls.target.set(...target);
    this.controls.update();
    this.moved_();
  }

  /** Turns there swiftly, or at once where motion is not wanted. */
  turnTo(to: Pose, still: boolean): void {
    if (still) return this.apply(to);
    this.turn_ = { from: this.pose, to, start: performance.now() };
    this.moved_();
  }

  /** Goes on with the turn that is under way. */
  advance(now: number): void {
    if (!this.turn_) return;
    const { from, to, start } = this.turn_;
    const t = Math.min(1, Math.max(0, (now - start) / kTurnMs));
    this.apply(blend(from, to, eased(t)));
    if (t >= 1) this.turn_ = null;
  }

  /** Tells of every pose that it takes but those it follows: so two views share one. */
  listenToTurns(turned: (pose: Pose) => void): void {
    this.onTurn_ = turned;
  }

  /** Takes another view's pose. */
  follow(pose: Pose): void {
    this.turn_ = null;
    this.following_ = true;
    this.apply(pose);
    this.following_ = false;
  }

  /** Keyboard's way round: turns by degrees about the upright and the level axis, and steps nearer or away. */
  nudge(heading: number, height: number, zoom: number): void {
    this.turn_ = null;
    const target = this.controls.target;
    const arm = this.camera.position.clone().sub(target).multiplyScalar(zoom);
    const level = new Vector3(arm.z, 0, -arm.x).normalize();
    arm.applyAxisAngle(new Vector3(0, 1, 0), (heading * Math.PI) / 180).applyAxisAngle(level, (height * Math.PI) / 180);
    this.camera.position.copy(target).add(arm);
    this.controls.update();
    this.moved_();
  }

  /** Width over height of the picture. */
  setAspect(aspect: number): void {
    this.camera.aspect = aspect;
    this.camera.updateProjectionMatrix();
  }

  dispose(): void {
    this.controls.dispose();
  }

  private makeControls(canvas: HTMLCanvasElement): OrbitControls {
    const controls = new OrbitControls(this.camera, canvas);
    controls.enableDamping = !matchMedia('(prefers-reduced-motion: reduce)').matches;
    controls.dampingFactor = 0.12;
    controls.minDistance = 0.15;
    controls.maxDistance = 12;
    controls.maxPolarAngle = Math.PI * 0.56;
    controls.addEventListener('start', () => (this.turn_ = null));
    controls.addEventListener('change', () => {
      this.moved_();
      if (!this.following_) this.onTurn_?.(this.pose);
    });
    return controls;
  }
}

/** Between two poses around the target: the eye keeps its distance on the way round. */
function blend(from: Pose, to: Pose, t: number): Pose {
  const target = from.target.map((x, k) => x + t * (to.target[k]! - x)) as Vec3;
  const arm = (pose: Pose): Vector3 => new Vector3(...pose.eye).sub(new Vector3(...pose.target));
  const a = arm(from);
  const b = arm(to);
  const angle = (v: Vector3): number => Math.atan2(v.x, v.z);
  let turn = angle(b) - angle(a);
  if (turn > Math.PI) turn -= 2 * Math.PI;
  if (turn < -Math.PI) turn += 2 * Math.PI;
  const heading = angle(a) + t * turn;
  const flat = Math.hypot(a.x, a.z) * (1 - t) + Math.hypot(b.x, b.z) * t;
  const eye: Vec3 = [
    target[0] + flat * Math.sin(heading),
    target[1] + a.y * (1 - t) + b.y * t,
    target[2] + flat * Math.cos(heading),
  ];
  return { eye, target };
}
