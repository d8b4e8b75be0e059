# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""balcony studio: what a hand moves of a text, and what follows when it pulls at a picture."""

import support
from studio_case import CAMERA, SMALL, StudioTest, applied


class Hands(StudioTest):
    def handle(self, page, parameter, **asked):
        return next(one for one in page.result("handles", **asked)["handles"]
                    if one["parameter"] == parameter)

    def test_handles(self):
        text = CAMERA.replace("look relative", "look relative\n    move translate((1, 2, 3))")
        (self.folder / "my.cam").write_text(text)
        self.open()
        page = self.page().begin()
        answer = page.result("handles")
        self.assertEqual(answer["version"], page.version)
        self.assertEqual([(one["statement"], one["stage"], one["parameter"], one["kind"])
                          for one in answer["handles"]],
                         [("map", "", "u", "interval"),
                          ("move", "translate", "x", "space_point")])
        interval, place = answer["handles"]
        self.assertEqual([(one["value"], one["angle"], one["moves"], one.get("parameter"))
                          for one in interval["numbers"]],
                         [(-3, False, True, "size"), (3, False, True, "size")])
        self.assertEqual(interval["numbers"][0]["range"],
                         {"start": {"line": 1, "character": 20},
                          "end": {"line": 1, "character": 21}})
        self.assertEqual(place["range"], {"start": {"line": 7, "character": 9},
                                          "end": {"line": 7, "character": 29}})

    def test_a_handle_moves_the_text(self):
        text = CAMERA.replace("look relative", "look relative\n    move translate((1, 2, 3))")
        (self.folder / "my.cam").write_text(text)
        self.open()
        page = self.page().begin()
        answer = page.result("handles/move", handle=self.handle(page, "x"), moves=[
            {"number": 0, "value": 1.5004, "step": 0.01}, {"number": 2, "value": -4}])
        self.assertEqual(answer["version"], page.version)
        self.assertEqual(applied(text, answer["edits"]), text.replace("1, 2, 3", "1.5, 2, -4"))
        answer = page.result("handles/move", handle=self.handle(page, "u"), moves=[
            {"number": 1, "value": 2, "step": 0.1}])
        self.assertEqual(applied(text, answer["edits"]), text.replace("size = 3", "size = 2"))

    def test_keys(self):
        self.open()
        page = self.page().begin()
        self.assertEqual(page.result("keys")["keys"], [])

        def written(method, **asked):
            answer = page.result(method, **asked)
            self.assertEqual(answer["version"], page.version)
            return applied(CAMERA, answer["edits"])

        values = [{"parameter": "height", "value": 7}]
        self.assertEqual(written("text/set", values=values, time=2),
                         CAMERA.replace("height = 5", "height = 7"))
        keyed = CAMERA.replace("height = 5", "height = keys((0, 5), (2, 7))")
        self.assertEqual(written("text/set", values=values, time=2, keys=True, frame=0.04), keyed)
        page.edit(keyed)
        self.assertEqual(page.result("keys")["keys"], [{"parameter": "height", "times": [0, 2]}])
        self.assertEqual(page.result("keys", camera="other")["keys"], [])
        # What is shown has the value of the time.
        told = page.wait_for("view/camera", change=page.result("view/change", time=1)["change"])
        height = next(one for one in told["moving"] if one["name"] == "height")
        self.assertEqual((height["value"], height["written"]), (6, "keys((0, 5), (2, 7))"))
        self.assertEqual(told["time"], 1)
        [edit] = page.result("text/unkey", time=2.01)["edits"]
        self.assertEqual(edit["newText"], "5")
        self.assertIn("no parameter has a key at 1 s",
                      page.error("text/unkey", time=1)["message"])
        for wrong in ({"time": "one"}, {"keys": 1}, {"frame": []}):
            self.assertEqual(page.error("text/set", values=values, **wrong)["code"], -32602)

    def test_handles_of_another_camera(self):
        (self.folder / "my.cam").write_text("camera wide = pinhole(fov = 100deg)\n" + CAMERA)
        self.open()
        page = self.page().begin()
        handle = self.handle(page, "u", camera="wide")
        self.assertIsNone(handle["range"])
        self.assertEqual(handle["numbers"][0]["parameter"], "fov")
        answer = page.result("handles/move", camera="wide", handle=handle,
                             moves=[{"number": 0, "value": 1, "step": 0.001}])
        self.assertEqual([one["newText"] for one in answer["edits"]], ["90deg"])
        page.notify("view/change", camera="wide")
        self.assertEqual(self.handle(page, "u"), handle)

    def test_handles_that_are_none(self):
        self.open()
        page = self.page().begin()
        handle = self.handle(page, "u")
        for wrong in ({"handle": handle}, {"moves": []}, {"handle": 5, "moves": []},
                      {"handle": {}, "moves": []}, {"handle": handle, "moves": [{"number": 0}]},
                      {"handle": handle, "moves": [{"number": -1, "value": 1}]},
                      {"handle": handle, "moves": [{"number": 0, "value": "1"}]}, {"camera": 7}):
            self.assertEqual(page.error("handles/move", **wrong)["code"], -32602, wrong)
        for wrong, says in (({"handle": dict(handle, index=1), "moves": []}, "ask for its handles"),
                            ({"handle": handle, "moves": [{"number": 9, "value": 1}]},
                             "number 10 of this handle does not move")):
            error = page.error("handles/move", **wrong)
            self.assertEqual(error["code"], -32803)
            self.assertIn(says, error["message"])
        self.assertEqual(page.result("handles", camera="nothing")["handles"], [])
        page.edit("camera {")
        self.assertEqual(page.result("handles")["handles"], [])

    def test_a_drag(self):
        # Where the picture shows the origin and (1, 0, 0): the text has 3 units on either side,
        # and both surfaces have them at the same place.
        self.open()
        page = self.page().begin()
        page.result("view/change", size=SMALL)
        pull = {"point": [1, 0, 0], "from": [42.67, 24], "to": [48, 24]}
        change = page.result("view/drag", parameters=["size"], pulls=[
            {"point": [0, 0, 0], "from": [32, 24], "to": [32, 24]}, pull])["change"]
        told = page.wait_for("view/dragged", change=change)
        self.assertEqual(told["diagnostics"], [])
        self.assertEqual([one["parameter"] for one in told["values"]], ["size"])
        self.assertAlmostEqual(told["values"][0]["value"], 2, 4)
        self.assertEqual([one["follows"] for one in told["points"]], [True, True])
        self.assertAlmostEqual(told["points"][1]["at"][0], 48, 3)
        self.assertLess(told["points"][1]["miss"], 0.5)
        page.wait_for_frame(change)
        # The text that is made of it has no hand at it.
        text = applied(CAMERA, page.result("text/set", values=told["values"])["edits"])
        page.edit(text)
        change = page.result("view/change")["change"]
        page.wait_for("view/rest", change=change)
        self.assertEqual([one for one in page.told if one["method"] == "view/dragged"
                          and one["params"]["change"] > told["change"]], [])

    def test_what_cannot_follow_says_so(self):
        self.open()
        page = self.page().begin()
        page.result("view/change", size=SMALL)
        pull = {"point": [1, 0, 0], "from": [42.67, 24], "to": [48, 24]}
        change = page.result("view/drag", parameters=["hieght"], pulls=[pull])["change"]
        told = page.wait_for("view/dragged", change=change)
        self.assertIn("did you mean 'height'?", told["diagnostics"][0]["message"])
        self.assertFalse(told["points"][0]["follows"])
        change = page.result("view/drag", layer=7, pulls=[pull])["change"]
        self.assertTrue(page.wait_for("view/dragged", change=change)["diagnostics"])

    def test_a_drag_that_is_none(self):
        self.open()
        page = self.page().begin()
        pull = {"point": [1, 0, 0], "from": [1, 2], "to": [3, 4]}
        for wrong in ({}, {"pulls": 5}, {"pulls": [5]}, {"pulls": [dict(pull, point=[1, 2])]},
                      {"pulls": [dict(pull, to="there")]}, {"pulls": [pull] * 65},
                      {"pulls": [dict(pull, infinite="yes")]}, {"pulls": [pull], "layer": -1},
                      {"pulls": [pull], "parameters": "size"}):
            self.assertEqual(page.error("view/drag", **wrong)["code"], -32602, wrong)
        # Numbers that no picture has.
        page.wait_for("studio/scene", state="ready")
        for number in (1e300, -1e300, 1e-300):
            change = page.result("view/drag", pulls=[
                {"point": [number, 0, number], "from": [number, 0], "to": [3, number]},
                {"point": [0, 0, 0], "infinite": True, "from": [1, 1], "to": [2, 2]}])["change"]
            page.wait_for("view/dragged", change=change)
        self.assertTrue(self.is_alive())


if __name__ == "__main__":
    support.main()
