// Words that stand in many places.

import { grammar } from '../grammar';

const { counted, number } = grammar('en');

export const common = {
  cancel: 'Cancel',
  drapeAgain: 'Drape again',
  startDrape: 'Start drape',
  newProject: 'New project',
  notDraped: 'Not draped yet',
  close: 'Close',
  name: 'Name',
  sew: 'Sew',
  unit: 'Unit',
  size: 'Size',
  pieces: 'Pieces',
  body: 'Body',
  piece: 'Piece',
  all: 'All',
  none: 'None',
  delete: 'Delete',
  length: 'Length',
  takeOut: 'Take out',
  nothing: 'None',
  noneFound: 'None',
  ago: {
    now: 'just now',
    minutes: (n: number) => `${number(n)} min ago`,
    hours: (n: number) => `${number(n)} h ago`,
    days: (n: number) => `${counted(n, 'day', 'days')} ago`,
  },
};
