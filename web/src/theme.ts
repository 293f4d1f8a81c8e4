// Light and dark: the system's choice until the button is used. Views that draw on a canvas listen to changes.
import { h } from "./dom.ts";

const listeners: (() => void)[] = [];
const system = matchMedia("(prefers-color-scheme: dark)");

export function isDark(): boolean {
  const chosen = document.documentElement.dataset["theme"];
  return chosen === undefined ? system.matches : chosen === "dark";
}

/** Calls the listener when colours change. */
export function onTheme(listener: () => void): void {
  listeners.push(listener);
}

/** A colour of the style sheet, such as "--ink". */
export function colour(name: string): string {
  return getComputedStyle(document.documentElement).getPropertyValue(name).trim();
}

export function themeButton(): HTMLElement {
  const button = h("button", { type: "button", class: "theme" });
  const label = () => {
    button.textContent = isDark() ? "Light colours" : "Dark colours";
  };
  button.addEventListener("click", () => {
    document.documentElement.dataset["theme"] = isDark() ? "light" : "dark";
    for (const listener of listeners) listener();
  });
  system.addEventListener("change", () => {
    for (const listener of listeners) listener();
  });
  onTheme(label);
  label();
  return button;
}
