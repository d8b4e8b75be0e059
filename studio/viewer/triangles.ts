// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// All instances of a scene as one set of triangles in the world.

import { BufferAttribute, BufferGeometry } from "three";
import type { Instance, Mesh, PageData } from "./page_data";

export interface Triangles {
    /** Positions and corners. */
    geometry: BufferGeometry;
    /** By vertex: the normal, which is 0 where a mesh has none, and the number of the material. */
    normals: Float32Array;
    /** By vertex: both sets of texture coordinates; null if no mesh has any. */
    coordinates: Float32Array | null;
    /** By vertex; null if no mesh has any. */
    colors: Float32Array | null;
}

type Vector = [number, number, number];

const cross = (a: Vector, b: Vector): Vector => [
    a[1] * b[2] - a[2] * b[1],
    a[2] * b[0] - a[0] * b[2],
    a[0] * b[1] - a[1] * b[0],
];

const row = (place: number[], i: number): Vector => place.slice(3 * i, 3 * i + 3) as Vector;

class Gatherer {
    private readonly positions: Float32Array;
    private readonly corners: Uint32Array;
    private readonly made: Triangles;
    private vertex = 0;
    private corner = 0;

    constructor(
        private readonly data: PageData,
        private readonly bytes: ArrayBuffer,
    ) {
        const meshes = data.instances.map(({ mesh }) => data.meshes[mesh]!);
        const vertices = meshes.reduce((sum, mesh) => sum + mesh.vertices, 0);
        const triangles = meshes.reduce((sum, mesh) => sum + mesh.triangles, 0);
        this.positions = new Float32Array(3 * vertices);
        this.corners = new Uint32Array(3 * triangles);
        const hasCoordinates = meshes.some((mesh) => mesh.coordinates.some((set) => set !== null));
        const hasColors = meshes.some((mesh) => mesh.colors !== undefined);
        this.made = {
            geometry: new BufferGeometry(),
            normals: new Float32Array(4 * vertices),
            coordinates: hasCoordinates ? new Float32Array(4 * vertices) : null,
            colors: hasColors ? new Float32Array(4 * vertices).fill(1) : null,
        };
    }

    run(): Triangles {
        for (const instance of this.data.instances) this.add(instance, this.data.meshes[instance.mesh]!);
        this.made.geometry.setAttribute("position", new BufferAttribute(this.positions, 3));
        this.made.geometry.setIndex(new BufferAttribute(this.corners, 1));
        return this.made;
    }

    private add({ place }: Instance, mesh: Mesh): void {
        this.addPositions(place, mesh);
        this.addNormals(place, mesh);
        this.addCoordinates(mesh);
        if (mesh.colors !== undefined) {
            const from = new Uint8Array(this.bytes, mesh.colors, 4 * mesh.vertices);
            const to = this.made.colors!.subarray(4 * this.vertex);
            for (let i = 0; i < from.length; ++i) to[i] = from[i]! / 255;
        }
        const isShort = mesh.vertices <= 0xffff;
        const from = new (isShort ? Uint16Array : Uint32Array)(this.bytes, mesh.corners, 3 * mesh.triangles);
        for (let i = 0; i < from.length; ++i) this.corners[this.corner + i] = this.vertex + from[i]!;
        this.vertex += mesh.vertices;
        this.corner += from.length;
    }

    private addPositions(place: number[], mesh: Mesh): void {
        const from = new Float32Array(this.bytes, mesh.positions, 3 * mesh.vertices);
        const to = this.positions.subarray(3 * this.vertex);
        for (let i = 0; i < from.length; i += 3) {
            for (let axis = 0; axis < 3; ++axis) {
                to[i + axis] =
                    from[i]! * place[axis]! +
                    from[i + 1]! * place[3 + axis]! +
                    from[i + 2]! * place[6 + axis]! +
                    place[9 + axis]!;
            }
        }
    }

    // By the inverse transpose of the placement, but for a factor that is positive.
    private addNormals(place: number[], mesh: Mesh): void {
        const to = this.made.normals.subarray(4 * this.vertex);
        for (let i = 0; i < mesh.vertices; ++i) to[4 * i + 3] = mesh.material;
        if (mesh.normals === undefined) return;
        const [x, y, z] = [row(place, 0), row(place, 1), row(place, 2)];
        const columns = [cross(y, z), cross(z, x), cross(x, y)] as const;
        const determinant = x[0] * columns[0][0] + x[1] * columns[0][1] + x[2] * columns[0][2];
        const side = determinant < 0 ? -1 : 1;
        const from = new Int16Array(this.bytes, mesh.normals, 3 * mesh.vertices);
        for (let i = 0; i < mesh.vertices; ++i) {
            const [a, b, c] = [from[3 * i]!, from[3 * i + 1]!, from[3 * i + 2]!];
            const sum = [0, 1, 2].map((axis) => a * columns[0][axis]! + b * columns[1][axis]! + c * columns[2][axis]!);
            const length = side * Math.hypot(...sum) || 1;
            for (let axis = 0; axis < 3; ++axis) to[4 * i + axis] = sum[axis]! / length;
        }
    }

    private addCoordinates(mesh: Mesh): void {
        mesh.coordinates.forEach((begin, set) => {
            if (begin === null) return;
            const from = new Float32Array(this.bytes, begin, 2 * mesh.vertices);
            const to = this.made.coordinates!.subarray(4 * this.vertex);
            for (let i = 0; i < mesh.vertices; ++i) {
                to[4 * i + 2 * set] = from[2 * i]!;
                to[4 * i + 2 * set + 1] = from[2 * i + 1]!;
            }
        });
    }
}

export const gather = (data: PageData, bytes: ArrayBuffer): Triangles => new Gatherer(data, bytes).run();
