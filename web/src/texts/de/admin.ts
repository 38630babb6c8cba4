// Der Dienst für den, der ihn betreibt.

import type { Texts } from '../en';

export const admin: Texts['admin'] = {
  open: 'Dienst',
  openTip: 'Auslastung des Dienstes, seine Konten und die Drapierungen aller',
  title: 'Der Dienst',
  loading: 'Der Dienst wird befragt …',
  single: 'der einzige Nutzer',
  notYours: (name) =>
    `Auslastung, Konten und die Drapierungen aller sehen Konten, die den Dienst betreuen; ${name} gehört nicht dazu. Ihre eigenen Projekte und Drapierungen stehen in der Liste.`,
  load: {
    title: 'Auslastung',
    running: 'Drapierungen im Gang',
    queued: 'Drapierungen in der Schlange',
    paused: 'Drapierungen angehalten',
    viewers: 'Zuschauer',
    kept: 'Von allen belegt',
    free: 'Frei auf der Platte',
    of: (all) => `von ${all}`,
    notReady: 'Der Dienst nimmt zurzeit keine neue Arbeit an.',
    failures: 'Was seit seinem Beginn nicht aufbewahrt werden konnte:',
  },
  accounts: {
    title: 'Konten',
    heads: {
      name: 'Name',
      keeps: 'Belegt',
      projects: 'Projekte',
      drapes: 'Drapierungen',
      unfinished: 'Nicht beendet',
      since: 'Seit',
      access: 'Zugang',
    },
    admin: 'Verwaltung',
    locked: 'gesperrt',
    lock: 'Sperren',
    unlock: 'Wieder zulassen',
    you: 'das sind Sie',
    of: (what, name) => `${what}: ${name}`,
  },
  jobs: {
    title: 'Drapierungen, die nicht beendet sind',
    none: 'Nichts wird drapiert, und nichts wartet.',
    heads: {
      name: 'Drapierung',
      account: 'Konto',
      state: 'Zustand',
      priority: 'Vorrang',
      worked: 'Rechenzeit',
      begun: 'Begonnen',
      holder: 'Bearbeitet von',
    },
    priorities: { interactive: 'sofort', batch: 'wenn Zeit ist' },
  },
};
