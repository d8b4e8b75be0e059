// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// JSON-RPC over a WebSocket that is opened again when it is lost.

import type { FrameHead } from "./protocol";

export class Refusal extends Error {
    constructor(
        message: string,
        readonly code: number,
    ) {
        super(message);
    }
}

/** Where an answer did not come, because the connection was lost. */
export class Lost extends Error {}

export interface Listener {
    opened(): void;
    /** `isRefused` if the server is there and does not accept the page. */
    lost(isRefused: boolean): void;
    told(method: string, params: unknown): void;
    frame(head: FrameHead, bytes: Uint8Array): void;
}

interface Waiting {
    resolve(result: unknown): void;
    reject(why: Error): void;
}

interface Message {
    id?: number;
    method?: string;
    params?: unknown;
    result?: unknown;
    error?: { code: number; message: string };
}

const firstDelay = 200;
const longestDelay = 2000;

export class Connection {
    private socket: WebSocket | null = null;
    private readonly waiting = new Map<number, Waiting>();
    private nextId = 1;
    private delay = firstDelay;
    private timer = 0;

    constructor(
        private readonly address: string,
        private readonly listener: Listener,
    ) {
        // A machine that wakes up does not wait for the next attempt.
        addEventListener("online", () => this.retry());
        document.addEventListener("visibilitychange", () => {
            if (!document.hidden) this.retry();
        });
    }

    open(): void {
        const socket = new WebSocket(this.address);
        socket.binaryType = "arraybuffer";
        socket.onopen = () => {
            this.delay = firstDelay;
            this.listener.opened();
        };
        socket.onmessage = (event: MessageEvent<string | ArrayBuffer>) => {
            if (typeof event.data === "string") this.receive(JSON.parse(event.data) as Message);
            else this.receiveBytes(event.data);
        };
        socket.onclose = () => void this.closed();
        this.socket = socket;
    }

    get isOpen(): boolean {
        return this.socket?.readyState === WebSocket.OPEN;
    }

    notify(method: string, params: unknown): void {
        if (this.isOpen) this.socket!.send(JSON.stringify({ jsonrpc: "2.0", method, params }));
    }

    request<Result>(method: string, params: unknown): Promise<Result> {
        if (!this.isOpen) return Promise.reject(new Lost("there is no connection"));
        const id = this.nextId++;
        const answer = new Promise<unknown>((resolve, reject) => this.waiting.set(id, { resolve, reject }));
        this.socket!.send(JSON.stringify({ jsonrpc: "2.0", id, method, params }));
        return answer as Promise<Result>;
    }

    private receive(message: Message): void {
        if (message.method !== undefined) {
            this.listener.told(message.method, message.params);
            return;
        }
        const waiting = this.waiting.get(message.id ?? -1);
        if (!waiting) return;
        this.waiting.delete(message.id!);
        if (message.error) waiting.reject(new Refusal(message.error.message, message.error.code));
        else waiting.resolve(message.result);
    }

    private receiveBytes(data: ArrayBuffer): void {
        const length = new DataView(data).getUint32(0, true);
        const head = new TextDecoder().decode(new Uint8Array(data, 4, length));
        this.listener.frame(JSON.parse(head) as FrameHead, new Uint8Array(data, 4 + length));
    }

    private async closed(): Promise<void> {
        for (const waiting of this.waiting.values()) waiting.reject(new Lost("the connection is lost"));
        this.waiting.clear();
        this.socket = null;
        this.timer = window.setTimeout(() => this.open(), this.delay);
        this.delay = Math.min(2 * this.delay, longestDelay);
        this.listener.lost(await this.isServerThere());
    }

    // A socket does not tell why it was not opened.
    private async isServerThere(): Promise<boolean> {
        try {
            return (await fetch("/", { cache: "no-store" })).ok && !this.isOpen;
        } catch {
            return false;
        }
    }

    private retry(): void {
        if (this.socket) return;
        clearTimeout(this.timer);
        this.open();
    }
}
