// Files that somebody dropped on the page: what they are, whether a project can be made of them, and when not, what is
// missing and how to get on. Pure but for reading the files' text.

export interface GivenFile {
  /** Name without folders. */
  name: string;
  blob: Blob;
}

export interface IntakePlan {
  /** The project document's text, parsed; null when there is none or it is broken. */
  document: Record<string, unknown> | null;
  documentName: string;
  name: string;
  /** Files that the document names, with their kind and, when it was given, the file. */
  needed: { name: string; kind: 'dxf' | 'body'; file: GivenFile | null }[];
  /** Given, but the document does not name them. */
  unused: string[];
  problems: IntakeProblem[];
  /** Pieces read out of a DXF that came without a document. */
  loose: { dxf: GivenFile; pieces: string[] } | null;
  ready: boolean;
}

export interface IntakeProblem {
  code: string;
  text: string;
  where: string;
}

/** Largest document and file that are read here; the service has its own limits. */
export const kLargestDocument = 4 * 1024 * 1024;
export const kLargestFile = 64 * 1024 * 1024;

const kBodyFile = /\.(obj|gltf|glb|ply|stl|fbx|dae)$/i;
const isDxf = (name: string): boolean => /\.dxf$/i.test(name);
const isJson = (name: string): boolean => /\.json$/i.test(name);
const baseName = (path: string): string => path.slice(path.lastIndexOf('/') + 1);
const sameName = (a: string, b: string): boolean => baseName(a).toLowerCase() === baseName(b).toLowerCase();

const isObject = (value: unknown): value is Record<string, unknown> =>
  typeof value === 'object' && value !== null && !Array.isArray(value);
const listOf = (value: unknown): Record<string, unknown>[] => (Array.isArray(value) ? value.filter(isObject) : []);

/** The files that a project document names, each once, in the order of their first mention. */
export function filesNamedBy(document: Record<string, unknown>): { name: string; kind: 'dxf' | 'body' }[] {
  const named = new Map<string, 'dxf' | 'body'>();
  for (const piece of listOf(document.pieces)) {
    if (isObject(piece.from) && typeof piece.from.dxf === 'string') named.set(piece.from.dxf, 'dxf');
  }
  for (const body of listOf(document.bodies)) {
    if (typeof body.file === 'string' && body.file !== '') named.set(body.file, 'body');
  }
  return [...named].map(([name, kind]) => ({ name, kind }));
}

/** Names of the pieces (blocks) in a DXF's text, in the file's order. Enough to show what came; the service reads it properly. */
export function piecesNamedIn(dxf: string): string[] {
  const lines = dxf.split(/\r\n|\r|\n/);
  const names: string[] = [];
  let inBlock = false;
  for (let i = 0; i + 1 < lines.length; i += 2) {
    const code = lines[i]!.trim();
    const value = lines[i + 1]!.trim();
    if (code === '0') inBlock = value === 'BLOCK';
    else if (inBlock && code === '2') {
      if (!value.startsWith('*') && !names.includes(value)) names.push(value);
      inBlock = false;
    }
  }
  return names;
}

/** A document to begin with: the DXF's pieces, one fabric, the program's mannequin; seams are for a person to add. */
export function starterDocument(dxf: string, pieces: readonly string[]): Record<string, unknown> {
  const placed = pieces.map((piece, i) => ({
    id: piece,
    from: { dxf, piece },
    fabric: 'cotton',
    placement: { wrapped: { radius: 0.3, angle: Math.round((360 * i) / pieces.length), height: 1.1 } },
  }));
  const cotton = {
    id: 'cotton',
    name: 'Plain-woven cotton',
    areal_mass_g_m2: 150,
    stretch_warp_n_m: 2500,
    stretch_weft_n_m: 1800,
    stretch_coupling_n_m: 400,
    stretch_shear_n_m: 500,
    bend_warp_un_m: 10,
    bend_weft_un_m: 8,
    bend_bias_un_m: 7,
    thickness_mm: 0.4,
    friction: 0.35,
    colour: [0.55, 0.62, 0.72],
  };
  return {
    toile: 1,
    name: dxf.replace(/\.dxf$/i, ''),
    pieces: placed,
    fabrics: [cotton],
    seams: [],
    bodies: [{ id: 'body', mannequin: { height_cm: 170 } }],
  };
}

async function readDocument(file: GivenFile, problems: IntakeProblem[]): Promise<Record<string, unknown> | null> {
  if (file.blob.size > kLargestDocument) {
    problems.push({ code: 'json.too_large', text: 'A project document has at most 4 MiB.', where: file.name });
    return null;
  }
  try {
    const value: unknown = JSON.parse(await file.blob.text());
    if (isObject(value) && 'toile' in value) return value;
    problems.push({
      code: 'project.format',
      text: 'This JSON file is no Toile project: it has no key "toile".',
      where: file.name,
    });
  } catch (error) {
    problems.push({ code: 'json.malformed', text: `Not valid JSON: ${(error as Error).message}`, where: file.name });
  }
  return null;
}

/** Looks at everything given so far; of files with the same name the last one counts. */
export async function planIntake(given: readonly GivenFile[]): Promise<IntakePlan> {
  const files = given.filter((file, i) => !given.slice(i + 1).some((later) => sameName(later.name, file.name)));
  const problems: IntakeProblem[] = [];
  for (const { name, blob } of files) {
    if (blob.size > kLargestFile)
      problems.push({ code: 'file.too_large', text: 'Files have at most 64 MiB.', where: name });
    else if (!isDxf(name) && !isJson(name) && !kBodyFile.test(name)) {
      problems.push({
        code: 'file.kind',
        text: 'Neither a project (.json), a pattern (.dxf) nor a body (.obj, .glb, …).',
        where: name,
      });
    }
  }
  const documents = files.filter((file) => isJson(file.name));
  if (documents.length > 1) {
    problems.push({
      code: 'project.several',
      text: 'One project at a time: leave one document away.',
      where: documents.map((d) => d.name).join(', '),
    });
  }
  const document = documents.length === 1 ? await readDocument(documents[0]!, problems) : null;
  return document ? planWith(document, documents[0]!.name, files, problems) : planWithout(files, problems);
}

function planWith(
  document: Record<string, unknown>,
  documentName: string,
  files: readonly GivenFile[],
  problems: IntakeProblem[],
): IntakePlan {
  const needed = filesNamedBy(document).map((need) => ({
    ...need,
    file: files.find((file) => sameName(file.name, need.name)) ?? null,
  }));
  const unused = files
    .filter((file) => !isJson(file.name) && !needed.some((need) => need.file === file))
    .map((file) => file.name);
  const ready = problems.length === 0 && needed.every((need) => need.file !== null);
  const name =
    typeof document.name === 'string' && document.name ? document.name : documentName.replace(/\.json$/i, '');
  return { document, documentName, name, needed, unused, problems, loose: null, ready };
}

async function planWithout(files: readonly GivenFile[], problems: IntakeProblem[]): Promise<IntakePlan> {
  const dxf = files.find((file) => isDxf(file.name) && file.blob.size <= kLargestFile);
  const loose = dxf ? { dxf, pieces: piecesNamedIn(await dxf.blob.text()) } : null;
  const unused = files.filter((file) => file !== dxf && !isJson(file.name)).map((file) => file.name);
  return { document: null, documentName: '', name: dxf?.name ?? '', needed: [], unused, problems, loose, ready: false };
}
