// Just enough of a WebSocket server for the mock: the handshake, unmasked frames out, short masked text in.

import { createHash } from 'node:crypto';
import type { IncomingMessage } from 'node:http';
import type { Duplex } from 'node:stream';

const kGuid = '258EAFA5-E914-47DA-95CA-C5AB0DC85B11';

export interface MockSocket {
  send(data: string | Uint8Array): void;
  close(): void;
  /** Bytes that wait because the other side does not read. */
  waiting(): number;
}

export function accept(
  request: IncomingMessage,
  wire: Duplex,
  onText: (text: string) => void,
  onClose: () => void,
): MockSocket {
  const key = createHash('sha1')
    .update(request.headers['sec-websocket-key'] + kGuid)
    .digest('base64');
  wire.write(
    `HTTP/1.1 101 Switching Protocols\r\nUpgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Accept: ${key}\r\n\r\n`,
  );
  wire.on('data', (bytes: Buffer) => {
    const length = bytes[1]! & 0x7f;
    if ((bytes[0]! & 0x0f) === 8 || length > 125) return wire.destroy();
    if ((bytes[0]! & 0x0f) !== 1) return;
    onText(
      Buffer.from(bytes.subarray(6, 6 + length))
        .map((byte, i) => byte ^ bytes[2 + (i % 4)]!)
        .toString(),
    );
  });
  wire.on('close', onClose);
  wire.on('error', onClose);
  return {
    send: (data) => void (wire.destroyed || wire.write(framed(data))),
    close: () => void wire.end(Buffer.from([0x88, 0])),
    waiting: () => wire.writableLength,
  };
}

function framed(data: string | Uint8Array): Buffer {
  const payload = Buffer.from(data as Uint8Array);
  const opcode = typeof data === 'string' ? 0x81 : 0x82;
  const head =
    payload.length < 126
      ? Buffer.from([opcode, payload.length])
      : payload.length < 65536
        ? Buffer.from([opcode, 126, payload.length >> 8, payload.length & 0xff])
        : Buffer.concat([Buffer.from([opcode, 127, 0, 0, 0, 0]), uint32(payload.length)]);
  return Buffer.concat([head, payload]);
}

function uint32(value: number): Buffer {
  const bytes = Buffer.alloc(4);
  bytes.writeUInt32BE(value);
  return bytes;
}
