// Takes over what is edited while a drape is under way, once no more of it comes, where cloth may go on hanging after it.

import { effect } from '@preact/signals';
import type { AppState } from '../state/AppState';
import { isActive } from '../state/jobs';

/** Without another edit, ms. */
const kQuiet = 500;

export class WarmEdits {
  private wait_: ReturnType<typeof setTimeout> | undefined;
  /** The drape that an edit waits for. */
  private job_: string | null = null;

  constructor(
    private readonly state_: AppState,
    private readonly goOn_: () => Promise<void>,
  ) {}

  /** Until the function that it gives is called. */
  start(): () => void {
    const { goesOnWarm, job, project } = this.state_;
    const stop = effect(() => {
      const shown = job.value;
      void project.value?.revision;
      if (goesOnWarm.value && shown) return this.await(shown.id);
      // What was edited before the drape came to its end is not left lying because that came within the wait.
      const ended = shown !== null && shown.id === this.job_ && !isActive(shown.state);
      if (!ended) this.forget();
    });
    return () => {
      stop();
      this.forget();
    };
  }

  private await(job: string): void {
    this.forget();
    this.job_ = job;
    this.wait_ = setTimeout(() => {
      this.forget();
      void this.goOn_();
    }, kQuiet);
  }

  private forget(): void {
    clearTimeout(this.wait_);
    this.job_ = null;
  }
}
