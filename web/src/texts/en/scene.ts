// The 3D view, maps, and two drapes beside each other.

import { grammar } from '../grammar';

const { counted } = grammar('en');

export const scene = {
  twoDrapes: 'Two drapes',
  views: 'Views',
  halfHint: (name: string) => `${name} drape; arrow keys turn both, plus and minus zoom`,
  open: 'Open',
  fetching: 'Fetching the drape…',
  cannotShow: 'This drape cannot be shown',
  noWebgl: 'This browser could not open WebGL 2:',
  left: 'Left',
  right: 'Right',
  colourBy: 'Colour the cloth by',
  colourByKey: 'Colour the cloth by (X)',
  cloth: 'Cloth',
  maps: {
    warp: {
      title: 'Stretch along the warp',
      words: 'Red is stretched, blue is pushed together.',
    },
    weft: {
      title: 'Stretch along the weft',
      words: 'Red is stretched, blue is pushed together.',
    },
    shear: {
      title: 'Shear',
      words: 'How far warp and weft are from a right angle.',
    },
    room: {
      title: 'Room to the body',
      words: 'Red lies on the body, blue hangs free.',
    },
    curvature: {
      title: 'Curvature',
      words: 'Red bulges outwards, blue is hollow.',
    },
    pressure: {
      title: 'Pressure on the skin',
      words: 'How firmly it presses; 0 where it stands off.',
    },
  },
  /** A map that cannot be shown now. */
  missing: {
    live: (map: string) => `${map}, once it hangs`,
    none: (map: string) => `${map}, not kept`,
    bodyless: (map: string) => `${map}, without a body`,
  },
  title: '3D view',
  canvas: 'Body and cloth; arrow keys turn, plus and minus zoom',
  no3d: 'No 3D here',
  noWebglBecause: (why: string) => `This browser could not open WebGL 2: ${why}`,
  bodyKey: 'Body (B)',
  body: 'Body',
  meshKey: 'Mesh (W)',
  mesh: 'Mesh',
  failed: 'This drape failed',
  whereBegan: 'Its pieces stand where it began.',
  cancelled: 'Cancelled',
  changed: 'The project has changed since this drape.',
  hands: {
    pull: { name: 'Pull', tip: 'Pull at the cloth', hint: 'Drag the cloth. I pins what you hold, Esc ends.' },
    pin: { name: 'Pin', tip: 'Pin the cloth where it is', hint: 'Click the cloth where it is to stay. The pins are listed under Drape.' },
  },
  takesOver: 'Your change is taken over while it drapes…',
  takeOver: 'Go on with the change',
  why: 'Why',
  next: 'It is next; a worker takes it as soon as one is free.',
  inQueue: 'In the queue',
  readyToDrape: 'The pieces are read and ready. A drape sews them around the body.',
  before: (n: number) => `${counted(n, 'drape', 'drapes')} before it.`,
  views_: {
    front: 'Front',
    back: 'Back',
    side: 'Side',
    'three-quarter': '¾',
  },
  viewNames: {
    front: 'front view',
    back: 'back view',
    side: 'side view',
    'three-quarter': 'three-quarter view',
  },
};
