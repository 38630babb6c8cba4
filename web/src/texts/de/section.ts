import { grammar } from '../grammar';
import type { Texts } from '../en';

const { counted } = grammar('de');

export const section: Texts['section'] = {
  title: 'Querschnitt und Zugabe',
  key: 'Querschnitt durch Körper und Stoff (C)',
  open: 'Zeigen',
  close: 'Schließen',
  height: 'Höhe',
  aboveFloor: (length) => `${length} über dem Boden`,
  noClothThere: 'In dieser Höhe ist kein Stoff.',
  front: 'Vorn',
  drawing: (height) => `Umrisse von Körper und Stoff ${height} über dem Boden, von oben gesehen`,
  parts: {
    around: 'Rundherum',
    trunk: 'Rumpf',
    trunk_and_arm: 'Rumpf mit Armen',
    both_legs: 'Beide Beine',
    left_arm: 'Linker Arm',
    right_arm: 'Rechter Arm',
    left_leg: 'Linkes Bein',
    right_leg: 'Rechtes Bein',
  },
  room: (least, median) => `Luft ab ${least}, zur Hälfte unter ${median}.`,
  layers: (n) => `Die engste von ${counted(n, 'Lage', 'Lagen')}.`,
  hangs: (length) => `Hängt auf ${length}.`,
  open_: (n, length) => `${counted(n, 'Umriss', 'Umrisse')} des Stoffs nicht geschlossen, zusammen ${length}.`,
};
