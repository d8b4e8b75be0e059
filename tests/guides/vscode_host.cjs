// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
//
// Usage: node vscode_host.cjs EXTENSION COMMAND
//
// Activates and deactivates an extension where all of VS Code's interface does nothing, and prints what a user
// would be told. The setting balcony.command is COMMAND.

const Module = require("node:module");

const [extension, command] = process.argv.slice(2);
const disposable = { dispose() {} };
const subscribe = () => disposable;

class EventEmitter {
    listeners = new Set();
    event = (listener) => {
        this.listeners.add(listener);
        return disposable;
    };
    fire(value) {
        for (const listener of this.listeners) listener(value);
    }
    dispose() {}
}

const known = {
    "vscode": { version: "1.90.0", EventEmitter },
    "vscode.env": { language: "en", appName: "test" },
    "vscode.workspace": {
        getConfiguration: () => ({ get: (name) => (name === "command" ? command : undefined), has: () => false }),
        textDocuments: [],
        notebookDocuments: [],
        workspaceFolders: undefined,
    },
    "vscode.window": {
        showErrorMessage: async (text) => console.log(`error: ${text}`),
        visibleTextEditors: [],
        visibleNotebookEditors: [],
        tabGroups: { all: [], onDidChangeTabs: subscribe, onDidChangeTabGroups: subscribe },
        createOutputChannel: () => ({ append() {}, appendLine() {}, show() {}, dispose() {} }),
    },
};

/** What stands at a path: as known, an event, or something that can be called, made and inherited from. */
function thing(path) {
    const one = class {
        set() {}
        clear() {}
        dispose() {}
    };
    return new Proxy(one, {
        get(target, key) {
            if (typeof key === "symbol" || key in target || key === "prototype") return target[key];
            if (key in (known[path] ?? {})) return known[path][key];
            if (/^on[A-Z]/.test(key)) return subscribe;
            return (target[key] = thing(`${path}.${key}`));
        },
        apply: () => disposable,
    });
}

const vscode = thing("vscode");
const load = Module._load;
Module._load = (name, ...rest) => (name === "vscode" ? vscode : load(name, ...rest));

const { activate, deactivate } = require(extension);
activate({ subscriptions: [] }).then(async () => {
    console.log("activated");
    await deactivate();
    console.log("deactivated");
    process.exit(0);
});
