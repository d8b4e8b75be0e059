# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""Common parts of the tests of balcony studio."""

import http.client
import re

import support
from web_socket import Page

CAMERA = """// Looks down along z.
camera above(size = 3, height = 5) {  // A comment.
    axes y_up
    map  u = -size .. size, v = square
    eye  surface(u, v) = [u, v, height]
    toward surface(u, v) = [u, v, 0]
    look relative
}
"""
SMALL = [64, 48]


def applied(text, edits):
    """The text with edits of the protocol. It is ASCII."""
    lines = text.splitlines(keepends=True)
    starts = [sum(map(len, lines[:i])) for i in range(len(lines) + 1)]
    def offset(place):
        return starts[place["line"]] + place["character"]
    for edit in sorted(edits, key=lambda edit: -offset(edit["range"]["start"])):
        begin, end = offset(edit["range"]["start"]), offset(edit["range"]["end"])
        text = text[:begin] + edit["newText"] + text[end:]
    return text


class StudioTest(support.CommandTest):
    def setUp(self):
        super().setUp()
        (self.folder / "my.cam").write_text(CAMERA)

    def open(self, *words, scene="scene.obj", camera="my.cam", **how):
        """Starts the studio."""
        self.process = self.start("studio", scene, camera, "--samples", "2", *words, **how)
        process = self.process
        self.addCleanup(lambda: (process.kill(), process.wait(), process.stdout.close(),
                                 process.stderr.close()))
        line = process.stdout.readline().decode()
        found = re.fullmatch(r"http://127\.0\.0\.1:(\d+)/\?token=([0-9a-f]{32})\n", line)
        self.assertTrue(found, line)
        self.port, self.token = int(found[1]), found[2]

    def page(self, **how):
        page = Page(self.port, self.token, **how)
        self.addCleanup(page.close)
        return page

    def shown(self, **changes):
        """A page whose small picture is at rest."""
        page = self.page().begin()
        page.result("view/change", size=SMALL, **changes)
        page.wait_for("view/camera", name="above")
        page.wait_for("view/rest")
        return page

    def get(self, path, method="GET", **headers):
        """The status, the headers and the body of an answer."""
        connection = http.client.HTTPConnection("127.0.0.1", self.port, timeout=60)
        connection.request(method, path, headers=headers)
        answer = connection.getresponse()
        made = answer.status, answer.headers, answer.read()
        connection.close()
        return made

    def is_alive(self):
        page = self.page().begin()
        page.close()
        return self.process.poll() is None
