// What a hand does in the 3D view besides turning it: a press, a drag and a click go to the tools that are held.

import type { Aim, SceneDrag, SceneTool, SceneTouch } from '../tools/SceneTool';
import type { Hand } from '../tools/PatternTool';

/** A press that moves less than this, in pixels, is a click. */
const kClickPx = 4;

/** Looks at what lies under the pointer. */
export interface Ray extends SceneTouch {
  through(event: PointerEvent): SceneTouch;
}

/** A press that a tool took. */
interface Hold {
  tool: SceneTool;
  drag: SceneDrag;
  begun: boolean;
  /** What letting go would do; null: nothing yet. */
  aim: Aim | null;
}

export class SceneHands {
  private tools_: readonly SceneTool[] = [];
  private press_: [number, number] | null = null;
  private hold_: Hold | null = null;

  /** Listens to the canvas before the camera's own listeners do; `changed` asks for another picture. */
  constructor(
    private readonly canvas_: HTMLCanvasElement,
    private readonly ray_: Ray,
    /** Of the camera: off while something is dragged. */
    private readonly controls_: { enabled: boolean },
    private readonly hand_: Hand,
    private readonly changed_: () => void,
  ) {
    this.listen();
  }

  /** Those that are held, the first to be asked first. */
  setTools(tools: readonly SceneTool[]): void {
    this.tools_ = tools;
    if (this.hold_ && !tools.includes(this.hold_.tool)) this.letGo();
    if (!this.hold_) this.canvas_.style.cursor = this.restingCursor();
  }

  private restingCursor(): string {
    return this.tools_.find((tool) => tool.cursor !== undefined)?.cursor ?? '';
  }

  private listen(): void {
    // Before the camera's own listeners, which something that is dragged keeps from turning.
    this.canvas_.addEventListener('pointerdown', (event) => this.down(event), { capture: true });
    this.canvas_.addEventListener('pointermove', (event) => this.move(event));
    this.canvas_.addEventListener('pointerup', (event) => this.up(event));
    this.canvas_.addEventListener('pointercancel', () => this.letGo());
    this.canvas_.addEventListener('pointerleave', () => this.hover(null));
  }

  /** Whether the pointer is about where it came down. */
  private isStill(event: PointerEvent): boolean {
    if (!this.press_) return false;
    return Math.hypot(event.clientX - this.press_[0], event.clientY - this.press_[1]) < kClickPx;
  }

  private down(event: PointerEvent): void {
    this.press_ = [event.clientX, event.clientY];
    if (event.button !== 0) return;
    const touch = this.ray_.through(event);
    for (const tool of this.tools_) {
      const drag = tool.press?.(this.hand_, touch);
      if (drag) return this.take(tool, drag, event);
    }
  }

  private take(tool: SceneTool, drag: SceneDrag, event: PointerEvent): void {
    this.hold_ = { tool, drag, begun: false, aim: null };
    this.controls_.enabled = false;
    this.canvas_.setPointerCapture(event.pointerId);
    if (drag.cursor !== undefined) this.canvas_.style.cursor = drag.cursor;
  }

  private move(event: PointerEvent): void {
    if (this.hold_ && !this.isStill(event)) this.pull(this.hold_, event);
    if (event.buttons === 0 && event.pointerType === 'mouse') this.hover(event);
  }

  private pull(hold: Hold, event: PointerEvent): void {
    const touch = this.ray_.through(event);
    if (!hold.begun) hold.drag.begin?.(touch);
    hold.begun = true;
    const aim = hold.drag.to(touch);
    if (!aim) return;
    hold.aim = aim;
    if (aim.cursor !== undefined) this.canvas_.style.cursor = aim.cursor;
    this.changed_();
  }

  private up(event: PointerEvent): void {
    const isClick = this.isStill(event);
    const hold = this.hold_;
    this.press_ = null;
    this.letGo();
    if (hold && !isClick) hold.aim?.drop();
    else if (isClick && event.button === 0 && hold?.drag.clicks !== false) this.click(event);
  }

  private click(event: PointerEvent): void {
    const touch = this.ray_.through(event);
    this.tools_.some((tool) => tool.click?.(this.hand_, touch));
  }

  /** Null: the pointer has left. */
  private hover(event: PointerEvent | null): void {
    const touch = event && this.ray_.through(event);
    for (const tool of this.tools_) tool.hover?.(this.hand_, touch);
  }

  private letGo(): void {
    const hold = this.hold_;
    if (!hold) return;
    this.hold_ = null;
    this.controls_.enabled = true;
    this.canvas_.style.cursor = this.restingCursor();
    hold.drag.end?.(this.ray_);
    this.changed_();
  }
}
