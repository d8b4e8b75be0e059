# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""Options, errors and reports of render, and the correct picture."""

import os
import pty
import re
import time

import support


class Options(support.CommandTest):
    def render(self, *words, **how):
        return self.run_command("render", "scene.obj", "--size", "16x16", *words, **how)

    def refuses(self, option, *values):
        for value in values:
            with self.subTest(option=option, value=value):
                self.refused("render", "scene.obj", f"{option}={value}", "-o", "p.png", code=2,
                             says=option)
        self.assertNotIn("p.png", self.files())

    def test_numbers_out_of_range(self):
        self.refuses("--samples", "0", "-1", "1000001", "1e3", "3.5", "nan", "99999999999999999999")
        self.refuses("--threads", "-1", "1025", "two")
        self.refuses("--exposure", "nan", "inf", "-inf", "1e9", "bright", "+-1", "++1")
        self.refuses("--time", "nan", "inf", "1e999", "noon")
        self.refuses("--ambient", "nan", "inf", "-0.1", "1e39")
        self.refuses("--integrator", "paths", "Direct", "0")
        self.refuses("--bounces", "-1", "129", "many", "diffuse", "mirror=2", "diffuse=2,",
                     "glossy=-1", "=3")
        self.refuses("--clamp", "-1", "nan", "none")

    def test_sizes(self):
        self.refuses("--size", "0x0", "10x", "x10", "-5", "1e3", "10x10x10", "1000001", "0", "10*10",
                     " 5", "99999999999999999999x1")
        began = time.monotonic()
        err = self.refused("render", "scene.obj", "--size", "1000000x1000000", code=3, says="GB")
        self.assertIn("1000000 x 1000000", err)
        self.assertLess(time.monotonic() - began, 10.0)

    def test_texture_memory(self):
        self.refuses("--texture-memory", "0", "63", "-1", "1KB", "lots", "nan", "inf", "1e99", "GiB")
        for value in ("64", "100MB", "0.5GiB", "2GB", "64MiB"):
            out, _ = self.render("--texture-memory", value, "-o", "p.exr")
            self.assertRegex(out, r", \d+ MiB\n")
        facts = self.json_of("render", "scene.obj", "--size", "16x16", "-o", "p.exr")
        self.assertGreater(facts["peak_memory"], 1_000_000)

    # Also of a picture for the screen, whose exposure is measured in one that is made before.
    def test_a_texture_for_which_there_is_no_space_is_a_warning(self):
        side = 4300  # With its mip levels, 99 MB.
        support.write_png(self.folder / "grey.png", [b"\x80" * side] * side, 1)
        (self.folder / "grey.mtl").write_text("newmtl grey\nmap_Kd grey.png\n")
        (self.folder / "scene.obj").write_text(
            "mtllib grey.mtl\nusemtl grey\nv -1 -1 0\nv 1 -1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\n"
            "f 1/1 2/2 3/3\n")
        nowhere = {**os.environ, "TMPDIR": str(self.folder / "nowhere")}
        for output in ("p.png", "p.exr"):
            _, err = self.render("--texture-memory", "64", "-o", output, env=nowhere)
            self.assertIn("cannot be written to the folder", err, output)

    def test_backgrounds(self):
        self.refuses("--background", "nan", "1,2", "1,2,3,4", "1,,2", ",,", "-1", "0.5,nan,0", "red",
                     "0x10")
        for text, colour in (("black", (0, 0, 0)), ("white", (255, 255, 255)), ("0,1,0", (0, 255, 0)),
                             ("0", (0, 0, 0)), ("1e0", (255, 255, 255))):
            self.render("--background", text, "-o", "p.png")
            _, _, rows = support.png_pixels(self.folder / "p.png")
            self.assertEqual(rows[0][0], (*colour, 255), text)

    def test_values_that_begin_with_a_minus(self):
        self.render("--exposure", "-1.5", "--time", "-2", "-o", "p.exr")
        self.render("--exposure", "-.5", "--time=-.5", "-o", "p.exr")
        self.render("--exposure", "+2", "-o", "p.exr")

    def test_exposure_suits_the_light_unless_it_is_set(self):
        text = support.gltf_text_with_light()
        bright = text.replace('"type"', '"intensity": 1e6, "type"')
        self.assertNotEqual(text, bright)
        (self.folder / "bright.gltf").write_text(bright)
        small = ("--size", "64x36", "-s", "1", "-o", "p.png")
        options = ("render", "bright.gltf", "--ambient", "0", *small)
        self.assertLess(self.json_of(*options)["exposure"], -5)
        self.assertEqual(self.json_of(*options, "--exposure", "0")["exposure"], 0)
        self.assertEqual(self.json_of("render", "room.glb", *small)["exposure"], 0)

    def test_set(self):
        self.render("-c", "my.cam:above", "--set", "size=1", "--set", "size=2*2", "-o", "p.exr")
        for wrong, code in (("size", 1), ("=3", 1), ("size=", 1), ("siez=3", 1), ("size==3", 1),
                            ("size=nan", 1), ("size=1)", 1)):
            self.refused("render", "scene.obj", "-c", "my.cam:above", "--set", wrong, code=code,
                         says="--set")
        self.refused("render", "scene.obj", "--set", "a=1", code=2, says="--set needs a camera")

    def test_width_and_height(self):
        self.refuses("--width", "0", "-5", "1e3", "1000001")
        (self.folder / "wide.cam").write_text(
            support.CAMERAS.replace("axes y_up", "axes y_up aspect 4/3"))
        for words, size in ((("--width", "32"), (32, 24)), (("-W", "32"), (32, 24)),
                            (("-H", "12"), (16, 12)), (("-W", "5", "--height", "7"), (5, 7))):
            facts = self.json_of("render", "scene.obj", "-c", "wide.cam", *words, "-o", "p.exr")
            self.assertEqual((facts["width"], facts["height"]), size, words)
        self.refused("render", "scene.obj", "--size", "5", "-W", "5", code=2,
                     says="exclude each other")

    def test_set_as_people_type_it(self):
        for words in (("size", "1"), ("size", "=", "1"), ("size=", "1"), ("size", "=1"),
                      ("size = 1",), (" size =1 ",), ("size 1",)):
            self.render("-c", "my.cam:above", "--set", *words, "-o", "p.png")
            self.assertEqual(support.opaque_share(self.folder / "p.png"), 1.0, words)
        self.render("-c", "my.cam:above", "--set", "size", "-(-3)", "-o", "p.png")
        self.refused("render", "scene.obj", "-c", "my.cam:above", "--set", "size", "-o", "p.png",
                     code=1, says="--set size sets nothing")

    def test_set_accumulates(self):
        err = self.refused("render", "scene.obj", "-c", "pinhole", "--set", "nix=1", "--set",
                           "nax=1", code=1, says="'nix'")
        self.assertIn("'nax'", err)

    def test_cameras_that_are_not_there(self):
        def refuses(camera, says, helps=""):
            self.refused("render", "scene.obj", "--camera", camera, code=1, says=says, helps=helps)

        refuses("panoroma", "'panoroma'", "did you mean 'panorama'?")
        refuses("my.cam:closup", "'closup'", "closeup")
        refuses("my.cam:", "names no camera")
        refuses("none.cam", "'none.cam'")
        refuses("none.cam:closeup", "'none.cam'")
        refuses(".", "'.' is a folder")

    def test_cameras_of_the_scene(self):
        (self.folder / "filmed.gltf").write_text(support.gltf_text_with_cameras())

        def is_seen(x, y, *options):
            self.run_command("render", "filmed.gltf", "--size", "80", "--background",
                             "transparent", "-o", "p.png", *options)
            width, height, rows = support.png_pixels(self.folder / "p.png")
            return (width, height), rows[y][x][3] == 255

        self.assertEqual(is_seen(40, 40, "-c", "scene:Front"), ((80, 80), True))
        self.assertEqual(is_seen(40, 40, "-c", "scene:"), ((80, 80), True))
        self.assertEqual(is_seen(40, 40), ((80, 80), True), "the first is the default camera")
        # (0, -0.5, 0) is 4 to the left and 2.5 below the camera, (0.4, 0, 0) just in the corner.
        self.assertEqual(is_seen(3, 39, "-c", "scene:Plan"), ((80, 40), True))
        self.assertEqual(is_seen(40, 20, "-c", "scene:Plan"), ((80, 40), False))
        out, _ = self.run_command("locate", "scene:Plan", "--scene", "filmed.gltf", "--size", "80",
                                  "--point", "4,2,0")
        self.assertRegex(out, r"x +40\.0+ +y +20\.0+")

        def refuses(camera, says, helps, *words):
            self.refused("render", "filmed.gltf", "--camera", camera, *words, code=1, says=says,
                         helps=helps)

        refuses("scene:Frnt", "no camera 'Frnt'", "did you mean 'scene:Front'?")
        refuses("scene:Somewhere", "'Somewhere'", "Front, Plan")
        refuses("scene:Front", "no parameters", "camera files", "--set", "a=1")
        self.refused("render", "scene.obj", "-c", "scene:", code=1, says="has no cameras")
        self.refused("explain", "scene:Front", code=1, says="no scene is given",
                     helps="balcony render")

    def test_a_picture_of_nothing_says_why(self):
        cameras = """
            camera up { axes y_up  map u = -2 .. 2, v = -1 .. 1
                        eye surface(u, v) = [u, v, 5]  look normal }
            camera aside { axes y_up  map u = 1 .. -1, v = square
                           eye point(40, 0, 40)  toward plane((41, 0, 40)) }
            camera millimetres { axes y_up  map u = -2000 .. 2000, v = -1000 .. 1000
                                 eye surface(u, v) = [u + 9000, v, 5000]
                                 toward surface(u, v) = [u, v, -5000]  look relative }
            camera away { axes y_up  map u = -40 .. 40, v = square
                          eye surface(u, v) = [u, v, 50]  look normal(back) }
            camera small { axes y_up  map u = -40 .. 40, v = square
                           eye surface(u, v) = [u, v, -0.5]  look normal(back) }
            picture two { layer above  layer up { place (0, 0) .. (1/2, 1/2) } }
            camera above { axes y_up  map u = -2 .. 2, v = -1 .. 1
                           eye surface(u, v) = [u, v, 5]  look normal(back) }"""
        (self.folder / "miss.cam").write_text(cameras)

        def says(camera, *texts):
            _, err = self.run_command("render", "scene.obj", "-c", f"miss.cam:{camera}", "--size",
                                      "40", "-o", "p.exr")
            for text in texts:
                self.assertIn(text, err)

        says("up", "no ray of camera 'up' meets anything", "would meet 2 objects",
             "look normal(back)")
        says("aside", "no ray of camera 'aside'", "start outside the scene, (-2, -1, -1) .. (2, 1, 0)")
        says("two", "no ray of layer 'up' meets anything", "normal(back)")
        says("millimetres", "lengths 0.001 times as large", "scale(0.001)")
        says("away", "only 0.", "% of the rays of camera 'away' meet anything: they start outside")
        for fine in ("above", "small"):
            _, err = self.run_command("render", "scene.obj", "-c", f"miss.cam:{fine}", "-o", "p.exr",
                                      "--size", "40")
            self.assertEqual(err, "")
        out, _ = self.run_command("check", "miss.cam:up", "--scene", "scene.obj")
        self.assertIn("no ray meets anything: in the opposite direction", out)
        self.assertNotIn("never seen", out)
        self.assertNotIn("no defects", out)
        report = self.json_of("check", "miss.cam:above", "--scene", "scene.obj")
        self.assertIsNone(report["files"][0]["reports"][0]["in_scene"]["meets_nothing"])

    def test_an_added_scene_joins_the_picture(self):
        away = ("--set", "px=1000")
        self.run_command("draw", "pinhole", *away, "-o", "arrows.glb")
        options = ("render", "scene.obj", "-c", "pinhole", "--no-fit", *away, "--size", "64x32", "-s", "1",
                   "-o", "p.exr")
        alone = self.json_of(*options)["layers"][0]["hits"]
        both = self.json_of(*options, "--add", "arrows.glb")["layers"][0]["hits"]
        self.assertEqual(alone, 0)
        self.assertGreater(both, 0)
        self.refused("render", "scene.obj", "--add", "nowhere.glb", "-o", "q.exr", code=1,
                     says="there is no file 'nowhere.glb'")

    def test_scenes_that_are_not_there(self):
        self.refused("render", "none.obj", code=1, says="'none.obj'")
        self.refused("render", ".", code=1, says="'.' is a folder")
        self.refused("render", "", code=2, says="''")

    def test_a_wrong_camera_does_not_wait_for_the_scene(self):
        err = self.refused("render", "none.obj", "-c", "panoroma", code=1, says="'panoroma'")
        self.assertNotIn("none.obj", err)


class Report(support.CommandTest):
    LONG = ("render", "scene.obj", "-c", "my.cam:above", "--size", "700x700", "-s", "60",
            "--integrator", "preview", "-o", "p.exr", "-j", "1")

    def test_facts_as_json(self):
        facts = self.json_of("render", "scene.obj", "--size", "8x4", "-s", "3", "-o", "p.exr")
        self.assertEqual((facts["output"], facts["width"], facts["height"], facts["rays"]),
                         ("p.exr", 8, 4, 96))
        self.assertEqual((facts["interrupted"], facts["diagnostics"]), (False, []))
        for words, code in ((("none.obj",), 1), (("scene.obj", "--size", "0"), 2),
                            (("scene.obj", "-o", "no/p.exr"), 3), (("scene.obj", "-o", "p"), 2)):
            self.json_of("render", *words, code=code)

    def test_names_that_are_not_utf8(self):
        document = self.json_of("render", b"\xff.obj", code=1)
        self.assertIn("\ufffd", document["diagnostics"][0]["message"])

    def test_result_and_progress_go_apart(self):
        out, err = self.run_command(*self.LONG)
        self.assertRegex(out, r"^p\.exr: 700 x 700 pixels through 'above', 60 passes, 29\.4 M rays")
        self.assertEqual(out.count("\n"), 1)
        self.assertLessEqual(err.count("\n"), 11)
        self.assertNotIn("\r", err)
        for line in err.splitlines():
            self.assertRegex(line, r"^ *\d+ %, pass \d+ of 60")
        self.assertEqual(self.run_command(*self.LONG, "--quiet"), ("", ""))

    def test_a_quick_render_shows_no_progress(self):
        _, err = self.run_command("render", "scene.obj", "--size", "16", "-o", "p.exr")
        self.assertEqual(err, "")

    def test_bar_on_a_terminal(self):
        # Long enough for an estimate of the time, on a busy machine, too.
        for seconds in ("2", "10", "50"):
            shown = self.shown_on_a_terminal(seconds)
            if " left" in shown:
                break
        self.assertRegex(shown, r"\r\[#+ *\] +\d+ %, pass \d+ of 1000, [0-9.:]+ \w+ left\x1b\[K")
        self.assertRegex(shown, r"\r\x1b\[Kp\.exr: [^\r\n]*\r\n$")
        self.assertLess(max(len(part) for part in re.split(r"[\r\n]", shown)), 90)

    def shown_on_a_terminal(self, seconds):
        """By a render that ends after so many seconds."""
        screen, terminal = pty.openpty()
        words = ["1000" if word == "60" else word for word in self.LONG[:-4]]
        words += ["-o", "p.exr", "--time-limit", seconds]
        with self.start(*words, stdout=terminal, stderr=terminal,
                        env={**os.environ, "TERM": "xterm"}) as process:
            os.close(terminal)
            seen = b""
            while True:
                try:
                    part = os.read(screen, 65536)
                except OSError:
                    break
                if not part:
                    break
                seen += part
        os.close(screen)
        self.assertEqual(process.returncode, 0)
        return seen.decode()


class Picture(support.CommandTest):
    def test_without_a_camera_the_scene_is_in_the_picture(self):
        for scene in ("scene.obj", "room.glb"):
            self.run_command("render", scene, "--size", "160x90", "-s", "1", "--background",
                             "transparent", "-o", "p.png")
            self.assertGreater(support.opaque_share(self.folder / "p.png"), 0.04)
            _, _, rows = support.png_pixels(self.folder / "p.png")
            border = rows[0] + rows[-1] + [row[0] for row in rows] + [row[-1] for row in rows]
            self.assertTrue(all(pixel[3] == 0 for pixel in border), "the scene is cut off")

    def test_scenes_of_extreme_size(self):
        for scale in (1e-3, 1e9):
            corners = "".join(f"v {x * scale} {y * scale} 0\n" for x, y in ((-1, -1), (1, -1), (0, 1)))
            (self.folder / "odd.obj").write_text(corners + "f 1 2 3\n")
            self.run_command("render", "odd.obj", "--size", "64x36", "-s", "1", "-o", "p.png")
            self.assertGreater(support.opaque_share(self.folder / "p.png"), 0.04, scale)

    def test_a_camera_with_gaps_says_how_many(self):
        words = ("render", "scene.obj", "--size", "16x16", "-s", "4", "-o", "p.png")
        out, err = self.run_command(*words, "-c", "my.cam:half")
        self.assertRegex(err, r"warning: camera 'half' has no ray at \d+ of 1024 picture points")
        self.assertIn("(128 of 256 pixel centres)", err)
        _, _, rows = support.png_pixels(self.folder / "p.png")
        self.assertTrue(all(pixel[3] == 0 for row in rows for pixel in row[:7]))
        facts = self.json_of(*words, "-c", "my.cam:half")
        self.assertEqual(facts["invalid_pixels"], 128)
        self.assertEqual(facts["diagnostics"][0]["severity"], "warning")

    def test_what_is_cut_out_is_no_gap(self):
        words = ("render", "scene.obj", "--size", "16x16", "-s", "1", "-o", "p.exr")
        out, err = self.run_command(*words, "-c", "fulldome")
        self.assertEqual(err, "")
        self.assertEqual(self.json_of(*words, "-c", "fulldome")["invalid_pixels"] > 0, True)
        # A gap within what its arranger shows is one.
        (self.folder / "ring.cam").write_text(
            "camera ring {\n"
            "    aspect 1\n"
            "    arrange formula(x, y) = [if(x^2 + y^2 <= 1, x, 2), y]\n"
            "    map u = -2 .. 2, v = square\n"
            "    eye surface(u, v) = [u, v, 5 + sqrt(u^2 + v^2 - 1)/1e6]\n"
            "    toward surface(u, v) = [u, v, 0]\n"
            "}\n")
        _, err = self.run_command(*words, "-c", "ring.cam")
        self.assertIn("warning: camera 'ring' has no ray at", err)

    def test_a_camera_without_any_ray(self):
        _, err = self.run_command("render", "scene.obj", "--size", "8x8", "-o", "p.png", "-c",
                                  "my.cam:nowhere")
        self.assertIn("warning: camera 'nowhere' has no ray anywhere", err)
        self.assertEqual(support.opaque_share(self.folder / "p.png"), 0.0)

    def test_threads_do_not_matter(self):
        for ending in ("png", "exr"):
            made = []
            for threads in ("1", "2", "2"):
                name = f"{len(made)}.{ending}"
                self.run_command("render", "room.glb", "--size", "200x150", "-s", "3", "-o", name,
                                 "-j", threads)
                made.append((self.folder / name).read_bytes())
            self.assertEqual(made[0], made[1])
            self.assertEqual(made[1], made[2])

    def test_every_layer_whatever_the_case_of_the_ending(self):
        for name in ("a.exr", "b.EXR"):
            self.run_command("render", "room.glb", "--size", "8x8", "-s", "1", "-o", name)
            self.assertIn(b"ray_length.Z", (self.folder / name).read_bytes())
        self.run_command("render", "room.glb", "--size", "8x8", "-s", "1", "-o", "c.PNG")
        self.assertEqual(support.png_pixels(self.folder / "c.PNG")[:2], (8, 8))

    # The design asks for 0.3 s on a quiet machine; a busy one gets the double and some.
    def test_starts_quickly(self):
        def seconds():
            began = time.monotonic()
            self.run_command("render", "room.glb", "--size", "16x16", "-s", "1", "--integrator",
                             "preview", "-o", "p.png")
            return time.monotonic() - began

        best = min(seconds() for _ in range(5))
        print(f"\nrender of 16 x 16 pixels, start to end: {best:.2f} s", flush=True)
        if "BALCONY_SANITIZED" not in os.environ:
            self.assertLess(best, 1.0)

    def test_the_outer_half_of_a_soft_edge_is_beyond_the_map(self):
        (self.folder / "soft.cam").write_text("""
camera patch(margin = 0) { aspect 1 axes y_up
    map u = margin - 1 .. 1 - margin, v = margin - 1 .. 1 - margin
    eye    surface(u, v) = [u, v, 5 + (sqrt(1 - u^2) + sqrt(1 - v^2))/1e6]
    toward surface(u, v) = [u, v, 0] }
picture inset(margin = 0) 80 x 80 {
    layer patch(margin = margin) { place (1/4, 1/4) .. (3/4, 3/4) soft 0.4 }
}
""")
        # The edge is from 12 to 28, its middle the place's border at 20; filters reach 2 further.
        for margin, outside in (("0", False), ("0.2", True)):
            self.run_command("render", "scene.obj", "--camera", "soft.cam", "--set",
                             f"margin={margin}", "-o", "soft.png")
            _, _, rows = support.png_pixels(self.folder / "soft.png")
            alpha = [pixel[3] for pixel in rows[40]]
            self.assertEqual(alpha[9], 0)
            self.assertEqual(alpha[17] > 0, outside)
            self.assertTrue(0 < alpha[22] < alpha[25] < alpha[31] == 255, alpha)


if __name__ == "__main__":
    support.main()
