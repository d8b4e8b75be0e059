// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// The camera in space, drawn by three.js: what the picture sees as points, the surface on which rays begin,
// some rays, and that of the pixel under the hand. This module is loaded when it is first wanted.

import * as three from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";
import type { Lattice } from "./lattice";
import type { PicturePlace, Triple } from "./protocol";

export type Colour = [number, number, number];

/** Rays are drawn for every so many points of the lattice, each way. */
const every = 6;

export class SpaceScene {
    private readonly renderer: three.WebGLRenderer;
    private readonly scene = new three.Scene();
    private readonly camera = new three.PerspectiveCamera(50, 1, 0.01, 1e5);
    private readonly controls: OrbitControls;
    private readonly parts = new three.Group();
    private readonly hovered = new three.Group();
    private points: three.Points | null = null;
    private hasView = false;
    private size = 1;

    /** Throws an error if the browser has no WebGL. */
    constructor(canvas: HTMLCanvasElement, up: Triple) {
        this.renderer = new three.WebGLRenderer({ canvas, antialias: true, alpha: true });
        this.camera.up.set(...up);
        this.controls = new OrbitControls(this.camera, canvas);
        this.controls.listenToKeyEvents(canvas);
        this.controls.addEventListener("change", () => this.draw());
        this.scene.add(this.parts, this.hovered);
    }

    resize(width: number, height: number): void {
        if (width === 0 || height === 0) return;
        this.renderer.setPixelRatio(devicePixelRatio);
        this.renderer.setSize(width, height, false);
        this.camera.aspect = width / height;
        this.camera.updateProjectionMatrix();
        this.draw();
    }

    /** `colours` are those of the points of the lattice in the picture. */
    show(lattice: Lattice, colours: Colour[]): void {
        this.clear(this.parts);
        this.addPoints(lattice, colours);
        this.addEye(lattice);
        this.addRays(lattice);
        if (!this.hasView) this.look();
        this.draw();
    }

    hover(place: PicturePlace | null): void {
        this.clear(this.hovered);
        if (place?.ray) {
            const from = new three.Vector3(...place.ray.origin);
            const to = place.hit
                ? new three.Vector3(...place.hit.point)
                : from.clone().addScaledVector(new three.Vector3(...place.ray.direction), this.size);
            this.hovered.add(this.line([from, to], 0xe0a458, 1), this.dot(from, 0.006), this.dot(to, 0.009));
        }
        this.draw();
    }

    /** The point of the scene that is drawn nearest to a place of the canvas, from -1 to 1 each way. */
    pick(x: number, y: number): Triple | null {
        if (!this.points) return null;
        const ray = new three.Raycaster();
        ray.params.Points.threshold = this.size * 0.012;
        ray.setFromCamera(new three.Vector2(x, y), this.camera);
        const [found] = ray.intersectObject(this.points);
        if (found?.index === undefined) return null;
        const at = this.points.geometry.getAttribute("position");
        return [at.getX(found.index), at.getY(found.index), at.getZ(found.index)];
    }

    look(): void {
        const box = new three.Box3().setFromObject(this.parts);
        if (box.isEmpty()) return;
        const centre = box.getCenter(new three.Vector3());
        this.size = box.getSize(new three.Vector3()).length();
        const up = this.camera.up;
        const side = new three.Vector3(up.z, up.x, up.y);
        const back = side.clone().cross(up);
        const away = side.multiplyScalar(0.5).addScaledVector(back, 0.6).addScaledVector(up, 0.62).normalize();
        // All of a sphere around the box is in view, also in a narrow window.
        const angle = (this.camera.fov * Math.PI) / 360;
        const distance = (0.5 * this.size) / Math.sin(Math.atan(Math.tan(angle) * Math.min(1, this.camera.aspect)));
        this.camera.position.copy(centre).addScaledVector(away, distance);
        this.camera.near = this.size / 1000;
        this.camera.far = this.size * 20;
        this.camera.updateProjectionMatrix();
        this.controls.target.copy(centre);
        this.controls.update();
        this.hasView = true;
    }

    dispose(): void {
        this.controls.dispose();
        this.renderer.dispose();
    }

    private draw(): void {
        this.renderer.render(this.scene, this.camera);
    }

    private clear(group: three.Group): void {
        for (const child of [...group.children]) {
            const drawn = child as three.Mesh;
            drawn.geometry.dispose();
            (drawn.material as three.Material).dispose();
            group.remove(child);
        }
    }

    private addPoints({ places }: Lattice, colours: Colour[]): void {
        const at: number[] = [];
        const shown: number[] = [];
        for (const [index, place] of places.entries()) {
            if (!place?.hit) continue;
            at.push(...place.hit.point);
            const colour = new three.Color().setRGB(...(colours[index]!.map((one) => one / 255) as Colour), three.SRGBColorSpace);
            shown.push(colour.r, colour.g, colour.b);
        }
        const geometry = new three.BufferGeometry();
        geometry.setAttribute("position", new three.Float32BufferAttribute(at, 3));
        geometry.setAttribute("color", new three.Float32BufferAttribute(shown, 3));
        const material = new three.PointsMaterial({ size: 4, sizeAttenuation: false, vertexColors: true });
        this.points = new three.Points(geometry, material);
        this.parts.add(this.points);
    }

    /** The surface on which rays begin, which is one point for many cameras. */
    private addEye({ columns, rows, places }: Lattice): void {
        const at: number[] = [];
        const number = new Map<number, number>();
        const box = new three.Box3();
        for (const [index, place] of places.entries()) {
            if (!place?.ray) continue;
            number.set(index, at.length / 3);
            at.push(...place.ray.origin);
            box.expandByPoint(new three.Vector3(...place.ray.origin));
        }
        if (box.isEmpty()) return;
        const extent = box.getSize(new three.Vector3()).length();
        const scale = new three.Box3().setFromObject(this.points!).union(box).getSize(new three.Vector3()).length() || 1;
        if (extent < 1e-6 * scale) {
            this.size = scale;
            this.parts.add(this.dot(box.min, 0.012));
            return;
        }
        const corners: number[] = [];
        for (let row = 0; row + 1 < rows; ++row) {
            for (let column = 0; column + 1 < columns; ++column) {
                const first = row * columns + column;
                const cell = [first, first + 1, first + columns, first + columns + 1].map((one) => number.get(one));
                if (cell.some((one) => one === undefined)) continue;
                const [a, b, c, d] = cell as [number, number, number, number];
                corners.push(a, c, b, b, c, d);
            }
        }
        const geometry = new three.BufferGeometry();
        geometry.setAttribute("position", new three.Float32BufferAttribute(at, 3));
        geometry.setIndex(corners);
        const look = { color: 0x6aa7d6, transparent: true, opacity: 0.4, side: three.DoubleSide, depthWrite: false };
        this.parts.add(new three.Mesh(geometry, new three.MeshBasicMaterial(look)));
    }

    private addRays({ columns, places }: Lattice): void {
        const ends: three.Vector3[] = [];
        for (const [index, place] of places.entries()) {
            const [column, row] = [index % columns, Math.floor(index / columns)];
            if (!place?.ray || !place.hit || column % every !== 0 || row % every !== 0) continue;
            ends.push(new three.Vector3(...place.ray.origin), new three.Vector3(...place.hit.point));
        }
        this.parts.add(this.line(ends, 0x9a9a96, 0.3));
    }

    private line(ends: three.Vector3[], color: number, opacity: number): three.LineSegments {
        const geometry = new three.BufferGeometry().setFromPoints(ends);
        return new three.LineSegments(geometry, new three.LineBasicMaterial({ color, opacity, transparent: opacity < 1 }));
    }

    private dot(at: three.Vector3, part: number): three.Mesh {
        const geometry = new three.SphereGeometry(part * this.size, 16, 12);
        const mesh = new three.Mesh(geometry, new three.MeshBasicMaterial({ color: 0xe0a458 }));
        mesh.position.copy(at);
        return mesh;
    }
}
