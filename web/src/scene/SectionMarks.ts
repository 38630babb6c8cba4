// The section that is shown, on body and cloth: seen through both, since it runs around them.

import { Group } from 'three';
import type { Outline } from '../state/planeCut';
import type { Section } from '../state/section';
import { disposeLines, fatLines, fitLines, setSegments } from './fatLines';

const kBody = '#5b5b66';
const kCloth = '#d4146a';
const kBodyPx = 1.6;
const kClothPx = 2.4;

export class SectionMarks {
  readonly group = new Group();
  private readonly body_ = fatLines(kBody, kBodyPx);
  private readonly cloth_ = fatLines(kCloth, kClothPx);

  constructor() {
    for (const lines of [this.body_, this.cloth_]) {
      lines.material.depthTest = false;
      lines.renderOrder = 7;
      this.group.add(lines);
    }
  }

  show(section: Section | null): void {
    setSegments(this.body_, (section?.body ?? []).flatMap((one) => segments(one, section!.height)));
    setSegments(this.cloth_, (section?.cloth ?? []).flatMap((one) => segments(one, section!.height)));
  }

  resize(width: number, height: number): void {
    for (const lines of [this.body_, this.cloth_]) fitLines(lines, width, height);
  }

  dispose(): void {
    for (const lines of [this.body_, this.cloth_]) disposeLines(lines);
  }
}

function segments({ places, closed }: Outline, height: number): number[] {
  return places.flatMap(([x, z], i) => {
    const [fromX, fromZ] = places.at(i - 1)!;
    return i === 0 && !closed ? [] : [fromX, height, fromZ, x, height, z];
  });
}
