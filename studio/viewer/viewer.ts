// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// A page in which a browser looks at a scene through a camera.

import { makeAtlas } from "./atlas";
import { type PageData, readBytes, readData } from "./page_data";
import { Picture } from "./picture";
import { Sliders } from "./sliders";
import { gather } from "./triangles";

const element = <E extends HTMLElement>(id: string): E => document.getElementById(id) as E;

const canvas = element<HTMLCanvasElement>("picture");
const stage = element("stage");
const message = element("message");
const state = element("state");
const words = element<HTMLDialogElement>("words");

function say(text: string): void {
    message.textContent = text;
    message.hidden = text === "";
}

/** More pixels than that take a phone too long. */
const mostPixels = 4e6;

/** Of a pixel, when the picture is finished: page.html#samples=8 has fewer. */
const allSamples = Number(/^#samples=(\d+)$/.exec(location.hash)?.[1] ?? 32);

/** As large as there is room for, in the shape of the picture. */
function fit(data: PageData, picture: Picture): void {
    const [width, height] = data.size;
    const room = Math.min(stage.clientWidth / width, stage.clientHeight / height);
    const ratio = Math.min(devicePixelRatio, 2);
    const scale = Math.min(room * ratio, Math.sqrt(mostPixels / (width * height)));
    const pixels = [width, height].map((side) => Math.max(1, Math.round(side * scale))) as [number, number];
    canvas.style.width = `${Math.round(width * room)}px`;
    canvas.style.height = `${Math.round(height * room)}px`;
    picture.resize(...pixels);
}

function listenToKeys(reset: () => void, full: () => void): void {
    document.addEventListener("keydown", (event) => {
        const isTyping = event.target instanceof HTMLInputElement && event.target.type === "text";
        if (isTyping || event.ctrlKey || event.metaKey || event.altKey || words.open) return;
        if (event.key === "r" || event.key === "R") reset();
        else if (event.key === "f" || event.key === "F") full();
        else if (event.key === "?") words.showModal();
        else return;
        event.preventDefault();
    });
}

function showPicture(data: PageData, picture: Picture): void {
    // The time is another number of the camera.
    const time = { name: "t", value: data.time, unit: "seconds", min: 0, max: Math.max(10, 2 * data.time) };
    const sliders = new Sliders(element("sliders"), data.hasTime ? [...data.parameters, time] : data.parameters);
    sliders.onmove = () => {
        const values = sliders.values;
        picture.show(data.hasTime ? values.slice(0, -1) : values, data.hasTime ? values.at(-1)! : data.time);
    };
    sliders.onhold = (isHeld) => picture.hold(isHeld);
    const full = () => {
        if (document.fullscreenElement) void document.exitFullscreen();
        else if (document.fullscreenEnabled) void stage.requestFullscreen();
    };
    const reset = () => sliders.reset();
    element("reset").addEventListener("click", reset);
    element("full").addEventListener("click", full);
    element("full").hidden = !document.fullscreenEnabled;
    element("reset").hidden = sliders.values.length === 0;
    listenToKeys(reset, full);
    picture.onprogress = (samples, all) => {
        if (samples >= 0) say("");
        document.documentElement.dataset["samples"] = String(samples);
        state.textContent = samples <= 0 ? "Coarse" : samples === all ? "Finished" : `${samples} of ${all} samples`;
    };
    new ResizeObserver(() => fit(data, picture)).observe(stage);
    fit(data, picture);
}

async function start(): Promise<void> {
    const data = readData();
    element("title").textContent = data.title;
    element("version").textContent = `Balcony ${data.version}`;
    canvas.setAttribute("aria-label", data.title);
    element("about").addEventListener("click", () => words.showModal());
    element("panel").addEventListener("submit", (event) => event.preventDefault());
    const gl = document.createElement("canvas").getContext("webgl2");
    if (!gl || !(gl.getExtension("EXT_color_buffer_float") ?? gl.getExtension("EXT_color_buffer_half_float"))) {
        say("This page needs WebGL 2 with floating-point pictures, which this browser does not have here.");
        return;
    }
    const most = Math.min(4096, gl.getParameter(gl.MAX_TEXTURE_SIZE) as number);
    gl.getExtension("WEBGL_lose_context")?.loseContext();
    canvas.addEventListener("webglcontextlost", (event) => {
        event.preventDefault();
        say("The graphics processor has given up. Load the page again.");
    });
    // The words are drawn before the work begins.
    await new Promise((done) => setTimeout(done, 50));
    const bytes = readBytes();
    const atlas = await makeAtlas(data, bytes, most);
    const tables = new Float32Array(bytes, data.tables.begin, data.tables.count);
    const picture = new Picture(canvas, data, gather(data, bytes), atlas, tables, allSamples);
    showPicture(data, picture);
    await picture.start();
}

start().catch((error: unknown) => {
    console.error(error);
    say(`The picture cannot be shown here: ${error instanceof Error ? error.message : String(error)}`);
});
