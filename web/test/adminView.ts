// What whoever runs a service sees of it, for tests.

import type { AdminAccount, AdminJob, AdminLoad } from '../src/api/admin';
import type { Session } from '../src/api/types';

export const loadOf = (more: Partial<AdminLoad> = {}): AdminLoad => ({
  ready: true,
  jobs_queued: 3,
  jobs_running: 2,
  jobs_paused: 0,
  viewers: 4,
  disk_bytes: 500_000_000_000,
  disk_free_bytes: 41_000_000_000,
  store_failures: {},
  ...more,
});

export const accountOf = (name: string | null, more: Partial<AdminAccount> = {}): AdminAccount => ({
  id: `ac_${name ?? ''}`,
  name,
  admin: false,
  locked: false,
  created_ms: 1,
  bytes: 0,
  assets: 0,
  projects: 0,
  jobs: 0,
  unfinished_jobs: 0,
  ...more,
});

export const adminJobOf = (more: Partial<AdminJob> = {}): AdminJob => ({
  id: 'j_1',
  owner: 'ac_ben',
  account: 'ben',
  name: 'Shirt',
  state: 'running',
  priority: 'batch',
  holder: 'worker-2',
  attempt: 1,
  created_ms: 100_000,
  started_ms: 300_000,
  worked_s: 75,
  ...more,
});

/** Of anna, where there are accounts. */
export const sessionOf = (scopes: Session['scopes']): Session => ({ accounts: true, name: 'anna', scopes, expires_ms: 0 });
