// What a person's hand does to the cloth of the drape that is shown, over its stream.

import { effect } from '@preact/signals';
import type { Place } from '../api/dressing';
import type { StreamWord } from '../api/types';
import type { AppState } from '../state/AppState';
import type { ClothPoint, HandTool } from '../state/hands';

/** ms between two places that are told: the service takes 60 a second. */
const kPause = 33;

export class LiveCommands {
  private timer_: ReturnType<typeof setTimeout> | undefined;
  private told_: Place | null = null;

  constructor(
    private readonly state_: AppState,
    private readonly say_: (word: StreamWord) => void,
  ) {
    // What cannot be touched any more is held by nobody.
    effect(() => {
      if (!state_.touchable.value) this.letGo();
    });
  }

  /** Takes a tool, or puts it away. */
  take(tool: HandTool): void {
    const { hands } = this.state_;
    this.letGo();
    hands.tool.value = hands.tool.value === tool ? 'look' : tool;
  }

  /** Whether a tool was put away. */
  putAway(): boolean {
    const { tool } = this.state_.hands;
    if (tool.value === 'look') return false;
    this.letGo();
    tool.value = 'look';
    return true;
  }

  hold(point: ClothPoint): void {
    this.letGo();
    this.state_.hands.held.value = { point, to: point.at };
    this.tell();
  }

  /** Draws what is held; the newest place is told, some thirty times a second. */
  draw(to: Place): void {
    const { held } = this.state_.hands;
    if (!held.value) return;
    held.value = { ...held.value, to };
    this.timer_ ??= setTimeout(() => this.tell(), kPause);
  }

  letGo(): void {
    const { held } = this.state_.hands;
    clearTimeout(this.timer_);
    this.timer_ = undefined;
    if (!held.peek()) return;
    held.value = null;
    this.told_ = null;
    this.say_({ type: 'let_go' });
  }

  pin({ triangle, shares }: ClothPoint): void {
    const epoch = this.state_.cloth.topology?.epoch;
    if (epoch !== undefined) this.say_({ type: 'pin', epoch, triangle, shares });
  }

  /** What the hand holds stays where it is, and the hand is free. */
  pinHeld(): void {
    const held = this.state_.hands.held.value;
    if (!held) return;
    this.pin(held.point);
    this.letGo();
  }

  unpin(pin: number): void {
    this.state_.hands.litPin.value = null;
    this.say_({ type: 'unpin', pin });
  }

  private tell(): void {
    const held = this.state_.hands.held.value;
    const epoch = this.state_.cloth.topology?.epoch;
    this.timer_ = undefined;
    if (!held || epoch === undefined || held.to === this.told_) return;
    this.told_ = held.to;
    const { triangle, shares } = held.point;
    this.say_({ type: 'pull', epoch, triangle, shares, to: held.to });
    this.timer_ = setTimeout(() => this.tell(), kPause);
  }
}
