// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// The page: its parts, and what each of them tells the others.

import { type ChangeSet, Text } from "@codemirror/state";
import { html, LitElement, nothing } from "lit";
import type { CameraWall, WallServer } from "./camera_wall";
import "./camera_wall";
import { Refusal } from "./connection";
import type { CameraSpace } from "./camera_space";
import "./camera_space";
import { askForName, askForSize, confirm, showKeys } from "./dialogs";
import type { CameraEditor } from "./editor";
import "./editor";
import { exportCamera } from "./exports";
import { copyCommand, startFilm, startRender, stopRender } from "./full_render";
import { HandleHand } from "./handle_hand";
import type { Pair } from "./handle_marks";
import { handStep } from "./number_drag";
import { Inspection } from "./inspection";
import { type KeyActions, press } from "./keys";
import type { Problem } from "./language_server";
import type { LivePicture } from "./picture";
import "./picture";
import type { PictureHandles } from "./picture_handles";
import "./picture_handles";
import { choiceOf, sizeOf, type SizeChoice } from "./picture_size";
import { problemList } from "./problem_list";
import { PictureHand } from "./picture_hand";
import "./picture_overlays";
import "./picture_touch";
import { type About, type BuiltInCamera, type Dragged, type FrameHead, type ParameterValue, type Position, Refused, type Triple } from "./protocol";
import { remarkList } from "./remarks";
import { seenWords } from "./seen_words";
import { failureOf, type Page, Session } from "./session";
import type { ParameterSliders } from "./sliders";
import "./sliders";
import { splitter } from "./splitter";
import "./stage_numbers";
import { wordsOf } from "./state_words";
import { taken } from "./taken_camera";
import { chooseTheme, chosenTheme, showTheme } from "./theme";
import "./timeline";
import { toolbar, type ToolbarActions } from "./toolbar";

/** How long words stay that are to be read once, in milliseconds. */
const noticeTime = 7000;

export class BalconyStudio extends LitElement implements Page {
    readonly session = new Session(`ws://${location.host}/live${location.search}`, this);
    private size: SizeChoice = { kind: "fit" };
    private pixels: [number, number] = [0, 0];
    private notice: { words: string; isMistake: boolean } | null = null;
    private noticeTimer = 0;
    private hasHandles = true;
    private hasTimeline = false;
    private readonly hand = new HandleHand({
        edits: (index, handle, moves) => this.session.moved(index, handle, moves),
        hold: (edits) => this.editor.hold(edits),
        release: () => this.editor.release(),
        failed: (why) => this.sayFailure(why),
    });

    private readonly inspection = new Inspection({
        grid: (columns, rows) => this.session.grid(columns, rows),
        check: () => this.session.check(),
        changed: () => this.changed(),
        failed: (why) => this.sayFailure(why),
    });
    /** Where a point that was picked in space appears. */
    private found: Pair[] = [];
    private lastDrag: Dragged | null = null;
    private readonly pictureHand = new PictureHand({
        at: (place) => this.session.at(place),
        drag: (pulls) => this.session.drag(pulls, this.sliders.following),
        keep: () => this.keepDrag(),
        cancelled: () => this.sliders.forget(),
        changed: () => this.changed(),
    });

    override createRenderRoot() {
        return this;
    }

    private get editor(): CameraEditor {
        return this.querySelector<CameraEditor>("camera-editor")!;
    }

    private get picture(): LivePicture {
        return this.querySelector<LivePicture>("live-picture")!;
    }

    private get wall(): CameraWall {
        return this.querySelector<CameraWall>("camera-wall")!;
    }

    private get sliders(): ParameterSliders {
        return this.querySelector<ParameterSliders>("parameter-sliders")!;
    }

    override connectedCallback(): void {
        super.connectedCallback();
        // Before the editor, which has other uses for some keys.
        addEventListener("keydown", (event) => press(event, this.keyActions), { capture: true });
        addEventListener("beforeunload", (event) => {
            if (this.session.about && !this.session.about.readOnly && !this.session.isSaved) event.preventDefault();
        });
    }

    override firstUpdated(): void {
        let timer = 0;
        new ResizeObserver(() => {
            clearTimeout(timer);
            timer = window.setTimeout(() => this.fit(), 120);
        }).observe(this.picture);
        this.picture.onfix = (problem, fix) => this.mend(problem, fix);
        this.picture.onplace = ({ from, to }) => this.editor.goTo(from, to);
        this.sliders.onmove = (values) => this.session.changeView({ values });
        this.sliders.onrest = (values) => void this.write(values);
        this.session.connection.open();
    }

    // What the session changes.

    text(): Text {
        return this.querySelector<CameraEditor>("camera-editor")?.document ?? Text.empty;
    }

    begin(about: About): void {
        const { session } = this;
        this.editor.begin(about.text, about.readOnly, {
            ask: session.ask,
            changed: (changes: ChangeSet) => session.typed(changes),
            format: () => this.attempt(session.format()),
            rename: (name, position) => this.attempt(this.rename(name, position)),
        });
        document.title = `${about.uri.slice(about.uri.lastIndexOf("/") + 1)} – Balcony studio`;
        this.fit();
    }

    take(changes: ChangeSet): void {
        this.editor.take(changes);
    }

    edit(...edits: Parameters<CameraEditor["edit"]>): void {
        this.editor.edit(...edits);
    }

    showProblems(problems: Problem[]): void {
        this.editor.showProblems(problems);
    }

    showValues(...values: Parameters<CameraEditor["showValues"]>): void {
        this.editor.showValues(...values);
    }

    show(head: FrameHead, bytes: Uint8Array): Promise<boolean> {
        return this.picture.show(head, bytes);
    }

    thumbnail(head: FrameHead, bytes: Uint8Array): void {
        void this.wall.picture(head, bytes);
    }

    noThumbnail(camera: string, message: string): void {
        this.wall.fail(camera, message);
    }

    dragged(told: Dragged): void {
        if (!this.pictureHand.pulled) return;
        this.lastDrag = told;
        this.pictureHand.told(told);
        this.sliders.show(told.values);
    }

    rested(): void {
        void this.pictureHand.refresh();
    }

    say(words: string, isMistake = false): void {
        this.notice = { words, isMistake };
        clearTimeout(this.noticeTimer);
        this.noticeTimer = window.setTimeout(() => {
            this.notice = null;
            this.changed();
        }, noticeTime);
        this.changed();
    }

    changed(): void {
        this.requestUpdate();
    }

    // What the person does.

    private readonly actions: ToolbarActions = {
        camera: (name) => {
            this.sliders.forget();
            this.session.changeView({ camera: name, values: [] });
            this.changed();
        },
        wall: () => this.attempt(this.wall.open()),
        size: (name) => void this.resize(name),
        save: () => this.attempt(this.save()),
        render: () => this.attempt(startRender(this.session, this.pixels).then(() => this.changed())),
        stop: () => this.attempt(stopRender(this.session)),
        command: () => this.attempt(copyCommand(this.session)),
        export: (language) => this.attempt(exportCamera(this.session, language)),
        expose: () => this.session.changeView({ exposure: true }),
        stereo: (format) => this.session.changeView({ stereo: format }),
        format: () => this.attempt(this.session.format()),
        theme: (theme) => {
            chooseTheme(theme);
            this.changed();
        },
        overlay: (name) => this.inspection.toggle(name),
        space: () => {
            this.inspection.hasSpace = !this.inspection.hasSpace;
            this.found = [];
            this.changed();
        },
        timeline: () => {
            this.hasTimeline = !this.hasTimeline;
            if (!this.hasTimeline) void this.session.film.leave();
            this.changed();
        },
        handles: () => {
            this.hasHandles = !this.hasHandles;
            this.changed();
        },
        keys: () => void showKeys(),
    };

    private readonly keyActions: KeyActions = {
        save: this.actions.save,
        render: this.actions.render,
        keys: this.actions.keys,
        undo: () => this.editor.undo(),
        redo: () => this.editor.redo(),
        text: () => this.editor.focus(),
        sliders: () => this.sliders.querySelector("input")?.focus(),
        handles: () => this.querySelector<PictureHandles>("picture-handles")?.focusFirst(),
    };

    /** Says the words that come of it, if any. */
    private attempt(action: Promise<string | null | void>): void {
        action.then((words) => words && this.say(words)).catch((failure: unknown) => this.sayFailure(failure));
    }

    private sayFailure(failure: unknown): void {
        const words = failureOf(failure);
        if (words) this.say(words, true);
    }

    private mend(problem: Problem, fix: number): void {
        this.editor.change(problem.fixes[fix]!.changes);
        this.editor.focus();
    }

    private async write(values: ParameterValue[]): Promise<void> {
        try {
            await this.session.write(values);
            this.sliders.settle(values);
        } catch (failure) {
            const words = failureOf(failure);
            if (!words) return; // The values go into the text when the server is back.
            this.say(words, true);
            this.sliders.forget();
            this.session.changeView({ values: [] });
        }
        // The new text has put an end to the values of before.
        if (this.sliders.values.length > 0) this.session.changeView({ values: this.sliders.values });
    }

    private readonly wallServer: WallServer = {
        list: async () =>
            (await this.session.connection.request<{ cameras: BuiltInCamera[] }>("cameras/list", {})).cameras,
        show: (names, size) => this.session.connection.request("cameras/show", { names, ...size }),
        take: (name) => this.attempt(this.takeCamera(name)),
    };

    private async takeCamera(name: string): Promise<void> {
        const { text } = await this.session.connection.request<{ text: string }>("cameras/text", { name });
        const before = this.editor.text;
        const start = taken(before, text, name, this.session.cameras);
        this.editor.change({ from: before.length, insert: start.insert });
        this.editor.goTo(this.editor.text.length - start.insert.trimStart().length);
        this.sliders.forget();
        await this.session.showNew(start.name);
        this.changed();
    }

    /** Writes what a hand on the picture has found. */
    private async keepDrag(): Promise<void> {
        const values = this.lastDrag?.values ?? [];
        this.lastDrag = null;
        if (values.length > 0) await this.write(values.map((one) => ({ ...one, step: handStep(one.value) / 100 })));
    }

    private fit(): void {
        const [width, height] = sizeOf(this.size, this.session.camera?.aspect ?? 16 / 9, this.picture.room);
        if (width === this.pixels[0] && height === this.pixels[1]) return;
        this.pixels = [width, height];
        this.session.changeView({ size: this.pixels });
        this.changed();
    }

    private async resize(name: string): Promise<void> {
        const choice = choiceOf(name === "other" ? ((await askForSize(this.pixels)) ?? "") : name);
        if (choice) this.size = choice;
        this.fit();
        this.changed();
    }

    private async rename(name: string, position: Position): Promise<void> {
        const text = this.editor.document;
        const wanted = await askForName(name);
        if (wanted && wanted !== name && this.editor.document.eq(text)) await this.session.rename(position, wanted);
        this.editor.focus();
    }

    private async save(): Promise<void> {
        try {
            await this.session.save(false);
        } catch (failure) {
            if (!(failure instanceof Refusal) || failure.code !== Refused.changed) throw failure;
            const isForced = await confirm("The file has changed on the disk", failure.message, "Replace it");
            if (!isForced) return;
            await this.session.save(true);
        }
        this.say("Saved");
    }

    // What is seen.

    override updated(): void {
        if (this.session.camera) this.fit();
        if (this.session.shown) this.inspection.follow(this.session.shown.change, this.pixels);
    }

    private over() {
        const { handles, about } = this.session;
        const hand = this.pictureHand;
        const { seen } = hand;
        const isOneEye = !this.session.camera?.stereo;
        const canDrag = this.session.can("view/drag") && about?.readOnly === false && isOneEye;
        const { lattice, overlays, remarks, chosen } = this.inspection;
        return html`
            <picture-overlays
                .lattice=${lattice}
                .shown=${new Set(overlays)}
                .isAngle=${this.session.isAngle}
                .up=${this.session.up}
                .remarks=${remarks}
                .chosen=${chosen}
                .pixels=${this.pixels}
            ></picture-overlays>
            ${this.session.can("view/at")
                ? html`<picture-touch
                      .pixels=${this.pixels}
                      .hand=${hand}
                      .canDrag=${canDrag}
                      .grips=${[...hand.grips]}
                      .crosses=${hand.isKept && seen ? [[seen.x, seen.y], ...this.found] : this.found}
                  ></picture-touch>`
                : nothing}
            ${this.hasHandles && handles.length > 0 && isOneEye
                ? html`<picture-handles
                      .handles=${handles}
                      .pixels=${this.pixels}
                      .hand=${this.hand}
                  ></picture-handles>`
                : nothing}
        `;
    }

    private async find(point: Triple): Promise<void> {
        const { places } = await this.session.connection.request<{ places: { x: number; y: number }[] }>("view/find", {
            point,
        });
        this.found = places.map(({ x, y }) => [x, y]);
        const words = places.length === 1 ? "one place" : `${places.length} places`;
        this.say(places.length > 0 ? `The point appears in ${words}.` : "The picture does not show this point.");
    }

    private space() {
        const { inspection } = this;
        if (!inspection.hasSpace) return nothing;
        return html`<camera-space
            .lattice=${inspection.lattice}
            .colours=${inspection.lattice ? this.picture.coloursOf(inspection.lattice) : []}
            .seen=${this.pictureHand.seen}
            .up=${this.session.up}
            .onpick=${((point) => this.attempt(this.find(point))) as CameraSpace["onpick"]}
        ></camera-space>`;
    }

    /** What stands under the hand, where the hand is not. */
    private seenLine() {
        const { seen, isKept, pulled } = this.pictureHand;
        if (pulled || !seen) return nothing;
        const words = seenWords(seen, this.session.isAngle);
        return html`<div class="seen-at ${seen.y > 0.7 * this.pixels[1] ? "above" : ""}" aria-live=${isKept ? "polite" : "off"}>
            ${words.map(
                ({ name, value }) =>
                    html`<span>${name ? html`<span class="quiet">${name}</span> ` : nothing}${value}</span>`,
            )}
        </div>`;
    }

    /** Why the picture does not follow the hand. */
    private get dragWords(): string {
        const { pulled } = this.pictureHand;
        if (!pulled) return "";
        const why = this.lastDrag?.diagnostics[0]?.message;
        if (why) return why.split("\n")[0]!;
        return pulled.told?.follows === false ? "The numbers that follow cannot bring it nearer." : "";
    }

    override render() {
        const { session } = this;
        const words = wordsOf(session.doing);
        const { camera, error, shown, latency } = session;
        const follows = latency.typical;
        const go = ({ from, to }: Problem): void => this.editor.goTo(from, to);
        return html`
            ${toolbar(
                { session, size: this.size, pixels: this.pixels, theme: chosenTheme(), hasHandles: this.hasHandles, hasTimeline: this.hasTimeline, inspection: this.inspection },
                this.actions,
            )}
            <main>
                <section class="seen" aria-label="Picture">
                    <div class="views ${this.pixels[0] > 2 * this.pixels[1] ? "wide" : ""}">
                    <live-picture
                        .problem=${error}
                        .waiting=${shown ? "" : [words.text, words.advice ?? ""].join("\n")}
                        .isBusy=${words.kind === "busy"}
                        .ratio=${this.pixels[1] > 0 ? this.pixels[0] / this.pixels[1] : 16 / 9}
                        .label="Picture of the camera ${camera?.name ?? ""}"
                        .over=${this.over()}
                        .words=${this.seenLine()}
                    ></live-picture>
                    ${this.space()}
                    </div>
                    <div class="status ${words.kind}">
                        <span class="dot"></span>
                        <span id="state" role="status">${words.text}</span>
                        ${this.dragWords || words.advice
                            ? html`<span class="quiet" role="status">${this.dragWords || words.advice}</span>`
                            : nothing}
                        <span class="space"></span>
                        <span class="quiet" ?hidden=${follows === null} title="From the hand to the picture, typically">
                            ${Math.round(follows ?? 0)} ms
                        </span>
                        <span class="quiet">${this.pixels[0]} × ${this.pixels[1]}</span>
                    </div>
                    ${this.hasTimeline
                        ? html`<time-line
                              .film=${session.film}
                              .animation=${session.scene.duration ?? 0}
                              .shown=${shown?.change ?? 0}
                              .failed=${(why: unknown) => this.sayFailure(why)}
                              .onfilm=${(frames: number) => this.attempt(startFilm(session, this.pixels, frames).then(() => this.changed()))}
                          ></time-line>`
                        : nothing}
                    ${camera ? remarkList(this.inspection) : nothing}
                    ${this.hasHandles && session.handles.length > 0
                        ? html`<stage-numbers
                              .handles=${session.handles}
                              .sliders=${new Set(session.parameters.map(({ name }) => name))}
                              .pixels=${this.pixels}
                              .hand=${this.hand}
                          ></stage-numbers>`
                        : nothing}
                    <parameter-sliders
                        ?hidden=${!camera}
                        aria-label="Numbers of the camera"
                        .parameters=${session.parameters}
                        .isReadOnly=${session.about?.readOnly ?? true}
                        .canFollow=${session.pulled}
                    ></parameter-sliders>
                </section>
                ${splitter()}
                <section class="written" aria-label="Text">
                    <camera-editor></camera-editor>
                    ${problemList(session.problems, go, (problem, fix) => this.mend(problem, fix))}
                </section>
            </main>
            <camera-wall .server=${this.wallServer}></camera-wall>
            <div class="notice ${this.notice?.isMistake ? "mistake" : ""}" role="alert" ?hidden=${!this.notice}
                >${this.notice?.words ?? ""}</div
            >
        `;
    }
}

showTheme();
customElements.define("balcony-studio", BalconyStudio);
