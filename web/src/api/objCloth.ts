// The cloth of a drape that nobody streams any more, read from its final.obj: the page shows it as if it were a frame.

import type { ClothTopology, TopologyPiece } from './frames';

export interface ClothFromObj {
  topology: ClothTopology;
  positions: Float32Array<ArrayBuffer>;
}

const kColour: [number, number, number] = [0.55, 0.62, 0.72];

const colourOf = (piece: KnownPiece | undefined): [number, number, number] =>
  [...(piece?.colour ?? kColour)] as [number, number, number];

/** What is known of a piece beside the file. */
export interface KnownPiece {
  id: string;
  colour: readonly number[];
}

/** A name in OBJ ends at a blank: the service writes "_" for each, and for control characters. */
 
const objName = (id: string): string => id.replace(/[\x00-\x20\x7f]/g, '_') || '_';

/**
 * Reads "v", "vt" (flat places), "o" and three-cornered "f" lines; one object is one piece, which has its own id again
 * where `known` has it; a plain file is one piece, the first. @throws RangeError on anything unusable.
 */
export function clothFromObj(text: string, known: readonly KnownPiece[]): ClothFromObj {
  const xyz: number[] = [];
  const flat: number[] = [];
  const corners: number[] = [];
  const pieces: { id: string; first: number; last: number }[] = [];
  for (const line of text.split('\n')) {
    const words = line.trim().split(/\s+/);
    if (words[0] === 'v') xyz.push(Number(words[1]), Number(words[2]), Number(words[3]));
    else if (words[0] === 'vt') flat.push(Number(words[1]), Number(words[2]));
    else if (words[0] === 'o') pieces.push({ id: words.slice(1).join(' '), first: Infinity, last: -1 });
    else if (words[0] === 'f') addFace(words, corners, pieces);
  }
  const vertexCount = xyz.length / 3;
  if (vertexCount === 0 || corners.some((v) => !(v >= 0 && v < vertexCount)) || xyz.some((x) => !Number.isFinite(x))) {
    throw new RangeError('obj: no usable mesh');
  }
  const byName = new Map(known.map((piece) => [objName(piece.id), piece]));
  const listed = pieces
    .filter((piece) => piece.last >= 0)
    .map(
      (piece): TopologyPiece => ({
        id: byName.get(piece.id)?.id ?? piece.id,
        firstVertex: piece.first,
        vertexCount: piece.last + 1 - piece.first,
        colour: colourOf(byName.get(piece.id)),
      }),
    );
  if (listed.length === 0) {
    listed.push({ id: '', firstVertex: 0, vertexCount, colour: colourOf(known[0]) });
  }
  const topology: ClothTopology = {
    epoch: 0,
    vertexCount,
    origin: [0, 0, 0],
    step: 1e-4,
    pieces: listed,
    rest: new Float32Array(flat.length === 2 * vertexCount ? flat : seenFromAhead(xyz)),
    triangles: new Uint32Array(corners),
    sewn: sewnByPlace(xyz),
  };
  return { topology, positions: new Float32Array(xyz) };
}

/** Flat places for cloth that comes without: all in one point a texture could not be drawn at all. */
function seenFromAhead(xyz: readonly number[]): number[] {
  return xyz.filter((_, i) => i % 3 < 2);
}

function addFace(words: string[], corners: number[], pieces: { first: number; last: number }[]): void {
  const piece = pieces[pieces.length - 1];
  for (const word of words.slice(1, 4)) {
    const vertex = parseInt(word, 10) - 1;
    corners.push(vertex);
    if (!piece) continue;
    piece.first = Math.min(piece.first, vertex);
    piece.last = Math.max(piece.last, vertex);
  }
}

/** Vertices in the very same place are sewn to each other: the drape has closed its seams. */
function sewnByPlace(xyz: readonly number[]): Uint32Array {
  const firstAt = new Map<string, number>();
  const pairs: number[] = [];
  for (let v = 0; 3 * v < xyz.length; ++v) {
    const place = xyz
      .slice(3 * v, 3 * v + 3)
      .map((x) => Math.round(x * 1e6))
      .join();
    const first = firstAt.get(place);
    if (first === undefined) firstAt.set(place, v);
    else pairs.push(first, v);
  }
  return new Uint32Array(pairs);
}
