// The service as whoever runs it sees it.

import type { AdminAccount, AdminJob, AdminLoad } from '../api/admin';
import type { Session } from '../api/types';

export interface AdminView {
  load: AdminLoad;
  accounts: AdminAccount[];
  jobs: AdminJob[];
}

/** Whether the page leads there: where there are accounts, those that may. Who is alone knows all of it already. */
export const mayRun = (session: Session | null): boolean =>
  session !== null && session.accounts && session.scopes.includes('admin');

/** Whether it is known to be somebody else's to see. */
export const isClosedTo = (session: Session | null): boolean => session !== null && session.accounts && !mayRun(session);

/** What all of them keep together, bytes. */
export const keptBy = (accounts: readonly AdminAccount[]): number => accounts.reduce((sum, { bytes }) => sum + bytes, 0);

/** Nobody locks themselves out. */
export const mayLock = (account: AdminAccount, session: Session | null): boolean =>
  mayRun(session) && account.name !== session?.name;
