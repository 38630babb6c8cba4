// State of one project: a signal says where it is declared that it begins anew with the next.

import { signal, type Signal } from '@preact/signals';

export class PerProject {
  private readonly restarts_: (() => void)[] = [];

  /** Another project is shown. */
  clear(): void {
    for (const restart of this.restarts_) restart();
  }

  /** A signal that has its first value again whenever another project is shown. */
  protected perProject<T>(first: T): Signal<T> {
    const made = signal(first);
    this.restarts_.push(() => {
      made.value = first;
    });
    return made;
  }
}
