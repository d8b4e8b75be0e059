// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Starts `balcony lsp` for the camera files of an editor's window.

import { window, workspace } from "vscode";
import { LanguageClient } from "vscode-languageclient/node";

let client;

function command() {
    return workspace.getConfiguration("balcony").get("command");
}

async function start() {
    client = new LanguageClient("balcony", "Balcony", { command: command(), args: ["lsp"] },
        { documentSelector: [{ language: "balcony-camera" }] });
    try {
        await client.start();
    } catch (failure) {
        client = undefined;
        window.showErrorMessage(`'${command()}' does not start: ${failure?.message ?? failure}. Install Balcony, `
            + "or name its command in the setting balcony.command.");
    }
}

export async function deactivate() {
    const running = client;
    client = undefined;
    await running?.stop();
}

/** @param {import("vscode").ExtensionContext} context */
export async function activate(context) {
    context.subscriptions.push(workspace.onDidChangeConfiguration(async change => {
        if (change.affectsConfiguration("balcony.command")) {
            await deactivate();
            await start();
        }
    }));
    await start();
}
