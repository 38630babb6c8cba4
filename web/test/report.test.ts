import { describe, expect, it } from 'vitest';
import type { Report } from '../src/api/types';
import { downloadsOf, reportLines, stillsOf } from '../src/state/report';
import { reportOf } from './samples';

const report = reportOf();
const line = (label: string, changes: Partial<Report> = {}) =>
  reportLines({ ...report, ...changes }).find((one) => one.label === label)!;

describe('a report in words', () => {
  it('says that it settled, when, and how long that took', () => {
    expect(line('Ending')).toMatchObject({ value: 'Settled at 3.50 s', verdict: 'good' });
    expect(line('Ending').sentence).toBe('The cloth came to rest after 10,502 steps, computed in 7.5 s.');
  });

  it('warns of a drape that did not come to rest', () => {
    expect(line('Ending', { settled: false, stop_reason: 'time' })).toMatchObject({
      value: 'Stopped: time',
      verdict: 'warn',
    });
  });

  it('counts intersections, also those that were there on the way', () => {
    expect(line('Intersections')).toMatchObject({ value: 'None', verdict: 'good' });
    const worst = { ...report.intersections, worst_frame: { step: 900, cloth_body: 1, cloth_cloth: 0 } };
    expect(line('Intersections', { intersections: worst }).sentence).toContain('1 place did at step 900');
    expect(
      line('Intersections', { intersections: { ...report.intersections, cloth_body: 3, cloth_cloth: 1 } }),
    ).toMatchObject({ value: '4', verdict: 'warn' });
  });

  it('tells closed seams from open ones', () => {
    expect(line('Seams')).toMatchObject({ value: 'Closed', verdict: 'good' });
    expect(line('Seams', { seam_gap_max_mm: 12.34 })).toMatchObject({ value: '12.3 mm', verdict: 'warn' });
  });

  it('names the seams that were left open', () => {
    const open = { seam_gap_max_mm: 30, open_seams: [{ id: 'cuff_left', gap_mm: 30 }] };
    expect(line('Seams', open).sentence).toBe('Left open: cuff_left by 30.0 mm.');
  });

  it('says whether the body wears it, and why not', () => {
    expect(line('Worn')).toMatchObject({ value: 'Yes', verdict: 'good' });
    const open_seams = [{ id: 'side', gap_mm: 12 }];
    expect(line('Worn', { worn: 'partly', open_seams })).toMatchObject({
      value: 'In part',
      verdict: 'warn',
      sentence: 'It is on, but for what did not close.',
    });
    const out = { code: 'piece.left_out', message: 'no seam', where: '', repaired: false } as const;
    const findings: Report['findings'] = [
      { ...out, place: [0, 0, 0], severity: 'warning', about: [{ thing: 'piece', id: 'sleeve' }] },
      { ...out, place: [0, 0, 0], severity: 'note', about: [{ thing: 'piece', id: 'pocket' }] },
    ];
    expect(line('Worn', { worn: 'partly', findings })).toMatchObject({ sentence: 'It is on, but for sleeve.' });
    const off: Report['findings'][number] = { code: 'worn.ring_off', severity: 'warning', message: 'a ring is off', where: '', about: [], place: [0, 0, 0], repaired: false };
    const slit: Report['findings'][number] = { ...off, code: 'worn.slit', message: 'an opening' };
    expect(line('Worn', { worn: 'partly', findings: [slit] })).toMatchObject({
      sentence: 'It is on, but for an opening with nothing in it.',
    });
    expect(line('Worn', { worn: 'no', findings: [off] })).toMatchObject({ value: 'No', sentence: 'a ring is off.' });
    expect(reportLines({ ...report, worn: undefined }).some((one) => one.label === 'Worn')).toBe(false);
  });

  it('gives the measures of the garment', () => {
    expect(line('Garment').value).toBe('62.5 cm tall');
    expect(line('Stretch').value).toBe('0.8 % warp, 1.8 % weft');
    const squeezed = {
      mean: 0.01, p99: 0.12, max: 0.2,
      tension: { mean: 0.001, p99: 0.012, max: 0.03 },
      compression: { mean: 0.009, p99: 0.12, max: 0.2 },
    };
    const gathered = { ...report.strain, weft: squeezed };
    expect(line('Stretch', { strain: gathered })).toMatchObject({ value: '0.8 % warp, 1.2 % weft', verdict: 'plain' });
  });
});

describe('result files', () => {
  const results = {
    'back.png': 9,
    'final.glb': 2,
    'final.obj': 3,
    'report.json': 4,
    'thumbnail.png': 1,
    'three-quarter.png': 8,
    'zeta.bin': 5,
  };

  it('are offered with the known ones first and stills apart', () => {
    expect(downloadsOf(results).map((file) => file.name)).toEqual([
      'final.glb',
      'final.obj',
      'report.json',
      'zeta.bin',
    ]);
    expect(stillsOf(results)).toEqual(['three-quarter.png', 'back.png']);
  });
});
