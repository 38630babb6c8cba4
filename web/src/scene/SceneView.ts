// The 3D view: what stands in it, and when to draw. It draws only when something has changed: a frame, the camera, the
// selection, the size. Loaded by itself, because three.js comes with it.

import { Color, Scene, type WebGLRenderer } from 'three';
import type { BodyMesh } from '../api/body';
import type { View, Viewpoint } from '../state/AppState';
import type { LiveCloth } from '../state/LiveCloth';
import type { Finding, ProjectBody, Start } from '../api/dressing';
import type { Progress } from '../api/types';
import type { Marks } from '../state/dressing';
import type { ClothMap } from '../state/clothMaps';
import type { Finish } from '../state/fabrics';
import type { Section } from '../state/section';
import type { Held } from '../state/hands';
import type { SeamPart } from '../state/seamView';
import type { Look } from '../state/texture';
import type { Hand } from '../tools/PatternTool';
import type { SceneTool } from '../tools/SceneTool';
import { BodyMarks } from './BodyMarks';
import { BodyObject } from './BodyObject';
import { ClothObject } from './ClothObject';
import { DrawPace } from './DrawPace';
import { HandMarks } from './HandMarks';
import { boundsOf, closeUp, footprints, kBodyOnly, kFov, poseFor, poseOf, type Bounds, type Pose } from './framing';
import { PointerRay } from './PointerRay';
import { finestRatio, hasGraphicsCard, makeRenderer } from './renderer';
import { SceneCamera } from './SceneCamera';
import { SceneHands } from './SceneHands';
import { SectionMarks } from './SectionMarks';
import { Studio, type StudioColours } from './Studio';

export class SceneView {
  private readonly renderer_: WebGLRenderer;
  /** Drawn by the processor: coarser while it moves, and smoothed by more pixels instead of samples when it rests. */
  private readonly slow_: boolean;
  private readonly scene_ = new Scene();
  private readonly camera_: SceneCamera;
  private readonly hands_: SceneHands;
  private readonly studio_: Studio;
  private readonly cloth_: ClothObject;
  private readonly body_: BodyObject;
  private readonly marks_ = new BodyMarks();
  private readonly handMarks_ = new HandMarks();
  private readonly sectionMarks_ = new SectionMarks();
  /** Shown in place of the drape's cloth. */
  private start_: Start | null = null;
  private readonly resizer_: ResizeObserver;
  private readonly stopListening_: () => void;
  private bodyBounds_: Bounds | null = null;
  private view_: View = 'three-quarter';
  private framed_ = false;
  private stale_ = true;
  private newFrame_ = false;
  /** Positions have come into the scene since the last picture. */
  private caughtUp_ = false;
  private request_ = 0;
  private readonly pace_ = new DrawPace();
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
    this.renderer_ = makeRenderer(canvas_, this.slow_);
    this.cloth_ = new ClothObject({
      thread: new Color(accent),
      selected: new Color(accent),
      hovered: new Color('#ffffff'),
    });
    this.body_ = new BodyObject(0xcfc8bf);
    this.scene_.add(this.studio_.group, this.body_.mesh, this.cloth_.group, this.marks_.group, this.handMarks_.group, this.sectionMarks_.group);
    this.camera_ = new SceneCamera(canvas_, () => this.invalidate());
    this.camera_.apply(poseFor('three-quarter', kBodyOnly, kFov, 1));
    this.renderer_.compile(this.scene_, this.camera_.camera);
    this.resizer_ = new ResizeObserver(() => this.resize());
    this.resizer_.observe(canvas_.parentElement ?? canvas_);
    this.stopListening_ = live_.listen((event) => this.take(event));
    this.takeAll();
    const touchable = {
      camera: this.camera_.camera,
      controls: this.camera_.controls,
      cloth: this.cloth_,
      body: this.body_,
      marks: this.marks_,
    };
    const ray = new PointerRay(canvas_, touchable);
    this.hands_ = new SceneHands(canvas_, ray, this.camera_.controls, hand, () => this.invalidate());
    this.resize();
  }

  setBody(body: BodyMesh | null): void {
    this.body_.set(body);
    this.bodyBounds_ = body ? boundsOf(body.positions) : null;
    this.studio_.standOn(body ? footprints(body.positions) : []);
    if (body && !this.framed_ && !this.cloth_.positions) this.camera_.apply(this.pose());
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

  setPins(pins: Progress['pins'], lit: number | null): void {
    this.handMarks_.setPins(pins, lit);
    this.invalidate();
  }

  setHeld(held: Held | null): void {
    this.handMarks_.setHeld(held);
    this.handMarks_.follow(this.cloth_.topology, this.cloth_.positions);
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
    this.camera_.turnTo(closeUp(finding.place, middle, this.camera_.pose), still);
  }

  setLooks(looks: ReadonlyMap<string, Look>): void {
    this.cloth_.setLooks(looks);
    this.invalidate();
  }

  setFinishes(finishes: ReadonlyMap<string, Finish>): void {
    this.cloth_.setFinishes(finishes);
    this.invalidate();
  }

  setSection(section: Section | null): void {
    this.sectionMarks_.show(section);
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
    this.camera_.turnTo(this.pose(), still);
  }

  /** Tells of every pose that the camera takes but those it follows: so two views share one. */
  listenToTurns(turned: (pose: Pose) => void): void {
    this.camera_.listenToTurns(turned);
  }

  /** Takes another view's pose. */
  follow(pose: Pose): void {
    this.framed_ = true;
    this.camera_.follow(pose);
  }

  /** Keyboard's way round: turns by degrees about the upright and the level axis, and steps nearer or away. */
  nudge(heading: number, height: number, zoom: number): void {
    this.camera_.nudge(heading, height, zoom);
  }

  dispose(): void {
    cancelAnimationFrame(this.request_);
    clearTimeout(this.rest_);
    this.resizer_.disconnect();
    this.stopListening_();
    this.camera_.dispose();
    this.cloth_.dispose();
    this.marks_.dispose();
    this.handMarks_.dispose();
    this.sectionMarks_.dispose();
    this.body_.dispose();
    this.studio_.dispose();
    this.renderer_.dispose();
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
    this.handMarks_.follow(this.cloth_.topology, this.cloth_.positions);
    return true;
  }

  private invalidate(): void {
    this.stale_ = true;
    this.canvas_.setAttribute('aria-busy', 'true');
    if (this.request_ !== 0) return;
    this.pace_.ask(performance.now());
    this.request_ = requestAnimationFrame((now) => this.tick(now));
  }

  private tick(now: number): void {
    this.request_ = 0;
    this.camera_.advance(now);
    this.catchUp();
    const fresh = this.caughtUp_;
    this.caughtUp_ = false;
    if (fresh && !this.framed_) {
      this.framed_ = true;
      this.camera_.apply(this.pose());
    }
    this.camera_.controls.update();
    if (!this.stale_) return this.restSoon();
    this.stale_ = false;
    this.studio_.face(this.camera_.camera.position, this.camera_.controls.target);
    this.draw(now);
    if (fresh && !this.start_) this.drawn_();
    if (this.camera_.turning) this.invalidate();
  }

  /** While things move on a slow machine the picture is coarser; when they rest it is drawn once more, sharp. */
  private draw(now: number): void {
    this.pace_.draw(now);
    this.render(finestRatio() * this.pace_.sharpness);
    this.restSoon();
  }

  private restSoon(): void {
    clearTimeout(this.rest_);
    this.rest_ = setTimeout(() => this.rest(), this.pace_.restsAfter);
  }

  /** Nothing has changed for a while: the canvas says so, to whoever wants to look at what stands still. */
  private rest(): void {
    if (this.request_ !== 0) return; // the tick that is to come asks again
    if (this.slow_ || this.pace_.sharpness < 1) this.render(this.slow_ ? 1.5 * finestRatio() : finestRatio());
    this.canvas_.setAttribute('aria-busy', 'false');
  }

  private render(ratio: number): void {
    // Threads cost a slow machine a quarter of its frames: they are drawn when it rests.
    this.cloth_.setFine(!this.slow_ || ratio > finestRatio());
    if (this.renderer_.getPixelRatio() !== ratio) this.renderer_.setPixelRatio(ratio);
    this.renderer_.render(this.scene_, this.camera_.camera);
  }

  private pose(): Pose {
    const positions = this.cloth_.positions;
    const cloth = positions ? boundsOf(positions) : null;
    return poseOf(this.view_, cloth, this.bodyBounds_, this.start_ !== null, this.camera_.camera.aspect);
  }

  /** From where it is seen now. */
  get viewpoint(): Viewpoint {
    const { eye, target } = this.camera_.pose;
    return { eye, target, angle: kFov, aspect: this.camera_.camera.aspect };
  }

  private resize(): void {
    const box = this.canvas_.parentElement ?? this.canvas_;
    const width = Math.max(1, box.clientWidth);
    const height = Math.max(1, box.clientHeight);
    this.renderer_.setSize(width, height, false);
    this.marks_.resize(width, height);
    this.sectionMarks_.resize(width, height);
    this.camera_.setAspect(width / height);
    this.invalidate();
  }
}
