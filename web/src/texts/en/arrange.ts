// Where the pieces stand before a drape, and what the look at them finds.

import { grammar } from '../grammar';

const { counted } = grammar('en');

export const arrange = {
  openProject: 'Open a project to arrange its pieces.',
  arrange: 'Arrange the pieces',
  boxes: 'Boxes',
  places: 'Places of the pieces',
  dragPiece: 'Drag a piece onto a side of a box in 3D, or choose its place here.',
  partner: 'The mirror image goes along on the other side',
  byHand: (place: string) => `by hand: ${place}`,
  part: 'Part',
  side: 'Side',
  across: 'Across',
  up: 'Up',
  away: 'Away',
  turn: 'Turn',
  rolled: 'Rolled around the part',
  overTip: 'The other side of the cloth to the body',
  turnOver: 'Turn the piece over',
  severities: {
    error: 'Error',
    warning: 'Warning',
    note: 'Note',
    repaired: 'Repaired',
  },
  looking: 'Looking at the start',
  problems: 'Problems',
  repaired: (n: number) => `${n} repaired`,
  ready: 'Ready to drape',
  notReady: 'Not ready to drape',
  noFault: 'nothing to find fault with',
  goodToKnow: (n: number) => `${counted(n, 'thing', 'things')} good to know`,
  errors: (n: number) => counted(n, 'error', 'errors'),
  warnings: (n: number) => counted(n, 'warning', 'warnings'),
  notes: (n: number) => counted(n, 'note', 'notes'),
};
