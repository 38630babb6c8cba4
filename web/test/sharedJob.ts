import type { SharedJob } from '../src/api/types';
import { jobOf } from './fakes';

/** A job as a link shows it, draped. */
export const sharedOf = (more: Partial<SharedJob> = {}): SharedJob => ({
  ...jobOf({ id: 'l_1', project_id: '', project_revision: 0, state: 'succeeded' }),
  progress: null,
  report: null,
  label: '',
  expires_ms: 0,
  take: [],
  stills: ['front.png'],
  cloth: true,
  ...more,
});
