// What came of a drape, and the ways on.

import type { Texts } from '../en';
import { grammar } from '../grammar';

const { number } = grammar('de');

export const outcome: Texts['outcome'] = {
  noResult: 'sie endete ohne Ergebnis',
  failed: 'Die Drapierung ist fehlgeschlagen',
  openWhy: 'Meist ist eine Naht dann verkehrt herum genäht, oder der Körper steht zwischen ihren Seiten.',
  openUneven: 'Eine Seite der weitesten ist viel länger als die andere: Vielleicht endet sie woanders, oder eine Naht daneben fehlt. Sonst ist eine Naht verkehrt herum genäht.',
  notWorn: 'Es wird nicht getragen, wie es sollte',
  leftOutWhy: 'Nichts verbindet sie mit dem Rest, oder das Kleidungsstück ließ sich mit ihnen nicht anziehen; deshalb wurde ohne sie drapiert.',
  leftOutSewn: 'Sie sind angenäht, aber mit ihnen ließ sich das Kleidungsstück nicht anziehen; es wurde ohne sie drapiert. Stehen sie am Anfang anders, kommen sie vielleicht mit.',
  moved: 'Am Ende bewegte es sich noch',
  movedWhy: 'Die Zeit war um, bevor es zur Ruhe kam. Zu sehen ist der letzte Augenblick; weiter und leichter Stoff braucht am längsten.',
  andMore: 'und mehr',
  older: 'Seit dieser Drapierung geändert',
  cancelled: 'Die Drapierung wurde abgebrochen',
  fixes: {
    reverse: (seam) => `Naht ${seam} umdrehen und drapieren`,
    arrange: 'Neu platzieren und drapieren',
    place: 'Von Hand platzieren',
    sew: 'Ihre Nähte suchen',
    edit: 'Umriss ansehen',
    seam: 'Naht ansehen',
    time: (seconds) => `${seconds} s geben und drapieren`,
  },
  openSeams: (n) => n === 1 ? 'Eine Naht blieb offen' : `${number(n)} Nähte blieben offen`,
  openings: (n) => n === 1 ? 'Eine Öffnung ist übrig' : `${number(n)} Öffnungen sind übrig`,
  leftOut: (n) => n === 1 ? 'Ein Teil wurde weggelassen' : `${number(n)} Teile wurden weggelassen`,
  without: (what) => `${what && `Seitdem: ${what} `}Stoff, Maße und Dateien hier sind die von vorher.`,
  texts: {
    inBody: 'Das Teil beginnt im Körper. Neu platziert steht es frei davor.',
    inCloth: 'Zwei Teile beginnen ineinander. Neu platziert stehen sie getrennt.',
    stalled: 'Die Nähte ließen sich nicht schließen. Stehen die Teile näher beieinander, ist weniger im Weg.',
    project: 'Der Fehler liegt im Projekt selbst, an der genannten Stelle.',
    dxf: 'Exportieren Sie das DXF noch einmal aus dem Schnittprogramm, oder berichtigen Sie die genannte Zeile.',
    body: 'Ein Körper ist ein geschlossenes Netz aus Dreiecken. Unter „Körper“ lässt sich eine andere Datei oder eine Größe wählen.',
    seam: 'Die Naht verbindet, was nicht zusammenpasst: Vielleicht liegt sie verkehrt herum oder endet woanders.',
    noSeams: 'Nichts sagt, wie die Teile zusammengenäht werden. Nähte lassen sich suchen oder mit N zusammenklicken.',
    outline: 'Der Umriss des Teils muss berichtigt werden.',
  },
};
