// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// The parts of the page that need no browser.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { readdirSync, readFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { test } from "node:test";
import { fileURLToPath } from "node:url";
import { build } from "../../studio/node_modules/esbuild/lib/main.js";

const repository = join(dirname(fileURLToPath(import.meta.url)), "../..");

/** The modules of the page as one. */
async function page() {
    const names = ["shared_text", "language", "language_server", "parameter_range", "picture_size", "latency", "number_drag", "lattice", "taken_camera", "film_time"];
    const made = await build({
        stdin: {
            contents: [
                ...names.map((name) => `export * from "./src/${name}";`),
                'export { Text, ChangeSet } from "@codemirror/state";',
                'export { StringStream } from "@codemirror/language";',
            ].join("\n"),
            resolveDir: join(repository, "studio"),
        },
        bundle: true,
        format: "esm",
        platform: "node",
        write: false,
    });
    return import(`data:text/javascript;base64,${Buffer.from(made.outputFiles[0].contents).toString("base64")}`);
}
const parts = await page();

function randomNumbers(seed) {
    let state = seed;
    return (below) => {
        state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
        return Math.floor((state / 2 ** 32) * below);
    };
}

/** A server that takes edits of its newest version only, and a page of it. Messages are late. */
class Server {
    constructor(text, random) {
        this.text = text;
        this.version = 1;
        this.random = random;
        this.pages = [];
    }

    page() {
        const page = {
            doc: parts.textOf(this.text),
            up: [], // Messages on their way, each way in order.
            down: [],
        };
        page.shared = new parts.SharedText(
            (version, text) =>
                new Promise((resolve) => {
                    page.up.push(() => this.take(page, version, text));
                    page.up.push(() => page.down.push(resolve)); // The answer of the question behind it.
                }),
        );
        page.shared.begin(this.version, this.text);
        this.pages.push(page);
        return page;
    }

    take(page, version, text) {
        const tell = (one, version, text) =>
            one.down.push(() => {
                const changes = one.shared.told(version, text);
                if (changes) one.doc = changes.apply(one.doc);
            });
        if (version !== this.version + 1) {
            tell(page, this.version, this.text);
        } else {
            [this.version, this.text] = [version, text];
            for (const one of this.pages) if (one !== page) tell(one, version, text);
        }
    }

    /** Lets one message arrive. */
    async step() {
        const queues = this.pages.flatMap(({ up, down }) => [up, down]).filter(({ length }) => length > 0);
        if (queues.length === 0) return false;
        queues[this.random(queues.length)].shift()();
        for (let i = 0; i < 4; ++i) await null;
        return true;
    }
}

test("pages that type at the same time end with one text, in which every letter is kept", async () => {
    for (let seed = 1; seed <= 200; ++seed) {
        const random = randomNumbers(seed);
        const server = new Server("eye sphere(1)\nlook normal\n", random);
        const pages = [server.page(), server.page(), server.page()];
        const typed = [];
        for (let i = 0; i < 40; ++i) {
            const page = pages[random(3)];
            if (random(3) > 0) {
                const letter = String.fromCharCode(0x4e00 + i);
                typed.push(letter);
                const changes = parts.ChangeSet.of(
                    { from: random(page.doc.length + 1), insert: letter },
                    page.doc.length,
                );
                page.doc = changes.apply(page.doc);
                page.shared.made(changes);
            } else {
                await server.step();
            }
        }
        while (await server.step());
        for (const page of pages) {
            assert.equal(page.doc.toString(), server.text, `seed ${seed}`);
            assert.ok(page.shared.isSettled);
            assert.equal(page.shared.version, server.version);
        }
        for (const letter of typed) assert.equal(server.text.split(letter).length, 2, `seed ${seed}: ${letter}`);
        assert.equal(server.text.replace(/[\u4e00-\u4eff]/g, ""), "eye sphere(1)\nlook normal\n");
    }
});

test("what is typed without a connection goes to the server that comes back", async () => {
    const sent = [];
    const shared = new parts.SharedText((version, text) => {
        sent.push([version, text]);
        return new Promise(() => {});
    });
    shared.begin(3, "a");
    shared.disconnected();
    shared.made(parts.ChangeSet.of({ from: 1, insert: "b" }, 1));
    assert.deepEqual(sent, []);
    // The same server, to which another page has written.
    const changes = shared.reconnected(4, "xa");
    assert.equal(changes.apply(parts.textOf("ab")).toString(), "xab");
    assert.deepEqual(sent, [[5, "xab"]]);
    // That edit had arrived before the connection was lost again.
    shared.disconnected();
    assert.equal(shared.reconnected(5, "xab"), null);
    assert.ok(shared.isSettled);
    // A new server with what was saved.
    shared.disconnected();
    shared.restarted(1, "a", "xab");
    assert.deepEqual(sent.at(-1), [2, "xab"]);
});

test("the difference of two texts is one replacement", () => {
    for (const [before, after] of [
        ["", "ab"],
        ["ab", ""],
        ["aa", "aaa"],
        ["a = 1\n", "a = 2\n"],
        ["same", "same"],
    ]) {
        const changes = parts.difference(before, after);
        assert.equal(changes.apply(parts.textOf(before)).toString(), after);
    }
    assert.deepEqual(parts.difference("a = 1;", "a = 27;").toJSON(), [4, [1, "27"], 1]);
});

// editors/cam_scopes.py reads the same grammar for docs and plates. An editor has it for each line alone.
const SCOPES = `
import json, sys
sys.path.insert(0, "editors")
from cam_scopes import scopes
print(json.dumps({name: [[one for one in scopes(line) if one[1]] for line in open(name).read().split("\\n")]
                  for name in sys.argv[1:]}))
`;

/** The class of each character. */
function coloured(text) {
    const tokens = parts.cameraTokens;
    const state = tokens.startState(4);
    const classes = [];
    for (const line of text.split("\n")) {
        const stream = new parts.StringStream(line, 4, 4);
        while (!stream.eol()) {
            stream.start = stream.pos;
            const found = tokens.token(stream, state);
            assert.ok(stream.pos > stream.start || found === null, line);
            for (let i = stream.start; i < stream.pos; ++i) classes.push(found);
        }
        classes.push(null);
    }
    return classes;
}

test("the editor's colours are those of the grammar, for all built-in cameras", () => {
    const files = readdirSync(join(repository, "cameras"), { recursive: true })
        .filter((name) => name.endsWith(".cam"))
        .map((name) => join("cameras", name));
    assert.ok(files.length > 150);
    const output = execFileSync("python3", ["-B", "-c", SCOPES, ...files], { cwd: repository, maxBuffer: 1 << 28 });
    const known = JSON.parse(output);
    const beginnings = new Map();
    for (const file of files) {
        for (const [index, line] of readFileSync(join(repository, file), "utf8").split("\n").entries()) {
            const classes = coloured(line);
            for (const [begin, part, scope] of known[file][index]) {
                for (let i = begin; i < begin + part.length; ++i) {
                    if (/\s/.test(line[i])) continue;
                    assert.equal(classes[i] === null, scope === "", `${file}: ${line}`);
                    if (scope) beginnings.set(scope, (beginnings.get(scope) ?? new Set()).add(classes[i]));
                }
            }
        }
    }
    assert.ok(beginnings.size >= 12);
    for (const [scope, classes] of beginnings) assert.equal(classes.size, 1, scope);
});

test("a comment over several lines is one", () => {
    const text = "/* eye\n sphere */ eye sphere(1)";
    const classes = coloured(text);
    assert.equal(classes[text.indexOf("sphere */")], "comment");
    assert.equal(classes[text.indexOf("sphere(")], "stage");
});

test("blanks of a completion", () => {
    assert.equal(parts.blanksOf("sphere(radius = ${1:1})$0"), "sphere(radius = ${1:1})${}");
    assert.equal(parts.blanksOf("f(u) = [${1:u}]$0"), "f(u) = [${1:u}]${}");
    assert.equal(parts.blanksOf("block {\\}$0"), "block {\\}${}");
});

test("edits change only what is different", () => {
    const text = parts.textOf("camera a(x = 1) {\n    eye point(x, 0, 0)\n}\n");
    const whole = { start: { line: 0, character: 0 }, end: { line: 3, character: 0 } };
    const changes = parts.changesOf(text, [{ range: whole, newText: text.toString().replace("x = 1", "x = 25") }]);
    assert.deepEqual(changes, [{ from: 13, to: 14, insert: "25" }]);
});

const parameter = (value, more = {}) => ({ name: "a", value, unit: "number", ...more });

test("a slider keeps to the limits of its parameter, and has room where there are none", () => {
    const degree = Math.PI / 180;
    const gamma = parts.rangeOf(parameter(0.25, { min: 0.05, max: 2 }));
    assert.deepEqual([gamma.min, gamma.max], [0.05, 2]);
    const excluded = parts.rangeOf(parameter(45, { min: 0, minExcluded: true }));
    assert.ok(excluded.min > 0 && excluded.min <= 0.1 && excluded.max === 90);
    const angle = parts.rangeOf(parameter(30 * degree, { unit: "angle" }));
    assert.deepEqual([angle.min, angle.max], [-180, 180]);
    for (const value of [-7, 0, 1e-3, 4e6]) {
        for (const more of [{}, { min: -10 }, { max: 5e6 }, { unit: "angle" }]) {
            const { min, max, step } = parts.rangeOf(parameter(value, more));
            const shown = more.unit ? value / degree : value;
            assert.ok(min <= shown && shown <= max && step > 0 && (max - min) / step >= 500, `${value}`);
        }
    }
    assert.equal(parts.numberText(30.85), "30.85");
    assert.equal(parts.rounded(1.4210000000000003, 0.001), 1.421);
});

test("a number that is dragged in the text", () => {
    const found = (line, part) => parts.numberAt(line, line.indexOf(part) + 1);
    assert.deepEqual(found("seam = 30.85deg) {", "30.85"), { from: 7, to: 12, value: 30.85, step: 0.1 });
    assert.deepEqual(found("map u = -36deg .. 1", "36"), { from: 8, to: 11, value: -36, step: 0.1 });
    assert.deepEqual(found("let a = b-2", "2"), { from: 10, to: 11, value: 2, step: 0.01 });
    assert.deepEqual(found("a(0..4)", "4"), { from: 5, to: 6, value: 4, step: 0.01 });
    assert.equal(found("x1 = y", "x1"), null);
});

test("the size of the picture", () => {
    assert.deepEqual(parts.sizeOf({ kind: "fit" }, 5, [838, 500]), [838, 168]);
    assert.deepEqual(parts.sizeOf({ kind: "fit" }, 1, [838, 500]), [500, 500]);
    assert.deepEqual(parts.sizeOf({ kind: "wide", width: 960 }, 16 / 9, [1, 1]), [960, 540]);
    for (const name of ["fit", "960", "960x540"]) assert.equal(parts.nameOf(parts.choiceOf(name)), name);
    assert.equal(parts.choiceOf("large"), null);
});

test("latency is from a change to the first picture that shows it or a later one", async () => {
    const latency = new parts.Latency();
    latency.begin(Promise.resolve(4));
    latency.begin(Promise.resolve(5));
    latency.begin(Promise.reject(new Error("lost")));
    await null;
    await null;
    latency.drawn(3);
    assert.equal(latency.typical, null);
    latency.drawn(5);
    assert.equal(latency.measured.length, 2);
    latency.drawn(6);
    assert.equal(latency.measured.length, 2);
});

test("a line of a level is where the values are, and not over a leap of an angle", () => {
    // The value is the place from the left in cells, which is half a cell beside the middle of the first one.
    const values = Array.from({ length: 20 }, (_, i) => i % 5);
    const pieces = parts.contour(values, 5, 4, 2.25, 10);
    assert.equal(pieces.length, 3);
    for (const piece of pieces) for (const [x] of piece) assert.ok(Math.abs(x - 2.75 / 5) < 1e-12);
    assert.deepEqual(parts.contour(values, 5, 4, 2.25, 0.5), []);
    assert.deepEqual(parts.contour(values.map(() => null), 5, 4, 2.25, 10), []);
});

test("levels are round numbers in the range", () => {
    assert.deepEqual(parts.levelsOf([-1.45, 1.45], false, 6), [-1, -0.5, 0, 0.5, 1]);
    const degrees = parts.levelsOf([-Math.PI, Math.PI], true, 8).map((one) => Math.round((one * 180) / Math.PI));
    assert.deepEqual(degrees, [-180, -135, -90, -45, 0, 45, 90, 135, 180]);
    assert.deepEqual(parts.levelsOf([null], false), []);
});

test("a camera that is taken has a name that the text does not have", () => {
    const camera = "// Of panorama().\ncamera panorama(yaw = 0deg) {\n}\n";
    assert.deepEqual(parts.taken("", camera, "panorama", []), { insert: camera, name: "panorama" });
    const { insert, name } = parts.taken("camera a {\n}", camera, "panorama", ["panorama", "panorama_2"]);
    assert.equal(name, "panorama_3");
    assert.equal(insert, "\n\n// Of panorama().\ncamera panorama_3(yaw = 0deg) {\n}\n");
});

test("keys are written at the time of the line, before the picture follows it", async () => {
    const answers = [];
    const session = {
        link: "open",
        camera: { time: 0.5 },
        about: { frameRate: 24, time: 0.25 },
        connection: { request: (method, { time }) => new Promise((answer) => answers.push(() => answer({ change: time }))) },
    };
    const film = new parts.FilmTime(session, {});
    assert.equal(film.asked.time, 0.5);
    void film.show(2);
    assert.equal(film.asked.time, 2);
    // Without the line, the time is the server's.
    const left = film.leave();
    answers.forEach((answer) => answer());
    await left;
    session.camera.time = 0.75;
    assert.equal(film.asked.time, 0.75);
});
