"""As much of a WebSocket (RFC 6455) as a viewer of a drape needs."""

import base64
import os
import socket
import struct

TEXT, BINARY, CLOSE, PING, PONG = 1, 2, 8, 9, 10


class WebSocket:
    def __init__(self, port, target):
        self.socket = socket.create_connection(("127.0.0.1", port), timeout=120)
        key = base64.b64encode(os.urandom(16)).decode()
        self.socket.sendall((f"GET {target} HTTP/1.1\r\nHost: 127.0.0.1:{port}\r\nUpgrade: websocket\r\n"
                             f"Connection: Upgrade\r\nSec-WebSocket-Key: {key}\r\nSec-WebSocket-Version: 13\r\n\r\n")
                            .encode())
        self.stream = self.socket.makefile("rb")
        status = self.stream.readline()
        if b" 101 " not in status:
            raise RuntimeError(f"no WebSocket: {status}")
        while self.stream.readline() not in (b"\r\n", b""):
            pass

    def send(self, kind, data):
        if len(data) > 125:
            raise ValueError("a viewer says no more than 125 bytes")
        mask = os.urandom(4)
        covered = bytes(byte ^ mask[i % 4] for i, byte in enumerate(data))
        self.socket.sendall(bytes([0x80 | kind, 0x80 | len(data)]) + mask + covered)

    def messages(self):
        """(kind, bytes) of each message, the close with its code last."""
        while True:
            first, length = self.stream.read(2)
            if not first & 0x80:
                raise RuntimeError("the service cuts its messages into parts")
            if length == 126:
                length, = struct.unpack(">H", self.stream.read(2))
            elif length == 127:
                length, = struct.unpack(">Q", self.stream.read(8))
            kind, data = first & 0x0f, self.stream.read(length)
            if kind == PING:
                self.send(PONG, data)
            elif kind == CLOSE:
                self.send(CLOSE, data[:2])
                yield CLOSE, data
                return
            elif kind != PONG:
                yield kind, data

    def close(self):
        self.stream.close()
        self.socket.close()
