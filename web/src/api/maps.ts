// maps.json, which the service leaves with a drape that has ended: figures of the cloth at each of its vertices.

export interface MapFile {
  pieces: { id: string; first_vertex: number; vertex_count: number }[];
  maps: { map: string; values: number[] }[];
}

/** @throws SyntaxError, or RangeError on what is no such file */
export function readMaps(text: string): MapFile {
  const file = JSON.parse(text) as Partial<MapFile> | null;
  if (!Array.isArray(file?.pieces) || !Array.isArray(file.maps)) throw new RangeError('maps.json has no maps');
  return { pieces: file.pieces, maps: file.maps };
}
