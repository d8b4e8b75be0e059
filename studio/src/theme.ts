// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Dark or light, by the system or by choice.

const key = "balcony-theme";

export type Theme = "system" | "dark" | "light";

export const themes: Theme[] = ["system", "dark", "light"];

export function chosenTheme(): Theme {
    const stored = localStorage.getItem(key) as Theme | null;
    return stored && themes.includes(stored) ? stored : "system";
}

export function chooseTheme(theme: Theme): void {
    localStorage.setItem(key, theme);
    showTheme();
}

export function showTheme(): void {
    const isDark = matchMedia("(prefers-color-scheme: dark)").matches;
    const chosen = chosenTheme();
    document.documentElement.dataset["theme"] = chosen === "system" ? (isDark ? "dark" : "light") : chosen;
}

matchMedia("(prefers-color-scheme: dark)").addEventListener("change", showTheme);
