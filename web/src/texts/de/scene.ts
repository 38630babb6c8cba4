// The 3D view, maps, and two drapes beside each other.

import type { Texts } from '../en';
import { grammar } from '../grammar';

const { counted } = grammar('de');

export const scene: Texts['scene'] = {
  twoDrapes: 'Zwei Drapierungen',
  views: 'Ansichten',
  halfHint: (name) => `${name} Drapierung; Pfeiltasten drehen beide, Plus und Minus zoomen`,
  open: 'Öffnen',
  fetching: 'Die Drapierung wird geholt …',
  cannotShow: 'Diese Drapierung kann nicht gezeigt werden',
  noWebgl: 'Dieser Browser konnte WebGL 2 nicht öffnen:',
  left: 'Linke',
  right: 'Rechte',
  colourBy: 'Stoff einfärben nach',
  colourByKey: 'Stoff einfärben nach (X)',
  cloth: 'Stoff',
  maps: {
    warp: {
      title: 'Dehnung längs der Kette',
      words: 'Rot ist gedehnt, Blau gestaucht.',
    },
    weft: {
      title: 'Dehnung längs des Schusses',
      words: 'Rot ist gedehnt, Blau gestaucht.',
    },
    shear: {
      title: 'Scherung',
      words: 'Wie weit Kette und Schuss vom rechten Winkel abweichen.',
    },
    room: {
      title: 'Abstand zum Körper',
      words: 'Rot liegt am Körper an, Blau hängt frei.',
    },
    curvature: {
      title: 'Wölbung',
      words: 'Rot wölbt sich nach außen, Blau ist hohl.',
    },
    pressure: {
      title: 'Druck auf die Haut',
      words: 'Wie fest der Stoff drückt; 0, wo er absteht.',
    },
  },
  missing: {
    live: (map) => `${map}, sobald es hängt`,
    none: (map) => `${map}, nicht aufgehoben`,
    bodyless: (map) => `${map}, ohne Körper`,
  },
  title: '3D-Ansicht',
  canvas: 'Körper und Stoff; Pfeiltasten drehen, Plus und Minus zoomen',
  no3d: 'Hier geht kein 3D',
  noWebglBecause: (why) => `Dieser Browser konnte WebGL 2 nicht öffnen: ${why}`,
  bodyKey: 'Körper (B)',
  body: 'Körper',
  meshKey: 'Netz (W)',
  mesh: 'Netz',
  failed: 'Diese Drapierung ist fehlgeschlagen',
  whereBegan: 'Die Teile stehen, wo sie begann.',
  cancelled: 'Abgebrochen',
  changed: 'Das Projekt wurde seit dieser Drapierung geändert.',
  hands: {
    pull: { name: 'Ziehen', tip: 'Am Stoff ziehen', hint: 'Ziehen Sie am Stoff. I steckt fest, was Sie halten, Esc beendet.' },
    pin: {
      name: 'Stecken',
      tip: 'Den Stoff feststecken, wo er ist',
      hint: 'Klicken Sie auf den Stoff, wo er bleiben soll. Die Nadeln stehen unter Verlauf.',
    },
  },
  takesOver: 'Die Änderung wird übernommen, während drapiert wird…',
  takeOver: 'Mit der Änderung weiter',
  why: 'Warum',
  next: 'Sie ist die nächste; sobald ein Rechenplatz frei ist, beginnt sie.',
  inQueue: 'In der Warteschlange',
  readyToDrape: 'Die Schnittteile sind gelesen und bereit. Beim Drapieren werden sie um den Körper zusammengenäht.',
  before: (n) => `${counted(n, 'Drapierung', 'Drapierungen')} davor.`,
  views_: {
    front: 'Vorn',
    back: 'Hinten',
    side: 'Seite',
    'three-quarter': '¾',
  },
  viewNames: {
    front: 'Ansicht von vorn',
    back: 'Ansicht von hinten',
    side: 'Ansicht von der Seite',
    'three-quarter': 'Dreiviertelansicht',
  },
};
