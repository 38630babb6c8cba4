// A drape under way: its states, phases and figures.

import type { Texts } from '../en';

export const drape: Texts['drape'] = {
  solver: {
    paper: 'Die Methode des Aufsatzes, zum Vergleich. Sie kann Stoff durchlassen; Durchdringungen werden gezählt.',
    how: 'Wie drapiert wird',
    solver: 'Verfahren',
    next: 'Es gilt ab der nächsten Drapierung.',
    toile: 'Nichts geht durch etwas hindurch.',
  },
  speedHere: 'Hier wird gezeichnet, wie der Stoff zur Ruhe kommt.',
  speedOf: 'Bewegung des Stoffes',
  speedNow: (speed) => `Bewegung des Stoffes, jetzt ${speed}`,
  dashed: 'gestrichelt: in Ruhe',
  facts: {
    drape: 'Drapierung',
    version: 'Version',
    revision: 'Revision des Projekts',
    running: 'Laufzeit',
    particles: 'Netzpunkte',
    triangles: 'Dreiecke',
  },
  pins: {
    title: 'Nadeln',
    one: (n) => `Nadel ${n}`,
    height: (height) => `in ${height} Höhe`,
    remove: (n) => `Nadel ${n} entfernen`,
  },
  starting: 'Beginnt',
  states: {
    queued: 'Wartet',
    running: 'Läuft',
    paused: 'Angehalten',
    succeeded: 'Fertig',
    failed: 'Fehlgeschlagen',
    cancelled: 'Abgebrochen',
  },
  phases: {
    queued: 'Wartet auf einen Rechenplatz',
    mesh: 'Schnittteile werden vernetzt',
    place: 'Schnittteile werden platziert',
    dress: 'Kleidungsstück wird angezogen',
    sew: 'Es wird genäht',
    drape: 'Es wird drapiert',
    move: 'Körper bewegt sich',
    check: 'Es wird geprüft',
    stills: 'Bilder werden gemacht',
  },
};
