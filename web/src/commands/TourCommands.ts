// Leads somebody around who has just come. It begins by itself once in a browser, and then only when it is asked for.

import type { AppState } from '../state/AppState';
import { tourStops } from '../state/tour';
import { keep, kept } from '../texts/kept';

const kName = 'tour';

export class TourCommands {
  constructor(private readonly state_: AppState) {}

  /** On the first visit of a project or a drape. */
  greet(): void {
    if (!this.state_.atWork.value || kept(kName) !== null) return;
    this.begin();
  }

  begin(): void {
    // From here on, also if the page is left in the middle.
    keep(kName, 'seen');
    this.state_.helpShown.value = false;
    this.state_.tourStop.value = 0;
  }

  /** The next stop, or one back; behind the last one it is over. */
  step(by: 1 | -1): void {
    const { tourStop } = this.state_;
    if (tourStop.value === null) return;
    const next = Math.max(0, tourStop.value + by);
    tourStop.value = next < tourStops.length ? next : null;
  }

  /** False when there was none. */
  end(): boolean {
    const { tourStop } = this.state_;
    if (tourStop.value === null || !this.state_.atWork.value) return false;
    tourStop.value = null;
    return true;
  }
}
