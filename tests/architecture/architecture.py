#!/usr/bin/env python3
# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""Checks the structure of the sources against layers.txt.

Usage: architecture.py REPOSITORY

Derives from the files what uses what, and names each of these on standard output:
  - a file that includes a header of a layer which its own layer may not use
  - a file that includes a private header of another layer: one in src/, not in include/balcony/,
    unless layers.txt opens it to the layer, and a header that is opened to a layer without need.
    Tests in tests/<layer>/ may include the private headers of that layer, and of those that open
    any to it; programs none
  - a CMake target that is linked to a layer which it may not use
  - a file that includes a header of a layer to which its target is not linked
  - files that include each other in a circle, and folders of a layer that do
  - a public header that includes a private one
  - a header from outside included elsewhere than its one folder
  - a folder of src/ that the table does not know
The exit code is 1 if there is any.
"""

import os
import re
import sys
from pathlib import Path

SOURCE_SUFFIXES = {".cpp", ".hpp", ".h", ".inl"}
INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*([<"])([^>"]+)[>"]', re.MULTILINE)


class Table:
    """layers.txt: what each layer may use, its public headers, its private ones that are open to
    other layers, and where outside headers belong."""

    def __init__(self, text):
        self.direct = {}
        self.only_in = {}
        self.layer_of_header = {}
        self.open_to = {}
        for line in text.splitlines():
            line = line.split("#")[0].strip()
            confined = re.fullmatch(r"(\S+/|\S+\.h)\s+only in\s+(\S+)", line)
            header = re.fullmatch(r"(\w+)\.hpp\s+of\s+(\w+)", line)
            opened = re.fullmatch(r"(\S+/\S+\.(?:hpp|inl))\s+open to\s+(.+)", line)
            row = re.fullmatch(r"(\w+):\s*(.*)", line)
            if confined:
                self.only_in[confined[1]] = confined[2]
            elif opened:
                self.open_to[opened[1]] = opened[2].split()
            elif header:
                self.layer_of_header[header[1]] = header[2]
            elif row:
                self.direct[row[1]] = row[2].split()
            elif line:
                raise SystemExit(f"layers.txt: cannot read '{line}'")

    def opening_to(self, layer):
        """The layers that open a private header to another."""
        return {name.split("/")[0] for name, users in self.open_to.items() if layer in users}

    def reachable(self, layer):
        """The layer itself and all that it may use, directly or through another."""
        return closure(layer, lambda name: self.direct if "*" in self.direct[name]
                       else self.direct[name])


def closure(start, neighbours):
    seen, waiting = {start}, [start]
    while waiting:
        for name in neighbours(waiting.pop()):
            if name not in seen:
                seen.add(name)
                waiting.append(name)
    return seen


class Tree:
    """The sources under src/ and include/balcony/ with their include edges."""

    def __init__(self, root, layer_of_header):
        self.root = root
        self.layer_of_header = layer_of_header
        self.files = sorted(
            path for folder in ("src", "include") for path in (root / folder).rglob("*")
            if path.suffix in SOURCE_SUFFIXES)
        known = set(self.files)
        self.edges = {}
        self.outside = {}
        for path in self.files:
            self.edges[path], self.outside[path] = [], []
            for kind, name in INCLUDE.findall(path.read_text(encoding="utf-8")):
                folders = [root / "include", root / "src"]
                if kind == '"':
                    folders.insert(0, path.parent)
                candidates = (Path(os.path.normpath(folder / name)) for folder in folders)
                header = next((found for found in candidates if found in known), None)
                if header:
                    self.edges[path].append(header)
                else:
                    self.outside[path].append(name)

    def name(self, path):
        return str(path.relative_to(self.root))

    def is_public(self, path):
        return path.relative_to(self.root).parts[0] == "include"

    def layer(self, path):
        """src/<layer>/..., include/balcony/<layer>.hpp, or what layers.txt says of a header."""
        parts = path.relative_to(self.root).parts
        if not self.is_public(path):
            return parts[1]
        header = Path(parts[2]).stem
        return self.layer_of_header.get(header, header)


def cmake_links(root, layer, known_layers):
    """The layers to which the targets in src/<layer>/ are linked, as their CMake files say."""
    links = set()
    for listing in (root / "src" / layer).rglob("CMakeLists.txt"):
        text = re.sub(r"#.*", "", listing.read_text(encoding="utf-8"))
        for arguments in re.findall(r"\bbalcony_layer\s*\(([^)]*)\)", text):
            words = arguments.split()
            if "USES" in words:
                for word in words[words.index("USES") + 1:]:
                    if word in ("SOURCES", "PRIVATE"):
                        break
                    links.add(word)
        for name in re.findall(r"\bbalcony(?:_|::)(\w+)", text):
            if name in known_layers:
                links.add(name)
    return links - {layer}


def circle(edges):
    """Nodes that lead to each other in a circle, or nothing."""
    finished = set()
    for start in edges:
        trail, on_trail = [(start, iter(edges[start]))], {start}
        while trail and start not in finished:
            node, remaining = trail[-1]
            following = next(remaining, None)
            if following is None:
                finished.add(node)
                on_trail.discard(node)
                trail.pop()
            elif following in on_trail:
                nodes = [step for step, _ in trail]
                return nodes[nodes.index(following):] + [following]
            elif following not in finished:
                trail.append((following, iter(edges[following])))
                on_trail.add(following)
    return []


def folder_edges(tree, table):
    """What the folders inside each layer include of each other's headers. Headers beside the folders
    are the ground of these; sources beside them, which join the folders, belong to none. A layer
    that may use all has no order of its own."""
    layers = tree.root / "src"
    inside = {path for path in tree.files
              if layers in path.parents
              and (path.parent.parent != layers or path.suffix != ".cpp")
              and "*" not in table.direct.get(tree.layer(path), ())}
    edges = {path.parent: set() for path in inside}
    for path in inside:
        edges[path.parent] |= {header.parent for header in tree.edges[path]
                               if header in inside and tree.layer(header) == tree.layer(path)
                               and header.parent != path.parent}
    return {folder: sorted(edges[folder]) for folder in sorted(edges)}


def circle_findings(tree, table):
    for kind, edges in (("files", tree.edges), ("folders", folder_edges(tree, table))):
        found = circle(edges)
        if found:
            yield f"{kind} include each other: " + " > ".join(tree.name(path) for path in found)


def include_findings(tree, table, links):
    needless = {(name, user) for name, users in table.open_to.items() for user in users}
    for path in tree.files:
        layer = tree.layer(path)
        if layer not in table.direct:
            yield f"{tree.name(path)}: layers.txt knows no layer '{layer}'"
            continue
        linked = closure(layer, lambda name: links.get(name, ()))
        for header in tree.edges[path]:
            target, edge = tree.layer(header), f"{tree.name(path)} includes {tree.name(header)}"
            if target not in table.reachable(layer):
                yield f"{edge}: {layer} may not use {target}"
            elif target not in linked and (tree.root / "src" / layer / "CMakeLists.txt").exists():
                yield f"{edge}: CMake does not link {layer} to {target}"
            if target != layer and not tree.is_public(header):
                name = str(header.relative_to(tree.root / "src"))
                needless.discard((name, layer))
                if layer not in table.open_to.get(name, ()):
                    yield f"{edge}: the private headers of {target} are its own"
            if tree.is_public(path) and not tree.is_public(header):
                yield f"{edge}: a public header may not include a private one"
        for header in tree.outside[path]:
            for prefix, folder in table.only_in.items():
                if header.startswith(prefix) and tree.root / "src" / folder not in path.parents:
                    yield f"{tree.name(path)} includes {header}: {prefix} belongs in src/{folder}"
    for name, user in sorted(needless):
        yield f"layers.txt opens {name} to {user}, which does not include it"


def outsider_findings(root, table):
    """Private headers that tests of other layers and programs include."""
    for folder in ("tests", "bench", "plates", "examples"):
        for path in sorted((root / folder).rglob("*")):
            if path.suffix not in SOURCE_SUFFIXES:
                continue
            parts = path.relative_to(root).parts
            own = {parts[1], *table.opening_to(parts[1])} if folder == "tests" else {}
            for _, name in INCLUDE.findall(path.read_text(encoding="utf-8")):
                layer = name.split("/")[0]
                if layer in table.direct and layer not in own and (root / "src" / name).exists():
                    yield (f"{path.relative_to(root)} includes src/{name}: "
                           f"the private headers of {layer} are its own")


def findings(root):
    table = Table((root / "tests/architecture/layers.txt").read_text(encoding="utf-8"))
    tree = Tree(root, table.layer_of_header)
    links = {layer: cmake_links(root, layer, table.direct) for layer in table.direct}
    yield from include_findings(tree, table, links)
    yield from outsider_findings(root, table)
    for layer, used in links.items():
        for name in sorted(used):
            if name not in table.reachable(layer):
                yield f"src/{layer}/CMakeLists.txt: {layer} may not be linked to {name}"
    yield from circle_findings(tree, table)


def main():
    if len(sys.argv) != 2:
        raise SystemExit(__doc__)
    found = list(findings(Path(sys.argv[1]).resolve()))
    print("\n".join(found) if found else "the structure is as layers.txt says")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
