# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""balcony export: cameras as texts in other languages."""

import ast
import subprocess

import support

TOWER = """// Looks out of a tower.
camera tower(radius = 3, lean = 10deg, count = 2) {
    map  u = -180deg .. 180deg, v = -1 .. 1
    eye  cylinder(radius)
    move repeat(count, rotate(y, lean))
}

picture both {
    layer tower
    layer tower { place (0.7, 0.1) .. (0.9, 0.3) }
}
"""


class Export(support.CommandTest):
    def setUp(self):
        super().setUp()
        (self.folder / "tower.cam").write_text(TOWER)

    def test_the_ending_names_the_language(self):
        for ending, begins in (("osl", "// tower:"), ("glsl", "// tower:"), ("c", "// tower:"),
                               ("py", "# tower:")):
            out, err = self.run_command("export", "tower.cam:tower", "-o", f"t.{ending}")
            self.assertTrue(out.startswith(f"t.{ending}: exported"), out)
            self.assertEqual(err, "")
            text = (self.folder / f"t.{ending}").read_text()
            self.assertTrue(text.startswith(begins), text[:80])
            self.assertIn("Looks out of a tower.", text)
            self.assertIn("eye cylinder(radius)", text)
        self.assertIn("import numpy", text, "the first language of this ending")

    def test_standard_output_is_the_text_alone(self):
        out, err = self.run_command("export", "tower.cam:tower", "--to", "c")
        self.assertTrue(out.startswith("// tower:"))
        self.assertTrue(out.endswith("}\n"))
        self.assertEqual(err, "")

    def test_parameters_stay_open(self):
        def facts(*options):
            return self.json_of("export", "tower.cam:tower", "--to", "c", "--json", *options)
        self.assertEqual(facts()["parameters"]["open"], [])
        found = facts("--parameters", "all")["parameters"]
        self.assertEqual(found, {"open": ["radius", "lean"], "closed": ["count"]})
        text = facts("--parameters", "lean", "--set", "radius=7")["text"]
        self.assertIn("parameters->lean", text)
        self.assertIn("7.0 * ", text)
        self.assertEqual(self.json_of("export", "tower.cam:tower", "--to", "osl", "--json")
                         ["parameters"]["open"], ["radius", "lean"])
        self.refused("export", "tower.cam:tower", "--to", "c", "--parameters", "lena", code=1,
                     says="no parameter 'lena'", helps="did you mean 'lean'")

    def test_the_inverse_stands_behind_the_ray(self):
        for words in (("--to", "c", "--parameters", "all"), ("--to", "numpy"), ("--to", "torch")):
            plain = self.run_command("export", "tower.cam:tower", *words)[0]
            whole = self.run_command("export", "tower.cam:tower", *words, "--inverse")[0]
            self.assertTrue(whole.startswith(plain[:200]))
            self.assertNotIn("tower_find(", plain)
            self.assertIn("tower_find(", whole)
        self.refused("export", "tower.cam:tower", "--to", "osl", "--inverse", code=2,
                     says="in the language osl finds no points", helps="one of c, numpy, torch")

    def test_single_precision_is_judged(self):
        facts = self.json_of("export", "tower.cam:tower", "--to", "osl", "--json")
        self.assertLess(facts["single_precision"]["largest_pixels"], 0.01)
        far = "camera far { map u = -1 .. 1, v = square  eye surface(u, v) = [1e6 + u, 1e6 + v, 0] }"
        (self.folder / "far.cam").write_text(far)
        out, err = self.run_command("export", "far.cam", "-o", "far.osl")
        self.assertIn("in single precision, rays move by up to", err)
        _, err = self.run_command("export", "far.cam", "-o", "far.c")
        self.assertEqual(err, "")

    def test_refusals_name_the_reason(self):
        self.refused("export", "tower.cam:both", "--to", "c", code=1, says="is a picture",
                     helps="layers")
        self.refused("export", "tower.cam:tower", code=2, says="is not known", helps="--to")
        self.refused("export", "tower.cam:tower", "--to", "oslo", code=2, says="--to",
                     helps="did you mean 'osl'?")
        self.refused("export", "tower.cam:tower", "-o", "none/t.c", code=3, says="none")
        mesh = ("camera vase { map u = 0 .. 1, v = 0 .. 1  eye mesh(\"vase.obj\")  look normal }")
        (self.folder / "vase.cam").write_text(mesh)
        self.refused("export", "vase.cam", "--to", "glsl", code=1, says='mesh("vase.obj")',
                     helps="balcony rays")
        focus = ("camera f { map u = -1 .. 1, v = square  eye point()  "
                 "toward surface(u, v) = [1, u, v]  lens(0.1, focus = on(\"Vase\")) }")
        (self.folder / "focus.cam").write_text(focus)
        self.refused("export", "focus.cam", "--to", "c", code=1, says="Vase", helps="focus = 5")

    def test_hostile_texts_stay_comments(self):
        text = ("// */ \"quoted\" \\\ncamera x(y = 1, double = 2, s1 = 3) {\n"
                "    map  u = -y .. double, v = -1 .. s1\n    eye plane()\n}\n")
        (self.folder / "x.cam").write_text(text)
        self.run_command("export", "x.cam", "-o", "x.c", "--parameters", "all")
        built = subprocess.run(["g++", "-x", "c", "-std=c99", "-Wall", "-Wextra", "-Werror", "-c",
                                "x.c", "-o", "x.o"], cwd=self.folder, capture_output=True,
                               text=True)
        self.assertEqual(built.returncode, 0, built.stderr)

    def test_names_of_python_stay_its_own(self):
        (self.folder / "None.cam").write_text(
            "camera None(x = 1, lambda = 2, live = 3, mi = 4, np = 5, torch = 6, self = 7, s1 = 8) {\n"
            "    map u = -x - lambda .. live + mi, v = -np - torch .. self + s1\n    eye plane()\n}\n")
        for language, library in (("numpy", "np"), ("torch", "torch"), ("mitsuba", "mi")):
            out, _ = self.run_command("export", "None.cam", "--to", language, "--parameters", "all")
            compile(out, f"{language}.py", "exec")
            self.assertNotIn(library, self.formula_names(out))

    @staticmethod
    def formula_names(text):
        """The names of the parameters of the function with the formulas."""
        function = next(one for one in ast.parse(text).body
                        if isinstance(one, ast.FunctionDef) and one.name.endswith("_formulas"))
        return {one.arg for one in function.args.args}


if __name__ == "__main__":
    support.main()
