// What all messages of a drape's stream share: their first eight bytes, and the errors of reading them.
// The layout stands in ../frames.md; ../cpp has the same in C++. No part of this folder needs a browser.

export type FrameErrorCode = 'frame.malformed' | 'frame.version' | 'frame.wrong_base';

/** Bytes that are no message, or a delta that does not fit what the reader holds. */
export class FrameError extends Error {
  override readonly name = 'FrameError';

  constructor(
    readonly code: FrameErrorCode,
    message: string,
  ) {
    super(message);
  }
}

export const malformed = (message: string): FrameError => new FrameError('frame.malformed', message);

/** The third byte of a message. */
export const MessageType = { topology: 1, key: 2, delta: 3 } as const;
export type MessageType = (typeof MessageType)[keyof typeof MessageType];

/** Bytes of magic, version, type and epoch. */
export const kPrefixSize = 8;

const kMagic = [0x54, 0x4c] as const; // "TL"
const kVersion = 1;

/** What a binary message is, from its first bytes. Throws FrameError. */
export function messageType(bytes: Uint8Array): MessageType {
  if (bytes.length < kPrefixSize || bytes[0] !== kMagic[0] || bytes[1] !== kMagic[1]) {
    throw malformed('this is no message of a drape’s stream');
  }
  if (bytes[2] !== kVersion) {
    throw new FrameError('frame.version', 'the stream speaks another version than this page; reload it');
  }
  const type = bytes[3]!;
  if (type < MessageType.topology || type > MessageType.delta) throw malformed('the message is of no known type');
  return type as MessageType;
}

export function writePrefix(view: DataView, type: MessageType, epoch: number): void {
  view.setUint8(0, kMagic[0]);
  view.setUint8(1, kMagic[1]);
  view.setUint8(2, kVersion);
  view.setUint8(3, type);
  view.setUint32(4, epoch, true);
}

// Frames come many times a second, so their few numbers are read without making a DataView for each message.

export function uint32At(bytes: Uint8Array, at: number): number {
  return (bytes[at]! | (bytes[at + 1]! << 8) | (bytes[at + 2]! << 16) | (bytes[at + 3]! << 24)) >>> 0;
}

export function int32At(bytes: Uint8Array, at: number): number {
  return uint32At(bytes, at) | 0;
}

const floatBits = new Uint32Array(1);
const floatValue = new Float32Array(floatBits.buffer);

export function float32At(bytes: Uint8Array, at: number): number {
  floatBits[0] = uint32At(bytes, at);
  return floatValue[0]!;
}
