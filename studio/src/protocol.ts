// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// What the page and the server tell each other: docs/studio.md.

export const protocol = 1;

/** Of a text: lines from 0, and code units of UTF-16 in a line. */
export interface Position {
    line: number;
    character: number;
}

export interface Range {
    start: Position;
    end: Position;
}

export interface TextEdit {
    range: Range;
    newText: string;
}

export interface FileDiagnostic {
    range: Range;
    severity: 1 | 2;
    message: string;
}

export interface CodeAction {
    title: string;
    diagnostics: FileDiagnostic[];
    edit: { changes: Record<string, TextEdit[]> };
}

export interface DocumentSymbol {
    name: string;
    detail?: string;
    kind: number;
    selectionRange: Range;
    children?: DocumentSymbol[];
}

/** What the answer of `initialize` says about the file and its scene. */
export interface About {
    protocol: number;
    version: string;
    session: string;
    uri: string;
    text: string;
    textVersion: number;
    savedVersion: number | null;
    camera: string;
    scene: string;
    readOnly: boolean;
    size: [number, number];
    /** What the server can do beyond text and view. */
    requests?: string[];
    /** That cameras are exported to. */
    languages?: { name: string; meaning: string }[];
    /** In seconds: of the first picture. */
    time?: number;
    /** Frames a second of films. */
    frameRate?: number;
    /** How both eyes' pictures are shown in one. */
    stereoFormats?: { name: string; meaning: string }[];
    /** The extensions of films that are written: ".mp4". */
    films?: string[];
}

/** The keys of a number of the camera, in seconds. */
export interface ParameterKeys {
    parameter: string;
    times: number[];
}

/** A camera in another language. */
export interface Exported {
    text: string;
    file: string;
    diagnostics: FileDiagnostic[];
}

export interface RenderOrder {
    width: number;
    height: number;
    samples: number;
    denoise: boolean;
    /** png, exr, or the extension of a film. */
    output: string;
    /** Of a film. */
    frames?: number;
    /** Goes once round the scene. */
    turntable?: boolean;
}

export interface RenderProgress {
    id: number;
    /** The part, from 0 to 1. */
    done: number;
    seconds: number;
}

export interface RenderDone {
    id: number;
    file: string | null;
    stopped: boolean;
    diagnostics: { message: string }[];
}

/** A number of the camera. Angles are in radians. */
export interface Parameter {
    name: string;
    value: number;
    unit: string;
    min?: number;
    max?: number;
    minExcluded?: boolean;
    meaning?: string;
}

export interface ParameterValue {
    parameter: string;
    value: number;
    /** Decides on the digits that are written; all of them without one. */
    step?: number;
}

export interface CameraState {
    change: number;
    name: string;
    diagnostics: FileDiagnostic[];
    open: Parameter[];
    closed: Parameter[];
    /** They change with time, and have their value at the time that is shown. */
    moving: Parameter[];
    aspect?: number;
    /** In seconds, that is shown. */
    time: number;
    /** A name of the stereo formats; without one, it is the picture of one eye. */
    stereo?: string;
}

export interface ViewChange {
    camera?: string;
    values?: ParameterValue[];
    size?: [number, number];
    /** In seconds. */
    time?: number;
    exposure?: boolean;
    stereo?: string | null;
}

export type Quality = "coarse" | "preview" | "paths" | "denoised";

/** The head of a binary message. */
export interface FrameHead {
    kind: string;
    /** The camera of a thumbnail. */
    name?: string;
    change: number;
    quality: Quality;
    width: number;
    height: number;
    samples: number;
    seconds: number;
    format: "jpeg" | "png" | "rgb";
}

export interface SceneState {
    state: "loading" | "ready" | "failed";
    /** Of the longest animation, in seconds. */
    duration?: number;
    message?: string;
}

export type HandleKind =
    | "number"
    | "size"
    | "count"
    | "angle"
    | "interval"
    | "parameter_point"
    | "picture_point"
    | "picture_region"
    | "space_point"
    | "direction";

export interface HandleNumber {
    value: number;
    angle: boolean;
    moves: boolean;
    min?: number;
    max?: number;
    /** The parameter of the camera that it is made of. */
    parameter?: string;
    range: Range | null;
}

/** What a hand can move of the text. */
export interface Handle {
    kind: HandleKind;
    statement: string;
    stage: string;
    parameter: string;
    index: number;
    meaning: string;
    range: Range | null;
    numbers: HandleNumber[];
}

/** Another value for a number of a handle; `step` is what a pixel of the hand is. */
export interface HandleMove {
    number: number;
    value: number;
    step: number;
}

/** Edits of a version of the text. */
export interface EditsOfText {
    edits: TextEdit[];
    version: number;
}

export type Triple = [number, number, number];

/** The ray of a pixel of the full size, and what it meets. */
export interface Seen {
    ray: { layer: string; origin: Triple; direction: Triple; u: number; v: number } | null;
    hit: { object: string; material: string; distance: number; point: Triple; magnification: number; metric?: Triple } | null;
}

/** What check finds about a camera of the picture. */
export interface Remark {
    camera: string;
    name: string;
    defect: boolean;
    message: string;
    remedy: string;
    /** Left, top, right and bottom, in pixels of the full size. */
    boxes: [number, number, number, number][];
    at: [number, number] | null;
}

export interface PicturePlace extends Seen {
    x: number;
    y: number;
}

/** A point of the scene, or the direction to one, that is pulled from one pixel to another. */
export interface Pull {
    point: Triple;
    infinite?: boolean;
    from: [number, number];
    to: [number, number];
}

export interface DragPoint {
    at: [number, number] | null;
    miss: number;
    follows: boolean;
}

export interface Dragged {
    change: number;
    values: ParameterValue[];
    points: DragPoint[];
    diagnostics: FileDiagnostic[];
    seconds: number;
}

export interface BuiltInCamera {
    name: string;
    family: string;
    about: string;
    keywords: string | string[];
}

export interface NewText {
    version: number;
    text: string;
}

/** The error codes that the page acts on. */
export enum Refused {
    methodNotFound = -32601,
    changed = -32001,
}
