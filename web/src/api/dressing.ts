// Bodies, places and the look before a drape, as the service tells them. Lengths in metres unless the key says otherwise.

import { decodeBody, type BodyMesh } from './body';
import { decodeTopology, type ClothTopology } from './frames';
import { ApiError, Http } from './http';
import type { Asset, Project } from './types';

export type Place = [number, number, number];
export type Sex = 'female' | 'male' | 'child';

/** As a project document has it; measures as "waist_cm". */
export interface Mannequin {
  preset?: string;
  sex?: Sex;
  pose?: 'a' | 't';
  arm_angle?: number;
  triangles?: number;
  [measure_cm: `${string}_cm`]: number | undefined;
}

export interface BodyPreset {
  name: string;
  sex: Sex;
  measures_cm: Record<string, number>;
}

export interface MeasureRule {
  name: string;
  rule: string;
  girth: boolean;
  least_cm: number;
  most_cm: number;
}

export interface BodyTables {
  presets: BodyPreset[];
  measures: MeasureRule[];
}

export interface TakenMeasure {
  name: string;
  girth: boolean;
  cm: number;
  at_cm: number;
  asked_cm: number | null;
  rule: string;
  /** Where the tape lies; that of a girth closes by itself. */
  line: Place[];
}

export interface Landmark {
  name: string;
  place: Place;
  /** Whether the project says where it is: put elsewhere by hand, or added. */
  own?: boolean;
}

export interface PartBox {
  part: string;
  centre: Place;
  axes: [Place, Place, Place];
  half: Place;
}

export interface Figure {
  stands: boolean;
  why: { code: string; detail: string } | null;
  vertices: number;
  triangles: number;
  low: Place;
  high: Place;
  measures: TakenMeasure[];
  landmarks: Landmark[];
  boxes: PartBox[];
}

export interface ProjectBody extends Figure {
  id: string;
  file: string | null;
  mannequin: Mannequin | null;
  friction: number;
  skin_offset_mm: number;
}

export interface Stance {
  unit_in_m: number;
  up: 'y' | 'z';
  upside_down: boolean;
  turned_degrees: number;
}

/** Who is to be dressed. */
export interface BodyWish {
  mannequin?: Mannequin;
  asset?: string;
  unit?: string;
  up?: string;
  turn?: number;
  friction?: number;
  skin_offset_mm?: number;
}

export type Severity = 'error' | 'warning' | 'note';

export interface Finding {
  code: string;
  severity: Severity;
  message: string;
  where: string;
  place: Place;
  repaired: boolean;
}

export interface Check {
  ready: boolean;
  findings: Finding[];
  pieces: { id: string; low: Place; high: Place; by_hand: Omit<PieceWish, 'piece'> | null }[];
}

export interface Arrangement {
  pieces: { id: string; place: string }[];
  holds: string[];
  findings: Finding[];
}

export type BoxSide = 'front' | 'back' | 'left' | 'right';

export interface PieceWish {
  piece: string;
  part: string;
  side: BoxSide;
  at_mm: [number, number];
  away_mm: number;
  turn: number;
  wrapped: boolean;
  /** The piece's mirror image goes to the other side. */
  with_partner?: boolean;
}

/** The pieces where a drape would begin. */
export interface Start {
  topology: ClothTopology;
  positions: Float32Array;
}

export interface DressingApi {
  tables(): Promise<BodyTables>;
  bodies(project: string): Promise<ProjectBody[]>;
  mesh(project: string): Promise<BodyMesh>;
  stance(asset: string): Promise<Figure & { stance: Stance | null }>;
  dress(project: Project, body: string, wish: BodyWish): Promise<Project>;
  undress(project: Project, body: string): Promise<Project>;
  /** Moves a landmark to the skin nearest to the place, or adds one. */
  mark(project: Project, body: string, landmark: string, place: Place): Promise<Project>;
  unmark(project: Project, body: string, landmark: string): Promise<Project>;
  arrange(project: Project): Promise<Project & { arrangement: Arrangement }>;
  place(project: Project, wish: PieceWish): Promise<Project>;
  check(project: string): Promise<Check>;
  start(project: string): Promise<Start>;
  upload(name: string, bytes: Blob): Promise<Asset>;
}

/** @throws ApiError when the lengths do not agree. */
export function decodeStart(bytes: ArrayBuffer): Start {
  const broken = (): ApiError => new ApiError(0, 'page.start', 'The start of the drape came damaged.');
  if (bytes.byteLength < 4) throw broken();
  const size = new DataView(bytes).getUint32(0, true);
  if (4 + size > bytes.byteLength) throw broken();
  const topology = decodeTopology(new Uint8Array(bytes, 4, size));
  // The topology may end anywhere, and floats begin at multiples of four: they are copied.
  const floats = bytes.slice(4 + size);
  if (floats.byteLength !== 12 * topology.vertexCount) throw broken();
  return { topology, positions: new Float32Array(floats) };
}

const part = encodeURIComponent;

export function makeDressingApi(http = new Http('/api/v1')): DressingApi {
  const one = (id: string): string => `/projects/${part(id)}`;
  const json = async <T>(path: string, init: RequestInit): Promise<T> =>
    (await http.send(path, init)).json() as Promise<T>;
  const changing = (project: Project): Record<string, string> => ({ 'If-Match': `"${project.revision}"` });
  return {
    tables: () => http.get('/bodies/presets'),
    bodies: async (id) => (await http.get<{ bodies: ProjectBody[] }>(`${one(id)}/bodies`)).bodies,
    mesh: async (id) => decodeBody(await http.bytes(`${one(id)}/body`)),
    stance: (asset) => http.get(`/bodies/${part(asset)}/figure`),
    dress: (project, body, wish) =>
      json(`${one(project.id)}/bodies/${part(body)}`, {
        method: 'PUT',
        headers: { 'Content-Type': 'application/json', ...changing(project) },
        body: JSON.stringify(wish),
      }),
    undress: (project, body) =>
      json(`${one(project.id)}/bodies/${part(body)}`, { method: 'DELETE', headers: changing(project) }),
    mark: (project, body, landmark, place) =>
      json(`${one(project.id)}/bodies/${part(body)}/landmarks/${part(landmark)}`, {
        method: 'PUT',
        headers: { 'Content-Type': 'application/json', ...changing(project) },
        body: JSON.stringify({ place }),
      }),
    unmark: (project, body, landmark) =>
      json(`${one(project.id)}/bodies/${part(body)}/landmarks/${part(landmark)}`, {
        method: 'DELETE',
        headers: changing(project),
      }),
    arrange: (project) => http.post(`${one(project.id)}/arrange`, undefined, changing(project)),
    place: (project, wish) => http.post(`${one(project.id)}/place`, wish, changing(project)),
    check: (id) => http.get(`${one(id)}/check`),
    start: async (id) => decodeStart(await http.bytes(`${one(id)}/start`)),
    upload: (name, bytes) =>
      json(`/bodies?name=${part(name)}`, {
        method: 'POST',
        headers: { 'Content-Type': 'application/octet-stream' },
        body: bytes,
      }),
  };
}
