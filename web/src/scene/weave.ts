// Small tiles of cloth that its flat coordinates repeat: thread by thread a little lighter or darker, and how threads stand
// up from the cloth.

import type { Weave } from '../state/fabrics';
import { DataTexture, LinearFilter, LinearMipmapLinearFilter, RepeatWrapping, RGBAFormat } from 'three';

/** Side of the tile in pixels, and in metres of cloth. */
const kSide = 256;
export const kTileMetres = 0.08;

/** The same numbers at every visit. */
function noise(seed: number): () => number {
  let state = seed >>> 0;
  return () => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return state / 2 ** 32;
  };
}

/** Slubs: threads that run the whole tile, thicker in places. */
function threads(random: () => number): Float32Array {
  const values = new Float32Array(kSide * kSide);
  for (let thread = 0; thread < kSide; ++thread) {
    const base = random() - 0.5;
    let slub = 0;
    for (let i = 0; i < kSide; ++i) {
      slub = 0.94 * slub + 0.22 * (random() - 0.5);
      values[thread * kSide + i] = 0.55 * base + slub;
    }
  }
  return values;
}

export function weaveTexture(): DataTexture {
  const random = noise(20030726);
  const warp = threads(random);
  const weft = threads(random);
  const pixels = new Uint8Array(4 * kSide * kSide);
  for (let y = 0; y < kSide; ++y) {
    for (let x = 0; x < kSide; ++x) {
      const over = (x + y) % 2 === 0 ? 0.5 : -0.5;
      const value = 236 + 12 * warp[x * kSide + y]! + 12 * weft[y * kSide + x]! + 2 * over;
      pixels.fill(Math.max(0, Math.min(255, value)), 4 * (y * kSide + x), 4 * (y * kSide + x) + 3);
      pixels[4 * (y * kSide + x) + 3] = 255;
    }
  }
  return tiled(new DataTexture(pixels, kSide, kSide, RGBAFormat));
}

/** Side of a tile of threads in pixels, and in metres of cloth: eight threads or four loops, a little coarser than real. */
const kThreadSide = 64;
const kThreadMetres = 0.0064;

/** Height of the cloth at a place of the tile, both 0 to 8 threads; 0 to 1. */
const kHeights: Record<Weave, (x: number, y: number) => number> = {
  plain: (x, y) => over(x, y, (Math.floor(x) + Math.floor(y)) % 2 === 0),
  twill: (x, y) => over(x, y, (Math.floor(x) + Math.floor(y)) % 4 < 2),
  satin: (x, y) => over(x, y, (Math.floor(x) + 3 * Math.floor(y)) % 8 === 0),
  knit: (x, y) => 0.5 + 0.5 * Math.sin(Math.PI * (y + 1.2 * Math.abs((x % 2) - 1))) * Math.abs(Math.sin((Math.PI * x) / 2)),
  net: (x, y) => Math.max(Math.abs(Math.cos((Math.PI * x) / 4)) ** 8, Math.abs(Math.cos((Math.PI * y) / 4)) ** 8),
  felt: (x, y) => 0.5 + 0.25 * (Math.sin(5.1 * x + 2 * Math.sin(1.57 * y)) + Math.sin(4.7 * y + 2 * Math.sin(1.57 * x))),
};

/** A round thread across or along, whichever lies over the other. */
function over(x: number, y: number, across: boolean): number {
  const [side, along] = across ? [y, x] : [x, y];
  return Math.sin(Math.PI * (side - Math.floor(side))) * (0.6 + 0.4 * Math.sin(Math.PI * (along - Math.floor(along))));
}

/** How light finds the threads. */
export function threadNormals(weave: Weave): DataTexture {
  const height = (i: number, j: number): number => {
    const at = (k: number): number => (8 * ((k + kThreadSide) % kThreadSide)) / kThreadSide;
    return kHeights[weave](at(i), at(j));
  };
  const pixels = new Uint8Array(4 * kThreadSide * kThreadSide);
  for (let j = 0; j < kThreadSide; ++j) {
    for (let i = 0; i < kThreadSide; ++i) {
      const [dx, dy] = [height(i - 1, j) - height(i + 1, j), height(i, j - 1) - height(i, j + 1)];
      const length = Math.hypot(dx, dy, 1);
      const packed = [dx, dy, 1].map((part) => Math.round(127.5 + (127.5 * part) / length));
      pixels.set([...packed, 255], 4 * (j * kThreadSide + i));
    }
  }
  const texture = tiled(new DataTexture(pixels, kThreadSide, kThreadSide, RGBAFormat));
  texture.repeat.setScalar(kTileMetres / kThreadMetres);
  return texture;
}

function tiled(texture: DataTexture): DataTexture {
  texture.wrapS = RepeatWrapping;
  texture.wrapT = RepeatWrapping;
  texture.magFilter = LinearFilter;
  texture.minFilter = LinearMipmapLinearFilter;
  texture.generateMipmaps = true;
  texture.anisotropy = 4;
  texture.needsUpdate = true;
  return texture;
}
