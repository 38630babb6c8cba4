// The body of a job as the service sends it: uint32 vertices, uint32 triangles, float32 xyz of each vertex in metres,
// then three uint32 a triangle; little endian.

export interface BodyMesh {
  positions: Float32Array;
  indices: Uint32Array;
}

/** @throws RangeError when the lengths do not agree with the counts, or an index has no vertex. */
export function decodeBody(bytes: ArrayBuffer): BodyMesh {
  if (bytes.byteLength < 8) throw new RangeError('body: shorter than its header');
  const header = new DataView(bytes);
  const vertices = header.getUint32(0, true);
  const triangles = header.getUint32(4, true);
  if (bytes.byteLength !== 8 + 12 * vertices + 12 * triangles) {
    throw new RangeError(`body: ${bytes.byteLength} bytes do not hold ${vertices} vertices and ${triangles} triangles`);
  }
  const positions = new Float32Array(bytes, 8, 3 * vertices);
  const indices = new Uint32Array(bytes, 8 + 12 * vertices, 3 * triangles);
  if (indices.some((index) => index >= vertices)) throw new RangeError('body: an index has no vertex');
  return { positions, indices };
}
