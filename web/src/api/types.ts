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
  strain: { warp: Strain; weft: Strain; shear: Strain };
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
  kind: 'dxf' | 'body';
  name: string;
  size: number;
  info?: Record<string, unknown>;
}

export type Point = [number, number];

/** A piece of the pattern as it is cut; millimetres, y up. */
export interface Piece {
  id: string;
  outline: Point[];
  holes: Point[][];
  grain: Point | null;
  fabric: string;
  /** Linear RGB. */
  colour: [number, number, number];
  edges: { id: string; points: Point[] }[];
}

export interface SeamEdge {
  piece: string;
  edge: string;
  reversed?: boolean;
}

export interface Seam {
  id: string;
  a: SeamEdge[];
  b: SeamEdge[];
  same_direction?: boolean;
}

export interface Pieces {
  pieces: Piece[];
  seams: Seam[];
}

/** Text messages of a job's stream. */
export type StreamText =
  | ({ type: 'job' } & Job)
  | ({ type: 'progress' } & Progress)
  | ({ type: 'ended'; job: Job } & Progress)
  | { type: 'error'; code: string; detail: string; where: string };
