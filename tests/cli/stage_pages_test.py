# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""docs/stages matches the catalogue and has a picture of every example."""

import support

REMEDY = "docs/stages does not match the catalogue: run scripts/pictures --stages and commit the result"
MOST_BYTES = 60_000


def texts(folder):
    return {str(path.relative_to(folder)): path.read_text()
            for path in folder.rglob("*") if path.suffix in (".md", ".cam")}


class StagePages(support.CommandTest):
    def setUp(self):
        super().setUp()
        self.kept = support.REPOSITORY / "docs" / "stages"

    def test_pages_are_up_to_date(self):
        self.run_command("list", "--markdown", "stages")
        made, kept = texts(self.folder / "stages"), texts(self.kept)
        self.assertEqual(sorted(made), sorted(kept), REMEDY)
        for name, text in made.items():
            self.assertEqual(text, kept[name], f"{name}: {REMEDY}")

    def test_every_example_has_a_picture(self):
        examples = {path.stem for path in (self.kept / "examples").glob("*.cam")}
        pictures = {path.stem: path for path in (self.kept / "pictures").glob("*.png")}
        self.assertGreater(len(examples), 20)
        self.assertEqual(sorted(examples), sorted(pictures), REMEDY)
        for name, path in pictures.items():
            self.assertLess(path.stat().st_size, MOST_BYTES, name)

    def test_refusal(self):
        (self.folder / "file").write_text("")
        self.refused("list", "--markdown", "file/stages", code=3, says="cannot be written")


if __name__ == "__main__":
    support.main()
