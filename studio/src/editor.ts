// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// The text of the camera file.

import { autocompletion, closeBrackets, closeBracketsKeymap, completionKeymap } from "@codemirror/autocomplete";
import { defaultKeymap, history, historyKeymap, isolateHistory, redo, undo } from "@codemirror/commands";
import { bracketMatching, indentOnInput, indentUnit, syntaxHighlighting } from "@codemirror/language";
import { lintKeymap, setDiagnostics } from "@codemirror/lint";
import { highlightSelectionMatches, searchKeymap } from "@codemirror/search";
import { Annotation, type ChangeSet, type ChangeSpec, EditorSelection, EditorState, Text, Transaction } from "@codemirror/state";
import {
    drawSelection,
    EditorView,
    highlightActiveLine,
    hoverTooltip,
    keymap,
    lineNumbers,
} from "@codemirror/view";
import { css, html, LitElement } from "lit";
import { editorTheme } from "./editor_theme";
import { type KnownValue, knownValues, setKnownValues } from "./known_values";
import { cameraColours, cameraIndent, cameraLanguage } from "./language";
import { type Ask, changesOf, completions, help, offsetOf, positionOf, type Problem } from "./language_server";
import { numberDrag } from "./number_drag";
import { OneStep } from "./one_step";
import type { Position, Range, TextEdit } from "./protocol";
import { signatureHelp } from "./signature_help";
import { wrappedLines } from "./wrapped_lines";

/** What another page has typed. */
const fromElsewhere = Annotation.define<boolean>();

export interface EditorActions {
    ask: Ask;
    /** After each change that was made here. */
    changed(changes: ChangeSet): void;
    format(): void;
    /** Gives the name at a place another name. */
    rename(name: string, position: Position): void;
}

export class CameraEditor extends LitElement {
    static override styles = css`
        :host,
        #text {
            display: block;
            height: 100%;
        }
    `;

    private view: EditorView | null = null;
    private step: OneStep | null = null;
    private actions: EditorActions | null = null;

    override render() {
        return html`<div id="text"></div>`;
    }

    get text(): string {
        return this.document.toString();
    }

    /** Shows a text without a past. */
    begin(text: string, isReadOnly: boolean, actions: EditorActions): void {
        this.actions = actions;
        this.view?.destroy();
        this.view = new EditorView({
            parent: this.renderRoot.querySelector("#text")!,
            // Styles of a shadow root are adopted, which the page's content security policy allows.
            root: this.renderRoot as ShadowRoot,
            state: EditorState.create({ doc: text, extensions: this.extensions(isReadOnly, actions) }),
        });
        this.step = new OneStep(this.view);
    }

    private extensions(isReadOnly: boolean, actions: EditorActions) {
        const format = (): boolean => {
            actions.format();
            return true;
        };
        const define = (): boolean => {
            void this.goToDefinition();
            return true;
        };
        const rename = (): boolean => {
            this.rename();
            return true;
        };
        const references = (): boolean => {
            void this.selectReferences();
            return true;
        };
        return [
            lineNumbers(),
            wrappedLines,
            history(),
            drawSelection(),
            EditorState.allowMultipleSelections.of(true),
            indentUnit.of("    "),
            indentOnInput(),
            bracketMatching(),
            closeBrackets(),
            highlightActiveLine(),
            highlightSelectionMatches(),
            cameraLanguage,
            cameraIndent,
            syntaxHighlighting(cameraColours),
            autocompletion({ override: [completions(actions.ask)], icons: false, maxRenderedOptions: 60 }),
            hoverTooltip(help(actions.ask), { hoverTime: 400, hideOnChange: true }),
            signatureHelp(actions.ask),
            knownValues,
            numberDrag,
            editorTheme,
            EditorState.readOnly.of(isReadOnly),
            EditorView.contentAttributes.of({ "aria-label": "Text of the camera file" }),
            keymap.of([
                { key: "Shift-Alt-f", run: format },
                { key: "F2", run: rename },
                { key: "F12", run: define, shift: references },
                ...closeBracketsKeymap,
                ...completionKeymap,
                ...historyKeymap,
                ...searchKeymap,
                ...lintKeymap,
                ...defaultKeymap,
            ]),
            EditorView.updateListener.of((update) => {
                const isFromElsewhere = update.transactions.some((one) => one.annotation(fromElsewhere));
                if (update.docChanged && !isFromElsewhere) actions.changed(update.changes);
            }),
        ];
    }

    /** Makes changes as one step of undo. */
    change(changes: ChangeSpec): void {
        this.view?.dispatch({ changes, annotations: isolateHistory.of("full"), userEvent: "hand" });
    }

    edit(edits: TextEdit[]): void {
        if (this.view && edits.length > 0) this.change(changesOf(this.view.state.doc, edits));
    }

    /** Makes edits on the way of a hand, all of which are one step of undo when it is released. */
    hold(edits: TextEdit[]): void {
        if (edits.length > 0) this.step?.change(changesOf(this.document, edits));
    }

    release(): void {
        this.step?.end();
    }

    /** Shows what was changed elsewhere, which undo leaves as it is. */
    take(changes: ChangeSet): void {
        this.release();
        this.view?.dispatch({
            changes,
            annotations: [fromElsewhere.of(true), Transaction.addToHistory.of(false)],
        });
    }

    undo(): void {
        if (this.view) undo(this.view);
    }

    redo(): void {
        if (this.view) redo(this.view);
    }

    get document(): Text {
        return this.view?.state.doc ?? Text.empty;
    }

    showProblems(problems: Problem[]): void {
        if (!this.view) return;
        const shown = problems.map(({ fixes, line: _, ...problem }) => ({
            ...problem,
            actions: fixes.map(({ title, changes }) => ({ name: title, apply: () => this.change(changes) })),
        }));
        this.view.dispatch(setDiagnostics(this.view.state, shown));
    }

    showValues(values: KnownValue[]): void {
        this.view?.dispatch({ effects: setKnownValues.of(values) });
    }

    /** Selects a part of the text. */
    goTo(from: number, to = from): void {
        this.view?.dispatch({ selection: { anchor: from, head: to }, scrollIntoView: true });
        this.view?.focus();
    }

    override focus(): void {
        this.view?.focus();
    }

    private rename(): void {
        const { state } = this.view!;
        const { head } = state.selection.main;
        const word = state.wordAt(head);
        if (word && !state.readOnly) {
            this.actions!.rename(state.sliceDoc(word.from, word.to), positionOf(state.doc, head));
        }
    }

    /** Selects all places where the name at the cursor stands, so that they are typed at once. */
    private async selectReferences(): Promise<void> {
        const { doc, selection } = this.view!.state;
        const found = await this.actions!.ask<{ range: Range }[] | null>("textDocument/references", {
            position: positionOf(doc, selection.main.head),
            context: { includeDeclaration: true },
        });
        if (!found?.length || !this.document.eq(doc)) return;
        const ranges = found.map(({ range }) =>
            EditorSelection.range(offsetOf(doc, range.start), offsetOf(doc, range.end)),
        );
        this.view!.dispatch({ selection: EditorSelection.create(ranges), scrollIntoView: true });
    }

    private async goToDefinition(): Promise<void> {
        const { state } = this.view!;
        const position = positionOf(state.doc, state.selection.main.head);
        const found = await this.actions!.ask<{ range: { start: Position } } | null>("textDocument/definition", {
            position,
        });
        if (found) this.goTo(offsetOf(this.document, found.range.start));
    }
}

customElements.define("camera-editor", CameraEditor);
