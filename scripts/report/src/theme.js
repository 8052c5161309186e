// Light or dark: as the system says (set in the page's head, before anything is drawn), until the button is pressed.

import { byId, onToggle } from "./elements.js";

const root = document.documentElement;

export const isDark = () => root.dataset.theme === "dark";

/** The value of a colour of the style sheet, such as "ink" for --ink. */
export const colour = (name) => getComputedStyle(root).getPropertyValue(`--${name}`).trim();

export function startTheme(changed) {
  const button = byId("theme");
  button.setAttribute("aria-pressed", String(isDark()));
  onToggle(button, (dark) => {
    root.dataset.theme = dark ? "dark" : "light";
    changed();
  });
}
