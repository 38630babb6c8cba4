// The stream's codec, as the page uses it. The one door to ../../../proto/ts.

export { FrameReader, dequantise, type FrameGrid } from '../../../proto/ts/frameCodec';
export { MessageType, messageType } from '../../../proto/ts/message';
export {
  decodeTopology,
  type StreamPiece as TopologyPiece,
  type Topology as ClothTopology,
} from '../../../proto/ts/topologyCodec';
