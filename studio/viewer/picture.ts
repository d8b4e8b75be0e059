// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// The picture: coarse while a hand moves, whole where it rests, then with more and more samples. It is drawn in
// tiles that take a fraction of a frame, so that a weak processor does not hang.

import {
    AddEquation,
    BufferAttribute,
    BufferGeometry,
    Camera,
    CustomBlending,
    DataTexture,
    FloatType,
    GLSL3,
    HalfFloatType,
    type IUniform,
    Mesh,
    NearestFilter,
    NoBlending,
    OneFactor,
    RawShaderMaterial,
    RedFormat,
    RGBAFormat,
    Scene,
    type Texture,
    Vector2,
    Vector4,
    WebGLRenderer,
    WebGLRenderTarget,
} from "three";
import { FloatVertexAttributeTexture, MeshBVH, MeshBVHUniformStruct } from "three-mesh-bvh";
import { type Atlas, materialTable } from "./atlas";
import type { PageData } from "./page_data";
import { sampleOffset } from "./sample_offset";
import { copyShader, displayShader, sampleShader, treeDepth, vertexShader } from "./shader";
import type { Triangles } from "./triangles";

/** What a coarse picture and a tile may take, in milliseconds. */
const coarseTime = 40;
const tileTime = 20;
/** How long the picture is still before it is made whole, in milliseconds. */
const pause = 150;
const smallestTile = 16;

/** A texture of numbers, four a texel, in rows. */
function numberTexture(numbers: Float32Array, size: 1 | 4): DataTexture {
    const texels = Math.max(1, numbers.length / size);
    const width = Math.min(texels, 2048);
    const height = Math.ceil(texels / width);
    const all = new Float32Array(size * width * height);
    all.set(numbers);
    const texture = new DataTexture(all, width, height, size === 1 ? RedFormat : RGBAFormat, FloatType);
    texture.needsUpdate = true;
    return texture;
}

function vertexTexture(numbers: Float32Array | null): Texture {
    const texture = new FloatVertexAttributeTexture();
    texture.updateFrom(new BufferAttribute(numbers ?? new Float32Array(4), 4));
    return texture;
}

const nextFrame = (): Promise<void> => new Promise((done) => requestAnimationFrame(() => done()));
const wait = (time: number): Promise<void> => new Promise((done) => setTimeout(done, time));

export class Picture {
    /** What is shown: 0 samples are a coarse picture, and -1 one that is not yet that of the newest change. */
    onprogress: (samples: number, all: number) => void = () => {};
    /** Whether a hand is down, so that the picture stays coarse. */
    isHeld = false;

    private readonly renderer: WebGLRenderer;
    private readonly camera = new Camera();
    private readonly scene = new Scene();
    private readonly mesh: Mesh;
    private readonly uniforms: Record<string, IUniform>;
    private readonly sampling: RawShaderMaterial;
    private readonly adding: RawShaderMaterial;
    private readonly display: RawShaderMaterial;
    private readonly one: WebGLRenderTarget;
    private readonly sum: WebGLRenderTarget;
    private size = new Vector2(1, 1);
    /** Rises with all that changes the picture. */
    private version = 0;
    private wake: () => void = () => {};
    /** How many pixels of the screen a pixel of a coarse picture has in each direction. */
    private coarseness = 4;
    private tile = 64;

    constructor(
        canvas: HTMLCanvasElement,
        data: PageData,
        triangles: Triangles,
        atlas: Atlas,
        tables: Float32Array,
        /** Of a pixel, when the picture is finished. */
        private readonly allSamples: number,
    ) {
        this.renderer = new WebGLRenderer({ canvas, alpha: true, antialias: false, preserveDrawingBuffer: true });
        this.renderer.autoClear = false;
        const gl = this.renderer.getContext();
        const isFloat = gl.getExtension("EXT_color_buffer_float") !== null && gl.getExtension("EXT_float_blend") !== null;
        const target = () =>
            new WebGLRenderTarget(1, 1, {
                count: 2,
                type: isFloat ? FloatType : HalfFloatType,
                minFilter: NearestFilter,
                magFilter: NearestFilter,
                depthBuffer: false,
            });
        [this.one, this.sum] = [target(), target()];

        const bvh = new MeshBVHUniformStruct();
        bvh.updateFrom(new MeshBVH(triangles.geometry, { targetLeafSize: 4, maxDepth: treeDepth }));
        this.uniforms = {
            triangles: { value: bvh },
            normals: { value: vertexTexture(triangles.normals) },
            coordinates: { value: vertexTexture(triangles.coordinates) },
            colors: { value: vertexTexture(triangles.colors) },
            materials: { value: numberTexture(materialTable(data, atlas), 4) },
            color_images: { value: atlas.colors },
            number_images: { value: atlas.numbers },
            table_numbers: { value: numberTexture(tables, 1) },
            picture_parameters: { value: data.parameters.map(({ value }) => value) },
            picture_size: { value: new Vector2(...data.size) },
            target_size: { value: new Vector2(1, 1) },
            offset: { value: new Vector2(0, 0) },
            time: { value: data.time },
            number: { value: 0 },
        };
        const material = (fragmentShader: string, uniforms: Record<string, IUniform>) =>
            new RawShaderMaterial({
                glslVersion: GLSL3,
                vertexShader,
                fragmentShader,
                uniforms,
                depthTest: false,
                depthWrite: false,
                blending: NoBlending,
            });
        const shown = () => ({ light_of: { value: null }, display_of: { value: null } });
        this.sampling = material(sampleShader(data, triangles), this.uniforms);
        this.adding = material(copyShader, shown());
        Object.assign(this.adding, {
            blending: CustomBlending,
            blendEquation: AddEquation,
            blendSrc: OneFactor,
            blendDst: OneFactor,
        });
        const [r, g, b] = data.background ?? [0, 0, 0];
        this.display = material(displayShader, {
            ...shown(),
            screen_size: { value: this.size },
            used: { value: new Vector2(1, 1) },
            samples: { value: 1 },
            gain: { value: 2 ** data.exposure },
            background: { value: new Vector4(r, g, b, data.background ? 1 : 0) },
        });
        const geometry = new BufferGeometry();
        geometry.setAttribute("position", new BufferAttribute(new Float32Array([-1, -1, 0, 3, -1, 0, -1, 3, 0]), 3));
        this.mesh = new Mesh(geometry, this.sampling);
        this.mesh.frustumCulled = false;
        this.scene.add(this.mesh);
    }

    /** Compiles the shaders, which takes a driver seconds for a long camera, and begins. */
    async start(): Promise<void> {
        const failures: string[] = [];
        this.renderer.debug.onShaderError = (gl, program, vertex, fragment) => {
            failures.push(gl.getProgramInfoLog(program) ?? "", gl.getShaderInfoLog(vertex) ?? "", gl.getShaderInfoLog(fragment) ?? "");
        };
        await this.renderer.compileAsync(this.scene, this.camera);
        await this.drawCoarse();
        const failure = failures.find((text) => text.trim() !== "");
        if (failure) throw new Error(failure.trim().split("\n")[0]);
        void this.work();
    }

    /** The values of the parameters, in radians where they are angles, and the time in seconds. */
    show(values: number[], time: number): void {
        this.uniforms["picture_parameters"]!.value = values;
        this.uniforms["time"]!.value = time;
        this.change();
    }

    /** Width and height in pixels of the screen. */
    resize(width: number, height: number): void {
        if (this.size.x === width && this.size.y === height) return;
        this.size.set(width, height);
        this.renderer.setSize(width, height, false);
        this.one.setSize(width, height);
        this.sum.setSize(width, height);
        this.change();
    }

    private change(): void {
        ++this.version;
        this.onprogress(-1, this.allSamples);
        this.wake();
    }

    /** The hand is up or down. */
    hold(isHeld: boolean): void {
        this.isHeld = isHeld;
        this.wake();
    }

    private async work(): Promise<void> {
        for (;;) {
            const version = this.version;
            const isNew = () => version !== this.version;
            await this.drawCoarse();
            if (!isNew()) this.onprogress(0, this.allSamples);
            const rest = performance.now() + pause;
            while (!isNew() && (this.isHeld || performance.now() < rest)) await this.changed(rest - performance.now());
            for (let pass = 0; pass < this.allSamples && !isNew(); ++pass) await this.drawPass(pass, isNew);
            while (!isNew()) await this.changed();
        }
    }

    /** Waits until something has changed, or for a time. */
    private changed(time?: number): Promise<void> {
        return new Promise((done) => {
            this.wake = done;
            if (time !== undefined && time > 0) setTimeout(done, time);
        });
    }

    private async drawCoarse(): Promise<void> {
        const used = this.size.clone().divideScalar(this.coarseness).ceil();
        const time = await this.timed(() => {
            this.setSample(0, used);
            this.draw(this.sampling, this.one, [0, 0, used.x, used.y]);
            this.present(this.one, used, 1, [0, 0, this.size.x, this.size.y]);
        });
        const wanted = this.coarseness * Math.sqrt(time / coarseTime);
        this.coarseness = Math.min(16, Math.max(1, (this.coarseness + wanted) / 2));
    }

    /** Another sample of all pixels; the tiles of the first one are shown at once. */
    private async drawPass(pass: number, isNew: () => boolean): Promise<void> {
        this.setSample(pass, this.size);
        const { x: width, y: height } = this.size;
        for (let top = 0, rows = 0; top < height; top += rows) {
            rows = Math.min(this.tile, height - top);
            for (let left = 0, columns = 0; left < width; left += columns) {
                columns = Math.min(this.tile, width - left);
                const box: Box = [left, height - top - rows, columns, rows];
                const time = await this.timed(() => {
                    this.draw(this.sampling, this.one, box);
                    if (pass === 0) this.present(this.one, this.size, 1, box);
                });
                if (isNew()) return;
                this.adaptTile(time);
            }
        }
        const all: Box = [0, 0, width, height];
        if (pass === 0) {
            this.renderer.setRenderTarget(this.sum);
            this.renderer.setClearColor(0, 0);
            this.renderer.clear();
        }
        this.copyFrom(this.adding, this.one);
        this.draw(this.adding, this.sum, all);
        this.present(this.sum, this.size, pass + 1, all);
        this.onprogress(pass + 1, this.allSamples);
    }

    private adaptTile(time: number): void {
        const wanted = this.tile * Math.min(2, Math.max(0.5, Math.sqrt(tileTime / Math.max(time, 1))));
        this.tile = Math.max(smallestTile, Math.min(4096, Math.round(wanted)));
    }

    private setSample(number: number, size: Vector2): void {
        this.uniforms["number"]!.value = number;
        this.uniforms["target_size"]!.value = size;
        this.uniforms["offset"]!.value = new Vector2(...sampleOffset(number));
    }

    private copyFrom(material: RawShaderMaterial, from: WebGLRenderTarget): void {
        material.uniforms["light_of"]!.value = from.textures[0];
        material.uniforms["display_of"]!.value = from.textures[1];
    }

    private present(from: WebGLRenderTarget, used: Vector2, samples: number, box: Box): void {
        this.copyFrom(this.display, from);
        this.display.uniforms["used"]!.value = used;
        this.display.uniforms["samples"]!.value = samples;
        this.draw(this.display, null, box);
    }

    private draw(material: RawShaderMaterial, target: WebGLRenderTarget | null, [x, y, width, height]: Box): void {
        this.mesh.material = material;
        this.renderer.setRenderTarget(target);
        if (target) {
            // The picture of a coarse target has its corner at (0, 0).
            const { x: w, y: h } = this.uniforms["target_size"]!.value as Vector2;
            target.viewport.set(0, 0, w, h);
            target.scissor.set(x, y, width, height);
            target.scissorTest = true;
            this.renderer.setRenderTarget(target);
        } else {
            this.renderer.setViewport(0, 0, this.size.x, this.size.y);
            this.renderer.setScissor(x, y, width, height);
            this.renderer.setScissorTest(true);
        }
        this.renderer.render(this.scene, this.camera);
    }

    /** Does something and waits until the graphics processor has done it. Returns how long that took. */
    private async timed(act: () => void): Promise<number> {
        const gl = this.renderer.getContext() as WebGL2RenderingContext;
        const begin = performance.now();
        act();
        const fence = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0)!;
        gl.flush();
        for (;;) {
            await (document.hidden ? wait(50) : nextFrame());
            const state = gl.clientWaitSync(fence, 0, 0);
            if (state === gl.ALREADY_SIGNALED || state === gl.CONDITION_SATISFIED || gl.isContextLost()) break;
        }
        gl.deleteSync(fence);
        return performance.now() - begin;
    }
}

/** Left, bottom, width and height in pixels. */
type Box = [number, number, number, number];
