# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""A WebSocket (RFC 6455) as a page has it, and a page of the studio without pictures."""

import base64
import hashlib
import json
import os
import socket
import struct
import time

TEXT, BINARY, CLOSE, PING, PONG = 1, 2, 8, 9, 10
PATIENCE = 60  # Seconds; a loaded machine needs some.


class Refused(Exception):
    """The server does not open a socket: the status of its answer."""


class Closed(Exception):
    """The socket is closed: the code of its end, or None."""


class WebSocket:
    def __init__(self, port, target, host=None, origin=None):
        self.read = b""
        self.socket = socket.create_connection(("127.0.0.1", port), PATIENCE)
        key = base64.b64encode(os.urandom(16)).decode()
        lines = [f"GET {target} HTTP/1.1", f"Host: {host or f'127.0.0.1:{port}'}",
                 "Upgrade: websocket", "Connection: Upgrade", f"Sec-WebSocket-Key: {key}",
                 "Sec-WebSocket-Version: 13"]
        if origin:
            lines.append(f"Origin: {origin}")
        self.socket.sendall(("\r\n".join(lines) + "\r\n\r\n").encode())
        while b"\r\n\r\n" not in self.read:
            self.fill()
        head, self.read = self.read.split(b"\r\n\r\n", 1)
        status = int(head.split()[1])
        if status != 101:
            self.socket.close()
            raise Refused(status)
        expected = base64.b64encode(hashlib.sha1(
            key.encode() + b"258EAFA5-E914-47DA-95CA-C5AB0DC85B11").digest())
        assert b"\r\nSec-WebSocket-Accept: " + expected in head, head

    def fill(self, seconds=PATIENCE):
        self.socket.settimeout(seconds)
        try:
            more = self.socket.recv(1 << 16)
        except ConnectionError as problem:
            raise Closed(None) from problem
        if not more:
            raise Closed(None)
        self.read += more

    def take(self, count, seconds):
        while len(self.read) < count:
            self.fill(seconds)
        part, self.read = self.read[:count], self.read[count:]
        return part

    def send(self, data, kind=TEXT, is_last=True):
        size = len(data)
        head = bytes([kind | (0x80 if is_last else 0)])
        if size < 126:
            head += bytes([0x80 | size])
        elif size < 1 << 16:
            head += b"\xfe" + struct.pack(">H", size)
        else:
            head += b"\xff" + struct.pack(">Q", size)
        mask = os.urandom(4)
        whole = int.from_bytes(data, "big") ^ int.from_bytes((mask * (size // 4 + 1))[:size], "big")
        self.socket.sendall(head + mask + whole.to_bytes(size, "big"))

    def receive(self, seconds=PATIENCE):
        """The kind and the bytes of the next message. Pings are answered."""
        whole, kind = b"", None
        while True:
            first, second = self.take(2, seconds)
            assert not second & 0x80, "a server does not mask"
            size = second & 0x7f
            if size == 126:
                (size,) = struct.unpack(">H", self.take(2, seconds))
            elif size == 127:
                (size,) = struct.unpack(">Q", self.take(8, seconds))
            data = self.take(size, seconds)
            if first & 15 == CLOSE:
                raise Closed(struct.unpack(">H", data[:2])[0] if data else None)
            if first & 15 == PING:
                self.send(data, PONG)
            elif first & 15 != PONG:
                kind, whole = kind or first & 15, whole + data
                if first & 0x80:
                    return kind, whole

    def close(self):
        self.socket.close()


class Page:
    """Speaks with the studio, and acknowledges pictures unless it is slow."""

    def __init__(self, port, token, is_slow=False):
        self.socket = WebSocket(port, f"/live?token={token}")
        self.number, self.is_slow = 0, is_slow
        self.told, self.frames = [], []

    def begin(self):
        self.about = self.result("initialize", processId=None, capabilities={})["studio"]
        self.notify("initialized")
        self.uri, self.version = self.about["uri"], self.about["textVersion"]
        self.notify("textDocument/didOpen", textDocument={
            "uri": self.uri, "languageId": "balcony", "version": self.version, "text": ""})
        return self

    def send(self, message):
        self.socket.send(message if isinstance(message, bytes) else json.dumps(message).encode())

    def notify(self, method, **params):
        self.send({"jsonrpc": "2.0", "method": method, "params": params})

    def next(self, seconds=PATIENCE):
        """The next message: JSON, or the head of a frame with its bytes as `picture`."""
        kind, data = self.socket.receive(seconds)
        if kind == TEXT:
            message = json.loads(data)
            if "method" in message:
                self.told.append(message)
            return message
        (length,) = struct.unpack("<I", data[:4])
        head = json.loads(data[4:4 + length])
        head["picture"] = data[4 + length:]
        self.frames.append(head)
        if not self.is_slow and head["kind"] == "frame":
            self.seen(head)
        return head

    def seen(self, head):
        self.notify("view/seen", change=head["change"])

    def ask(self, method, **params):
        self.number += 1
        self.send({"jsonrpc": "2.0", "id": self.number, "method": method, "params": params})
        while True:
            answer = self.next()
            if answer.get("id") == self.number and "method" not in answer:
                return answer

    def result(self, method, **params):
        answer = self.ask(method, **params)
        assert "result" in answer, answer
        return answer["result"]

    def error(self, method, **params):
        answer = self.ask(method, **params)
        assert "error" in answer, answer
        return answer["error"]

    def wait_for(self, method, seconds=PATIENCE, **members):
        """What is told by a notification whose parameters have these members; what was told before
        is looked at first."""
        end, at = time.monotonic() + seconds, 0
        while True:
            for message in self.told[at:]:
                if message["method"] == method and members.items() <= message["params"].items():
                    return message["params"]
            at = len(self.told)
            self.next(max(0.01, end - time.monotonic()))

    def wait_for_frame(self, change, quality=None):
        while True:
            for frame in self.frames:
                if frame["change"] >= change and quality in (None, frame["quality"]):
                    return frame
            self.next()

    def edit(self, text):
        """Sends another text, made of the last one that is known."""
        self.version += 1
        self.notify("textDocument/didChange",
                    textDocument={"uri": self.uri, "version": self.version},
                    contentChanges=[{"text": text}])

    def close(self):
        self.socket.close()
