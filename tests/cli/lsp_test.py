# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""balcony lsp: the Language Server Protocol, message by message."""

import json
import os
import random
import select
import statistics
import subprocess
import time

import support

URI = "file:///camera/my.cam"
TEXT = """// The middle of the room.
let half = 180deg/2
camera wide(fov = 2*half) {
    map u = fov/2 .. -fov/2, v = square
    eye sphere(radius = 1)
    look normal outward
}
picture both {
    layer wide(fov = 90deg)
}
"""


def packed(message):
    text = message if isinstance(message, bytes) else json.dumps(message).encode()
    return b"Content-Length: %d\r\n\r\n%s" % (len(text), text)


def request(number, method, **params):
    return {"jsonrpc": "2.0", "id": number, "method": method, "params": params}


def notification(method, **params):
    return {"jsonrpc": "2.0", "method": method, "params": params}


def opening(text, uri=URI, version=1):
    return notification("textDocument/didOpen", textDocument={
        "uri": uri, "languageId": "balcony", "version": version, "text": text})


class Client:
    """A client that waits for each answer."""

    def __init__(self, process):
        self.process, self.number, self.read = process, 0, b""

    def send(self, message):
        self.process.stdin.write(packed(message))
        self.process.stdin.flush()

    def next_message(self, seconds=60):
        end = time.monotonic() + seconds
        while True:
            header, found, rest = self.read.partition(b"\r\n\r\n")
            length = int(header.split(b":")[1]) if found else 0
            if found and len(rest) >= length:
                self.read = rest[length:]
                return json.loads(rest[:length])
            if not select.select([self.process.stdout], [], [], max(0, end - time.monotonic()))[0]:
                raise AssertionError("there is no answer")
            more = os.read(self.process.stdout.fileno(), 1 << 16)
            if not more:
                raise AssertionError("the output has ended")
            self.read += more

    def next_error(self):
        while True:
            answer = self.next_message()
            if "error" in answer:
                return answer["error"]

    def ask(self, method, **params):
        self.number += 1
        self.send(request(self.number, method, **params))
        while True:
            answer = self.next_message()
            if answer.get("id") == self.number:
                return answer

    def result(self, method, **params):
        answer = self.ask(method, **params)
        assert "result" in answer, answer
        return answer["result"]

    def diagnostics(self, version, count=1):
        """What is published about a version; a text without errors has two states."""
        while True:
            said = self.next_message()
            if said.get("method") == "textDocument/publishDiagnostics":
                if said["params"].get("version") == version:
                    count -= 1
                    if count == 0:
                        return said["params"]["diagnostics"]


def at(line, character):
    return {"line": line, "character": character}


def part(line, begin, end):
    return {"start": at(line, begin), "end": at(line, end)}


class Lsp(support.CommandTest):
    def connect(self, text=TEXT, **capabilities):
        process = self.start("lsp", stdin=subprocess.PIPE, bufsize=0)
        self.addCleanup(process.stderr.close)
        self.addCleanup(process.stdout.close)
        self.addCleanup(process.stdin.close)
        self.addCleanup(process.wait)
        self.addCleanup(process.kill)
        client = Client(process)
        self.hello = client.result("initialize", processId=None, capabilities=capabilities)
        client.send(notification("initialized"))
        if text is not None:
            client.send(opening(text))
        return client

    def place(self, line, character):
        return {"textDocument": {"uri": URI}, "position": at(line, character)}

    def test_capabilities(self):
        self.connect(None)
        self.assertEqual(sorted(self.hello["capabilities"]), [
            "codeActionProvider", "completionProvider", "definitionProvider",
            "documentFormattingProvider", "documentSymbolProvider", "hoverProvider",
            "inlayHintProvider", "positionEncoding", "referencesProvider", "renameProvider",
            "signatureHelpProvider", "textDocumentSync"])
        self.assertEqual(self.hello["serverInfo"]["name"], "balcony")

    def test_shutdown_and_exit(self):
        client = self.connect()
        self.assertIsNone(client.result("shutdown"))
        self.assertEqual(client.ask("textDocument/hover", **self.place(0, 0))["error"]["code"],
                         -32600)
        client.send(notification("exit"))
        self.assertEqual(client.process.wait(20), 0)
        self.assertEqual(client.process.stderr.read(), b"")

    def test_an_exit_without_shutdown_fails(self):
        client = self.connect()
        client.send(notification("exit"))
        self.assertEqual(client.process.wait(20), 1)

    def test_the_end_of_the_input_fails(self):
        client = self.connect()
        client.process.stdin.close()
        self.assertEqual(client.process.wait(20), 1)

    def test_hover(self):
        client = self.connect()
        told = client.result("textDocument/hover", **self.place(4, 10))
        self.assertEqual(told["range"], part(4, 8, 14))
        self.assertTrue(told["contents"]["value"].startswith("```balcony\nsphere(radius, by)\n```"))
        self.assertIn("```text\n", told["contents"]["value"])
        self.assertIsNone(client.result("textDocument/hover", **self.place(6, 0)))

    def test_hover_of_a_camera(self):
        client = self.connect()
        self.assertEqual(client.result("textDocument/hover", **self.place(8, 11)), {
            "contents": {"kind": "markdown",
                         "value": "```balcony\ncamera wide(fov = 2*half)\n```\n"},
            "range": part(8, 10, 14)})

    def test_completion(self):
        client = self.connect()
        found = client.result("textDocument/completion", **self.place(4, 10))["items"]
        sphere = next(one for one in found if one["label"] == "sphere")
        self.assertEqual(sphere["textEdit"]["range"], part(4, 8, 14))
        self.assertEqual(sphere["textEdit"]["newText"], "sphere")  # It has its arguments.
        client.send(notification(
            "textDocument/didChange", textDocument={"uri": URI, "version": 2},
            contentChanges=[{"range": part(4, 8, 26), "text": ""}]))
        found = client.result("textDocument/completion", **self.place(4, 8))["items"]
        sphere = next(one for one in found if one["label"] == "sphere")
        self.assertEqual(sphere["insertTextFormat"], 1)
        self.assertTrue(sphere["textEdit"]["newText"].startswith("sphere(radius = 1"))

    def test_completion_with_snippets(self):
        client = self.connect("camera a {\n    eye \n}\n", textDocument={
            "completion": {"completionItem": {"snippetSupport": True}}})
        found = client.result("textDocument/completion", **self.place(1, 8))["items"]
        sphere = next(one for one in found if one["label"] == "sphere")
        self.assertEqual(sphere["insertTextFormat"], 2)
        self.assertTrue(sphere["textEdit"]["newText"].startswith("sphere(radius = ${1:1}"))
        self.assertTrue(sphere["textEdit"]["newText"].endswith(")$0"))

    def test_signature(self):
        client = self.connect()
        told = client.result("textDocument/signatureHelp", **self.place(8, 24))
        self.assertEqual(told["signatures"][0]["label"], "wide(fov = 2*half)")
        self.assertEqual(told["signatures"][0]["parameters"][0]["label"], [5, 17])
        self.assertEqual(told["activeParameter"], 0)

    def test_definition_and_references(self):
        client = self.connect()
        self.assertEqual(client.result("textDocument/definition", **self.place(8, 11)),
                         {"uri": URI, "range": part(2, 7, 11)})
        found = client.result("textDocument/references", **self.place(2, 13),
                              context={"includeDeclaration": True})
        self.assertEqual([one["range"] for one in found],
                         [part(2, 12, 15), part(3, 12, 15), part(3, 22, 25), part(8, 15, 18)])

    def test_definition_in_an_import(self):
        (self.folder / "shared.cam").write_text("let w = 1\n")
        uri = (self.folder / "a b.cam").as_uri()
        client = self.connect(None)
        client.send(opening('import "shared.cam"\ncamera a { eye sphere(w) }\n', uri))
        found = client.result("textDocument/definition", textDocument={"uri": uri},
                              position=at(1, 22))
        self.assertEqual(found, {"uri": (self.folder / "shared.cam").as_uri(),
                                 "range": part(0, 4, 5)})

    def test_rename(self):
        client = self.connect()
        self.assertEqual(client.result("textDocument/prepareRename", **self.place(1, 5)),
                         part(1, 4, 8))
        made = client.result("textDocument/rename", **self.place(1, 5), newName="quarter")
        self.assertEqual(made, {"changes": {URI: [
            {"range": part(1, 4, 8), "newText": "quarter"},
            {"range": part(2, 20, 24), "newText": "quarter"}]}})
        refused = client.ask("textDocument/rename", **self.place(1, 5), newName="eye")
        self.assertEqual(refused["error"],
                         {"code": -32803, "message": "'eye' is reserved: choose another name"})

    def test_formatting(self):
        client = self.connect("camera a{eye sphere(1)}")
        (edit,) = client.result("textDocument/formatting", textDocument={"uri": URI}, options={})
        self.assertEqual(edit, {"range": part(0, 0, 23),
                                "newText": "camera a {\n    eye sphere(1)\n}\n"})
        client = self.connect("camera a{eye sphere(1}")
        self.assertIsNone(client.result("textDocument/formatting", textDocument={"uri": URI},
                                        options={}))

    def test_values(self):
        client = self.connect()
        found = client.result("textDocument/inlayHint", textDocument={"uri": URI},
                              range={"start": at(0, 0), "end": at(20, 0)})
        self.assertEqual([(one["position"], one["label"]) for one in found],
                         [(at(1, 19), "= 90deg"), (at(2, 24), "= 180deg")])

    def test_symbols(self):
        client = self.connect()
        found = client.result("textDocument/documentSymbol", textDocument={"uri": URI})
        self.assertEqual([(one["name"], one["detail"]) for one in found],
                         [("half", "let"), ("wide", "camera"), ("both", "picture")])
        self.assertEqual(found[1]["children"][0]["name"], "fov")

    def test_diagnostics_with_a_fix(self):
        text = "camera a {\n    map u = 0 .. 1, v = 0 .. 1\n    eye sphrere(1)\n}\n"
        client = self.connect(text)
        (said,) = client.diagnostics(1)
        self.assertEqual(said, {"range": part(2, 8, 15), "severity": 1, "source": "balcony",
                                "message": "there is no object generator named 'sphrere'\n"
                                           "did you mean 'sphere'?"})
        (fix,) = client.result("textDocument/codeAction", textDocument={"uri": URI},
                               range=part(2, 9, 9), context={"diagnostics": [said]})
        self.assertEqual(fix, {"title": "write 'sphere'", "kind": "quickfix",
                               "diagnostics": [said],
                               "edit": {"changes": {URI: [
                                   {"range": part(2, 8, 15), "newText": "sphere"}]}}})
        client.send(notification("textDocument/didChange",
                                 textDocument={"uri": URI, "version": 2},
                                 contentChanges=[{"range": part(2, 8, 15), "text": "sphere"}]))
        self.assertEqual(client.diagnostics(2), [])

    def test_what_check_finds(self):
        client = self.connect("camera half {\n    map u = -2 .. 2, v = square\n"
                              "    eye surface(u, v) = [u, v, sqrt(u)]\n    look along(z)\n}\n")
        (said,) = client.diagnostics(1, 2)
        self.assertEqual((said["range"], said["severity"]), (part(0, 7, 11), 2))
        self.assertIn("no ray", said["message"])

    def test_only_the_last_state_is_told(self):
        client = self.connect("camera a { ey }")
        for version in range(2, 30):
            client.send(notification(
                "textDocument/didChange", textDocument={"uri": URI, "version": version},
                contentChanges=[{"text": TEXT.replace("90", str(60 + version))}]))
        said = client.next_message()
        self.assertEqual(said["params"], {"uri": URI, "version": 29, "diagnostics": []})

    def test_a_closed_text_has_no_marks(self):
        client = self.connect("camera a { eye nothing }")
        self.assertNotEqual(client.diagnostics(1), [])
        client.send(notification("textDocument/didClose", textDocument={"uri": URI}))
        self.assertEqual(client.next_message()["params"], {"uri": URI, "diagnostics": []})
        self.assertEqual(client.ask("textDocument/hover", **self.place(0, 0))["error"]["code"],
                         -32602)

    def test_positions_are_utf_16(self):
        client = self.connect("/* \U0001F980\u00e9 */ let w = 1 camera a { aspect w eye point }\r\n")
        self.assertEqual(client.result("textDocument/definition", **self.place(0, 38)),
                         {"uri": URI, "range": part(0, 14, 15)})
        client.send(notification("textDocument/didChange",
                                 textDocument={"uri": URI, "version": 2},
                                 contentChanges=[{"range": part(0, 14, 15), "text": "wide"},
                                                 {"range": part(0, 41, 42), "text": "wide"}]))
        self.assertEqual(client.result("textDocument/definition", **self.place(0, 42)),
                         {"uri": URI, "range": part(0, 14, 18)})

    def test_messages_in_the_wrong_order(self):
        with self.start("lsp", stdin=subprocess.PIPE) as process:
            client = Client(process)
            self.assertEqual(client.ask("textDocument/hover")["error"]["code"], -32002)
            client.send(opening(TEXT))  # Not heard yet.
            client.result("initialize", capabilities={})
            self.assertEqual(client.ask("initialize", capabilities={})["error"]["code"], -32600)
            self.assertEqual(client.ask("textDocument/hover", **self.place(0, 0))["error"]["code"],
                             -32602)
            process.kill()

    def test_what_is_not_known(self):
        client = self.connect()
        self.assertEqual(client.ask("textDocument/moniker")["error"], {
            "code": -32601, "message": "there is no request 'textDocument/moniker'"})
        client.send(notification("$/cancelRequest", id=7))
        client.send(notification("workspace/nothing"))
        client.send({"jsonrpc": "2.0", "id": 5, "result": None})
        client.send([1, 2])
        self.assertEqual(client.next_error()["code"], -32600)
        client.send(b"{ no JSON")
        self.assertEqual(client.next_error()["code"], -32700)
        self.assertEqual(client.ask("textDocument/hover", position=3)["error"]["code"], -32602)

    def test_a_message_of_100_mb(self):
        client = self.connect()
        client.process.stdin.write(b"Content-Length: 100000000\r\n\r\n")
        for _ in range(100):
            client.process.stdin.write(b"x" * 1_000_000)
        self.assertEqual(client.next_error()["code"], -32600)
        self.assertIsNotNone(client.result("textDocument/hover", **self.place(4, 10)))

    def test_a_message_that_nests_too_deeply(self):
        client = self.connect()
        deep = b"[" * 400_000 + b"]" * 400_000
        for message in (b'{"jsonrpc": "2.0", "id": %s, "method": "shutdown"}' % deep,
                        b'{"jsonrpc": "2.0", "id": 1, "method": "shutdown", "params": %s}' % deep):
            client.send(message)
            self.assertIn("nests", client.next_error()["message"])
        self.assertIsNone(client.result("shutdown"))

    def test_a_text_that_is_too_long(self):
        client = self.connect("// " + "x" * 1_000_000)
        (said,) = client.diagnostics(1)
        self.assertEqual(said["message"], "a camera file is at most 1 MB")
        self.assertEqual(client.ask("textDocument/hover", **self.place(0, 0))["error"]["code"],
                         -32803)

    def test_headers_that_cannot_be_read(self):
        for header in (b"Content-Length: many\r\n\r\n", b"\r\n", b"Content-Type: a\r\n\r\n",
                       b"Content-Length: -1\r\n\r\n", b"x" * 100_000, b"Content-Length: 5"):
            with self.subTest(header=header[:30]):
                with self.start("lsp", stdin=subprocess.PIPE) as process:
                    out, err = process.communicate(header, timeout=20)
                self.assertEqual((process.returncode, err), (1, b""))
                self.assertIn(b"-32700", out)

    def test_thousands_of_changed_messages(self):
        messages = [opening(TEXT),
                    notification("textDocument/didChange",
                                 textDocument={"uri": URI, "version": 2},
                                 contentChanges=[{"range": part(2, 0, 5), "text": "cam"}])]
        methods = ("completion", "hover", "definition", "references", "rename", "prepareRename",
                   "signatureHelp", "inlayHint", "codeAction", "formatting", "documentSymbol")
        for i, method in enumerate(methods):
            messages.append(request(i + 1, f"textDocument/{method}", **self.place(3, 12),
                                    range=part(1, 2, 3), newName="b"))
        chance = random.Random(5)
        client = self.connect()
        for _ in range(3000):
            text = bytearray(json.dumps(chance.choice(messages)).encode())
            for _ in range(chance.randrange(1, 5)):
                begin = chance.randrange(len(text))
                text[begin:begin + chance.randrange(4)] = bytes(
                    chance.choice(b'{}[]",:0123456789eabt\\\xff\x00 ')
                    for _ in range(chance.randrange(4)))
            if b'"exit"' in text or b'"shutdown"' in text:
                continue
            client.send(bytes(text))
            while select.select([client.process.stdout], [], [], 0)[0]:
                client.next_message()
        client.send(opening(TEXT))
        client.number = 10**6
        self.assertIsNotNone(client.result("textDocument/hover", **self.place(4, 10)))

    def test_answers_come_at_once(self):
        text = TEXT + "".join(
            f"camera c{i}(a = {i + 1}, b = 2*a) {{\n    let w = a*b\n    map u = 0 .. w, v = square\n"
            f"    eye sphere(radius = 1)\n    look normal outward\n}}\n" for i in range(166))
        self.assertGreater(text.count("\n"), 1000)
        client = self.connect(text)
        for method, place in (("hover", self.place(4, 10)), ("completion", self.place(4, 10)),
                              ("completion", self.place(5, 10))):
            seconds = []
            for i in range(20):
                client.send(notification(
                    "textDocument/didChange", textDocument={"uri": URI, "version": 2 + i},
                    contentChanges=[{"range": part(0, 0, 1), "text": "/"}]))
                begin = time.perf_counter()
                client.result(f"textDocument/{method}", **place)
                seconds.append(time.perf_counter() - begin)
            print(f"{method}: {1e3*statistics.median(seconds):.1f} ms of {len(text)} bytes")
            if not os.environ.get("BALCONY_SANITIZED"):
                self.assertLess(min(seconds), 0.02)


if __name__ == "__main__":
    support.main()
