// The golden messages of ../fixtures/frames as the tests read them. Loaded by Vite, so that no test needs Node.

import golden from '../fixtures/frames/frames.json';
import type { DecodedFrame } from './frameCodec';
import type { Topology } from './topologyCodec';

const files = import.meta.glob<string>('../fixtures/frames/*.bin', {
  query: '?url&inline',
  import: 'default',
  eager: true,
});

function fileBytes(name: string): Uint8Array {
  const url = files[`../fixtures/frames/${name}`];
  if (url === undefined) throw new Error(`no golden file ${name}`);
  return Uint8Array.from(atob(url.slice(url.indexOf(',') + 1)), (c) => c.charCodeAt(0));
}

export interface GoldenFrame extends DecodedFrame {
  file: string;
  bytes: Uint8Array;
  before: Int16Array;
}

export const goldenFrames: GoldenFrame[] = golden.frames.map((f) => ({
  file: f.file,
  bytes: fileBytes(f.file),
  header: { key: f.key, epoch: f.epoch, seq: f.seq, step: f.step, time: Math.fround(f.time) },
  before: Int16Array.from(f.before),
  grid: Int16Array.from(f.grid),
}));

type Triple = [number, number, number];

export const goldenTopologies: { file: string; bytes: Uint8Array; topology: Topology }[] = golden.topologies.map(
  (t) => ({
    file: t.file,
    bytes: fileBytes(t.file),
    topology: {
      epoch: t.epoch,
      origin: t.origin as Triple,
      step: t.step,
      vertexCount: t.rest.length,
      pieces: t.pieces.map((p) => ({
        id: p.id,
        firstVertex: p.first_vertex,
        vertexCount: p.vertex_count,
        colour: p.colour.map(Math.fround) as Triple,
      })),
      rest: Float32Array.from(t.rest.flat()),
      triangles: Uint32Array.from(t.triangles.flat()),
      sewn: Uint32Array.from(t.sewn.flat()),
    },
  }),
);

export interface RefusedMessage {
  why: string;
  code: string;
  bytes: Uint8Array;
  before: Int16Array;
}

const refused = (list: typeof golden.refused_frames): RefusedMessage[] =>
  list.map((r) => ({
    why: r.why,
    code: r.code,
    bytes: Uint8Array.from(r.hex.match(/../g) ?? [], (byte) => parseInt(byte, 16)),
    before: new Int16Array(r.numbers_before),
  }));

export const refusedFrames = refused(golden.refused_frames);
export const refusedTopologies = refused(golden.refused_topologies);
