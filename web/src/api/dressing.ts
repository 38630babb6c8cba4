// Bodies, places and the look before a drape, as the service tells them. Lengths in metres unless the key says otherwise.

import { decodeBody, type BodyMesh } from './body';
import { decodeTopology, type ClothTopology } from './frames';
import { ApiError, Http, kLongPatience } from './http';
import type { Answer, Asset, One, Project, Question, Schemas } from './types';

export type Place = Schemas['Place'];
export type Mannequin = Schemas['Mannequin'];
export type Sex = BodyPreset['sex'];
export type MeasureName = Schemas['MeasureName'];
export type BodyTables = Schemas['BodyPresets'];
export type BodyPreset = One<BodyTables['presets']>;
export type MeasureRule = One<BodyTables['measures']>;

export type Figure = Schemas['Figure'];
export type TakenMeasure = One<Figure['measures']>;
export type Landmark = One<Figure['landmarks']>;
export type PartBox = One<Figure['boxes']>;
export type ProjectBody = Schemas['ProjectBody'];
export type Stance = NonNullable<Schemas['Stance']>;

/** Who is to be dressed. */
export type BodyWish = Question<'dressProject'>;

export type Finding = Schemas['Finding'];
export type Severity = Finding['severity'];
export type Check = Schemas['Check'];
export type Arrangement = Schemas['Arrangement'];
export type BodyPart = Schemas['BodyPart'];
export type BoxSide = Schemas['BoxSide'];

/** Where a hand puts a piece: all that may be left out is said. */
export type PieceWish = NonNullable<One<Check['pieces']>['by_hand']> &
  Pick<Question<'placePiece'>, 'piece' | 'with_partner'>;

/** The pieces where a drape would begin. */
export interface Start {
  topology: ClothTopology;
  positions: Float32Array;
}

export interface DressingApi {
  tables(): Promise<BodyTables>;
  bodies(project: string): Promise<ProjectBody[]>;
  mesh(project: string): Promise<BodyMesh>;
  stance(asset: string): Promise<Answer<'showBodyFigure'>>;
  dress(project: Project, body: string, wish: BodyWish): Promise<Project>;
  undress(project: Project, body: string): Promise<Project>;
  /** Moves a landmark to the skin nearest to the place, or adds one. */
  mark(project: Project, body: string, landmark: string, place: Place): Promise<Project>;
  unmark(project: Project, body: string, landmark: string): Promise<Project>;
  arrange(project: Project): Promise<Answer<'arrangeProject'>>;
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
  const changing = (project: Project): Record<string, string> => ({ 'If-Match': `"${project.revision}"` });
  return {
    tables: () => http.get('/bodies/presets'),
    bodies: async (id) => (await http.get<Answer<'showProjectBodies'>>(`${one(id)}/bodies`)).bodies,
    mesh: async (id) => decodeBody(await http.bytes(`${one(id)}/body`)),
    stance: (asset) => http.get(`/bodies/${part(asset)}/figure`),
    dress: (project, body, wish) =>
      http.json(`${one(project.id)}/bodies/${part(body)}`, {
        method: 'PUT',
        headers: { 'Content-Type': 'application/json', ...changing(project) },
        body: JSON.stringify(wish),
      }),
    undress: (project, body) =>
      http.json(`${one(project.id)}/bodies/${part(body)}`, { method: 'DELETE', headers: changing(project) }),
    mark: (project, body, landmark, place) =>
      http.json(`${one(project.id)}/bodies/${part(body)}/landmarks/${part(landmark)}`, {
        method: 'PUT',
        headers: { 'Content-Type': 'application/json', ...changing(project) },
        body: JSON.stringify({ place } satisfies Question<'moveLandmark'>),
      }),
    unmark: (project, body, landmark) =>
      http.json(`${one(project.id)}/bodies/${part(body)}/landmarks/${part(landmark)}`, {
        method: 'DELETE',
        headers: changing(project),
      }),
    arrange: (project) => http.post(`${one(project.id)}/arrange`, undefined, changing(project)),
    place: (project, wish) => http.post(`${one(project.id)}/place`, wish, changing(project)),
    // The service may put the garment on to see whether it can be: that takes it longer.
    check: (id) => http.get(`${one(id)}/check`, kLongPatience),
    start: async (id) => decodeStart(await http.bytes(`${one(id)}/start`, kLongPatience)),
    upload: (name, bytes) =>
      http.json(`/bodies?name=${part(name)}`, {
        method: 'POST',
        headers: { 'Content-Type': 'application/octet-stream' },
        body: bytes,
      }),
  };
}
