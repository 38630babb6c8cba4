// Pictures on pieces: how they lie on the flat cloth, as the service lays them too. Pure; millimetres unless it says so.

import type { Picture } from '../api/pictures';
import type { Edit, EditOf, Piece, Point, Project, Texture } from '../api/types';

/** The service takes so many edits at once. */
export const kMostEdits = 200;

/** Where a picture lies on a flat piece: repeats per millimetre along its width and height. */
export interface PictureFrame {
  /** A lower left corner of the picture. */
  origin: Point;
  across: Point;
  up: Point;
}

/** A piece with its picture, once that is loaded. */
export interface Look {
  /** Of the picture's file. */
  asset: string;
  texture: Texture;
  picture: Picture;
  frame: PictureFrame;
  /** Of the cloth, which shines through where the picture is not opaque; linear RGB. */
  colour: Piece['colour'];
}

/** The direction of the picture's upright, degrees counter-clockwise from the x axis. */
const uprightOf = (grain: Point | null, texture: Texture): number => {
  const [x, y] = grain ?? [0, 1];
  return (Math.atan2(y, x) * 180) / Math.PI + texture.angle;
};

export function pictureFrame(grain: Point | null, texture: Texture, aspect: number): PictureFrame {
  const angle = (uprightOf(grain, texture) * Math.PI) / 180;
  const [x, y] = [Math.cos(angle), Math.sin(angle)];
  const width = texture.scale_mm;
  const height = width / aspect;
  return { origin: texture.offset, across: [y / width, -x / width], up: [x / height, y / height] };
}

/** Repeats to the right and up from the picture's lower left corner. */
export function repeatsAt({ origin, across, up }: PictureFrame, [x, y]: Point): Point {
  const [dx, dy] = [x - origin[0], y - origin[1]];
  return [dx * across[0] + dy * across[1], dx * up[0] + dy * up[1]];
}

/** Texture coordinates of vertices `first` to `first + count`; `rest` in metres, two numbers a vertex. */
export function fillRepeats(frame: PictureFrame, rest: Float32Array, first: number, count: number, out: Float32Array): void {
  for (let v = 2 * first; v < 2 * (first + count); v += 2) {
    [out[v], out[v + 1]] = repeatsAt(frame, [1000 * rest[v]!, 1000 * rest[v + 1]!]);
  }
}

/** The same for an SVG pattern of one repeat, its y axis down. */
export function patternTransform(grain: Point | null, texture: Texture): string {
  const turned = 90 - uprightOf(grain, texture);
  return `translate(${texture.offset[0]} ${-texture.offset[1]}) rotate(${turned})`;
}

/** Ids of the files that the pieces show. */
export function assetsShown(pieces: readonly Pick<Piece, 'texture'>[], project: Project | null): string[] {
  const ids = pieces.flatMap(({ texture }) => (texture ? (project?.files[texture.image] ?? []) : []));
  return [...new Set(ids)];
}

/** Of each piece with a picture that is there. */
export function looksOf(
  pieces: readonly Pick<Piece, 'id' | 'texture' | 'grain' | 'colour'>[],
  project: Project | null,
  pictures: ReadonlyMap<string, Picture>,
): ReadonlyMap<string, Look> {
  const looks = new Map<string, Look>();
  for (const { id, texture, grain, colour } of pieces) {
    const asset = texture ? project?.files[texture.image] : undefined;
    const picture = asset === undefined ? undefined : pictures.get(asset);
    if (!texture || asset === undefined || !picture) continue;
    const frame = pictureFrame(grain, texture, picture.width / picture.height);
    looks.set(id, { asset, texture, picture, frame, colour });
  }
  return looks;
}

/** Whether an edit changes nothing but a picture on a piece. */
export const isOfPrints = ({ edit }: Edit): boolean => edit === 'set_texture';

/** The name under which a project has a file, or one that is free there. */
export function nameInProject(files: Readonly<Record<string, string>>, name: string, asset: string): string {
  const known = Object.entries(files).find(([, id]) => id === asset);
  if (known) return known[0];
  const dot = name.lastIndexOf('.');
  const [stem, ending] = dot > 0 ? [name.slice(0, dot), name.slice(dot)] : [name, ''];
  let free = name;
  for (let n = 2; free in files; ++n) free = `${stem}-${n}${ending}`;
  return free;
}

const sameTexture = (a: Texture | null, b: Texture | null): boolean =>
  a === b ||
  (a !== null &&
    b !== null &&
    a.image === b.image &&
    a.scale_mm === b.scale_mm &&
    a.angle === b.angle &&
    a.offset[0] === b.offset[0] &&
    a.offset[1] === b.offset[1]);

/** What the pieces show in common: a texture, none, or "mixed". */
export function commonTexture(pieces: readonly Piece[]): Texture | null | 'mixed' {
  const first = pieces[0]?.texture ?? null;
  return pieces.every((piece) => sameTexture(piece.texture, first)) ? first : 'mixed';
}

/** It says all of the texture. */
export type TextureEdit = EditOf<'set_texture'> & { texture?: Texture };

/** Edits that give each of the pieces what `texture` makes of it; those that have it already are left out. */
export function textureEdits(pieces: readonly Piece[], texture: (piece: Piece) => Texture | null): TextureEdit[] {
  return pieces.flatMap((piece): TextureEdit[] => {
    const wanted = texture(piece);
    if (sameTexture(piece.texture, wanted)) return [];
    return [{ edit: 'set_texture', piece: piece.id, ...(wanted && { texture: wanted }) }];
  });
}
