# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""balcony studio: the camera that is shown in other languages."""

import support
from studio_case import CAMERA, StudioTest


class Exports(StudioTest):
    # After the name of Balcony and the file, texts say the camera and its values.
    def test_the_text_is_that_of_the_command(self):
        self.open()
        page = self.shown()
        for language, ending in (("osl", "osl"), ("glsl", "glsl"), ("c", "c"), ("numpy", "py"),
                                 ("torch", "py")):
            made = page.result("export", language=language)
            out, _ = self.run_command("export", "my.cam:above", "--to", language)
            self.assertEqual(made["text"], out)
            self.assertEqual((made["file"], made["diagnostics"]), (f"above.{ending}", []))

    def test_it_has_the_values_that_are_shown(self):
        self.open()
        page = self.shown(values=[{"parameter": "size", "value": 2.5}])
        for language in ("c", "osl"):
            out, _ = self.run_command("export", "my.cam:above", "--set", "size=2.5", "--to", language)
            self.assertEqual(page.result("export", language=language)["text"], out)

    def test_what_cannot_be_exported_says_why(self):
        (self.folder / "my.cam").write_text(CAMERA + "picture two { layer above layer above }\n")
        self.open(camera="my.cam:above")
        page = self.shown()
        self.assertIn("not exported to 'cobol'", page.error("export", language="cobol")["message"])
        self.assertEqual(page.error("export")["code"], -32602)
        change = page.result("view/change", camera="two")["change"]
        page.wait_for("view/rest", change=change)
        self.assertIn("'two' is a picture with layers, but one camera is exported\n"
                      "  help: choose one of its cameras",
                      page.error("export", language="c")["message"])
        bent = CAMERA.replace("look relative", "look relative\n    bend pinholes([(0, 0, 3), (9, 0, 0)])")
        page.edit(bent)
        change = page.result("view/change", camera="above")["change"]
        page.wait_for("view/rest", change=change)
        self.assertIn("its rays are bent", page.error("export", language="c")["message"])

    def test_languages_are_told(self):
        self.open()
        names = [one["name"] for one in self.page().begin().about["languages"]]
        self.assertEqual(set(names), {"osl", "glsl", "c", "numpy", "torch", "mitsuba", "pov"})


if __name__ == "__main__":
    support.main()
