// Names of measures, places, parts and sizes.

import type { Texts } from '../en';

export const names: Texts['names'] = {
  sexes: {
    female: 'Damen',
    male: 'Herren',
    child: 'Kinder',
  },
  childSize: (n) => `Kinder ${n}`,
  menSize: (n) => `Herren ${n}`,
  things: {
    seam: 'Naht',
    piece: 'Schnittteil',
    body: 'Körper',
    edge: 'Kante',
  },
  measures: {
    height: 'Körperhöhe',
    bust: 'Oberweite',
    underbust: 'Unterbrust',
    waist: 'Taille',
    hip: 'Hüfte',
    neck: 'Hals',
    shoulder_width: 'Schulterbreite',
    upper_arm: 'Oberarm',
    wrist: 'Handgelenk',
    arm_length: 'Armlänge',
    thigh: 'Oberschenkel',
    calf: 'Wade',
    inseam: 'Schrittlänge',
    back_length: 'Rückenlänge',
    neckline: 'Halsansatz',
    high_hip: 'Hohe Hüfte',
    tape: 'Maßband',
    landmarks: 'Körperpunkte',
    boxes: 'Boxen',
  },
  parts: {
    torso: 'Rumpf',
    hips: 'Hüften',
    left_arm: 'linker Arm',
    right_arm: 'rechter Arm',
    left_leg: 'linkes Bein',
    right_leg: 'rechtes Bein',
    neck: 'Hals',
    head: 'Kopf',
  },
  sides: {
    front: 'vorn',
    back: 'hinten',
    left: 'links',
    right: 'rechts',
  },
};
