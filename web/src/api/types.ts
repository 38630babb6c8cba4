// What the service says, as JSON: short names for what proto/openapi.yaml and proto/asyncapi.yaml describe. Keys are the
// service's own (snake_case), so that nothing is renamed on the way.

import type { components, operations } from './generated/contract';

export type Schemas = components['schemas'];
export type One<List extends readonly unknown[]> = List[number];

/** The JSON with which an operation answers well. */
export type Answer<Operation extends keyof operations> = {
  [Status in keyof operations[Operation]['responses']]: Status extends 200 | 201
    ? operations[Operation]['responses'][Status] extends { content: { 'application/json': infer Body } }
      ? Body
      : never
    : never;
}[keyof operations[Operation]['responses']];

/** The JSON that an operation takes. */
export type Question<Operation extends keyof operations> = operations[Operation] extends {
  requestBody: { content: { 'application/json': infer Body } };
}
  ? Body
  : never;

/** What the pages of a printed pattern are. */
export type Paper = Schemas['Paper'];
export type JobState = Schemas['JobState'];
export type Progress = Schemas['Progress'];
/** A drape that was asked for. Lists leave out the report, the stream's last message also the progress. */
export type Job = Schemas['JobFields'] & { progress?: Progress | null; report?: Report | null; sweep?: Schemas['CellOfSweep'] };

/** report.json. The service keeps those of its older versions, in which stretch and squeeze are not told apart. */
export type Report = Omit<Schemas['report.schema'], 'strain'> & {
  strain: { warp: Stretch; weft: Stretch; shear: Strain };
};
export type Strain = Schemas['figures'];
export type Stretch = Strain & Partial<Schemas['stretch_figures']>;

/** Lists leave out the document. */
export type Project = Schemas['ProjectFields'] & { document?: Document };
export type Document = Schemas['Document'];
export type Asset = Schemas['Asset'];
export type Fabric = Schemas['Fabric'];
/** A step of a project's history. */
export type EditStep = Schemas['EditStep'];
/** How a movie stands that was asked for. */
export type MovieOrder = Schemas['Movie'];
/** By which a job is shown to others, and what they may take home. */
export type ShareLink = Schemas['Link'];
export type Taking = Schemas['Taking'];
/** A job as a link shows it. */
export type SharedJob = Omit<Schemas['SharedJob'], 'report'> & { report: Report | null };
/** Who asks, and what they may. */
export type Session = Schemas['Session'];
/** How a still stands that was asked for, and what is asked. */
export type StillOrder = Schemas['Still'];
export interface StillWish {
  eye: [number, number, number];
  target: [number, number, number];
  angle: number;
  width: number;
  height: number;
  transparent: boolean;
  /** What the cloth is coloured by, with a legend; without: as it looks. */
  map?: NonNullable<Question<'takeStill'>['map']>;
}
export type MovieKind = 'drape' | 'turntable';
export type Edit = One<Schemas['EditList']>;
export type EditOf<Kind extends Edit['edit']> = Extract<Edit, { edit: Kind }>;

/** Pieces and seams for a drawing; millimetres, y up. */
export type Pieces = Omit<Schemas['Pieces'], 'pieces'> & { pieces: Piece[] };
/** A piece as it is cut, of a project or of a file that is not one yet: the latter may be without a grain. */
export type Piece = Omit<One<Schemas['Pieces']['pieces']>, 'grain'> & { grain: Point | null };
/** What a job keeps of the look of its pieces, whatever becomes of the project. */
export type SeenPieces = Schemas['SeenPieces'];
export type SeenPiece = One<SeenPieces['pieces']>;
export type PieceEdge = One<Piece['edges']>;
export type Notch = One<Piece['notches']>;
export type Texture = NonNullable<Piece['texture']>;
export type Point = Schemas['Point'];
/** Four control points of a cubic Bézier. */
export type Curve = One<PieceEdge['curves']>;
/** A seam as the document has it. */
export type SeamSides = Schemas['seam'];
export type SeamEdge = One<SeamSides['a']>;
/** A seam with its lengths and what may be wrong with it. */
export type Seam = One<Pieces['seams']>;
export type SeamProposal = Schemas['SeamProposal'];

/** What a pattern file holds. */
export type Import = Schemas['Import'];
export type ImportedPiece = Schemas['ImportedPiece'];
export type ImportedEntity = One<Import['report']['entities']>;
export type ImportWarning = One<Import['report']['warnings']>;
export type Layer = One<Import['layers']>;
export type LayerMap = NonNullable<Question<'importPattern'>['layers']>;
/** What a layer may be given. */
export type LayerRole = LayerMap[string];
export type Unit = NonNullable<Question<'importPattern'>['unit']>;

/** What a viewer may say on a job's stream. */
export type StreamWord = Schemas['Control'] | Schemas['Pull'] | Schemas['Pin'] | Schemas['Unpin'];

/** Text messages of a job's stream. */
export type StreamText =
  | Schemas['JobMessage']
  | Schemas['ProgressMessage']
  | Schemas['EndedMessage']
  | Schemas['ErrorMessage'];
