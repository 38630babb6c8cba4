// How sharp the next picture is to be: while things move on a slow machine it is coarser. Pure but for its own figures.

/** Slower than this, the picture gets coarser; faster, finer again. */
const kSlowMs = 50;
const kFastMs = 24;
const kCoarsest = 0.6;
/** What is asked for later than this after a picture was not waited for: nothing had changed. */
const kPauseMs = 120;
/** One picture tells no more than this of the pace. */
const kLongestMs = 600;
const kRestMs = 250;

/** Times are ms of one clock. */
export class DrawPace {
  private lastDraw_ = 0;
  private asked_ = 0;
  /** ms from picture to picture, a running mean. */
  private pace_ = 16;
  private sharpness_ = 1;

  /** Share of the screen's own resolution. */
  get sharpness(): number {
    return this.sharpness_;
  }

  /** ms after a picture: if none follows, things rest. Between the pictures of a slow machine there is no rest. */
  get restsAfter(): number {
    return Math.max(kRestMs, 2 * this.pace_);
  }

  /** The next picture is asked for. */
  ask(now: number): void {
    this.asked_ = now;
  }

  /** It is drawn. */
  draw(now: number): void {
    const before = this.lastDraw_;
    this.lastDraw_ = now;
    const onGoing = this.asked_ - before < kPauseMs;
    if (onGoing) this.pace_ += 0.2 * (Math.min(now - before, kLongestMs) - this.pace_);
    if (this.pace_ > kSlowMs && onGoing) this.sharpness_ = Math.max(kCoarsest, this.sharpness_ * 0.8);
    else if (this.pace_ < kFastMs) this.sharpness_ = Math.min(1, this.sharpness_ * 1.05);
  }
}
