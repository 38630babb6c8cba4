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

/** Nobody locks themselves out. */
export const mayLock = (account: AdminAccount, session: Session | null): boolean =>
  mayRun(session) && account.name !== session?.name;
