// What is being done, and short news.

import type { Texts } from '../en';

export const messages: Texts['messages'] = {
  wouldFail: 'Seit dem Fehlschlag wurde nichts geändert: Es würde wieder fehlschlagen.',
  asDraped: 'Daran ist nichts zu ändern: Es ist, wie es drapiert wurde.',
  reading: 'Dateien werden gelesen',
  projectThere: (name) => `Projekt „${name}“ ist angelegt. Die Leertaste drapiert es.`,
  uploading: (name) => `${name} wird hochgeladen`,
  makingProject: 'Projekt wird angelegt',
  makingBody: 'Der Körper wird geformt',
  takingAway: (name) => `${name} wird weggenommen`,
  settingDistance: 'Der Abstand wird eingestellt',
  measuring: (name) => `${name} wird vermessen`,
  movingLandmark: 'Der Körperpunkt wird versetzt',
  puttingBack: 'Der Körperpunkt wird zurückgesetzt',
  arranging: 'Die Schnittteile werden platziert',
  placing: 'Das Schnittteil wird platziert',
  standing: 'Die Schnittteile werden um den Körper gestellt',
  inRows: (why) => `Die Schnittteile stehen in Reihen: ${why}`,
  twoCorners: 'Ein Umriss behält mindestens zwei Ecken.',
  changedElsewhere: 'Das Projekt wurde anderswo geändert; hier ist der neueste Stand.',
  pictureLost: 'Ein Bild dieses Projekts kann nicht gezeigt werden.',
};
