# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""balcony studio: questions about what a picture shows."""

import support
from studio_case import CAMERA, StudioTest


class Questions(StudioTest):
    # A pixel is 6/64 wide. The wall is one below the origin, the camera five above it.
    def test_what_stands_at_a_point(self):
        self.open()
        page = self.shown()
        seen = page.result("view/at", x=42.2, y=20.9)
        u, v = 10.5 * 6 / 64, 3.5 * 6 / 64
        self.assertEqual(seen["ray"], {"layer": "", "origin": [u, v, 5], "direction": [0, 0, -1],
                                       "u": u, "v": v})
        hit = seen["hit"]
        self.assertEqual((hit["object"], hit["distance"], hit["normal"]), ("wall", 6, [0, 0, 1]))
        for one, other in zip(hit["point"], [u, v, -1], strict=True):
            self.assertAlmostEqual(one, other, 5)
        self.assertAlmostEqual(hit["magnification"], 64 / 6, 5)
        for one, other in zip(hit["metric"], [(6 / 64) ** 2, 0, (6 / 64) ** 2], strict=True):
            self.assertAlmostEqual(one, other, 9)
        # It follows values, also those of another page.
        change = page.result("view/change", values=[{"parameter": "height", "value": 7}])["change"]
        page.wait_for("view/camera", change=change)
        self.assertEqual(page.result("view/at", x=42, y=20)["hit"]["distance"], 8)

    def test_what_stands_in_the_cells_of_a_grid(self):
        self.open()
        page = self.shown()
        places = page.result("view/grid", columns=8, rows=4)["places"]
        self.assertEqual(len(places), 32)
        for column, row in ((0, 0), (3, 1), (7, 3)):
            self.assertEqual(places[8 * row + column],
                             page.result("view/at", x=8 * column + 4, y=12 * row + 6))

    def test_what_check_finds(self):
        (self.folder / "my.cam").write_text(CAMERA.replace(
            "[u, v, height]", "[u, v, height + sqrt(1.5 - u)/1e6]"))
        self.open()
        page = self.shown()
        remark, = [one for one in page.result("view/check")["remarks"] if one["defect"]]
        self.assertIn("25 % of the picture has no ray", remark["message"])
        self.assertIn("restrict map", remark["remedy"])
        self.assertEqual((remark["camera"], remark["boxes"]), ("", [[48, 0, 64, 48]]))
        x, y = remark["at"]
        self.assertTrue(48 < x < 64 and 0 < y < 48)

    def test_only_the_newest_check_is_answered(self):
        self.open()
        page = self.shown()
        for number in range(5):
            page.send({"jsonrpc": "2.0", "id": 900 + number, "method": "view/check", "params": {}})
        answers = {}
        while len(answers) < 5:
            answer = page.next()
            if answer.get("id", 0) >= 900:
                answers[answer["id"]] = answer
        self.assertIn("result", answers[904])
        self.assertTrue(any("interrupted" in answers[900 + number].get("error", {}).get("message", "")
                            for number in range(4)))

    def test_a_time_is_shown(self):
        (self.folder / "my.cam").write_text(CAMERA.replace("[u, v, height]", "[u, v, height + t]"))
        self.open("--time", "1")
        page = self.shown()
        self.assertEqual((page.about["time"], page.about["frameRate"]), (1, 24))
        self.assertEqual(page.result("view/at", x=42, y=20)["hit"]["distance"], 7)
        self.assertEqual(page.result("command")["line"].split().count("--time"), 1)
        change = page.result("view/change", time=2.5)["change"]
        page.wait_for("view/rest", change=change)
        self.assertEqual(page.result("view/at", x=42, y=20)["hit"]["distance"], 8.5)
        words = page.result("command")["line"].split()
        self.assertEqual(words.count("--time"), 1)
        self.assertEqual(words[words.index("--time") + 1], "2.5")
        for wrong in ("soon", 1e300, None):
            self.assertEqual(page.error("view/change", time=wrong)["code"], -32602)

    def test_where_nothing_stands(self):
        (self.folder / "my.cam").write_text(CAMERA.replace("[u, v, height]",
                                                           "[u, v, height + sqrt(1 - u)]"))
        self.open()
        page = self.shown()
        self.assertEqual(page.result("view/at", x=60, y=20), {"ray": None, "hit": None})
        change = page.result("view/change", values=[{"parameter": "size", "value": 100}])["change"]
        page.wait_for("view/camera", change=change)
        seen = page.result("view/at", x=2, y=20)
        self.assertIsNotNone(seen["ray"])
        self.assertIsNone(seen["hit"])

    def test_where_a_point_appears(self):
        self.open()
        page = self.shown(values=[{"parameter": "size", "value": 2}])
        place, = page.result("view/find", point=[1, 0.5, 0])["places"]
        self.assertEqual([place[name] for name in ("x", "y", "distance", "hiddenBy")],
                         [48, 16, 5, None])
        self.assertEqual(place["origin"], [1, 0.5, 5])
        place, = page.result("view/find", point=[1, 0.5, -2])["places"]
        self.assertEqual(place["hiddenBy"], "wall")
        self.assertEqual(page.result("view/find", point=[9, 0, 0])["places"], [])

    def test_questions_that_are_none(self):
        self.open()
        page = self.shown()
        for method, asked in (("view/at", {}), ("view/at", {"x": 1}), ("view/at", {"x": "1", "y": 1}),
                              ("view/grid", {}), ("view/grid", {"columns": 3}),
                              ("view/grid", {"columns": 0, "rows": 3}),
                              ("view/grid", {"columns": 3, "rows": 257}),
                              ("view/grid", {"columns": 3, "rows": -1}),
                              ("view/find", {}), ("view/find", {"point": [1, 2]}),
                              ("view/find", {"point": "there"})):
            self.assertEqual(page.error(method, **asked)["code"], -32602, (method, asked))
        for x, y in ((64, 0), (0, 48), (-1, 0), (1e300, 0)):
            self.assertIn("is not in a picture of 64 x 48", page.error("view/at", x=x, y=y)["message"])
        for number in (1e300, -1e300):
            self.assertEqual(page.result("view/find", point=[number] * 3)["places"], [])

    def test_questions_about_nothing(self):
        self.open(scene="missing.obj")
        page = self.page().begin()
        page.wait_for("studio/scene", state="failed")
        for method, asked in (("view/at", {"x": 1, "y": 1}), ("view/grid", {"columns": 2, "rows": 2}),
                              ("view/check", {}), ("view/find", {"point": [1, 2, 3]})):
            self.assertIn("no picture is shown yet", page.error(method, **asked)["message"])

    def test_many_questions_at_once(self):
        self.open()
        page = self.shown()
        for i in range(500):
            page.notify("view/at", x=1, y=i % 48)
            page.send({"jsonrpc": "2.0", "id": 1000 + i, "method": "view/at",
                       "params": {"x": i % 64, "y": 3}})
        answers = {}
        while len(answers) < 500:
            answer = page.next()
            if answer.get("id", 0) >= 1000:
                answers[answer["id"]] = answer
        self.assertTrue(any("result" in one for one in answers.values()))
        for one in answers.values():
            self.assertTrue("result" in one or "ask again later" in one["error"]["message"])


if __name__ == "__main__":
    support.main()
