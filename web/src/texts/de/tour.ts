// Der Rundgang für jemanden, der gerade gekommen ist.

import type { Texts } from '../en';

export const tour: Texts['tour'] = {
  title: 'Rundgang durch die Seite',
  count: (n, of) => `${n} von ${of}`,
  skip: 'Überspringen',
  back: 'Zurück',
  next: 'Weiter',
  done: 'Fertig',
  again: 'Rundgang machen',
  stops: {
    cloth: {
      title: 'Das Kleidungsstück am Körper',
      text: 'Ziehen dreht die Ansicht, das Mausrad bringt sie näher. Die Knöpfe darüber zeigen es von jeder Seite und färben den Stoff danach, wie weit er gedehnt ist oder vom Körper absteht.',
    },
    pattern: {
      title: 'Seine flachen Schnittteile',
      text: 'Wählen Sie ein Schnittteil aus, und es leuchtet auch am Körper. Mit den Werkzeugen darüber bewegen Sie Punkte und nähen Kanten zusammen; jede Naht hat ihre Farbe. Strg Z nimmt zurück, was Sie getan haben.',
    },
    body: {
      title: 'Körper und Plätze',
      text: 'Unter Körper stehen Größen und Maße, oder Sie nehmen ein eigenes Netz. Anordnen stellt die Schnittteile mit einem Klick um ihn herum und sagt, was einer Drapierung im Weg steht.',
    },
    drape: {
      title: 'Drapieren',
      text: 'Die Leertaste beginnt, hält an und setzt fort. Sie können den Schnitt ändern, während der Stoff fällt, oder die Seite schließen: Die Drapierung geht ohne sie weiter.',
    },
    result: {
      title: 'Was daraus geworden ist',
      text: 'Ergebnis sagt nach dem Ende einer Drapierung, wie das Kleidungsstück passt, und hat Bilder, Filme und Modelle zum Mitnehmen. Die Taste ? zeigt alle Tasten und diesen Rundgang.',
    },
  },
};
