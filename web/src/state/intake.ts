// Files that somebody dropped on the page: what they are, whether a project can be made of them, and when not, what is
// missing and how to get on. Pure but for reading the files' text.

import { hasEnding, kPictureEndings } from '../api/formats';
import { t } from '../texts/language';
import { isObject, listOf } from './documents';

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
  needed: { name: string; kind: 'dxf' | 'body' | 'image'; file: GivenFile | null }[];
  /** Given, but the document does not name them. */
  unused: string[];
  problems: IntakeProblem[];
  /** A pattern that came without a document: the service reads it, and a project is made of what it holds. */
  loose: LoosePattern | null;
  ready: boolean;
}

export interface LoosePattern {
  kind: 'dxf' | 'specification';
  file: GivenFile;
  /** Files that may be the body. */
  bodies: GivenFile[];
}

export interface IntakeProblem {
  code: string;
  text: string;
  where: string;
}

/** Largest document and file that are read here; the service has its own limits. */
export const kLargestDocument = 4 * 1024 * 1024;
const kLargestFile = 64 * 1024 * 1024;

/** A file that can lie on cloth. */
export const isPicture = (name: string): boolean => hasEnding(name, kPictureEndings);
const isDxf = (name: string): boolean => hasEnding(name, ['.dxf']);
const isJson = (name: string): boolean => hasEnding(name, ['.json']);
/** What a mesh's name may end with; as long as that is not known, a file that is nothing else may be one. */
const isMesh = (name: string, endings: readonly string[] | null): boolean =>
  endings ? hasEnding(name, endings) : !isDxf(name) && !isJson(name) && !isPicture(name);
const baseName = (path: string): string => path.slice(path.lastIndexOf('/') + 1);
const sameName = (a: string, b: string): boolean => baseName(a).toLowerCase() === baseName(b).toLowerCase();

/** The files that a project document names, each once, in the order of their first mention. */
export function filesNamedBy(document: Record<string, unknown>): { name: string; kind: 'dxf' | 'body' | 'image' }[] {
  const named = new Map<string, 'dxf' | 'body' | 'image'>();
  for (const piece of listOf(document.pieces)) {
    if (isObject(piece.from) && typeof piece.from.dxf === 'string') named.set(piece.from.dxf, 'dxf');
    if (isObject(piece.texture) && typeof piece.texture.image === 'string') named.set(piece.texture.image, 'image');
  }
  for (const body of listOf(document.bodies)) {
    if (typeof body.file === 'string' && body.file !== '') named.set(body.file, 'body');
  }
  return [...named].map(([name, kind]) => ({ name, kind }));
}

interface ReadJson {
  document: Record<string, unknown> | null;
  specification: boolean;
}

/** A specification of GarmentCode has its panels under "pattern". */
const isSpecification = (value: Record<string, unknown>): boolean =>
  isObject(value.pattern) && isObject(value.pattern.panels);

async function readJson(file: GivenFile, problems: IntakeProblem[]): Promise<ReadJson> {
  if (file.blob.size > kLargestDocument) {
    problems.push({ code: 'json.too_large', text: t.intake.problems.documentSize, where: file.name });
    return { document: null, specification: false };
  }
  try {
    const value: unknown = JSON.parse(await file.blob.text());
    if (isObject(value) && 'toile' in value) return { document: value, specification: false };
    if (isObject(value) && isSpecification(value)) return { document: null, specification: true };
    problems.push({
      code: 'project.format',
      text: t.intake.problems.format,
      where: file.name,
    });
  } catch (error) {
    problems.push({ code: 'json.malformed', text: t.intake.problems.json((error as Error).message), where: file.name });
  }
  return { document: null, specification: false };
}

function problemsOfFile({ name, blob }: GivenFile, meshes: readonly string[] | null): IntakeProblem[] {
  if (blob.size > kLargestFile) return [{ code: 'file.too_large', text: t.intake.problems.fileSize, where: name }];
  if (isDxf(name) || isJson(name) || isPicture(name) || isMesh(name, meshes)) return [];
  const text = t.intake.problems.kind;
  return [{ code: 'file.kind', text, where: name }];
}

/**
 * Looks at everything given so far; of files with the same name the last one counts. `meshes` are the endings of their
 * names; null where they are not known.
 */
export async function planIntake(
  given: readonly GivenFile[],
  meshes: readonly string[] | null,
): Promise<IntakePlan> {
  const files = given.filter((file, i) => !given.slice(i + 1).some((later) => sameName(later.name, file.name)));
  const problems = files.flatMap((file) => problemsOfFile(file, meshes));
  const documents = files.filter((file) => isJson(file.name));
  if (documents.length > 1) {
    problems.push({
      code: 'project.several',
      text: t.intake.problems.several,
      where: documents.map((d) => d.name).join(', '),
    });
  }
  const json = documents.length === 1 ? await readJson(documents[0]!, problems) : null;
  if (json?.document) return planWith(json.document, documents[0]!.name, files, problems);
  const bodies = files.filter((file) => isMesh(file.name, meshes) && file.blob.size <= kLargestFile);
  return planWithout(files, json?.specification ? documents[0]! : null, bodies, problems);
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

function planWithout(
  files: readonly GivenFile[],
  specification: GivenFile | null,
  bodies: GivenFile[],
  problems: IntakeProblem[],
): IntakePlan {
  // Of several the newest counts.
  const drawings = files.filter((file) => isDxf(file.name) && file.blob.size <= kLargestFile);
  const pattern = specification ?? drawings[drawings.length - 1] ?? null;
  const loose: LoosePattern | null = pattern && {
    kind: specification ? 'specification' : 'dxf',
    file: pattern,
    bodies,
  };
  const used = (file: GivenFile): boolean => file === pattern || (loose !== null && bodies.includes(file));
  const unused = files.filter((file) => !used(file) && !isJson(file.name)).map((file) => file.name);
  return {
    document: null,
    documentName: '',
    name: pattern?.name ?? '',
    needed: [],
    unused,
    problems,
    loose,
    ready: false,
  };
}
