// Sweeps: one project on several bodies and of several fabrics.

import { Http, kLongPatience } from './http';
import type { Answer, Question, Schemas } from './types';

export type Sweep = Schemas['Sweep'];
/** Lists leave out the cells. */
export type SweepSummary = Schemas['SweepSummary'];
export type SweepCell = Schemas['SweepCell'];
export type SweepFigures = Schemas['SweepFigures'];
export type SweepWish = Question<'submitSweep'>;

export interface SweepApi {
  /** Newest first. */
  sweeps(): Promise<SweepSummary[]>;
  sweep(id: string): Promise<Sweep>;
  /** `key` makes asking twice (a lost answer) start one sweep only. */
  submitSweep(wish: SweepWish, key: string): Promise<Sweep>;
  cancelSweep(id: string): Promise<Sweep>;
  /** One whose drapes have ended, with their results. */
  removeSweep(id: string): Promise<void>;
  sweepUrl(id: string, file: 'table.csv' | 'sheet.png'): string;
}

const at = (id: string): string => `/sweeps/${encodeURIComponent(id)}`;

export function makeSweepApi(http: Http): SweepApi {
  return {
    sweeps: async () => (await http.get<Answer<'listSweeps'>>('/sweeps?limit=30')).sweeps,
    sweep: (id) => http.get(at(id)),
    submitSweep: (wish, key) => http.post('/sweeps', wish, { 'Idempotency-Key': key }, kLongPatience),
    cancelSweep: (id) => http.post(`${at(id)}/cancel`),
    removeSweep: async (id) => void (await http.send(at(id), { method: 'DELETE' })),
    sweepUrl: (id, file) => http.url(`${at(id)}/${file}`),
  };
}
