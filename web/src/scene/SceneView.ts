// The 3D view: renderer, camera, and when to draw. It draws only when something has changed: a frame, the camera, the
// selection, the size. Loaded by itself, because three.js comes with it.

import {
  Color,
  CustomToneMapping,
  PCFShadowMap,
  PerspectiveCamera,
  Scene,
  ShaderChunk,
  SRGBColorSpace,
  Vector3,
  VSMShadowMap,
  WebGLRenderer,
} from 'three';
import { OrbitControls } from 'three/examples/jsm/controls/OrbitControls.js';
import type { BodyMesh } from '../api/body';
import type { View } from '../state/AppState';
import type { LiveCloth } from '../state/LiveCloth';
import type { Finding, ProjectBody, Start } from '../api/dressing';
import type { Marks } from '../state/dressing';
import type { ClothMap } from '../state/clothMaps';
import type { Finish } from '../state/fabrics';
import type { SeamPart } from '../state/seamView';
import type { Look } from '../state/texture';
import type { Hand } from '../tools/PatternTool';
import type { SceneTool } from '../tools/SceneTool';
import { BodyMarks } from './BodyMarks';
import { BodyObject } from './BodyObject';
import { ClothObject } from './ClothObject';
import { boundsOf, closeUp, eased, footprints, poseFor, union, type Bounds, type Pose, type Vec3 } from './framing';
import { PointerRay } from './PointerRay';
import { SceneHands } from './SceneHands';
import { Studio, type StudioColours } from './Studio';

const kFov = 32;
/** With it, cloth is as bright as on the stills. */
const kExposure = 1.18;
const kTurnMs = 320;
/** Slower than this, the picture gets coarser; faster, finer again. */
const kSlowMs = 50;
const kFastMs = 24;
const kCoarsest = 0.6;
/** What is asked for later than this after a picture was not waited for: nothing had changed. */
const kPauseMs = 120;
/** One picture tells no more than this of the pace. */
const kLongestMs = 600;
const kRestMs = 250;
/** A body alone is framed whole; cloth with this much more room around it, m. */
const kBodyOnly: Bounds = { low: [-0.5, 0, -0.3], high: [0.5, 1.75, 0.3] };

export class SceneView {
  private readonly renderer_: WebGLRenderer;
  /** Drawn by the processor: coarser while it moves, and smoothed by more pixels instead of samples when it rests. */
  private readonly slow_: boolean;
  private readonly scene_ = new Scene();
  private readonly camera_ = new PerspectiveCamera(kFov, 1, 0.05, 40);
  private readonly controls_: OrbitControls;
  private readonly hands_: SceneHands;
  private readonly studio_: Studio;
  private readonly cloth_: ClothObject;
  private readonly body_: BodyObject;
  private readonly marks_ = new BodyMarks();
  /** Shown in place of the drape's cloth. */
  private start_: Start | null = null;
  private readonly resizer_: ResizeObserver;
  private readonly stopListening_: () => void;
  private bodyBounds_: Bounds | null = null;
  private view_: View = 'three-quarter';
  private framed_ = false;
  private turn_: { from: Pose; to: Pose; start: number } | null = null;
  /** Told of every turn that a person makes here. */
  private onTurn_: ((pose: Pose) => void) | null = null;
  private following_ = false;
  private stale_ = true;
  private newFrame_ = false;
  /** Positions have come into the scene since the last picture. */
  private caughtUp_ = false;
  private request_ = 0;
  private lastDraw_ = 0;
  /** When the next picture was asked for. */
  private asked_ = 0;
  /** ms from picture to picture, a running mean. */
  private pace_ = 16;
  /** Share of the screen's own resolution. */
  private sharpness_ = 1;
  private rest_: ReturnType<typeof setTimeout> | undefined;

  constructor(
    private readonly canvas_: HTMLCanvasElement,
    private readonly live_: LiveCloth,
    hand: Hand,
    /** A frame of the cloth has reached the screen. */
    private readonly drawn_: () => void,
    accent: string,
  ) {
    this.slow_ = !hasGraphicsCard();
    this.studio_ = new Studio(this.slow_);
    this.renderer_ = new WebGLRenderer({
      canvas: canvas_,
      antialias: !this.slow_,
      alpha: true,
      powerPreference: 'high-performance',
    });
    this.renderer_.toneMappingExposure = kExposure;
    this.renderer_.outputColorSpace = SRGBColorSpace;
    developAsStills();
    this.renderer_.toneMapping = CustomToneMapping;
    this.renderer_.shadowMap.enabled = true;
    // The soft one costs the processor two thirds of its frames.
    this.renderer_.shadowMap.type = this.slow_ ? PCFShadowMap : VSMShadowMap;
    this.cloth_ = new ClothObject({
      thread: new Color(accent),
      selected: new Color(accent),
      hovered: new Color('#ffffff'),
    });
    this.body_ = new BodyObject(0xcfc8bf);
    this.scene_.add(this.studio_.group, this.body_.mesh, this.cloth_.group, this.marks_.group);
    this.controls_ = this.makeControls();
    this.applyPose(poseFor('three-quarter', kBodyOnly, kFov, 1));
    this.renderer_.compile(this.scene_, this.camera_);
    this.resizer_ = new ResizeObserver(() => this.resize());
    this.resizer_.observe(canvas_.parentElement ?? canvas_);
    this.stopListening_ = live_.listen((event) => this.take(event));
    this.takeAll();
    const touchable = {
      camera: this.camera_,
      controls: this.controls_,
      cloth: this.cloth_,
      body: this.body_,
      marks: this.marks_,
    };
    const ray = new PointerRay(canvas_, touchable);
    this.hands_ = new SceneHands(canvas_, ray, this.controls_, hand, () => this.invalidate());
    this.resize();
  }

  setBody(body: BodyMesh | null): void {
    this.body_.set(body);
    this.bodyBounds_ = body ? boundsOf(body.positions) : null;
    this.studio_.standOn(body ? footprints(body.positions) : []);
    if (body && !this.framed_ && !this.cloth_.positions) this.applyPose(this.pose());
    this.invalidate();
  }

  /** The pieces where a drape would begin, in place of the drape's cloth; null: the drape again. */
  setStart(start: Start | null): void {
    if (start === this.start_) return;
    const other = (start === null) !== (this.start_ === null);
    this.start_ = start;
    if (other) this.framed_ = false;
    this.takeAll();
  }

  setFigures(bodies: ProjectBody[]): void {
    this.marks_.setBodies(bodies);
    this.invalidate();
  }

  showMarks(marks: Marks, lit: string | null): void {
    this.marks_.show(marks, lit);
    this.invalidate();
  }

  /** Those that the hand holds now, the first to be asked first. */
  setTools(tools: readonly SceneTool[]): void {
    this.hands_.setTools(tools);
  }

  /** Marks the place of a finding and flies to it, to the outer side of the body there. */
  lookAt(finding: Finding | null, still = false): void {
    this.marks_.mark(finding);
    this.invalidate();
    if (!finding) return;
    const middle = this.bodyBounds_ ?? kBodyOnly;
    const to = closeUp(finding.place, middle, this.currentPose());
    if (still) return this.applyPose(to);
    this.turn_ = { from: this.currentPose(), to, start: performance.now() };
  }

  setLooks(looks: ReadonlyMap<string, Look>): void {
    this.cloth_.setLooks(looks);
    this.invalidate();
  }

  setFinishes(finishes: ReadonlyMap<string, Finish>): void {
    this.cloth_.setFinishes(finishes);
    this.invalidate();
  }

  setMap(map: ClothMap | null): void {
    this.cloth_.setMap(map);
    this.invalidate();
  }

  /** Threads that are left once a drape is done belong to seams that did not close. */
  showOpenSeams(done: boolean, colour: string): void {
    this.cloth_.colourThreads(done ? new Color(colour) : null);
    this.invalidate();
  }

  show(bodyShown: boolean, meshShown: boolean): void {
    this.body_.mesh.visible = bodyShown && this.bodyBounds_ !== null;
    this.cloth_.showWires(meshShown);
    this.invalidate();
  }

  highlight(selected: string | null, hovered: string | null): void {
    this.cloth_.highlight(selected, hovered);
    this.invalidate();
  }

  /** Lights a seam along its sides. */
  lightSeam(parts: readonly SeamPart[]): void {
    this.cloth_.lightSeam(parts);
    this.invalidate();
  }

  paint(colours: StudioColours): void {
    this.studio_.paint(colours);
    this.invalidate();
  }

  /** Turns to a view, swiftly or at once where motion is not wanted. */
  look(view: View, still = false): void {
    this.view_ = view;
    this.catchUp(); // what came with the wish, as pieces arranged anew, is what is to be seen
    const to = this.pose();
    if (still) return this.applyPose(to);
    this.turn_ = { from: this.currentPose(), to, start: performance.now() };
    this.invalidate();
  }

  /** Tells of every pose that the camera takes but those it follows: so two views share one. */
  listenToTurns(turned: (pose: Pose) => void): void {
    this.onTurn_ = turned;
  }

  /** Takes another view's pose. */
  follow(pose: Pose): void {
    this.turn_ = null;
    this.framed_ = true;
    this.following_ = true;
    this.applyPose(pose);
    this.following_ = false;
  }

  /** Keyboard's way round: turns by degrees about the upright and the level axis, and steps nearer or away. */
  nudge(heading: number, height: number, zoom: number): void {
    this.turn_ = null;
    const target = this.controls_.target;
    const arm = this.camera_.position.clone().sub(target).multiplyScalar(zoom);
    const level = new Vector3(arm.z, 0, -arm.x).normalize();
    arm.applyAxisAngle(new Vector3(0, 1, 0), (heading * Math.PI) / 180).applyAxisAngle(level, (height * Math.PI) / 180);
    this.camera_.position.copy(target).add(arm);
    this.controls_.update();
    this.invalidate();
  }

  dispose(): void {
    cancelAnimationFrame(this.request_);
    clearTimeout(this.rest_);
    this.resizer_.disconnect();
    this.stopListening_();
    this.controls_.dispose();
    this.cloth_.dispose();
    this.marks_.dispose();
    this.body_.dispose();
    this.studio_.dispose();
    this.renderer_.dispose();
  }

  private makeControls(): OrbitControls {
    const controls = new OrbitControls(this.camera_, this.canvas_);
    controls.enableDamping = !matchMedia('(prefers-reduced-motion: reduce)').matches;
    controls.dampingFactor = 0.12;
    controls.minDistance = 0.15;
    controls.maxDistance = 12;
    controls.maxPolarAngle = Math.PI * 0.56;
    controls.addEventListener('start', () => (this.turn_ = null));
    controls.addEventListener('change', () => {
      this.invalidate();
      if (!this.following_) this.onTurn_?.(this.currentPose());
    });
    return controls;
  }

  private take(event: 'topology' | 'frame' | 'cleared'): void {
    if (this.start_) return;
    if (event === 'frame') {
      this.newFrame_ = true;
      return this.invalidate();
    }
    this.takeAll();
  }

  private get shown(): Pick<LiveCloth, 'topology' | 'positions'> {
    return this.start_ ?? this.live_;
  }

  private takeAll(): void {
    const { topology, positions } = this.shown;
    if (topology !== this.cloth_.topology) {
      if (topology === null) this.framed_ = false;
      this.cloth_.setTopology(topology);
    }
    this.newFrame_ = positions !== null;
    this.invalidate();
  }

  /** Puts the newest positions into the picture; whether there were any. */
  private catchUp(): boolean {
    const { positions } = this.shown;
    if (!this.newFrame_ || !positions) return false;
    this.newFrame_ = false;
    this.caughtUp_ = true;
    this.cloth_.setPositions(positions);
    return true;
  }

  private invalidate(): void {
    this.stale_ = true;
    this.canvas_.setAttribute('aria-busy', 'true');
    if (this.request_ !== 0) return;
    this.asked_ = performance.now();
    this.request_ = requestAnimationFrame((now) => this.tick(now));
  }

  private tick(now: number): void {
    this.request_ = 0;
    this.advanceTurn(now);
    this.catchUp();
    const fresh = this.caughtUp_;
    this.caughtUp_ = false;
    if (fresh && !this.framed_) {
      this.framed_ = true;
      this.applyPose(this.pose());
    }
    this.controls_.update();
    if (!this.stale_) return this.restSoon();
    this.stale_ = false;
    this.studio_.face(this.camera_.position, this.controls_.target);
    this.draw(now);
    if (fresh && !this.start_) this.drawn_();
    if (this.turn_) this.invalidate();
  }

  /** While things move on a slow machine the picture is coarser; when they rest it is drawn once more, sharp. */
  private draw(now: number): void {
    const spent = now - this.lastDraw_;
    this.lastDraw_ = now;
    const onGoing = this.asked_ - (now - spent) < kPauseMs;
    if (onGoing) this.pace_ += 0.2 * (Math.min(spent, kLongestMs) - this.pace_);
    if (this.pace_ > kSlowMs && onGoing) this.sharpness_ = Math.max(kCoarsest, this.sharpness_ * 0.8);
    else if (this.pace_ < kFastMs) this.sharpness_ = Math.min(1, this.sharpness_ * 1.05);
    this.render(finestRatio() * this.sharpness_);
    this.restSoon();
  }

  private restSoon(): void {
    clearTimeout(this.rest_);
    // Between the pictures of a slow machine there is no rest.
    this.rest_ = setTimeout(() => this.rest(), Math.max(kRestMs, 2 * this.pace_));
  }

  /** Nothing has changed for a while: the canvas says so, to whoever wants to look at what stands still. */
  private rest(): void {
    if (this.request_ !== 0) return; // the tick that is to come asks again
    if (this.slow_ || this.sharpness_ < 1) this.render(this.slow_ ? 1.5 * finestRatio() : finestRatio());
    this.canvas_.setAttribute('aria-busy', 'false');
  }

  private render(ratio: number): void {
    // Threads cost a slow machine a quarter of its frames: they are drawn when it rests.
    this.cloth_.setFine(!this.slow_ || ratio > finestRatio());
    if (this.renderer_.getPixelRatio() !== ratio) this.renderer_.setPixelRatio(ratio);
    this.renderer_.render(this.scene_, this.camera_);
  }

  private advanceTurn(now: number): void {
    if (!this.turn_) return;
    const { from, to, start } = this.turn_;
    const t = Math.min(1, Math.max(0, (now - start) / kTurnMs));
    this.applyPose(blend(from, to, eased(t)));
    if (t >= 1) this.turn_ = null;
  }

  /** What a view shows: the cloth, with the body's width around the start so that nothing jumps; else the body. */
  private pose(): Pose {
    const positions = this.cloth_.positions;
    const cloth = positions ? boundsOf(positions) : null;
    const body = this.bodyBounds_;
    // Before the drape all of both is shown: the pieces stand around the body.
    if (this.start_) return poseFor(this.view_, union(cloth, body) ?? kBodyOnly, kFov, this.camera_.aspect);
    const bounds = cloth ?? body ?? kBodyOnly;
    const tall = body && cloth && cloth.high[1] - cloth.low[1] > 0.6 * (body.high[1] - body.low[1]);
    return poseFor(this.view_, tall ? union(bounds, body)! : bounds, kFov, this.camera_.aspect);
  }

  private currentPose(): Pose {
    return { eye: this.camera_.position.toArray(), target: this.controls_.target.toArray() };
  }

  private applyPose({ eye, target }: Pose): void {
    this.camera_.position.set(...eye);
    this.controls_.target.set(...target);
    this.controls_.update();
    this.invalidate();
  }

  private resize(): void {
    const box = this.canvas_.parentElement ?? this.canvas_;
    const width = Math.max(1, box.clientWidth);
    const height = Math.max(1, box.clientHeight);
    this.renderer_.setSize(width, height, false);
    this.marks_.resize(width, height);
    this.camera_.aspect = width / height;
    this.camera_.updateProjectionMatrix();
    this.invalidate();
  }
}

/** Linear light to display as the stills do it (server/render/shaders.cpp): colours stay what they are, with a soft shoulder. */
function developAsStills(): void {
  ShaderChunk.tonemapping_pars_fragment = ShaderChunk.tonemapping_pars_fragment.replace(
    'vec3 CustomToneMapping( vec3 color ) { return color; }',
    `vec3 CustomToneMapping( vec3 color ) {
      vec3 light = toneMappingExposure * color;
      return min(light, 0.7) + 0.3 * (1.0 - exp(-max(light - 0.7, 0.0) / 0.3));
    }`,
  );
}

/** Pixels of the picture to one of the page, at most. */
const finestRatio = (): number => Math.min(window.devicePixelRatio, 2);

/** Whether WebGL is more than a stand-in drawn by the processor. */
function hasGraphicsCard(): boolean {
  const probe = document.createElement('canvas').getContext('webgl2', { failIfMajorPerformanceCaveat: true });
  probe?.getExtension('WEBGL_lose_context')?.loseContext();
  return probe !== null;
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
