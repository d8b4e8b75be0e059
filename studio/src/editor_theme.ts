// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// How the editor looks. Its colours are the page's, which studio.css has for dark and light.

import { EditorView } from "@codemirror/view";

const popup = {
    backgroundColor: "var(--raised)",
    border: "1px solid var(--line)",
    borderRadius: "6px",
    boxShadow: "var(--shadow)",
    color: "var(--text)",
};

export const editorTheme = EditorView.theme({
    "&": { height: "100%", backgroundColor: "var(--panel)", color: "var(--text)", fontSize: "13px" },
    "&.cm-focused": { outline: "none" },
    ".cm-scroller": { fontFamily: "var(--mono)", lineHeight: "1.6" },
    ".cm-content": { padding: "10px 0 40px", caretColor: "var(--accent)" },
    ".cm-line": { paddingRight: "12px" },
    ".cm-cursor": { borderLeft: "2px solid var(--accent)" },
    ".cm-gutters": { backgroundColor: "var(--panel)", color: "var(--faint)", border: "none" },
    ".cm-activeLine, .cm-activeLineGutter": { backgroundColor: "transparent" },
    "&.cm-focused .cm-activeLine": { backgroundColor: "var(--hover)" },
    "&.cm-focused > .cm-scroller > .cm-selectionLayer .cm-selectionBackground, .cm-selectionBackground": {
        backgroundColor: "var(--selection)",
    },
    "&.cm-focused .cm-matchingBracket": { backgroundColor: "var(--selection)" },
    ".cm-lintRange": { backgroundImage: "none !important", textDecorationSkipInk: "none" },
    ".cm-lintRange-error": { textDecoration: "underline wavy var(--error) 1px", textUnderlineOffset: "3px" },
    ".cm-lintRange-warning": { textDecoration: "underline wavy var(--warning) 1px", textUnderlineOffset: "3px" },
    ".cm-tooltip": popup,
    ".cm-tooltip .cm-tooltip-section": { border: "none" },
    ".cm-tooltip.cm-tooltip-autocomplete > ul": { fontFamily: "var(--mono)", fontSize: "12px", maxHeight: "16em" },
    ".cm-tooltip-autocomplete > ul > li": { padding: "3px 8px !important" },
    ".cm-tooltip.cm-tooltip-autocomplete > ul > li[aria-selected]": {
        backgroundColor: "var(--selection)",
        color: "var(--text)",
    },
    ".cm-completionDetail": { color: "var(--quiet)", fontStyle: "normal", marginLeft: "1em" },
    ".cm-completionMatchedText": { textDecoration: "none", color: "var(--accent)" },
    ".cm-tooltip.cm-completionInfo": { ...popup, padding: "6px 10px", maxWidth: "320px", font: "13px var(--sans)" },
    ".cm-diagnostic": { padding: "6px 10px", font: "13px var(--sans)", border: "none", whiteSpace: "pre-wrap" },
    ".cm-diagnosticAction": {
        backgroundColor: "var(--accent)",
        color: "var(--on-accent)",
        borderRadius: "4px",
        padding: "2px 8px",
        marginTop: "6px",
        marginLeft: "0",
        marginRight: "6px",
        font: "inherit",
        display: "inline-block",
    },
    ".cam-help": {
        maxWidth: "420px",
        maxHeight: "45vh",
        overflow: "auto",
        padding: "4px 12px",
        font: "13px/1.45 var(--sans)",
    },
    ".cam-help pre": {
        font: "12px/1.5 var(--mono)",
        whiteSpace: "pre-wrap",
        margin: "6px 0",
        color: "var(--text)",
    },
    ".cam-help p": { margin: "6px 0", color: "var(--quiet)", whiteSpace: "pre-line" },
    ".cam-signature strong": { color: "var(--accent)" },
    ".cam-value": { color: "var(--faint)", fontStyle: "italic", paddingLeft: "1.5ch" },
    "&.cam-drags": { "--cam-number-cursor": "ew-resize" },
    ".cm-snippetField": { backgroundColor: "var(--selection)", borderRadius: "2px" },
    ".cm-panels": { backgroundColor: "var(--raised)", color: "var(--text)", border: "none" },
    ".cm-panels input, .cm-panels button": { font: "12px var(--sans)", backgroundImage: "none" },
    ".cm-textfield": { backgroundColor: "var(--panel)", border: "1px solid var(--line)", borderRadius: "4px" },
    ".cm-button": { backgroundColor: "var(--panel)", border: "1px solid var(--line)", borderRadius: "4px" },
});
