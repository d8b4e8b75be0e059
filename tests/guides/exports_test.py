#!/usr/bin/env python3
# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""The NumPy functions and the GLSL functions of all examples of cameras, run by NumPy and by a
browser's WebGL 2.

Usage: exports_test.py BALCONY REPOSITORY EXPORTS

EXPORTS is the folder that write_exports wrote.
"""

import http.server
import json
import math
import queue
import shutil
import subprocess
import sys
import tempfile
import threading
import unittest
from pathlib import Path

EXPORTS = Path(sys.argv.pop(3)).resolve()

from guide import main, python_with, skip  # noqa: E402 (reads the other arguments)
from rays import MAGNIFYING, pixels_between  # noqa: E402

BROWSER = shutil.which("chromium") or shutil.which("chromium-browser")
# The compiler and the interpreter of OSL, which Debian 12 does not have. Without them, tests/bridge
# still compiles the shaders as C++.
OSLC, TESTSHADE = shutil.which("oslc"), shutil.which("testshade")
# Cameras whose GLSL is too large for a browser to compile in a test: a megabyte of noise.
TOO_LARGE = 500_000

# What Cycles defines for camera shaders. For testshade, which has the centres of 16 x 9 pixels, from
# the top left, in P; the points of the examples are moved from there.
CYCLES = """point camera_shader_raster_position() {
    return point(P[0] + 0.3 / WIDTH, 1.0 - (P[1] - 0.2 / HEIGHT), 0);
}
"""

READ_RAYS = """
import json, sys
import OpenImageIO as oiio
made = []
for name in ("position", "direction", "throughput"):
    pixels = oiio.ImageBuf(sys.argv[1] + "/" + name + ".exr").get_pixels(oiio.FLOAT)
    made.append(pixels.reshape(-1, pixels.shape[-1])[:, :3].tolist())
json.dump(made, sys.stdout)
"""

RUN_NUMPY = """
import importlib, json, sys
import numpy as np
sys.path.insert(0, sys.argv[1] + "/numpy")
exports = json.load(open(sys.argv[1] + "/exports.json"))
x, y = np.array(exports["points"]).T
made = {}
for name in exports["examples"]:
    if "numpy" in exports["examples"][name].get("languages", ()):
        ray = getattr(importlib.import_module(name), name + "_ray")
        rays = ray(x, y, exports["width"], exports["height"])
        # A single point and a grid give the same.
        one = ray(x[7], y[7], exports["width"], exports["height"])
        grid = ray(x.reshape(9, 16), y.reshape(9, 16), exports["width"], exports["height"])
        assert one[0].shape == (3,) and grid[0].shape == (9, 16, 3), name
        assert one[2] == rays[2][7] and np.array_equal(one[1], rays[1][7], equal_nan=True), name
        assert np.array_equal(grid[1].reshape(-1, 3), rays[1], equal_nan=True), name
        made[name] = [[*o, *d] if valid else None for o, d, valid in
                      zip(*(a.tolist() for a in rays))]
json.dump(made, sys.stdout)
"""

FIND_NUMPY = """
import importlib, json, sys
import numpy as np
sys.path.insert(0, sys.argv[1] + "/numpy")
exports = json.load(open(sys.argv[1] + "/exports.json"))
made = {}
for name, entry in exports["examples"].items():
    if entry["located"] and "numpy" in entry.get("languages", ()):
        find = getattr(importlib.import_module(name), name + "_find")
        points = np.array([one["point"] for one in entry["located"]])
        found, distance = find(points, exports["width"], exports["height"])
        one, z = find(points[0], exports["width"], exports["height"])
        assert one.shape == (2,) and np.array_equal(one, found[0], equal_nan=True), name
        made[name] = [None if np.isnan(d) else [*p, d]
                      for p, d in zip(found.tolist(), distance.tolist())]
json.dump(made, sys.stdout)
"""

PAGE = """<!DOCTYPE html><script>
const cameras = CAMERAS, points = POINTS;
const pause = milliseconds => new Promise(resolve => setTimeout(resolve, milliseconds));
let gl;
async function begin() {
    for (gl = null; !gl; await pause(200))
        gl = document.createElement("canvas").getContext("webgl2");
    gl.getExtension("EXT_color_buffer_float");
}
function shader(kind, text) {
    const made = gl.createShader(kind);
    gl.shaderSource(made, text);
    gl.compileShader(made);
    if (!gl.getShaderParameter(made, gl.COMPILE_STATUS)) throw gl.getShaderInfoLog(made);
    return made;
}
function texture() {
    const made = gl.createTexture();
    gl.bindTexture(gl.TEXTURE_2D, made);
    gl.texStorage2D(gl.TEXTURE_2D, 1, gl.RGBA32F, points.length, 1);
    return made;
}
function rays(text, lens, name) {
    const program = gl.createProgram();
    gl.attachShader(program, shader(gl.VERTEX_SHADER,
        "#version 300 es\\nvoid main() { gl_Position = vec4(gl_VertexID == 1 ? 3 : -1, " +
        "gl_VertexID == 2 ? 3 : -1, 0, 1); }"));
    gl.attachShader(program, shader(gl.FRAGMENT_SHADER, "#version 300 es\\n" + text +
        "\\nuniform vec2 points[" + points.length + "];\\nlayout(location = 0) out vec4 o;\\n" +
        "layout(location = 1) out vec4 d;\\nvoid main() { vec3 a, b;\\n" +
        "vec2 p = points[int(gl_FragCoord.x)];\\n" +
        "bool valid = " + name + "_ray(p.x, p.y, WIDTH, HEIGHT, 0.0, " + (lens ? "0.0, 0.0, " : "") +
        "a, b);\\no = vec4(a, valid ? 1.0 : 0.0); d = vec4(b, 7.0); }"));
    gl.linkProgram(program);
    if (!gl.getProgramParameter(program, gl.LINK_STATUS)) throw gl.getProgramInfoLog(program);
    gl.useProgram(program);
    gl.uniform2fv(gl.getUniformLocation(program, "points"), points.flat());
    gl.bindFramebuffer(gl.FRAMEBUFFER, gl.createFramebuffer());
    const places = [gl.COLOR_ATTACHMENT0, gl.COLOR_ATTACHMENT1];
    for (const place of places)
        gl.framebufferTexture2D(gl.FRAMEBUFFER, place, gl.TEXTURE_2D, texture(), 0);
    gl.drawBuffers(places);
    gl.viewport(0, 0, points.length, 1);
    gl.drawArrays(gl.TRIANGLES, 0, 3);
    return places.map(place => {
        const values = new Float32Array(4 * points.length);
        gl.readBuffer(place);
        gl.readPixels(0, 0, points.length, 1, gl.RGBA, gl.FLOAT, values);
        return Array.from(values, value => Number.isFinite(value) ? value : null);
    });
}
// The browser's software renderer may end behind a shader with large tables; then the camera gets
// another one.
async function main() {
    const made = {};
    await begin();
    for (const [name, [text, lens]] of Object.entries(cameras)) {
        for (let attempt = 0; attempt < 5; ++attempt) {
            try {
                made[name] = rays(text, lens, name);
            } catch (problem) {
                made[name] = "cannot compile: " + problem;
            }
            // A lost context draws nothing, not even the mark behind the direction.
            if (typeof made[name] !== "string" && made[name][1][3] === 7) break;
            await pause(200);
            await begin();
        }
    }
    await fetch("/result", {method: "POST", body: JSON.stringify(made)});
}
main().catch(problem => fetch("/result", {method: "POST",
    body: JSON.stringify({"the page": "failed: " + problem})}));
</script>"""


def browse(page, profile):
    """What a page in a browser without a window posts to /result."""
    results = queue.Queue()

    class Handler(http.server.BaseHTTPRequestHandler):
        def do_GET(self):
            self.send_response(200)
            self.send_header("Content-Type", "text/html; charset=utf-8")
            self.end_headers()
            self.wfile.write(page.encode())

        def do_POST(self):
            results.put(json.loads(self.rfile.read(int(self.headers["Content-Length"]))))
            self.send_response(204)
            self.end_headers()

        def log_message(self, *_):
            pass

    with http.server.ThreadingHTTPServer(("127.0.0.1", 0), Handler) as server:
        threading.Thread(target=server.serve_forever, daemon=True).start()
        browser = subprocess.Popen(
            [BROWSER, "--headless=new", "--no-sandbox", "--use-angle=swiftshader",
             "--enable-unsafe-swiftshader", "--disable-gpu-watchdog",
             "--disable-domain-blocking-for-3d-apis", "--disable-gpu-process-crash-limit",
             f"--user-data-dir={profile}", f"http://127.0.0.1:{server.server_port}/"],
            stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        try:
            return results.get(timeout=200)
        finally:
            browser.terminate()
            browser.wait()
            server.shutdown()


class ExportsTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = Path(tempfile.mkdtemp(prefix="balcony-exports-"))
        cls.addClassCleanup(shutil.rmtree, cls.folder)
        cls.exports = json.loads((EXPORTS / "exports.json").read_text())

    def compare(self, made, tolerance):
        """The largest difference in pixels; every camera must keep to the tolerance."""
        largest = (0.0, "")
        for name, rays in made.items():
            for exact, ray in zip(self.exports["examples"][name]["rays"], rays):
                with self.subTest(camera=name):
                    self.assertEqual(exact is None, ray is None, "there is a ray")
                    if exact is not None:
                        pixels = pixels_between(exact, ray[:3], ray[3:])
                        self.assertLess(pixels, tolerance)
                        largest = max(largest, (pixels, name))
        print(f"{len(made)} cameras; the largest difference is {largest[0]:.2g} pixels, of "
              f"{largest[1]}")

    def test_numpy(self):
        python = python_with("numpy")
        done = subprocess.run([python, "-c", RUN_NUMPY, EXPORTS], check=True,
                              stdout=subprocess.PIPE)
        made = json.loads(done.stdout)
        self.assertGreaterEqual(len(made) + 3, len(self.exports["examples"]), "all but meshes")
        self.compare(made, 1e-6)

    def test_numpy_finds_points_where_balcony_locates_them(self):
        done = subprocess.run([python_with("numpy"), "-c", FIND_NUMPY, EXPORTS], check=True,
                              stdout=subprocess.PIPE)
        wanted, found = 0, 0
        for name, places in json.loads(done.stdout).items():
            for place, entry in zip(places, self.exports["examples"][name]["located"], strict=True):
                wanted += 1
                found += place is not None
                if place is None or not entry["sightings"]:
                    continue
                with self.subTest(camera=name):
                    nearest = min(entry["sightings"], key=lambda one: math.dist(one[:2], place[:2]))
                    self.assertLess(math.dist(nearest[:2], place[:2]), 0.01)
                    self.assertAlmostEqual(nearest[2], place[2], delta=1e-3 * nearest[2])
        self.assertGreater(wanted, 2000)
        self.assertGreater(found, 0.995 * wanted)

    def shaded(self, name, python):
        """The rays of an OSL shader as OSL computes them."""
        width, height = self.exports["width"], self.exports["height"]
        text = (EXPORTS / "osl" / f"{name}.osl").read_text().replace(
            'getattribute("cam:image_resolution", resolution);',
            f"resolution = vector({width}, {height}, 0);")
        cycles = CYCLES.replace("WIDTH", f"{width:.1f}").replace("HEIGHT", f"{height:.1f}")
        (self.folder / "shader.osl").write_text(cycles + text)
        run = {"cwd": self.folder, "check": True, "stdout": subprocess.DEVNULL}
        subprocess.run([OSLC, "-q", "-o", "shader.oso", "shader.osl"], **run)
        subprocess.run([TESTSHADE, "-g", "16", "9", "--center", "-od", "float",
                        "-o", "position", "position.exr", "-o", "direction", "direction.exr",
                        "-o", "throughput", "throughput.exr", "shader"], **run)
        done = subprocess.run([python, "-c", READ_RAYS, self.folder], check=True,
                              stdout=subprocess.PIPE)

        def world(v):
            # Cycles' camera space: x to the right, y up, z forward.
            return [v[2], -v[0], v[1]]
        return [[*world(o), *world(d)] if t[0] == 1 else None
                for o, d, t in zip(*json.loads(done.stdout))]

    @unittest.skipUnless(OSLC and TESTSHADE, "oslc and testshade are not in the PATH")
    def test_osl(self):
        python = python_with("OpenImageIO", "numpy")
        self.assertTrue(python, "Python has no OpenImageIO")
        made = {name: self.shaded(name, python)
                for name, entry in self.exports["examples"].items()
                if "osl" in entry.get("languages", ()) and not entry["lens"] and not entry["y_up"]}
        self.assertGreater(len(made), 100)
        # OSL's own sines, logarithms and powers are wrong by several units in the last place.
        self.compare(made, 0.01)

    def browsed(self, texts):
        """The rays of GLSL functions as a browser computes them."""
        page = (PAGE.replace("CAMERAS", json.dumps(texts)).replace(
            "POINTS", json.dumps(self.exports["points"])).replace(
            "WIDTH", f"{self.exports['width']:.1f}").replace(
            "HEIGHT", f"{self.exports['height']:.1f}"))
        result = browse(page, self.folder / "profile")
        made = {}
        for name, values in result.items():
            self.assertNotIsInstance(values, str, f"{name}: {values}")
            o, d = values
            made[name] = [[*o[i:i + 3], *d[i:i + 3]] if o[i + 3] == 1 else None
                          for i in range(0, len(o), 4)]
        return made

    def test_glsl(self):
        texts = {name: [(EXPORTS / "glsl" / f"{name}.glsl").read_text(), entry["lens"]]
                 for name, entry in self.exports["examples"].items()
                 if "glsl" in entry.get("languages", ())}
        small = {name: text for name, text in texts.items() if len(text[0]) < TOO_LARGE}
        self.assertGreaterEqual(len(small) + 2, len(texts), "only the fractals are too large")
        made = self.browsed(small)
        # WebGL's sines and cosines may be wrong by 2^-11.
        self.compare({name: rays for name, rays in made.items() if name not in MAGNIFYING}, 0.05)
        for name, factor in MAGNIFYING.items():
            self.compare({name: made[name]}, 0.05*factor)


if __name__ == "__main__":
    if python_with("numpy") is None:
        skip("NumPy is not installed")
    if BROWSER is None:
        skip("Chromium is not installed")
    main()
