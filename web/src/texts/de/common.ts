// Words that stand in many places.

import type { Texts } from '../en';
import { grammar } from '../grammar';

const { counted, number } = grammar('de');

export const common: Texts['common'] = {
  cancel: 'Abbrechen',
  drapeAgain: 'Neu drapieren',
  startDrape: 'Drapieren',
  newProject: 'Neues Projekt',
  notDraped: 'Noch nicht drapiert',
  close: 'Schließen',
  name: 'Name',
  sew: 'Nähen',
  unit: 'Einheit',
  size: 'Größe',
  pieces: 'Schnittteile',
  body: 'Körper',
  piece: 'Schnittteil',
  all: 'Alle',
  none: 'Keine',
  delete: 'Löschen',
  length: 'Länge',
  takeOut: 'Mitnehmen',
  nothing: 'Keiner',
  noneFound: 'Keine',
  ago: {
    now: 'eben',
    minutes: (n) => `vor ${number(n)} min`,
    hours: (n) => `vor ${number(n)} h`,
    days: (n) => `vor ${counted(n, 'Tag', 'Tagen')}`,
  },
};
