// What whoever runs the service sees of it. Wants the scope admin.

import type { Http } from './http';
import type { Answer, Schemas } from './types';

export type AdminAccount = Schemas['AdminAccount'];
export type AdminJob = Schemas['AdminJob'];
export type AdminLoad = Schemas['AdminLoad'];

export interface AdminApi {
  adminAccounts(): Promise<AdminAccount[]>;
  /** Everybody's drapes that have not ended, the oldest first. */
  adminJobs(): Promise<AdminJob[]>;
  adminLoad(): Promise<AdminLoad>;
  /** Lets an account in no more, or again. */
  lockAccount(id: string, locked: boolean): Promise<void>;
}

export function makeAdminApi(http: Http): AdminApi {
  return {
    adminAccounts: async () => (await http.get<Answer<'adminAccounts'>>('/admin/accounts')).accounts,
    adminJobs: async () => (await http.get<Answer<'adminJobs'>>('/admin/jobs')).jobs,
    adminLoad: () => http.get('/admin/load'),
    lockAccount: async (id, locked) =>
      void (await http.send(`/admin/accounts/${encodeURIComponent(id)}/${locked ? 'lock' : 'unlock'}`, { method: 'POST' })),
  };
}
