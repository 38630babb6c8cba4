// What the service says, as JSON. Keys are the service's own (snake_case), so that nothing is renamed on the way.

export type JobState = 'queued' | 'running' | 'paused' | 'succeeded' | 'failed' | 'cancelled';

/** A drape that was asked for. Times are Unix milliseconds, 0 or null where it has not happened. */
export interface Job {
  id: string;
  project_id: string;
  project_revision: number;
  name: string;
  state: JobState;
  reason_code?: string;
  reason?: string;
  reason_where?: string;
  attempt?: number;
  created_ms: number;
  started_ms?: number | null;
  ended_ms?: number | null;
  /** File name → bytes. */
  results?: Record<string, number>;
  progress?: Progress | null;
  report?: Report | null;
}

/** Figures of a drape under way. */
export interface Progress {
  state: JobState;
  phase: string;
  fraction: number;
  step: number;
  simulated_s: number;
  rms_speed: number;
  seam_gap_mm: number;
  cloth_body: number;
  cloth_cloth: number;
  step_ms: number;
}

export interface Strain {
  mean: number;
  p99: number;
  max: number;
}

/** Magnitudes, and what is stretched and what is squeezed apart; older reports have magnitudes only. */
export interface Stretch extends Strain {
  tension?: Strain;
  compression?: Strain;
}

/** report.json; lengths in metres unless the key says otherwise. */
export interface Report {
  name: string;
  settled: boolean;
  stop_reason: string;
  cpu_s: number;
  wall_s: number;
  steps: number;
  simulated_s: number;
  particles: number;
  sewn_particles: number;
  triangles: number;
  body_triangles: number;
  intersections: {
    cloth_body: number;
    cloth_cloth: number;
    worst_frame: { step: number; cloth_body: number; cloth_cloth: number };
    frames_checked: number;
  };
  seam_gap_max_mm: number;
  strain: { warp: Stretch; weft: Stretch; shear: Strain };
  rms_speed: number;
  max_speed: number;
  lowest_m: number;
  highest_m: number;
  hash: string;
}

export interface Project {
  id: string;
  name: string;
  revision: number;
  files: Record<string, string>;
  document?: unknown;
  created_ms: number;
  updated_ms: number;
}

export interface Asset {
  id: string;
  kind: 'dxf' | 'specification' | 'body' | 'image';
  name: string;
  size: number;
  info?: Record<string, unknown>;
}

export type Point = [number, number];

/** Four control points of a cubic Bézier. */
export type Curve = [Point, Point, Point, Point];

export interface PieceEdge {
  id: string;
  /** The curves flattened. */
  points: Point[];
  curves: Curve[];
  length_mm: number;
  /** 0 is the outline, 1 the first hole. */
  loop: number;
}

export interface Notch {
  at: Point;
  depth_mm: number;
  inwards: Point | null;
}

/** A picture on a piece; its file is among the project's. */
export interface Texture {
  /** Name of the file in the project. */
  image: string;
  /** Width of one repeat. */
  scale_mm: number;
  /** Where a lower left corner of the picture lies. */
  offset: Point;
  /** Degrees, counter-clockwise from the grain. */
  angle: number;
}

/** A piece of the pattern as it is cut; millimetres, y up. */
export interface Piece {
  id: string;
  outline: Point[];
  holes: Point[][];
  grain: Point | null;
  fabric: string;
  /** Linear RGB. */
  colour: [number, number, number];
  edges: PieceEdge[];
  notches: Notch[];
  texture: Texture | null;
  lines: { id: string; points: Point[]; drawn: boolean }[];
}

export interface SeamEdge {
  piece: string;
  edge: string;
  reversed?: boolean;
  /** Fractions of the edge's length, in the outline's direction; 0 and 1 when they are missing. */
  from?: number;
  to?: number;
}

export interface SeamSides {
  id: string;
  a: SeamEdge[];
  b: SeamEdge[];
  same_direction?: boolean;
}

export interface SeamIssue {
  code: string;
  error: boolean;
  message: string;
  where: string;
}

export interface Seam extends SeamSides {
  length_a_mm: number;
  length_b_mm: number;
  issues: SeamIssue[];
}

export interface SeamProposal extends SeamSides {
  confidence: number;
  length_a_mm: number;
  length_b_mm: number;
}

export interface Pieces {
  pieces: Piece[];
  seams: Seam[];
}

/** One edit of proto/schema/edit.schema.json. */
export type Edit = { edit: string } & Record<string, unknown>;

/** A step of a project's history. */
export interface EditStep {
  number: number;
  undone: boolean;
  created_ms: number;
  edits: Edit[];
}

export type Unit = 'mm' | 'cm' | 'inch';

export interface ImportedPiece {
  name: string;
  size?: string;
  area_mm2?: number;
  width_mm?: number;
  height_mm?: number;
  edges?: number;
  notches?: number;
  grain_deg: number | null;
  quantity: number;
  mirrored: number;
  unfolded: boolean;
  outline?: 'sew' | 'cut';
  layer?: string;
  line?: number;
  material?: string;
  edge_list?: { id: string; length_mm: number; points: Point[] }[];
  notch_list?: { at: Point; depth_mm: number; angle_deg: number | null }[];
  line_list?: { id: string; points: Point[] }[];
  fault?: { code: string; message: string; where: string };
  points: Point[];
  hole_points: Point[][];
}

export interface ImportedEntity {
  type: string;
  layer: string;
  block: string;
  fate: 'kept' | 'converted' | 'dropped';
  reason: string;
  piece: string;
  count: number;
  lines: number[];
}

export interface ImportWarning {
  line: number;
  piece: string;
  at: Point | null;
  text: string;
  count: number;
}

/** What a pattern file holds. */
export interface Import {
  asset: string;
  file: string;
  unit: { name: string; mm_per_unit?: number; confidence: number; evidence: string[] };
  style: string;
  sizes: string[];
  size: string;
  sample_size: string;
  pieces: ImportedPiece[];
  seams: SeamProposal[];
  report: { counts: Record<string, number>; entities: ImportedEntity[]; warnings: ImportWarning[] };
  document: Record<string, unknown> | null;
}

/** Text messages of a job's stream. */
export type StreamText =
  | ({ type: 'job' } & Job)
  | ({ type: 'progress' } & Progress)
  | ({ type: 'ended'; job: Job } & Progress)
  | { type: 'error'; code: string; detail: string; where: string };
