// Which section is shown, and what was found there.

import { signal, type Signal } from '@preact/signals';
import { PerProject } from './PerProject';
import type { Level, Section } from './section';

export class SectionState extends PerProject {
  readonly shown: Signal<boolean> = signal(false);
  /** Of the plane above the floor, m; null: nobody has moved it yet. */
  readonly height: Signal<number | null> = this.perProject(null);
  /** Named heights of the body that the drape hangs on; none where nobody stands there, or somebody else by now. */
  readonly levels: Signal<readonly Level[]> = this.perProject([]);
  /** Of the newest moment that was cut. */
  readonly cut: Signal<Section | null> = signal(null);
}
