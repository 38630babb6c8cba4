// A small tile of woven structure that the cloth's flat coordinates repeat: thread by thread a little lighter or darker.

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
  const texture = new DataTexture(pixels, kSide, kSide, RGBAFormat);
  texture.wrapS = RepeatWrapping;
  texture.wrapT = RepeatWrapping;
  texture.magFilter = LinearFilter;
  texture.minFilter = LinearMipmapLinearFilter;
  texture.generateMipmaps = true;
  texture.anisotropy = 4;
  texture.needsUpdate = true;
  return texture;
}
