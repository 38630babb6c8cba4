// What the service says of small things, for tests that look at one part of it.

import type { Figure, Finding, ProjectBody } from '../src/api/dressing';
import type { Fabric, Import, ImportedPiece, Layer, Report } from '../src/api/types';
import { seamOf } from './fakes';

export const findingOf = (more: Partial<Finding> = {}): Finding => ({
  code: 'start.touches',
  severity: 'warning',
  message: 'it touches',
  where: 'piece front',
  about: [{ thing: 'piece', id: 'front' }],
  place: [0.2, 1, 0],
  repaired: false,
  ...more,
});

/** As the service tells them. */
export const meshFormats = ['OBJ', 'STL', 'PLY', 'glTF', 'GLB', 'FBX', 'DAE', '3DS', 'OFF'].map((name) => ({
  name,
  ending: `.${name.toLowerCase()}`,
}));

/** Of a small body whose waist has been measured. */
export const figure: Figure = {
  stands: true,
  why: null,
  vertices: 3,
  triangles: 1,
  low: [0, 0, 0],
  high: [1, 1.7, 0.2],
  measures: [{ name: 'waist', girth: true, cm: 72, at_cm: 105, asked_cm: 72, rule: 'narrowest', line: [] }],
  landmarks: [],
  boxes: [],
};
export const bodyOf = (more: Partial<ProjectBody> = {}): ProjectBody => ({
  ...figure,
  id: 'anna',
  file: null,
  mannequin: { preset: 'eu38', triangles: 2000 },
  friction: 0.4,
  skin_offset_mm: 1,
  ...more,
});

export const importedPiece = (name: string, more: Partial<ImportedPiece> = {}): ImportedPiece => ({
  name,
  grain_deg: 90,
  quantity: 1,
  mirrored: 0,
  unfolded: false,
  points: [
    [0, 0],
    [100, 0],
    [0, 50],
  ],
  hole_points: [],
  ...more,
});

/** What the service reads from shirt.dxf. */
export const layerOf = (name: string, read_as: Layer['read_as'], more: Partial<Layer> = {}): Layer => ({
  name,
  read_as,
  given: false,
  count: 3,
  kinds: [{ type: 'POLYLINE', count: 3 }],
  ...more,
});

export const importOf = (more: Partial<Import> = {}): Import => ({
  asset: 'a_1',
  file: 'shirt.dxf',
  unit: { name: 'cm', mm_per_unit: 10, confidence: 0.9, evidence: ['the size of the pieces'] },
  style: '',
  sizes: ['38', '40'],
  size: '38',
  sample_size: '38',
  layers: [layerOf('1', 'cut'), layerOf('15', 'text', { kinds: [{ type: 'TEXT', count: 2 }] }), layerOf('A', 'other')],
  pieces: [
    importedPiece('front'),
    importedPiece('sleeve', { quantity: 2, mirrored: 1 }),
    importedPiece('torn', { fault: { code: 'x', message: '', where: '' } }),
  ],
  seams: [
    { ...seamOf('seam0', ['front', 'e0'], ['sleeve', 'e1']), confidence: 0.95, to_wear: true },
    { ...seamOf('seam1', ['front', 'e2'], ['sleeve_mirrored', 'e1']), confidence: 0.5, to_wear: false },
  ],
  report: {
    counts: { records: 20, structure: 4, elsewhere: 1, vertices: 9, entities: 6, kept: 3, converted: 2, dropped: 1 },
    entities: [
      {
        type: 'POLYLINE',
        layer: '1',
        block: 'F',
        fate: 'kept',
        reason: '',
        piece: 'front',
        count: 3,
        lines: [5, 9, 30],
      },
      {
        type: 'TEXT',
        layer: '15',
        block: '',
        fate: 'converted',
        reason: 'a name',
        piece: 'sleeve',
        count: 2,
        lines: [40, 44],
      },
      { type: 'IMAGE', layer: '0', block: '', fate: 'dropped', reason: 'no cloth', piece: '', count: 1, lines: [60] },
    ],
    warnings: [{ line: 9, piece: 'front', at: [1, 2], text: 'a gap was closed', count: 2 }],
  },
  document: {
    toile: 1,
    name: 'shirt',
    pieces: [
      { id: 'front', fabric: 'cotton', placement: {}, from: { dxf: 'shirt.dxf', piece: 'front' } },
      { id: 'sleeve', fabric: 'cotton', placement: {}, from: { dxf: 'shirt.dxf', piece: 'sleeve' } },
      { id: 'sleeve_mirrored', fabric: 'cotton', placement: {} },
    ],
    fabrics: [],
    seams: [],
    bodies: [{ id: 'body', mannequin: {} }],
  },
  ...more,
});

/** Of a drape that settled. */
export const reportOf = (more: Partial<Report> = {}): Report => ({
  name: 'A-line skirt',
  settled: true,
  stop_reason: 'settled',
  cpu_s: 7.4,
  wall_s: 7.45,
  resumed: 0,
  steps: 10502,
  simulated_s: 3.5007,
  particles: 3286,
  sewn_particles: 3162,
  triangles: 6176,
  body_triangles: 3300,
  intersections: {
    cloth_body: 0,
    cloth_cloth: 0,
    worst_frame: { step: 0, cloth_body: 0, cloth_cloth: 0 },
    frames_checked: 212,
  },
  seam_gap_max_mm: 0,
  open_seams: [],
  worn: 'yes',
  attachments: [],
  strain: {
    warp: { mean: 0.0014, p99: 0.0078, max: 0.02 },
    weft: { mean: 0.0015, p99: 0.0184, max: 0.05 },
    shear: { mean: 0, p99: 0.016, max: 0.04 },
  },
  rms_speed: 0.00297,
  max_speed: 0.0156,
  lowest_m: 0.4774,
  highest_m: 1.1024,
  findings: [],
  hash: 'a5',
  ...more,
});

/** Of cotton, with the bending of a calico that is heavier. */
export const fabricOf = (name: string, more: Partial<Fabric> = {}): Fabric => ({
  toile_fabric: 1,
  name,
  title: `Title of ${name}`,
  fibre: 'cotton',
  construction: 'woven',
  weave: '2/1 twill',
  areal_mass_g_m2: 240,
  thickness_mm: 0.5,
  bend_warp_un_m: 41.4,
  bend_weft_un_m: 36.8,
  bend_bias_un_m: 30,
  stretch_warp: [
    { strain_percent: 4, tension_n_m: 90 },
    { strain_percent: 6, tension_n_m: 490 },
  ],
  stretch_weft: [{ strain_percent: 5, tension_n_m: 245 }],
  stretch_coupling_n_m: 199,
  stretch_shear_n_m: 120,
  limit_shear_rad: 0.3,
  friction: 0.4,
  colour: [0.5, 0.5, 0.5],
  sources: [],
  ...more,
});
