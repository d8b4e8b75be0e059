# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""The picture with sliders of notebooks. Its module runs in node, with a page of the least that it needs."""

import json
import math
import shutil
import subprocess
import unittest
from pathlib import Path

import balcony
from balcony._widget import View
from scene_files import AIMED, RoomTest

PAGE = """
const listeners = {};
class Element {
    constructor(tag) { this.tag = tag; this.style = {}; this.inside = []; this.listeners = {}; }
    append(...children) { this.inside.push(...children); }
    setAttribute(name, value) { this[name] = value; }
    addEventListener(name, call) { this.listeners[name] = call; }
    input(value) { this.value = value; this.listeners.input(); }
}
globalThis.document = {createElement: (tag) => new Element(tag)};
const urls = new Set();
URL.createObjectURL = (blob) => { const url = `blob:${urls.size}:${blob.size}`; urls.add(url); return url; };
URL.revokeObjectURL = (url) => urls.delete(url);
const sent = [];
const state = {
    sliders: [{name: "fov", value: 90, least: 1, most: 170, unit: "°"}, {name: "yaw", value: 0, least: -180, most: 180, unit: "°"}],
    values: {}, picture: new Uint8Array(3), message: "", done: 0};
const model = {
    get: (name) => state[name],
    set: (name, value) => { state[name] = value; },
    save_changes: () => sent.push({...state.values}),
    on: (name, call) => { listeners[name] = call; },
    off: (name, call) => { if (listeners[name] === call) { delete listeners[name]; } },
};
const change = (name, value) => { state[name] = value; listeners[`change:${name}`](); };
const {default: widget} = await import(process.argv[1]);
const el = new Element("div");
const clean = widget.render({model, el});
const [picture, message, fov, yaw] = el.inside;
const slider = (row) => row.inside[1];
const firstUrl = picture.src;
slider(fov).input("60");
slider(fov).input("50");
slider(yaw).input("10");
const beforeAnswer = [...sent];
change("picture", new Uint8Array(7));
change("message", "wrong");
change("done", 1);
change("done", 2);
console.log(JSON.stringify({
    rows: el.inside.length, range: [slider(fov).min, slider(fov).max, slider(fov).type], shown: fov.inside[2].textContent,
    firstUrl, secondUrl: picture.src, kept: urls.size, message: message.textContent, beforeAnswer, sent}));
clean();
console.log(JSON.stringify({urls: urls.size, listeners: Object.keys(listeners).length}));
"""


class Widget(RoomTest):
    def view(self):
        return View(balcony.load(self.room), balcony.camera(AIMED), {"size": (32, 24), "samples": 1})

    def test_sliders_have_the_limits_of_their_parameters(self):
        sliders = {one["name"]: one for one in self.view().sliders}
        self.assertEqual(set(sliders), {"yaw", "fov"})  # The spot is no number.
        fov, yaw = sliders["fov"], sliders["yaw"]
        for found, wanted in zip((fov["least"], fov["value"], fov["most"], yaw["least"], yaw["most"]),
                                 (1, 90, 170, -180, 180)):
            self.assertAlmostEqual(found, wanted, 10)
        self.assertEqual(fov["unit"], "°")

    def test_the_picture_follows(self):
        view = self.view()
        before, said = view.picture()
        self.assertEqual((before[:4], said), (b"\x89PNG", ""))
        after, said = view.picture({"yaw": 90.0})
        scene = balcony.load(self.room)
        wanted = scene.render(balcony.camera(AIMED, yaw=math.pi / 2), size=(32, 24), samples=1)
        self.assertEqual(after, wanted._repr_png_())
        self.assertNotEqual(after, before)
        nothing, said = view.picture({"fov": 500.0})
        self.assertEqual(nothing, b"")
        self.assertIn("fov", said)
        self.assertEqual(view.picture()[0], after)

    def test_it_says_what_it_needs(self):
        try:
            import anywidget  # noqa: F401
        except ImportError:
            with self.assertRaisesRegex(ImportError, "pip install anywidget"):
                balcony.widget(self.room, "fisheye")

    @unittest.skipUnless(shutil.which("node"), "node is not there")
    def test_the_page(self):
        module = (Path(balcony.__file__).parent / "_widget.js").resolve()
        copy = self.folder / "widget.mjs"
        copy.write_text(module.read_text())
        output = subprocess.run(["node", "--input-type=module", "-e", PAGE, str(copy)], check=True,
                                capture_output=True, text=True).stdout
        found, after = map(json.loads, output.splitlines())
        self.assertEqual((found["rows"], found["range"], found["shown"]), (4, [1, 170, "range"], "50.00°"))
        self.assertEqual(found["message"], "wrong")
        self.assertNotEqual(found["firstUrl"], found["secondUrl"])
        self.assertEqual(found["kept"], 1)
        # While values are answered, only the newest wait.
        self.assertEqual(found["beforeAnswer"], [{"fov": 60}])
        self.assertEqual(found["sent"], [{"fov": 60}, {"fov": 50, "yaw": 10}])
        self.assertEqual(after, {"urls": 0, "listeners": 0})


if __name__ == "__main__":
    unittest.main()
