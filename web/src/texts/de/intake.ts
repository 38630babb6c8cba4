// The first page, and files on their way to become a project.

import type { Texts } from '../en';
import { grammar } from '../grammar';

const { number } = grammar('de');

export const intake: Texts['intake'] = {
  start: 'Start',
  seeIt: 'Sehen Sie Ihren Schnitt am Körper',
  lead: 'Toile liest einen flachen Schnitt, näht seine Teile zusammen, stellt sie um einen Körper und lässt den Stoff fallen. Sie sehen dabei zu, ändern, was nicht passt, und nehmen Bilder, ein 3D-Modell und die Maße mit.',
  dropPattern: 'DXF-Schnitt hier ablegen oder auswählen',
  orSample: 'Oder mit einem Beispiel beginnen',
  goOn: 'Weiterarbeiten an',
  sampleTip: 'Legt ein Projekt davon an und drapiert es',
  dropToMake: 'Ablegen, um ein Projekt anzulegen',
  dropWhat: 'ein Schnitt (DXF, GarmentCode) oder project.json mit seinen Dateien; ein einzelnes Bild kommt auf den Stoff',
  takes: 'Ein Schnitt (DXF, GarmentCode-JSON), ein Körper (OBJ, glTF, …) oder eine project.json mit ihren Dateien',
  leaving: 'Noch einmal Esc schließt; von dem hier bleibt nichts.',
  newFrom: (file) => `Neues Projekt aus ${file}`,
  dropHere: 'Dateien hier ablegen oder auswählen',
  addMore: 'Weitere Dateien hinzufügen',
  create: 'Anlegen',
  createAndDrape: 'Anlegen und drapieren',
  roles: {
    project: 'Projekt',
    pattern: 'Schnitt',
    body: 'Körper',
    image: 'Bild',
    unused: 'Nicht verwendet',
  },
  besides: 'Sie liegen neben der project.json, wo diese gespeichert wurde. Legen Sie sie hier mit ab.',
  complete: 'Es ist alles da.',
  thePattern: 'der Schnitt',
  theBody: 'der Körper',
  alsoNeeds: (n) => n === 1 ? 'braucht noch diese Datei:' : `braucht noch diese ${number(n)} Dateien:`,
  problems: {
    documentSize: 'Ein Projektdokument hat höchstens 4 MiB.',
    format: 'Diese JSON-Datei ist weder ein Toile-Projekt (ihr fehlt der Schlüssel „toile“) noch eine GarmentCode-Spezifikation.',
    json: (why) => `Kein gültiges JSON: ${why}`,
    fileSize: 'Dateien haben höchstens 64 MiB.',
    kind: 'Weder ein Projekt (.json) noch ein Schnitt (.dxf, .json), ein Körper (.obj, .glb, …) oder ein Bild (.png, .jpg).',
    several: 'Ein Projekt auf einmal: Lassen Sie ein Dokument weg.',
  },
};
