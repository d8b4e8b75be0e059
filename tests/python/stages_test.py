# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""Cameras that are composed in Python, formulas of functions, and cameras of sampled rays."""

import copy
import inspect
import math
import pickle
import pydoc
import unittest
from pathlib import Path

import balcony
import numpy as np
from balcony import formulas, stages
from scene_files import RoomTest

SIZE = (64, 48)
DOCS = Path(__file__).resolve().parents[2] / "docs"


def assert_same_rays(one, other, size=SIZE):
    for array, wanted in zip(one.rays(*size, footprints=True), other.rays(*size, footprints=True)):
        np.testing.assert_array_equal(array, wanted)
    np.testing.assert_array_equal(one.rays(*size, footprints=True).footprints,
                                  other.rays(*size, footprints=True).footprints)


class Stages(unittest.TestCase):
    def test_every_stage_of_the_catalogue_is_there_and_says_what_it_is(self):
        all_kinds = stages.kinds()
        self.assertIn("helix", all_kinds["object generator"])
        for kind, rows in all_kinds.items():
            page = (DOCS / "stages" / f"{kind.replace(' ', '-')}s.md").read_text() \
                if kind not in ("focus", "lens") else None
            for name, meaning in rows.items():
                made = getattr(stages, name)
                self.assertIn(name, dir(stages))
                self.assertIn(f"{kind}: ", made.__doc__)
                self.assertIn(" ".join(meaning.split()), " ".join(made.__doc__.split()))
                if page is not None:
                    self.assertIn(f"## {name}\n", page)

    def test_help_reads_like_the_page(self):
        text = pydoc.plain(pydoc.render_doc(stages.helix))
        page = (DOCS / "stages" / "object-generators.md").read_text()
        section = page[page.index("## helix\n"):]
        section = section[:section.index("\n## ", 5)]
        formula = section[section.index("```text\n") + 8:]
        for line in formula[:formula.index("\n```")].splitlines():
            self.assertIn(line.strip(), text)
        for row in (line for line in section.splitlines() if line.startswith("| `")):
            name, kind, default, limits, meaning = (one.strip().strip("`") for one in row.split("|")[1:-1])
            for part in (name, kind, default, limits, meaning):
                self.assertIn(part, " ".join(text.split()), row)
        self.assertEqual(str(inspect.signature(stages.zoom)), "(at=(0.5, 0.5), radius=0.3, strength=2)")

    def test_every_example_of_the_catalogue_can_be_composed(self):
        # All stages without arguments, where they need none, are what the language takes.
        composed = 0
        for name in stages.kinds()["object generator"]:
            made = getattr(stages, name)
            try:
                text = str(made())
            except TypeError:
                continue
            composed += 1
            self.assertEqual(text, name)
        self.assertGreater(composed, 20)

    def test_a_stage_writes_its_arguments(self):
        for made, wanted in ((stages.circle(2), "circle(2)"),
                             (stages.circle(radius=0.1), "circle(radius = 0.1)"),
                             (stages.circle(np.float32(0.5)), "circle(0.5)"),
                             (stages.rotate(math.pi / 2), "rotate(90deg)"),
                             (stages.rotate(0.1), "rotate(0.1rad)"),
                             (stages.rotate("30deg"), "rotate(30deg)"),
                             (stages.arc_length(stages.circle, from_=0, to=1), "arc_length(circle, from = 0, to = 1)"),
                             (stages.product(stages.circle, stages.polyline([(1, 0), (2, 1)])),
                              "product(circle, polyline([(1, 0), (2, 1)]))"),
                             (stages.polyline(np.array([[1.0, 0.5], [2, 1]])), "polyline([(1, 0.5), (2, 1)])"),
                             (stages.polyline("path.csv"), 'polyline("path.csv")'),
                             (stages.ray_map(Path("rays.npy"), "targets"), 'ray_map("rays.npy", targets)'),
                             (stages.on("Vase"), 'on("Vase")'),
                             (stages.blend(stages.normal, stages.along("-z"), weight=lambda u, v: v / 2),
                              "blend(normal, along(-z), weight(u, v) = [v/2])")):
            self.assertEqual(str(made), wanted)
            self.assertIn(wanted, repr(made))

    def test_wrong_stages_say_what_is_right(self):
        with self.assertRaisesRegex(AttributeError, "did you mean 'helix'"):
            stages.helx
        with self.assertRaisesRegex(TypeError, "did you mean 'radius'"):
            stages.circle(radus=2)
        with self.assertRaisesRegex(TypeError, "circle"):
            stages.circle(1, 2, 3, 4, 5, 6)
        with self.assertRaisesRegex(TypeError, "object generator is needed"):
            balcony.compose(eye=stages.normal())
        for value in (math.nan, math.inf):
            with self.assertRaisesRegex(ValueError, "finite"):
                str(stages.circle(value))
        for value in (True, object(), {}, b"2"):
            with self.assertRaises(TypeError):
                str(stages.circle(value))
        with self.assertRaisesRegex(ValueError, "quotation mark"):
            str(stages.polyline('a".csv'))
        with self.assertRaises(balcony.InputError) as caught:
            balcony.compose(eye=stages.circle(-1), toward=stages.point(9, 0, 0))
        self.assertEqual(caught.exception.line, 2)


class Compose(RoomTest):
    def test_it_is_the_camera_of_the_text(self):
        text = """
camera flight(radius = 10 above 0, tilt = 30deg from 0deg to 90deg) {
    aspect 2
    map    u = 90deg .. 0deg, v = -180deg .. 180deg
    warp   zoom(at = (0.6, 0), radius = 0.4, strength = 2.5), rotate(10deg)
    eye    circle(radius)
    toward torus(5*radius, 2)
    move   rotate(x, tilt), translate(0, -14, 3)
}
"""
        radius = balcony.parameter("radius", 10, above=0)
        tilt = balcony.parameter("tilt", "30deg", at_least="0deg", at_most="90deg")
        made = balcony.compose(
            "flight", aspect=2, map=((math.pi / 2, 0), (-math.pi, "180deg")),
            warp=[stages.zoom(at=(0.6, 0), radius=0.4, strength=2.5), stages.rotate("10deg")],
            eye=stages.circle(radius), toward=stages.torus(5 * radius, 2),
            move=[stages.rotate("x", tilt), stages.translate(0, -14, 3)], comment="Flies round.")
        wanted = balcony.camera(text)
        self.assertEqual(made.name, "flight")
        self.assertIn("Flies round.", str(made))
        self.assertEqual(made.parameters, wanted.parameters)
        assert_same_rays(made, wanted)
        for cam in (made, wanted):
            cam.set(radius=3, tilt=0.4)
        assert_same_rays(made, wanted)
        assert_same_rays(balcony.camera(made.text), wanted)
        assert_same_rays(pickle.loads(pickle.dumps(made)), wanted)
        with self.assertRaises(balcony.Error):
            made.radius = 0

    def test_all_statements(self):
        made = balcony.compose(
            eye=balcony.path(stages.sphere(2), map=((1, -1), "square"), warp=stages.rotate(0.1),
                             move=[stages.translate(1, 2, 3)]),
            toward="sphere(9)", look="relative", map=((2, -2), "square"), axes="y_up", aspect=(6, 2),
            arrange=[stages.mirror("x")], stereo=stages.stereo(separation=0.1, convergence=3),
            lens=stages.lens(radius=0.1, focus=5), time=formulas.t + formulas.expression("y/50"),
            place="(0.1, 0.1) .. (0.9, 0.9)", fit="pz = scene_inside[2]",
            move=stages.translate(0, 0, balcony.parameter("pz", 0)))
        text = """
camera composed(pz = 0) {
    place (0.1, 0.1) .. (0.9, 0.9)
    axes y_up
    fit pz = scene_inside[2]
    arrange mirror(x)
    aspect (6, 2)
    map u = 2 .. -2, v = square
    eye {
        map u = 1 .. -1, v = square
        warp rotate(0.1rad)
        object sphere(2)
        move translate(1, 2, 3)
    }
    toward sphere(9)
    look relative
    stereo(separation = 0.1, convergence = 3)
    lens(radius = 0.1, focus = 5)
    time = t + y/50
    move translate(0, 0, pz)
}
"""
        assert_same_rays(made, balcony.camera(text))
        self.assertEqual([line.split() for line in made.text.splitlines()],
                         [line.replace("t + y/50", "t + (y/50)").split() for line in text.strip().splitlines()])

    def test_a_composed_camera_renders(self):
        cam = balcony.compose(eye=stages.sphere(0.2), map=((3, -3), "square"), move=stages.translate(0, 0, 1))
        scene = balcony.load(self.room)
        picture = scene.render(cam, size=SIZE, samples=1)
        rays = cam.rays(*SIZE, scene=scene)
        hits = rays.origins + picture["depth"][..., None] * rays.directions
        self.assertLess(np.abs(hits - picture["position"]).max(), 1e-5)

    def test_parameters_that_cannot_be(self):
        for name in ("a b", "1a", "", "ä"):
            with self.assertRaises(ValueError):
                balcony.parameter(name, 1)
        one, other = balcony.parameter("a", 1), balcony.parameter("a", 2)
        with self.assertRaisesRegex(ValueError, "'a'"):
            balcony.compose(eye=stages.circle(one), toward=stages.torus(other, 1))
        with self.assertRaises(balcony.InputError):
            balcony.compose(eye=stages.circle(balcony.parameter("camera", 1)))


class Formulas(unittest.TestCase):
    def test_a_stage_of_a_function_is_the_built_in_one(self):
        major, minor = balcony.parameter("major", 5), balcony.parameter("minor", 2)

        def torus(u, v):
            reach = major + minor * np.cos(v)
            return reach * np.cos(u), reach * np.sin(u), minor * np.sin(v)

        words = {"eye": stages.circle(1), "map": ((2, -2), (-1, 1)), "parameters": [major, minor]}
        own = balcony.compose(toward=stages.surface(torus), **words)
        built_in = balcony.compose(toward=stages.torus(major, minor), **words)
        # The same operations in another order: some roundings of numbers up to 7.
        for array, wanted in zip(own.rays(*SIZE, footprints=True), built_in.rays(*SIZE, footprints=True)):
            np.testing.assert_allclose(array, wanted, atol=1e-14)
        points = built_in.rays(*SIZE).origins[::8, ::8].reshape(-1, 3) + 3 * \
            built_in.rays(*SIZE).directions[::8, ::8].reshape(-1, 3)
        for at in (points, np.array([[20.0, 17.0], [41.5, 30.25]])):
            mine, names = own.jacobian(at, size=SIZE)
            theirs, wanted_names = built_in.jacobian(at, size=SIZE)
            self.assertEqual(names, wanted_names)
            self.assertEqual(set(names), {"major", "minor"})
            np.testing.assert_allclose(mine, theirs, rtol=1e-9, atol=1e-9)
        np.testing.assert_allclose(own.project(points, size=SIZE), built_in.project(points, size=SIZE), atol=1e-6)
        self.assertIn("cos", own.export("numpy"))

    def test_functions_are_those_of_numpy(self):
        x = np.random.default_rng(1).uniform(0.05, 0.95, 64)  # Off the jumps.
        one_argument = {"arccos", "arccosh", "arcsin", "arcsinh", "arctan", "arctanh", "absolute", "cbrt", "ceil",
                        "cos", "cosh", "deg2rad", "exp", "exp2", "expm1", "fabs", "floor", "log", "log10", "log1p",
                        "log2", "negative", "positive", "rad2deg", "reciprocal", "sign", "sin", "sinh", "sqrt",
                        "square", "tan", "tanh", "degrees", "radians"}
        two_arguments = {"add", "arctan2", "divide", "float_power", "floor_divide", "fmax", "fmin", "hypot",
                         "maximum", "minimum", "mod", "multiply", "power", "remainder", "subtract"}
        conditions = {"equal", "greater", "greater_equal", "less", "less_equal", "not_equal"}
        functions = [lambda u, name=name: getattr(np, name)(u + (name == "arccosh")) for name in one_argument]
        functions += [lambda u, name=name: getattr(np, name)(3 * u, u + 0.25) for name in two_arguments]
        functions += [lambda u, name=name: np.where(getattr(np, name)(u, 0.5), u, 2 - u) for name in conditions]
        functions += [lambda u: np.clip(u, 0.3, 0.5), lambda u: abs(u - 0.5), lambda u: (-u) % 0.3,
                      lambda u: -u**2, lambda u: (-u)**2, lambda u: 2**-u, lambda u: 2**u**2, lambda u: (2**u)**2,
                      lambda u: 1 - (u - 2), lambda u: 1 - u - 2, lambda u: 3 / (u / 2), lambda u: 3 / u / 2,
                      lambda u: 3 / (u * 2), lambda u: -(-u), lambda u: 1 - -u, lambda u: u // 0.3,
                      lambda u: np.where((u > 0.3) & ~(u > 0.7) | (u < 0.2), u, 0),
                      lambda u: np.array([[0.5, 2], [3, 4]])[1] @ np.array([u, u**2]),
                      lambda u: (np.sin(np.array([u, 2 * u])) * [1, 2]).sum(),
                      lambda u: np.float64(2) * u - np.float32(0.5) + np.int64(3),
                      lambda u: 1e-300 * u * 1e300, lambda u: u + 123456789012345678]
        for function in functions:
            # The value of the formula is the x of the origins of a curve.
            cam = balcony.compose(eye=stages.curve(lambda u: (function(u), 0, 0)), look=stages.along("x"),
                                  map=((0, 1), (0, 1)))
            at = np.stack([x * 100, 0 * x + 50], axis=-1)
            found = cam.rays_at(at, size=(100, 100)).origins[:, 0]
            u = cam.rays_at(at, size=(100, 100)).parameters[:, 0]
            wanted = np.array([float(function(one)) for one in u])
            np.testing.assert_allclose(found, wanted, rtol=1e-13, atol=1e-15,
                                       err_msg=inspect.getsource(function))

    def test_what_is_used_often_is_computed_once(self):
        # Of 2^300 operations, were it written out.
        def folded(u, v):
            x, y = u, v
            for _ in range(100):
                x, y = 0.5 * (x * y + np.sin(x)), 0.5 * (x + y)
            return x, y, u + v

        cam = balcony.compose(eye=stages.surface(folded), look=stages.along("x"), map=((0, 1), (1, 0)))
        self.assertLess(len(cam.text), 100_000)
        rays = cam.rays(8, 8)
        u, v = np.moveaxis(rays.parameters, -1, 0)
        np.testing.assert_allclose(rays.origins, np.stack(folded(u, v), axis=-1), atol=1e-14)
        # A condition of one long number, and the number of a parameter.
        factor = balcony.parameter("factor", 0.5)
        long = factor
        for _ in range(60):
            long = (long + factor / (1 + long)) / 2
        wanted = 0.5
        for _ in range(60):
            wanted = (wanted + 0.5 / (1 + wanted)) / 2
        cam = balcony.compose(eye=stages.circle(long), toward=stages.point(0, 0, 9), map=((0, 1), (0, 1)))
        rays = cam.rays(4, 4)
        np.testing.assert_allclose(np.linalg.norm(rays.origins[rays.valid], axis=-1), wanted, rtol=1e-14)

    def test_names_do_not_hide_each_other(self):
        u = balcony.parameter("u", 7)
        cam = balcony.compose(eye=stages.curve(lambda x: (u + x, 0, 0)), look=stages.along("x"),
                              map=((0, 1), (0, 1)))
        found = cam.rays_at([[25, 50]], size=(100, 100))
        self.assertEqual(found.origins[0, 0], 7 + found.parameters[0, 0])

    def test_what_a_formula_cannot_do_says_what_to_do(self):
        for function, says in ((lambda u: (1 if u > 0 else 2, 0), "select"),
                               (lambda u: (math.sin(u), 0), "numpy|NumPy"),
                               (lambda u: (u > 0 and u < 1, 0), "&"),
                               (lambda u: (np.gamma_(u) if hasattr(np, "gamma_") else np.heaviside(u, 1), 0),
                                "heaviside"),
                               (lambda u: (np.cumsum(u), 0), "cumsum"),
                               (lambda u: ("x", None), "returns"),
                               (lambda u: None, "returns"),
                               (3, "function")):
            with self.assertRaisesRegex(TypeError, says):
                balcony.compose(eye=stages.curve(function))
        with self.assertRaisesRegex(ValueError, "finite"):
            balcony.compose(eye=stages.curve(lambda u: (u, math.nan)))
        with self.assertRaises(balcony.InputError):
            balcony.compose(eye=stages.curve(lambda u: (u,)))
        with self.assertRaises(TypeError):
            balcony.compose(eye=stages.surface(lambda u: (u, 0, 0)))
        with self.assertRaisesRegex(TypeError, "2 arguments"):
            formulas.atan2(1)
        self.assertRaises(ZeroDivisionError, lambda: stages.curve(lambda u: (1 / 0, u)) and str(
            stages.curve(lambda u: (1 / 0, u))))

    def test_expressions_are_copied_and_shown(self):
        a = balcony.parameter("a", 1)
        self.assertEqual(repr((a + 1) * 2 - a**2), "(a + 1)*2 - a^2")
        self.assertEqual(repr(copy.copy(30 * formulas.deg)), "30*1deg")


class FromRays(RoomTest):
    @staticmethod
    def lens(x, y):
        # An equidistant fisheye by hand, in a round picture.
        right, up = 2 * x - 1, 1 - 2 * y
        radius = np.hypot(right, up)
        angle = radius * np.pi / 2
        across = np.where(radius > 0, np.sin(angle) / np.maximum(radius, 1e-300), 1)
        directions = np.stack([np.cos(angle), -right * across, up * across], axis=-1)
        return np.array([0.0, 0, 1.2]), directions, radius < 1

    def test_it_is_the_camera_of_the_function(self):
        made = balcony.from_rays(self.lens, self.folder / "lens.npy", size=(128, 128))
        cam = made.camera
        rays = cam.rays(128, 128)
        y, x = (np.mgrid[0:128, 0:128] + 0.5) / 128
        origin, directions, valid = self.lens(x, y)
        np.testing.assert_array_equal(rays.valid, valid)
        np.testing.assert_allclose(rays.directions[valid], directions[valid], atol=1e-12)
        np.testing.assert_allclose(rays.origins[valid], np.broadcast_to(origin, rays.origins.shape)[valid], atol=1e-12)
        # Anywhere between the samples, it is not farther off than it says.
        at = np.random.default_rng(1).uniform(30, 98, (2000, 2))
        found = cam.rays_at(at, size=(128, 128)).directions
        angle = np.linalg.norm(found - self.lens(*(at / 128).T)[1], axis=-1)
        self.assertLess(angle.max(), made.angle_error * 1.01)
        self.assertLess(made.angle_error, 1e-2)
        self.assertEqual({one.name for one in cam.check() if one.is_defect}, {"no ray"})
        with self.assertWarnsRegex(balcony.BalconyWarning, "no ray"):
            picture = balcony.render(self.room, cam.placed(np.eye(4)), size=64, samples=1)
        self.assertTrue(np.isfinite(picture["color"]).all())

    def test_twice_the_samples_have_an_eighth_of_the_error(self):
        def smooth(x, y):
            return np.zeros(3), np.stack([np.ones_like(x), np.sin(1.5 * x), np.cos(2 * y)], axis=-1)

        errors = [balcony.from_rays(smooth, self.folder / "smooth.npy", size=(n, n)).angle_error
                  for n in (32, 64, 128)]
        for one, next_one in zip(errors, errors[1:]):
            self.assertTrue(3.5 < one / next_one < 17, errors)
        made = balcony.from_rays(smooth, self.folder / "smooth.npy", size=(16, 16), tolerance=1e-5)
        self.assertLessEqual(made.angle_error, 1e-5)
        self.assertGreater(made.size[0], 16)
        # It is inverted as any other.
        at = np.random.default_rng(1).uniform(2, 62, (500, 2))
        rays = made.camera.rays_at(at, size=(64, 64))
        seen = made.camera.project(rays.origins + 2 * rays.directions, size=(64, 64))
        np.testing.assert_allclose(seen, at, atol=1e-5)

    def test_arrays_of_rays(self):
        original = balcony.camera("fisheye")
        rays = original.rays(96, 96)
        made = balcony.from_rays(tuple(rays), self.folder / "own.npy")
        found = made.camera.rays(96, 96)
        np.testing.assert_array_equal(found.valid, rays.valid)
        np.testing.assert_allclose(found.directions, rays.directions, atol=1e-12)
        self.assertTrue(math.isnan(made.angle_error))

    def test_rays_that_cannot_be(self):
        def of(origins, directions, *valid):
            return lambda x, y: (origins, directions, *valid)

        good = np.ones((4, 4, 3))
        for rays, wrong in ((of(good, good[:2]), ValueError), (of(good, np.ones((4, 4, 2))), ValueError),
                            (of(good, np.full((4, 4, 3), np.nan)), ValueError), (lambda x, y: 3, TypeError),
                            (of(good, 0 * good), ValueError), (of(good, good, np.ones((2, 2))), ValueError),
                            ((good,), TypeError)):
            with self.assertRaises(wrong):
                balcony.from_rays(rays, self.folder / "wrong.npy", size=(4, 4))
        with self.assertRaisesRegex(ValueError, "npy"):
            balcony.from_rays(of(good, good), self.folder / "rays.exr", size=(4, 4))
        for size in ((0, 4), (1, 1), (100_000, 4)):
            with self.assertRaisesRegex(ValueError, "size"):
                balcony.from_rays(of(good, good), self.folder / "wrong.npy", size=size)
        with self.assertRaises(OSError):
            balcony.from_rays(of(good, good), self.folder / "none" / "a.npy", size=(4, 4))

        def torn(x, y):
            return np.zeros(3), np.stack([np.ones_like(x), np.sign(x - 0.5), 0 * x], axis=-1)

        with self.assertRaisesRegex(ValueError, "abruptly"):
            balcony.from_rays(torn, self.folder / "torn.npy", size=(1024, 4), tolerance=1e-6)

        def apart(x, y):
            # One column has samples, and another one, far from it, what is midway.
            return np.zeros(3), np.stack([np.ones_like(x), 0 * x, 0 * x], axis=-1), (x == 0.5 / 1028) | (x == 0.75)

        with self.assertRaisesRegex(ValueError, r"1028 x 4 rays cannot be measured.* gaps"):
            balcony.from_rays(apart, self.folder / "apart.npy", size=(1028, 4), tolerance=1e-6)
        self.assertTrue(math.isnan(balcony.from_rays(apart, self.folder / "apart.npy", size=(1028, 4)).angle_error))

    def test_directions_of_any_length(self):
        for length in (1e-300, 1e300):
            made = balcony.from_rays(lambda x, y, length=length: (
                np.zeros(3), length * np.stack([3 + x, y, 0 * x], axis=-1)), self.folder / "long.npy", size=(16, 16))
            self.assertTrue(made.camera.rays(16, 16).valid.all())
            self.assertLess(made.angle_error, 1e-3)


if __name__ == "__main__":
    unittest.main()
