# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""balcony studio: the messages of its protocol."""

import signal
import time

import support
from studio_case import CAMERA, SMALL, StudioTest, applied


class Messages(StudioTest):
    def test_about(self):
        self.open("--size", "64x48")
        about = self.page().begin().about
        self.assertEqual(about["protocol"], 1)
        self.assertEqual(about["text"], CAMERA)
        self.assertEqual(about["uri"], (self.folder / "my.cam").resolve().as_uri())
        self.assertEqual(about["scene"], "scene.obj")
        self.assertEqual(about["size"], [64, 48])
        self.assertEqual(about["savedVersion"], about["textVersion"])
        self.assertFalse(about["readOnly"])

    def test_the_order_of_messages(self):
        self.open()
        page = self.page()
        for method in ("view/change", "text/set", "file/save", "textDocument/hover", "handles"):
            self.assertEqual(page.error(method)["code"], -32002, method)
        page.begin()
        for method in page.about["requests"]:
            self.assertNotEqual(page.ask(method).get("error", {}).get("code"), -32601, method)
        self.assertEqual(page.error("initialize")["code"], -32600)
        self.assertEqual(page.error("view/nothing")["code"], -32601)

    def test_the_language(self):
        self.open()
        page = self.page().begin()
        hover = page.result("textDocument/hover", textDocument={"uri": page.uri},
                            position={"line": 5, "character": 13})
        self.assertIn("surface", hover["contents"]["value"])
        self.assertEqual(
            [one["name"] for one in page.result("textDocument/documentSymbol",
                                                textDocument={"uri": page.uri})], ["above"])
        page.edit(CAMERA.replace("eye  surface", "eye  surfice"))
        told = page.wait_for("textDocument/publishDiagnostics", version=page.version)
        self.assertIn("surfice", told["diagnostics"][0]["message"])

    def test_pictures_get_better(self):
        self.open()
        page = self.page().begin()
        page.wait_for("studio/scene", state="ready")
        change = page.result("view/change", size=SMALL)["change"]
        rest = page.wait_for("view/rest", change=change)
        self.assertEqual(rest["change"], change)
        frames = [frame for frame in page.frames if frame["change"] == change]
        self.assertEqual([frame["quality"] for frame in frames][-1], "denoised")
        last = frames[-1]
        self.assertEqual((last["width"], last["height"], last["format"]), (64, 48, "png"))
        self.assertEqual(last["samples"], 2)
        (self.folder / "last.png").write_bytes(last["picture"])
        width, height, rows = support.png_pixels(self.folder / "last.png", form=(8, 2))
        self.assertEqual((width, height), (64, 48))
        self.assertGreater(len({pixel for row in rows for pixel in row}), 1)

    def test_a_picture_in_motion_is_coarse(self):
        self.open()
        page = self.page().begin()
        page.wait_for_frame(page.result("view/change", size=[1600, 1200])["change"])
        # A preview that comes soon takes the place of a coarse frame that has not been sent.
        end = time.monotonic() + 60
        while "coarse" not in (frame["quality"] for frame in page.frames):
            self.assertLess(time.monotonic(), end)
            height = 5 + len(page.frames) % 10 / 10
            change = page.result("view/change", values=[
                {"parameter": "height", "value": height}])["change"]
            page.wait_for_frame(change)
        frame = next(frame for frame in page.frames if frame["quality"] == "coarse")
        self.assertEqual(frame["format"], "jpeg")
        self.assertEqual(frame["picture"][:3], b"\xff\xd8\xff")
        self.assertLess(frame["width"], 1600)

    def test_parameters(self):
        self.open()
        page = self.page().begin()
        told = page.wait_for("view/camera", name="above")
        self.assertEqual([(one["name"], one["value"], one["unit"]) for one in told["open"]],
                         [("size", 3, "number"), ("height", 5, "number")])
        self.assertEqual(told["diagnostics"], [])

    def test_a_value_moves_the_picture(self):
        self.open()
        page = self.page().begin()
        still = page.result("view/change", size=SMALL)["change"]
        page.wait_for("view/rest", change=still)
        moved = page.result("view/change",
                            values=[{"parameter": "size", "value": 0.5}])["change"]
        self.assertGreater(moved, still)
        page.wait_for("view/rest", change=moved)
        self.assertNotEqual(page.wait_for_frame(still, "denoised")["picture"],
                            page.frames[-1]["picture"])

    def test_a_change_that_is_none(self):
        self.open()
        page = self.page().begin()
        for change in ({"size": [0, 5]}, {"size": [1e9, 1]}, {"size": [8192, 8192]},
                       {"size": [5]}, {"size": "big"}, {"size": [-4, 4]}, {"size": [1.5, 4]},
                       {"values": [{"parameter": "size"}]}, {"values": 5}, {"camera": 7},
                       {"values": [{"parameter": 1, "value": 1}]}, {"exposure": "yes"}):
            self.assertEqual(page.error("view/change", **change)["code"], -32602, change)

    def test_a_slow_page_gets_the_newest_picture(self):
        self.open()
        page = self.page(is_slow=True).begin()
        page.wait_for("studio/scene", state="ready")
        first = page.wait_for_frame(0)
        for i in range(20):
            last = page.result("view/change", size=SMALL, values=[
                {"parameter": "height", "value": 5 + i / 10}])["change"]
        page.wait_for("view/camera", change=last)
        # Nothing more comes until the first one is seen.
        time.sleep(1.0)
        page.result("textDocument/documentSymbol", textDocument={"uri": page.uri})
        self.assertEqual(len(page.frames), 1)
        page.seen(first)
        frame = page.wait_for_frame(first["change"] + 1)
        self.assertEqual(frame["change"], last)
        self.assertEqual(len(page.frames), 2)

    def test_a_camera_with_errors(self):
        self.open()
        page = self.page().begin()
        page.wait_for("view/camera", name="above")
        page.edit(CAMERA.replace("height]", "heigth]"))
        told = page.wait_for("view/camera", name="")
        self.assertIn("heigth", told["diagnostics"][0]["message"])
        self.assertEqual(told["diagnostics"][0]["range"]["start"]["line"], 4)
        page.edit(CAMERA)
        page.wait_for("view/camera", change=told["change"] + 1, name="above")

    def test_a_scene_that_fails(self):
        self.open(scene="missing.obj")
        page = self.page().begin()
        told = page.wait_for("studio/scene", state="failed")
        self.assertIn("missing.obj", told["message"])
        # The text can be edited all the same.
        self.assertEqual(page.about["text"], CAMERA)
        page.edit(CAMERA + "// More.\n")
        self.assertTrue(page.result("textDocument/documentSymbol",
                                    textDocument={"uri": page.uri}))
        self.assertIn("change", page.result("view/change", size=SMALL))

    def test_two_cameras_of_a_file(self):
        (self.folder / "my.cam").write_text(CAMERA + CAMERA.replace("above", "nearby"))
        self.open(camera="my.cam:above")
        page = self.page().begin()
        self.assertEqual(page.about["camera"], "above")
        page.wait_for("view/camera", name="above")
        page.notify("view/change", camera="nearby")
        page.wait_for("view/camera", name="nearby")

    def test_a_camera_to_begin_with(self):
        self.open(scene="room.glb", camera="fisheye")
        page = self.page().begin()
        self.assertIsNone(page.about["savedVersion"])
        self.assertIn("fisheye", page.about["text"])
        page.wait_for("view/camera", name="fisheye")
        self.assertNotIn("fisheye.cam", self.files())
        page.result("file/save")
        self.assertEqual((self.folder / "fisheye.cam").read_text(), page.about["text"])


class Texts(StudioTest):
    def test_values_are_written_into_the_text(self):
        self.open()
        page = self.page().begin()
        page.wait_for("view/camera", name="above")
        answer = page.result("text/set", values=[{"parameter": "height", "value": 7.5},
                                                 {"parameter": "size", "value": 2}])
        self.assertEqual(answer["version"], page.version)
        text = applied(CAMERA, answer["edits"])
        self.assertEqual(text, CAMERA.replace("size = 3, height = 5", "size = 2, height = 7.5"))
        # The page sends what it has made of them.
        page.edit(text)
        self.assertEqual(page.result("text/set", values=[])["edits"], [])
        change = page.result("view/change")["change"]
        told = page.wait_for("view/camera", change=change)
        self.assertEqual([one["value"] for one in told["open"]], [2, 7.5])

    def test_values_that_are_none(self):
        self.open()
        page = self.page().begin()
        page.wait_for("view/camera", name="above")
        error = page.error("text/set", values=[{"parameter": "hieght", "value": 1}])
        self.assertIn("did you mean 'height'?", error["message"])
        self.assertEqual(page.error("text/set")["code"], -32602)

    def test_two_pages_share_a_text(self):
        self.open()
        one, other = self.page().begin(), self.page().begin()
        text = CAMERA.replace("height = 5", "height = 6")
        one.edit(text)
        told = other.wait_for("studio/text", version=one.version)
        self.assertEqual(told["text"], text)
        other.version = told["version"]
        # The language server of the other page has it, too.
        other.edit(text + "camera more = above(height = 7)\n")
        symbols = other.result("textDocument/documentSymbol", textDocument={"uri": other.uri})
        self.assertEqual([one["name"] for one in symbols], ["above", "more"])
        one.wait_for("studio/text", version=other.version)
        symbols = one.result("textDocument/documentSymbol", textDocument={"uri": one.uri})
        self.assertEqual([one["name"] for one in symbols], ["above", "more"])

    def test_an_edit_of_an_older_text(self):
        self.open()
        one, other = self.page().begin(), self.page().begin()
        one.edit("// one\n" + CAMERA)
        one.result("textDocument/documentSymbol", textDocument={"uri": one.uri})
        other.edit("// other\n" + CAMERA)
        other.result("textDocument/documentSymbol", textDocument={"uri": other.uri})
        told = [message["params"] for message in other.told if message["method"] == "studio/text"]
        self.assertEqual([one["text"] for one in told], ["// one\n" + CAMERA] * 2)
        self.assertIsNotNone(told[0]["by"])
        self.assertIsNone(told[1]["by"])
        self.assertEqual([m for m in one.told if m["method"] == "studio/text"], [])
        # Parts of a text are not taken.
        one.notify("textDocument/didChange",
                   textDocument={"uri": one.uri, "version": one.version + 1},
                   contentChanges=[{"range": {"start": {"line": 0, "character": 0},
                                              "end": {"line": 0, "character": 1}}, "text": "x"}])
        self.assertEqual(one.wait_for("studio/text")["version"], one.version)

    def test_save(self):
        self.open()
        one, other = self.page().begin(), self.page().begin()
        one.edit("// saved\n" + CAMERA)
        answer = one.result("file/save")
        self.assertEqual(answer["version"], one.version)
        self.assertEqual((self.folder / "my.cam").read_text(), "// saved\n" + CAMERA)
        self.assertEqual(other.wait_for("studio/saved")["version"], one.version)
        self.assertEqual(self.page().begin().about["savedVersion"], one.version)
        self.assertEqual(self.files(), ["my.cam", "room.glb", "scene.obj"])

    def test_save_when_the_file_has_changed(self):
        self.open()
        page = self.page().begin()
        page.edit("// mine\n" + CAMERA)
        (self.folder / "my.cam").write_text("// theirs\n" + CAMERA)
        error = page.error("file/save")
        self.assertEqual(error["code"], -32001)
        self.assertIn("has changed on the disk", error["message"])
        self.assertEqual((self.folder / "my.cam").read_text(), "// theirs\n" + CAMERA)
        page.result("file/save", force=True)
        self.assertEqual((self.folder / "my.cam").read_text(), "// mine\n" + CAMERA)
        page.result("file/save")

    def test_save_where_nothing_can_be_written(self):
        self.open(camera="none/my.cam")
        error = self.page().begin().error("file/save")
        self.assertEqual(error["code"], -32803)
        self.assertIn("none", error["message"])

    def test_read_only(self):
        self.open("--read-only")
        page = self.page().begin()
        self.assertTrue(page.about["readOnly"])
        page.edit("// mine\n" + CAMERA)
        error = page.error("file/save", force=True)
        self.assertIn("--read-only", error["message"])
        self.assertEqual((self.folder / "my.cam").read_text(), CAMERA)

    def test_a_restart_keeps_nothing_but_the_file(self):
        self.open("--token-file", "token")
        page = self.page().begin()
        page.edit("// mine\n" + CAMERA)
        page.result("textDocument/documentSymbol", textDocument={"uri": page.uri})
        # A connection that is lost finds the text again; a server that is started again is another
        # session.
        again = self.page().begin()
        self.assertEqual(again.about["text"], "// mine\n" + CAMERA)
        self.assertEqual(again.about["session"], page.about["session"])
        self.process.send_signal(signal.SIGTERM)
        self.assertEqual(self.process.wait(60), 130)
        self.open("--token-file", "token", "--port", str(self.port))
        new = self.page().begin()
        self.assertEqual(new.about["text"], CAMERA)
        self.assertNotEqual(new.about["session"], page.about["session"])


if __name__ == "__main__":
    support.main()
