# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""balcony studio: who may connect, and what no page can do to the server."""

import json
import os
import random
import signal
import socket
import stat
import threading
import time

import support
from studio_case import CAMERA, SMALL, StudioTest
from web_socket import BINARY, Closed, Refused, WebSocket


class Http(StudioTest):
    def test_files(self):
        self.open()
        status, headers, body = self.get("/")
        self.assertEqual(status, 200)
        self.assertTrue(headers["Content-Type"].startswith("text/html"))
        self.assertEqual(headers["Cache-Control"], "no-store")
        self.assertEqual(headers["X-Content-Type-Options"], "nosniff")
        policy = headers["Content-Security-Policy"]
        self.assertIn("default-src 'self'", policy)
        self.assertIn("frame-ancestors 'none'", policy)
        self.assertNotIn("unsafe", policy)
        self.assertNotIn(self.token.encode(), body)
        self.assertEqual(self.get("/?token=" + self.token)[0], 200)
        for path in ("/my.cam", "/../my.cam", "/etc/passwd", "//", "/index.html/"):
            self.assertEqual(self.get(path)[0], 404, path)

    def test_other_methods(self):
        self.open()
        for method in ("POST", "PUT", "DELETE", "OPTIONS", "HEAD"):
            status, headers, _ = self.get("/", method)
            self.assertEqual((status, headers["Allow"]), (405, "GET"), method)

    def test_other_hosts(self):
        self.open()
        self.assertEqual(self.get("/", Host=f"localhost:{self.port}")[0], 200)
        for host in ("example.org", f"example.org:{self.port}", "127.0.0.1", "localhost:1",
                     f"127.0.0.1:{self.port}.example.org", ""):
            self.assertEqual(self.get("/", Host=host)[0], 403, host)
            with self.assertRaises(Refused) as refused:
                WebSocket(self.port, f"/live?token={self.token}", host=host or "x")
            self.assertEqual(refused.exception.args[0], 403)

    def test_other_origins(self):
        self.open()
        target = f"/live?token={self.token}"
        for origin in ("http://example.org", "null", f"https://127.0.0.1:{self.port}",
                       "http://127.0.0.1", f"http://127.0.0.1:{self.port}@example.org"):
            with self.assertRaises(Refused) as refused:
                WebSocket(self.port, target, origin=origin)
            self.assertEqual(refused.exception.args[0], 403)
            self.assertEqual(self.get("/", Origin=origin)[0], 403)
        WebSocket(self.port, target, origin=f"http://127.0.0.1:{self.port}").close()
        WebSocket(self.port, target, origin=f"http://localhost:{self.port}",
                  host=f"localhost:{self.port}").close()

    def test_the_token(self):
        self.open()
        for target in ("/live", "/live?token=", "/live?token=" + self.token[:-1],
                       "/live?token=" + self.token + "0", "/live?token=" + "0" * 32,
                       "/live?x=" + self.token, "/live#token=" + self.token):
            with self.assertRaises(Refused) as refused:
                WebSocket(self.port, target)
            self.assertIn(refused.exception.args[0], (403, 404), target)
        self.assertEqual(self.get("/live?token=" + self.token)[0], 426)

    def test_a_file_of_the_token(self):
        self.open("--token-file", "token")
        file = self.folder / "token"
        self.assertEqual(file.read_text(), self.token + "\n")
        self.assertEqual(stat.S_IMODE(os.stat(file).st_mode), 0o600)
        token, port = self.token, self.port
        self.process.send_signal(signal.SIGINT)
        self.process.wait(60)
        self.open("--token-file", "token", "--port", str(port))
        self.assertEqual((self.token, self.port), (token, port))
        file.write_text("secret\n")
        self.refused("studio", "scene.obj", "my.cam", "--token-file", "token", code=3,
                     says="32 hexadecimal digits")

    def test_a_port_that_is_in_use(self):
        self.open()
        err = self.refused("studio", "scene.obj", "my.cam", "--port", str(self.port), code=3,
                           says=f"port {self.port} of 127.0.0.1 cannot be used")
        self.assertIn("another --port", err)

    def test_requests_that_are_none(self):
        self.open()
        chance = random.Random(7)
        whole = (f"GET /live?token={self.token} HTTP/1.1\r\nHost: 127.0.0.1:{self.port}\r\n"
                 "Upgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Version: 13\r\n"
                 "Sec-WebSocket-Key: AAAAAAAAAAAAAAAAAAAAAA==\r\n\r\n").encode()
        for _ in range(300):
            changed = bytearray(whole)
            for _ in range(chance.randint(1, 4)):
                changed[chance.randrange(len(changed))] = chance.randrange(256)
            with socket.create_connection(("127.0.0.1", self.port)) as connection:
                connection.sendall(changed)
        with socket.create_connection(("127.0.0.1", self.port)) as connection:
            try:
                connection.sendall(b"GET / HTTP/1.1\r\n" + b"X: " + b"y" * 1_000_000)
            except ConnectionError:
                pass
        self.assertTrue(self.is_alive())

    def test_at_most_16_pages(self):
        self.open()
        pages = [self.page() for _ in range(16)]
        with self.assertRaises(Refused) as refused:
            self.page()
        self.assertEqual(refused.exception.args[0], 503)
        pages[0].close()
        end = time.monotonic() + 60
        while True:
            try:
                self.page()
                break
            except Refused:
                self.assertLess(time.monotonic(), end)


class Robustness(StudioTest):
    def test_a_message_of_100_mb(self):
        self.open()
        page = self.page().begin()
        with self.assertRaises((Closed, ConnectionError)):
            page.socket.send(b'"' + b"a" * 100_000_000 + b'"')
            while True:
                page.next()
        self.assertTrue(self.is_alive())

    def test_a_message_of_17_mb_has_its_code(self):
        self.open()
        opened = self.page().socket
        try:
            opened.send(b'"' + b"a" * 17_000_000 + b'"')
        except ConnectionError:
            pass
        with self.assertRaises(Closed) as closed:
            opened.receive()
        self.assertIn(closed.exception.args[0], (1009, None))

    def test_fragments(self):
        self.open()
        page = self.page().begin()
        whole = json.dumps({"jsonrpc": "2.0", "id": 77, "method": "textDocument/documentSymbol",
                            "params": {"textDocument": {"uri": page.uri}}}).encode()
        page.socket.send(whole[:10], is_last=False)
        page.socket.send(b"ping", 9)
        for i in range(10, len(whole) - 1):
            page.socket.send(whole[i:i + 1], 0, is_last=False)
        page.socket.send(whole[-1:], 0)
        while True:
            answer = page.next()
            if answer.get("id") == 77:
                break
        self.assertEqual(answer["result"][0]["name"], "above")

    def test_bytes_and_texts_that_are_none(self):
        self.open()
        for data, kind, code in ((b"\0\1\2", BINARY, 1003), (b"\xff\xfe", 1, 1007)):
            opened = self.page().socket
            opened.send(data, kind)
            with self.assertRaises(Closed) as closed:
                opened.receive()
            self.assertEqual(closed.exception.args[0], code)
        page = self.page()
        page.send(b"no JSON")
        self.assertEqual(page.next()["error"]["code"], -32700)
        page.send(b"[" * 100_000)
        self.assertEqual(page.next()["error"]["code"], -32700)

    def test_thousands_of_changed_messages(self):
        self.open()
        page = self.page().begin()
        handle = page.result("handles")["handles"][0]
        chance = random.Random(3)
        samples = [json.dumps(message).encode() for message in (
            {"jsonrpc": "2.0", "id": 1, "method": "view/change", "params": {
                "values": [{"parameter": "size", "value": 2.5}], "size": [64, 48]}},
            {"jsonrpc": "2.0", "method": "view/seen", "params": {"change": 3}},
            {"jsonrpc": "2.0", "id": 2, "method": "text/set", "params": {
                "values": [{"parameter": "size", "value": 2.5}]}},
            {"jsonrpc": "2.0", "id": 3, "method": "view/drag", "params": {"pulls": [
                {"point": [1, 0, 0], "from": [42.67, 24], "to": [48, 24]}], "layer": 0}},
            {"jsonrpc": "2.0", "id": 8, "method": "cameras/show", "params": {
                "names": ["pinhole", "fisheye"], "width": 9, "height": 9}},
            {"jsonrpc": "2.0", "id": 9, "method": "render/stop", "params": {"id": 1}},
            {"jsonrpc": "2.0", "id": 10, "method": "cameras/text", "params": {"name": "pinhole"}},
            {"jsonrpc": "2.0", "id": 6, "method": "view/at", "params": {"x": 32.5, "y": 20}},
            {"jsonrpc": "2.0", "id": 7, "method": "view/find", "params": {"point": [1, 0.5, 0]}},
            {"jsonrpc": "2.0", "id": 5, "method": "handles/move", "params": {
                "handle": handle, "moves": [{"number": 0, "value": 2.5, "step": 0.1}]}},
            {"jsonrpc": "2.0", "method": "textDocument/didChange", "params": {
                "textDocument": {"uri": page.uri, "version": 2},
                "contentChanges": [{"text": CAMERA}]}},
            {"jsonrpc": "2.0", "id": 4, "method": "textDocument/completion", "params": {
                "textDocument": {"uri": page.uri}, "position": {"line": 3, "character": 9}}})]
        def read():
            try:
                while True:
                    page.next()
            except (Closed, OSError, ValueError):
                pass
        reader = threading.Thread(target=read, daemon=True)
        reader.start()
        for _ in range(10_000):
            changed = bytearray(chance.choice(samples))
            for _ in range(chance.randint(1, 3)):
                at = chance.randrange(len(changed))
                how = chance.randrange(3)
                if how == 0:
                    changed[at] = chance.randrange(32, 127)
                elif how == 1:
                    del changed[at:at + chance.randint(1, 8)]
                else:
                    changed[at:at] = changed[chance.randrange(len(changed)):][:chance.randint(1, 8)]
            page.socket.send(bytes(changed) or b"x")
        self.assertTrue(self.is_alive())

    def test_a_page_that_leaves_in_the_middle(self):
        self.open()
        for _ in range(20):
            page = self.page().begin()
            page.notify("view/change", size=SMALL)
            page.edit(CAMERA.replace("size = 3", "size = 2"))
            page.close()
        self.assertTrue(self.is_alive())

    def test_ctrl_c_ends_it(self):
        self.open("--samples", "100000")
        page = self.page().begin()
        page.result("view/change", size=[640, 480])
        page.wait_for_frame(1)
        begin = time.monotonic()
        self.process.send_signal(signal.SIGINT)
        with self.assertRaises(Closed) as closed:
            while True:
                page.next()
        self.assertEqual(closed.exception.args[0], 1001)
        self.assertEqual(self.process.wait(60), 130)
        self.assertLess(time.monotonic() - begin, 20)
        self.assertNotIn(b"error", self.process.stderr.read())

    def test_ctrl_c_while_the_scene_is_loaded(self):
        self.open()
        self.process.send_signal(signal.SIGINT)
        self.assertEqual(self.process.wait(60), 130)


if __name__ == "__main__":
    support.main()
