// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// What the page knows of its server, and how both keep one text and one picture. It has no elements.

import type { ChangeSet, Text } from "@codemirror/state";
import { Connection, type Listener, Lost } from "./connection";
import { FilmTime } from "./film_time";
import { isSame } from "./handle_marks";
import type { KnownValue } from "./known_values";
import { namesIn, positionOf, type Problem, problemsOf, SymbolKind } from "./language_server";
import { Latency } from "./latency";
import {
    type About,
    type CameraState,
    type CodeAction,
    type DocumentSymbol,
    type Dragged,
    type EditsOfText,
    type FileDiagnostic,
    type FrameHead,
    type Handle,
    type HandleMove,
    type NewText,
    type Parameter,
    type ParameterValue,
    type PicturePlace,
    type Position,
    protocol,
    type Pull,
    type Remark,
    type RenderDone,
    type RenderProgress,
    type SceneState,
    type Seen,
    type TextEdit,
    type Triple,
    type ViewChange,
} from "./protocol";
import { SharedText } from "./shared_text";
import type { Doing, Link } from "./state_words";

/** The elements of the page, as far as the session changes them. */
export interface Page {
    text(): Text;
    begin(about: About): void;
    take(changes: ChangeSet): void;
    edit(edits: TextEdit[]): void;
    showProblems(problems: Problem[]): void;
    showValues(values: KnownValue[]): void;
    /** Whether it is shown, and no newer one. */
    show(head: FrameHead, bytes: Uint8Array): Promise<boolean>;
    /** Something to read once. */
    say(words: string, isMistake?: boolean): void;
    thumbnail(head: FrameHead, bytes: Uint8Array): void;
    noThumbnail(camera: string, message: string): void;
    /** What became of what a hand pulls. */
    dragged(told: Dragged): void;
    /** The picture will not change by itself. */
    rested(): void;
    /** Something else has changed. */
    changed(): void;
}

/** How long the text rests before its values are asked for. */
const pause = 200;

export class Session implements Listener {
    about: About | null = null;
    link: Link = "connecting";
    scene: SceneState = { state: "loading" };
    /** The last one without errors, whose picture is shown. */
    camera: CameraState | null = null;
    private symbols: DocumentSymbol[] = [];
    /** Of the camera that is chosen, in the text that the server has. */
    handles: Handle[] = [];
    /** By its name in the file; the last one if empty. */
    chosen = "";
    shown: FrameHead | null = null;
    isAtRest = false;
    /** Of a picture in full quality. */
    render: RenderProgress | null = null;
    readonly latency = new Latency();
    readonly film: FilmTime;
    readonly connection: Connection;
    private readonly text = new SharedText((version, text) => this.send(version, text));
    private savedText: string | null = null;
    private textProblems: Problem[] = [];
    private pictureProblems: FileDiagnostic[] = [];
    private size: [number, number] | null = null;
    private timer = 0;

    constructor(
        address: string,
        private readonly page: Page,
    ) {
        this.connection = new Connection(address, this);
        this.film = new FilmTime(this, page);
    }

    get doing(): Doing {
        const { link, scene, isAtRest } = this;
        return { link, scene, isAtRest, frame: this.shown, hasError: this.error !== null };
    }

    /** Of the text, and of the picture what is not said by those. */
    get problems(): Problem[] {
        const text = this.page.text();
        const ofPicture = this.about ? problemsOf(text, this.pictureProblems, [], this.about.uri) : [];
        const said = new Set(this.textProblems.map(({ message }) => message));
        return [...this.textProblems, ...ofPicture.filter(({ message }) => !said.has(message))];
    }

    /** What keeps the picture from following, or null. */
    get error(): Problem | null {
        return this.problems.find(({ severity }) => severity === "error") ?? null;
    }

    /** Whether the server has a request. */
    can(request: string): boolean {
        return this.about?.requests?.includes(request) ?? false;
    }

    /** Whether the server has the text of the editor. */
    get isSettled(): boolean {
        return this.link === "open" && this.text.isSettled;
    }

    /** The names of the cameras and pictures of the file. */
    get cameras(): string[] {
        return namesIn(this.symbols, SymbolKind.camera);
    }

    /** Those of the camera that is shown, as its text has them. */
    get parameters(): Parameter[] {
        if (!this.camera) return [];
        const { name, open, closed, moving } = this.camera;
        const declared = this.symbols.find((one) => one.name === name)?.children ?? [];
        const order = namesIn(declared, SymbolKind.parameter);
        return [...open, ...closed, ...moving].sort((a, b) => order.indexOf(a.name) - order.indexOf(b.name));
    }

    /** The names of those that can follow a hand on the picture. */
    get pulled(): string[] {
        const { open, moving } = this.camera ?? { open: [], moving: [] };
        return this.can("view/drag") ? [...open, ...moving].map(({ name }) => name) : [];
    }

    /** Whether u and v are angles. */
    get isAngle(): [boolean, boolean] {
        const isAngle = (name: string): boolean =>
            this.handles.some((one) => one.parameter === name && one.numbers[0]!.angle);
        return [isAngle("u"), isAngle("v")];
    }

    /** The vertical axis of the scene, where its format says which it is. */
    get up(): Triple | null {
        return /\.(glb|gltf)$/i.test(this.about?.scene ?? "") ? [0, 1, 0] : null;
    }

    get isSaved(): boolean {
        return this.savedText === this.page.text().toString();
    }

    /** Asks about the text as it is in the editor. */
    ask = async <Result>(method: string, params: object): Promise<Result> => {
        await this.text.whenSent();
        return this.connection.request<Result>(method, { textDocument: { uri: this.about!.uri }, ...params });
    };

    // The connection.

    async opened(): Promise<void> {
        const { studio } = await this.connection.request<{ studio: About }>("initialize", {
            processId: null,
            rootUri: null,
            capabilities: { textDocument: { completion: { completionItem: { snippetSupport: true } } } },
        });
        if (studio.protocol !== protocol) {
            this.link = "foreign";
            this.page.changed();
            return;
        }
        this.connection.notify("initialized", {});
        this.connection.notify("textDocument/didOpen", {
            textDocument: { uri: studio.uri, languageId: "balcony", version: studio.textVersion, text: studio.text },
        });
        const before = this.about;
        this.about = studio;
        this.link = "open";
        this.isAtRest = false;
        if (before) this.goOn(before, studio);
        else this.begin(studio);
        // The picture may have had its room before there was a connection.
        if (this.size) this.changeView({ size: this.size, camera: this.chosen });
        if (this.film.chosen !== null) void this.film.show(this.film.chosen);
        this.page.changed();
        await this.learn();
        this.findValuesSoon();
    }

    private begin(about: About): void {
        this.text.begin(about.textVersion, about.text);
        this.chosen = about.camera;
        this.savedText = about.savedVersion === about.textVersion ? about.text : null;
        this.page.begin(about);
    }

    /** After a lost connection: nothing that was typed here is lost. */
    private goOn(before: About, about: About): void {
        if (before.session === about.session) {
            const changes = this.text.reconnected(about.textVersion, about.text);
            if (changes) this.page.take(changes);
        } else {
            const mine = this.page.text().toString();
            if (this.savedText !== null && about.text !== this.savedText && about.text !== mine) {
                this.page.say("The file has changed on the disk. This is your text; saving it replaces the file.", true);
            }
            this.savedText = about.savedVersion === about.textVersion ? about.text : null;
            this.text.restarted(about.textVersion, about.text, mine);
        }
    }

    lost(isRefused: boolean): void {
        this.link = isRefused ? "refused" : this.about ? "lost" : "connecting";
        this.text.disconnected();
        this.render = null;
        this.page.changed();
    }

    told(method: string, params: unknown): void {
        this.notices[method]?.(params as never);
        this.page.changed();
    }

    private readonly notices: Record<string, (params: never) => void> = {
        "textDocument/publishDiagnostics": (told: { version?: number; diagnostics: FileDiagnostic[] }) =>
            void this.findFixes(told),
        "studio/text": ({ version, text }: NewText) => {
            const changes = this.text.told(version, text);
            if (changes) this.page.take(changes);
            this.learn().catch(() => {}); // Of a lost connection: it is asked for again.
            this.findValuesSoon();
        },
        "studio/saved": ({ version }: { version: number }) => void this.wasSaved(version),
        "studio/scene": (state: SceneState) => {
            this.scene = state;
            if (state.state === "ready" && state.message) this.page.say(state.message);
        },
        "view/camera": (state: CameraState) => {
            this.pictureProblems = state.diagnostics;
            if (!state.diagnostics.some(({ severity }) => severity === 1)) this.camera = state;
            this.isAtRest = false;
            this.showProblems();
        },
        "render/progress": (progress: RenderProgress) => (this.render = progress),
        "render/done": ({ file, stopped, diagnostics }: RenderDone) => {
            this.render = null;
            const words = file ? `${stopped ? "Stopped: wrote" : "Wrote"} ${file}` : "Nothing was written";
            this.page.say([words, ...diagnostics.map(({ message }) => message)].join("\n"), file === null && !stopped);
        },
        "cameras/failed": ({ name, message }: { name: string; message: string }) =>
            this.page.noThumbnail(name, message),
        "view/dragged": (told: Dragged) => this.page.dragged(told),
        "view/rest": () => {
            this.isAtRest = true;
            this.page.rested();
        },
    };

    async frame(head: FrameHead, bytes: Uint8Array): Promise<void> {
        if (head.kind === "thumbnail") this.page.thumbnail(head, bytes);
        if (head.kind !== "frame") return;
        const isShown = await this.page.show(head, bytes);
        this.connection.notify("view/seen", { change: head.change });
        if (!isShown) return;
        this.latency.drawn(head.change);
        this.shown = head;
        this.page.changed();
    }

    // The text.

    /** The editor has changed its text. */
    typed(changes: ChangeSet): void {
        this.text.made(changes);
        this.findValuesSoon();
        this.page.changed();
    }

    /** The answer of the question behind an edit tells that the edit was handled. */
    private async send(version: number, text: string): Promise<void> {
        this.connection.notify("textDocument/didChange", {
            textDocument: { uri: this.about!.uri, version },
            contentChanges: [{ text }],
        });
        await this.learn();
    }

    /** What stands in the text that the server has. */
    private async learn(): Promise<void> {
        await this.findNames();
        await this.learnHands();
    }

    /** What a hand can move of the camera that is chosen. */
    private async learnHands(): Promise<void> {
        await this.findHandles();
        await this.film.learn();
    }

    private async findNames(): Promise<void> {
        const symbols = await this.connection.request<DocumentSymbol[]>("textDocument/documentSymbol", {
            textDocument: { uri: this.about!.uri },
        });
        const before = this.cameras;
        this.symbols = symbols;
        this.chooseAgain(before);
        this.page.changed();
    }

    /** The camera that is shown may have another name now, or be gone: then the last one is shown. */
    private chooseAgain(before: string[]): void {
        const now = this.cameras;
        if (!before.includes(this.chosen) || now.includes(this.chosen) || now.length === 0) return;
        const renamed = now.length === before.length ? now[before.indexOf(this.chosen)]! : "";
        this.changeView({ camera: renamed, values: [] });
    }

    async findHandles(): Promise<void> {
        if (!this.can("handles") || this.about!.readOnly) return;
        try {
            const asked = { camera: this.chosen };
            this.handles = (await this.connection.request<{ handles: Handle[] }>("handles", asked)).handles;
        } catch (failure) {
            if (failure instanceof Lost) throw failure;
            this.handles = []; // The text has no such camera, which is said by its mistakes.
        }
        this.page.changed();
    }

    private findValuesSoon(): void {
        clearTimeout(this.timer);
        this.timer = window.setTimeout(() => {
            this.findValues().catch(() => {}); // Of a lost connection: they are asked for again.
        }, pause);
    }

    private async findValues(): Promise<void> {
        const text = this.page.text();
        const range = { start: { line: 0, character: 0 }, end: positionOf(text, text.length) };
        const values = await this.ask<KnownValue[]>("textDocument/inlayHint", { range });
        if (this.page.text() === text) this.page.showValues(values);
    }

    private async findFixes(told: { version?: number; diagnostics: FileDiagnostic[] }): Promise<void> {
        // Of an older text: those of the newest one come soon.
        const isCurrent = (): boolean =>
            this.text.isSettled && (told.version === undefined || told.version === this.text.version);
        await this.text.whenSettled();
        if (!isCurrent()) return;
        const text = this.page.text();
        const range = { start: { line: 0, character: 0 }, end: positionOf(text, text.length) };
        const actions =
            told.diagnostics.length === 0
                ? []
                : await this.ask<CodeAction[]>("textDocument/codeAction", { range, context: { diagnostics: [] } });
        if (!isCurrent()) return;
        this.textProblems = problemsOf(this.page.text(), told.diagnostics, actions, this.about!.uri);
        this.showProblems();
        this.page.changed();
    }

    private showProblems(): void {
        this.page.showProblems(this.problems);
    }

    async format(): Promise<void> {
        const edits = await this.ask<TextEdit[] | null>("textDocument/formatting", { options: {} });
        if (edits) this.page.edit(edits);
        else this.page.say("A text with errors is not formatted.", true);
    }

    async rename(position: Position, newName: string): Promise<void> {
        const made = await this.ask<{ changes: Record<string, TextEdit[]> } | null>("textDocument/rename", {
            position,
            newName,
        });
        if (made) this.page.edit(made.changes[this.about!.uri] ?? []);
        else this.page.say("Nothing here has a name that can be another one.", true);
    }

    // The picture.

    changeView(change: ViewChange): void {
        if (change.size) this.size = change.size;
        if (change.camera !== undefined) this.chosen = change.camera;
        if (this.link !== "open") return;
        if (change.camera !== undefined) this.learnHands().catch(() => {}); // Of a lost connection.
        this.isAtRest = false;
        const number = this.connection.request<{ change: number }>("view/change", change);
        // A new size or camera is not what a hand waits for.
        if (change.values) this.latency.begin(number.then(({ change }) => change));
        else number.catch(() => {}); // Of a lost connection.
    }

    /** What stands at a pixel of the full size; null if nobody knows. */
    async at([x, y]: [number, number]): Promise<PicturePlace | null> {
        try {
            return { x, y, ...(await this.connection.request<Seen>("view/at", { x, y })) };
        } catch {
            return null; // Of a lost connection, or there is no picture.
        }
    }

    /** What stands in the middles of equal cells, row by row from the top; null if nobody knows. */
    async grid(columns: number, rows: number): Promise<Seen[] | null> {
        try {
            return (await this.connection.request<{ places: Seen[] }>("view/grid", { columns, rows })).places;
        } catch {
            return null; // Of a lost connection, or there is no picture.
        }
    }

    /** What is wrong with the cameras of the picture, or worth knowing. */
    async check(): Promise<Remark[]> {
        return (await this.connection.request<{ remarks: Remark[] }>("view/check", {})).remarks;
    }

    /** A hand pulls at the picture, and these parameters follow. The number of the change; null without a connection. */
    drag(pulls: Pull[], parameters: string[]): Promise<number | null> {
        if (this.link !== "open") return Promise.resolve(null);
        this.isAtRest = false;
        const number = this.connection
            .request<{ change: number }>("view/drag", { pulls, parameters })
            .then(({ change }) => change);
        if (pulls.length > 0) this.latency.begin(number);
        return number.catch(() => null);
    }

    /** Edits of the text as it is when they are made. */
    async editsOf(method: string, asked: () => object): Promise<TextEdit[]> {
        for (;;) {
            await this.text.whenSettled();
            const made = await this.connection.request<EditsOfText>(method, asked());
            // Otherwise something was typed meanwhile, and the edits are not of this text.
            if (this.text.isSettled && made.version === this.text.version) return made.edits;
        }
    }

    /** Writes values into the text, as one step of undo. */
    async write(values: ParameterValue[]): Promise<void> {
        this.page.edit(await this.editsOf("text/set", () => ({ values, ...this.film.asked })));
        await this.text.whenSettled();
    }

    /** The edits that move a handle, which had an index in a text before. */
    moved(index: number, before: Handle, moves: HandleMove[]): Promise<TextEdit[]> {
        return this.editsOf("handles/move", () => {
            const handle = this.handles[index];
            if (!handle || !isSame(handle, before)) throw new Error("The text has changed under the hand.");
            return { camera: this.chosen, handle, moves };
        });
    }

    /** Shows a camera that has just been typed. */
    async showNew(camera: string): Promise<void> {
        await this.text.whenSettled();
        this.changeView({ camera, values: [] });
    }

    // The file.

    /** Throws a Refusal. */
    async save(force: boolean): Promise<void> {
        await this.text.whenSettled();
        await this.connection.request("file/save", force ? { force } : {});
    }

    private async wasSaved(version: number): Promise<void> {
        await this.text.whenSettled();
        if (version === this.text.version) this.savedText = this.page.text().toString();
        this.page.changed();
    }
}

/** What to say about a failure; null if the state says it already. */
export const failureOf = (failure: unknown): string | null =>
    failure instanceof Lost ? null : failure instanceof Error ? failure.message : String(failure);
