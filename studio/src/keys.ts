// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Keys that the page has wherever the focus is.

export interface KeyActions {
    save(): void;
    render(): void;
    keys(): void;
    undo(): void;
    redo(): void;
    text(): void;
    sliders(): void;
    handles(): void;
}

/** Undo in the text also from the sliders. */
function undoKey(event: KeyboardEvent, control: boolean, actions: KeyActions): (() => void) | null {
    const at = event.composedPath()[0] as HTMLElement;
    const isInText = at.closest(".cm-editor") !== null || (at as HTMLInputElement).type === "text";
    if (!control || isInText) return null;
    if (event.key === "y" || (event.key.toLowerCase() === "z" && event.shiftKey)) return actions.redo;
    return event.key === "z" ? actions.undo : null;
}

export function press(event: KeyboardEvent, actions: KeyActions): void {
    const control = event.ctrlKey || event.metaKey;
    const withControl: Record<string, () => void> = { s: actions.save, Enter: actions.render };
    const withAlt: Record<string, () => void> = { 1: actions.text, 2: actions.sliders, 3: actions.handles };
    const act =
        (control ? withControl[event.key] : event.altKey ? withAlt[event.key] : null) ??
        (event.key === "F1" ? actions.keys : undoKey(event, control, actions));
    if (!act || document.querySelector("dialog[open]")) return;
    event.preventDefault();
    event.stopPropagation();
    act();
}
