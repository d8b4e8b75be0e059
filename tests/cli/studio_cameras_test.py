# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""balcony studio: thumbnails of the built-in cameras."""

import support
from studio_case import StudioTest


class Cameras(StudioTest):
    def shown(self, page, names):
        """The heads of thumbnails, as soon as these are there."""
        while True:
            made = {one["name"]: one for one in page.frames if one["kind"] == "thumbnail"}
            if set(names) <= set(made):
                return made
            page.next()

    def test_a_list(self):
        self.open(scene="missing.obj")
        cameras = self.page().begin().result("cameras/list")["cameras"]
        self.assertGreater(len(cameras), 150)
        fisheye, = (one for one in cameras if one["name"] == "fisheye")
        self.assertEqual(fisheye["family"], "fisheye")
        listed, _ = self.run_command("list", "fisheye")
        self.assertIn(fisheye["about"].splitlines()[0], listed)

    def test_thumbnails(self):
        self.open(scene="room.glb")
        page, other = self.page().begin(), self.page().begin()
        page.wait_for("studio/scene", state="ready")
        names = ["pinhole", "fisheye", "panini"]
        page.result("cameras/show", names=names, width=64, height=36)
        made = self.shown(page, names)
        self.assertEqual((made["pinhole"]["width"], made["pinhole"]["height"]), (64, 36))
        self.assertEqual((made["fisheye"]["width"], made["fisheye"]["height"]), (36, 36))
        for one in made.values():
            self.assertEqual(one["format"], "jpeg")
            self.assertEqual(one["picture"][:3], b"\xff\xd8\xff")
        # All pages get them. Those that were made come at once.
        self.assertEqual(self.shown(other, names)["panini"]["picture"], made["panini"]["picture"])
        page.frames.clear()
        page.result("cameras/show", names=names[:2], width=64, height=36)
        self.assertEqual(set(self.shown(page, names[:2])), set(names[:2]))
        # Not in another size.
        page.frames.clear()
        page.result("cameras/show", names=names[:1], width=32, height=32)
        self.assertEqual(self.shown(page, names[:1])["pinhole"]["width"], 32)

    def test_a_text(self):
        self.open(scene="missing.obj")
        page = self.page().begin()
        text = page.result("cameras/text", name="panorama")["text"]
        self.assertRegex(text, r"(?m)^camera panorama\(.*yaw = 0deg")
        page.edit(text)
        self.assertEqual(page.wait_for("textDocument/publishDiagnostics",
                                       version=page.version)["diagnostics"], [])
        self.assertIn("fisheye", page.error("cameras/text", name="fishey")["message"])
        self.assertEqual(page.error("cameras/text", name="/etc/passwd")["code"], -32602)

    def test_what_cannot_be_shown(self):
        self.open(scene="room.glb")
        page = self.page().begin()
        page.wait_for("studio/scene", state="ready")
        (self.folder / "fisheye.cam").write_text("camera {")
        good = {"names": ["fisheye"], "width": 64, "height": 36}
        for wrong in ({"names": "fisheye"}, {"names": [7]}, {"width": 0}, {"width": 513},
                      {"height": -1}, {"height": 1.5}, {"names": ["my.cam"]},
                      {"names": ["/etc/passwd"]}):
            self.assertEqual(page.error("cameras/show", **{**good, **wrong})["code"], -32602, wrong)
        self.assertIn("fisheye", page.error("cameras/show", **{**good, "names": ["fishey"]})["message"])
        self.assertEqual(page.error("cameras/show")["code"], -32602)
        page.result("cameras/show", **{**good, "names": ["fisheye"] * 1000})
        page.result("cameras/show", **{**good, "names": []})
        self.assertTrue(self.is_alive())

    def test_without_a_scene(self):
        self.open(scene="missing.obj")
        page = self.page().begin()
        page.wait_for("studio/scene", state="failed")
        self.assertIn("no scene is loaded", page.error("cameras/show", names=[], width=9, height=9)["message"])


if __name__ == "__main__":
    support.main()
