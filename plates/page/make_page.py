# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""Writes the page of the plates.

Usage: make_page.py FOLDER

FOLDER holds what scripts/plates renders: NAME.png and NAME.json of each plate, and perhaps
NAME-map.png, NAME-camera.svg, NAME-povray.png, NAME.pinhole with the name of the picture to compare
with, and properties.json. Writes FOLDER/index.html, with the plates whose picture is there. To be run
in the repository.
"""

import html
import json
import re
import sys
from pathlib import Path

from cam_html import highlighted
from plate import all_plates, bounds_text, number_text

HERE = Path(__file__).resolve().parent


def escape(text):
    """Markdown's code, emphasis and links as HTML; the rest as it is."""
    text = html.escape(text, quote=False)
    text = re.sub(r"`([^`]+)`", r"<code>\1</code>", text)
    text = re.sub(r"\*([^*]+)\*", r"<em>\1</em>", text)
    return re.sub(r"\[([^\]]+)\]\([^)]+\)", r"\1", text)


def picture_html(plate):
    picture = f"{plate.name}.png"
    pinhole = plate.pinhole()
    if not pinhole:
        return f'<a class="picture" href="{picture}"><img src="{picture}" alt="{plate.title}"></a>'
    return f"""<label class="slider"><span>pinhole</span>
<input type="range" min="0" max="100" value="100" step="0.5" aria-label="from the pinhole to the plate">
<span>plate</span></label>
<div class="compare">
<img src="{picture}" alt="{plate.title}">
<img class="pinhole" src="{pinhole}" alt="The same scene through a pinhole">
<i class="edge"></i>
</div>"""


def property_html(rows):
    lines = "".join(
        f'<tr class="{"met" if row["met"] else "missed"}"><td>{escape(row["what"])}</td>'
        f'<td class="value">{number_text(row["value"])}</td><td>{bounds_text(row)}</td></tr>'
        for row in rows)
    return ("<table><caption>Measured</caption><tr><th>what</th><th>value</th><th>required</th></tr>"
            f"{lines}</table>") if rows else ""


def facts_html(plate):
    facts = plate.facts()
    rate = facts["rays"] / max(facts["seconds"], 1e-9)
    return (f'<p class="facts">{facts["width"]} × {facts["height"]} pixels, {facts["passes"]} samples '
            f'each, in {facts["seconds"]:.1f} s: {rate / 1e6:.2f} million camera rays a second with '
            f'all their light, {facts["camera_share"]:.1%} of the time in the camera.</p>')


def aside_html(plate):
    figures = [("-camera.svg", "The camera: where its rays start, and where they go"),
               ("-map.png", "Magnification: bright where things appear large")]
    return "".join(f'<figure><img loading="lazy" src="{plate.name}{ending}" alt="">'
                   f"<figcaption>{caption}</figcaption></figure>"
                   for ending, caption in figures if plate.file(ending))


def povray_html(plate):
    """Beside each other: the plate, and POV-Ray's own scene through the same camera."""
    if not plate.file("-povray.png"):
        return ""
    figures = [(".png", "Balcony, with its own scene"),
               ("-povray.png", "POV-Ray, with the original scene, through the same camera")]
    return '<div class="pair">' + "".join(
        f'<figure><img loading="lazy" src="{plate.name}{ending}" alt="">'
        f"<figcaption>{caption}</figcaption></figure>" for ending, caption in figures) + "</div>"


def section_html(plate, properties):
    return f"""<section id="{plate.name}">
<h2>{escape(plate.title)}</h2>
{picture_html(plate)}
<p>{escape(plate.paragraph)}</p>
{povray_html(plate)}<div class="details">
<div class="figures">{aside_html(plate)}</div>
<div>{property_html(properties)}
{facts_html(plate)}
<pre>{highlighted(plate.camera_text())}</pre>
<pre class="commands">{html.escape(chr(10).join(plate.commands()), quote=False)}</pre></div>
</div>
</section>"""


def page_html(plates, properties):
    thumbnails = "".join(
        f'<a href="#{plate.name}"><img loading="lazy" src="{plate.name}.png" alt="{plate.title}">'
        f"<span>{plate.number}</span></a>" for plate in plates)
    sections = "\n".join(section_html(plate, properties.get(str(plate.number), []))
                         for plate in plates)
    return f"""<!DOCTYPE html>
<html lang="en">
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>Balcony: the plates</title>
<style>
{(HERE / "page.css").read_text(encoding="utf-8")}</style>
<header>
<h1>The plates</h1>
<p>The fifteen plates of “Ray Tracing with Extended Cameras” (H. Löffelmann and E. Gröller, 1996),
rendered by Balcony with scenes of its own, and more. The slider above a picture brings in the
view of the same scene through a pinhole.</p>
</header>
<nav>{thumbnails}</nav>
<main>
{sections}
</main>
<script>
{(HERE / "page.js").read_text(encoding="utf-8")}</script>
</html>
"""


def main():
    if len(sys.argv) != 2:
        raise SystemExit(__doc__)
    folder = Path(sys.argv[1])
    plates = [plate for plate in all_plates(folder) if plate.is_rendered]
    measured = folder / "properties.json"
    properties = json.loads(measured.read_text(encoding="utf-8")) if measured.exists() else {}
    part = folder / "index.html.part"
    part.write_text(page_html(plates, properties), encoding="utf-8")
    part.replace(folder / "index.html")


if __name__ == "__main__":
    main()
