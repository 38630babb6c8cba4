// A section through body and cloth.

import { grammar } from '../grammar';

const { counted } = grammar('en');

export const section = {
  title: 'Section and ease',
  key: 'Section through body and cloth (C)',
  open: 'Show',
  close: 'Close',
  height: 'Height',
  aboveFloor: (length: string) => `${length} above the floor`,
  noClothThere: 'There is no cloth at this height.',
  front: 'Front',
  drawing: (height: string) => `Outlines of body and cloth ${height} above the floor, seen from above`,
  parts: {
    around: 'Around',
    trunk: 'Trunk',
    trunk_and_arm: 'Trunk with arms',
    both_legs: 'Both legs',
    left_arm: 'Left arm',
    right_arm: 'Right arm',
    left_leg: 'Left leg',
    right_leg: 'Right leg',
  },
  room: (least: string, median: string) => `Room from ${least}, half of it under ${median}.`,
  layers: (n: number) => `The tightest of ${counted(n, 'layer', 'layers')}.`,
  hangs: (length: string) => `Hangs at ${length}.`,
  open_: (n: number, length: string) => `${counted(n, 'outline', 'outlines')} of cloth not closed, together ${length}.`,
};
