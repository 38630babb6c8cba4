// Work on the cloth that is shown: at once when somebody asks for it, then at some of the frames, so that it takes no more
// than a part of the time.

/** Between two times at least, ms; and so many times as long as one takes. */
const kPauseMs = 200;
const kShare = 4;

export class FramePace {
  /** The last time, ms. */
  private took_ = 0;
  private timer_: ReturnType<typeof setTimeout> | undefined;

  constructor(private readonly work_: () => void) {}

  now(): void {
    clearTimeout(this.timer_);
    this.timer_ = undefined;
    const begun = performance.now();
    this.work_();
    this.took_ = performance.now() - begun;
  }

  /** A frame has come. */
  soon(): void {
    this.timer_ ??= setTimeout(() => this.now(), Math.max(kPauseMs, kShare * this.took_));
  }
}
