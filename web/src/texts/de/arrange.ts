// Where the pieces stand before a drape, and what the look at them finds.

import type { Texts } from '../en';
import { grammar } from '../grammar';

const { counted } = grammar('de');

export const arrange: Texts['arrange'] = {
  openProject: 'Öffnen Sie ein Projekt, um seine Schnittteile zu platzieren.',
  arrange: 'Schnittteile platzieren',
  boxes: 'Boxen',
  places: 'Plätze der Schnittteile',
  dragPiece: 'Ziehen Sie in 3D ein Schnittteil auf die Seite einer Box, oder wählen Sie seinen Platz hier.',
  partner: 'Das Gegenstück geht auf der anderen Seite mit',
  byHand: (place) => `von Hand: ${place}`,
  part: 'Körperteil',
  side: 'Seite',
  across: 'Quer',
  up: 'Hoch',
  away: 'Abstand',
  turn: 'Drehung',
  rolled: 'Um den Körperteil gerollt',
  overTip: 'Die andere Stoffseite zum Körper',
  turnOver: 'Schnittteil wenden',
  severities: {
    error: 'Fehler',
    warning: 'Warnung',
    note: 'Hinweis',
    repaired: 'Behoben',
  },
  looking: 'Der Anfang wird geprüft',
  problems: 'Probleme',
  repaired: (n) => `${n} behoben`,
  ready: 'Bereit zum Drapieren',
  notReady: 'Noch nicht bereit zum Drapieren',
  noFault: 'nichts zu beanstanden',
  goodToKnow: (n) => `${counted(n, 'Hinweis', 'Hinweise')} am Rande`,
  errors: (n) => counted(n, 'Fehler', 'Fehler'),
  warnings: (n) => counted(n, 'Warnung', 'Warnungen'),
  notes: (n) => counted(n, 'Hinweis', 'Hinweise'),
};
