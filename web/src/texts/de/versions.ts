import type { Texts } from '../en';

export const versions: Texts['versions'] = {
  title: 'Versionen',
  nameOf: 'Name dieses Stands',
  keep: 'Festhalten',
  current: 'der Stand von jetzt',
  restore: 'Zurückkehren',
  restoreIt: (name) => `Zu „${name}“ zurückkehren`,
  restoreTip: 'Das Projekt wird, wie es war; Strg Z führt wieder her',
  the: (name) => `die Version „${name}“`,
};
