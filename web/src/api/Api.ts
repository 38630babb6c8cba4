// The service's routes as functions. Everything above this file talks to the service through it.

import { makeAdminApi, type AdminApi } from './admin';
import { decodeBody, type BodyMesh } from './body';
import { Http, kLongPatience, matching } from './http';
import { makeLinkApi, type LinkApi } from './links';
import { makePatternUrls, type PatternUrls } from './patternFiles';
import { makeSweepApi, type SweepApi } from './sweeps';
import { makeSessionApi, type SessionApi } from './session';
import { makeVersionApi, type VersionApi } from './versions';
import type {
  Answer,
  Asset,
  Edit,
  EditStep,
  Fabric,
  Import,
  Job,
  Layer,
  LayerMap,
  MovieKind,
  MovieOrder,
  StillOrder,
  StillWish,
  Pieces,
  Project,
  Question,
  Report,
  SeamProposal,
  SeenPieces,
  Unit,
} from './types';

export type JobAction = 'pause' | 'resume' | 'step' | 'cancel';

export interface Api extends SessionApi, AdminApi, LinkApi, PatternUrls, SweepApi, VersionApi {
  projects(): Promise<Project[]>;
  project(id: string): Promise<Project>;
  createProject(document: unknown, files: Record<string, string>): Promise<Project>;
  /** With its drapes, and the files that nobody else uses. */
  removeProject(id: string): Promise<void>;
  pieces(projectId: string): Promise<Pieces>;
  /** All edits or none; `revision` is the one that they were made for. `files` (name → asset) come to the project's own. */
  edit(projectId: string, revision: number, edits: Edit[], files?: Record<string, string>): Promise<Project>;
  turn(projectId: string, revision: number, way: 'undo' | 'redo'): Promise<Project>;
  /** Newest first. */
  history(projectId: string): Promise<EditStep[]>;
  proposals(projectId: string): Promise<SeamProposal[]>;
  /** `layers`: what those of a DXF stand for, where a person says so. */
  importPattern(asset: string, unit: Unit | '', size: string, layers: LayerMap): Promise<Import>;
  /** Of an uploaded DXF, as they are usually read. */
  layers(asset: string): Promise<Layer[]>;
  bodies(): Promise<Asset[]>;
  /** Uploaded pictures, newest first. */
  images(): Promise<Asset[]>;
  /** The fabrics that pieces may be cut of, by name. */
  fabrics(): Promise<Fabric[]>;
  /** Size tables for mannequins. */
  bodyPresets(): Promise<{ id: string }[]>;
  /** Stands the pieces around the body: one step of the history. */
  arrange(projectId: string, revision: number): Promise<Project>;
  uploadAsset(kind: Asset['kind'], name: string, bytes: Blob): Promise<Asset>;
  /** Newest first, without those of sweeps. */
  jobs(): Promise<Job[]>;
  job(id: string): Promise<Job>;
  /** `key` makes asking twice (a lost answer) start one drape only. */
  /** `from`: a job from whose end to go on. */
  submit(projectId: string, key: string, from?: string): Promise<Job>;
  /** One that has ended, with its results. */
  removeJob(id: string): Promise<void>;
  act(id: string, action: JobAction): Promise<Job>;
  /** The project as it is by now in place of a drape under way, from how its cloth hangs. */
  goOn(id: string, key: string): Promise<Job>;
  /** Colours and fabrics with which it is draped. */
  seenPieces(id: string): Promise<SeenPieces>;
  report(id: string): Promise<Report>;
  resultText(id: string, name: string): Promise<string>;
  body(id: string): Promise<BodyMesh>;
  /** Asks for it; asking again tells how it stands, and tries again what has failed. */
  makeMovie(id: string, kind: MovieKind): Promise<MovieOrder>;
  movies(id: string): Promise<MovieOrder[]>;
  /** As makeMovie(), for a still. */
  takeStill(id: string, wish: StillWish): Promise<StillOrder>;
  takenStills(id: string): Promise<StillOrder[]>;
  /** `width`: of a still that is made smaller, pixels. */
  resultUrl(id: string, name: string, width?: number): string;
  assetUrl(id: string): string;
  streamUrl(id: string): string;
}

const part = encodeURIComponent;
const kBytes = { 'Content-Type': 'application/octet-stream' };

/** What has files of its own. */
const otherRoutes = (http: Http): SessionApi & AdminApi & LinkApi & PatternUrls & SweepApi & VersionApi => ({
  ...makeSessionApi(http),
  ...makeAdminApi(http),
  ...makeLinkApi(http),
  ...makePatternUrls(http),
  ...makeSweepApi(http),
  ...makeVersionApi(http),
});

const keyed = (key: string) => ({ 'Idempotency-Key': key });

const importWish = (asset: string, unit: Unit | '', size: string, layers: LayerMap): Question<'importPattern'> => ({
  asset,
  ...(unit && { unit }),
  ...(size && { size }),
  ...(Object.keys(layers).length > 0 && { layers }),
});

const submission = (project_id: string, from?: string): Question<'submitJob'> => ({
  project_id,
  priority: 'interactive',
  ...(from ? { from } : {}),
});

export function makeApi(http = new Http('/api/v1')): Api {
  const result = (id: string, name: string): string =>
    `/jobs/${part(id)}/results/${name.split('/').map(part).join('/')}`;
  return {
    ...otherRoutes(http),
    projects: async () => (await http.get<Answer<'listProjects'>>('/projects?limit=100')).projects,
    project: (id) => http.get(`/projects/${part(id)}`),
    createProject: (document, files) => http.post('/projects', { document, files }),
    removeProject: async (id) => void (await http.send(`/projects/${part(id)}?data=true`, { method: 'DELETE' })),
    pieces: (id) => http.get(`/projects/${part(id)}/pieces`),
    edit: (id, revision, edits, files = {}) =>
      http.post(
        `/projects/${part(id)}/edits`,
        { edits, files } satisfies Question<'editProject'>,
        matching(revision),
      ),
    turn: (id, revision, way) => http.post(`/projects/${part(id)}/${way}`, undefined, matching(revision)),
    history: async (id) => (await http.get<Answer<'listEdits'>>(`/projects/${part(id)}/edits?limit=100`)).edits,
    proposals: async (id) =>
      (await http.get<Answer<'proposeSeams'>>(`/projects/${part(id)}/proposals`, kLongPatience)).proposals,
    importPattern: (asset, unit, size, layers) =>
      http.post('/imports', importWish(asset, unit, size, layers), {}, kLongPatience),
    layers: async (asset) => (await http.get<Answer<'listLayers'>>(`/assets/${part(asset)}/layers`)).layers,
    bodies: async () => (await http.get<Answer<'listBodies'>>('/bodies')).assets,
    images: async () => (await http.get<Answer<'listAssets'>>('/assets?kind=image')).assets,
    fabrics: async () => (await http.get<Answer<'listFabrics'>>('/fabrics')).fabrics,
    bodyPresets: async () =>
      (await http.get<Answer<'listBodyPresets'>>('/bodies/presets')).presets.map(({ name }) => ({ id: name })),
    arrange: (id, revision) => http.post(`/projects/${part(id)}/arrange`, undefined, matching(revision)),
    uploadAsset: (kind, name, bytes) => {
      const path = `/assets?kind=${kind}&name=${part(name)}`;
      return http.json(path, { method: 'POST', headers: kBytes, body: bytes });
    },
    jobs: async () => (await http.get<Answer<'listJobs'>>('/jobs?limit=100&sweep=none')).jobs,
    job: (id) => http.get(`/jobs/${part(id)}`),
    submit: (id, key, from) => http.post('/jobs', submission(id, from), keyed(key)),
    removeJob: async (id) => void (await http.send(`/jobs/${part(id)}`, { method: 'DELETE' })),
    goOn: (id, key) => http.post(`/jobs/${part(id)}/go_on`, undefined, keyed(key)),
    act: (id, action) => http.post(`/jobs/${part(id)}/${action}`),
    seenPieces: (id) => http.get(`/jobs/${part(id)}/pieces`),
    report: (id) => http.get(result(id, 'report.json')),
    resultText: (id, name) => http.text(result(id, name)),
    body: async (id) => decodeBody(await http.bytes(`/jobs/${part(id)}/body`)),
    makeMovie: async (id, kind) => {
      const wish = { kind } satisfies Question<'makeMovie'>;
      return (await http.post<{ movie: MovieOrder }>(`/jobs/${part(id)}/movies`, wish)).movie;
    },
    movies: async (id) => (await http.get<Answer<'listMovies'>>(`/jobs/${part(id)}/movies`)).movies,
    takeStill: async (id, wish) =>
      (await http.post<{ still: StillOrder }>(`/jobs/${part(id)}/stills`, wish satisfies Question<'takeStill'>)).still,
    takenStills: async (id) => (await http.get<Answer<'listStills'>>(`/jobs/${part(id)}/stills`)).stills,
    resultUrl: (id, name, width) => http.url(result(id, name) + (width ? `/small?width=${width}` : '')),
    assetUrl: (id) => http.url(`/assets/${part(id)}/content`),
    streamUrl: (id) => http.socketUrl(`/jobs/${part(id)}/stream`),
  };
}
