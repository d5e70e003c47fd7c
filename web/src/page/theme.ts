// Light and dark: the system's choice, unless the reader chooses another one for this page.

import { html } from "./dom.ts";

/** Return whether the page is dark now. */
export function isDark(): boolean {
  const chosen = document.documentElement.dataset["theme"];
  return chosen ? chosen === "dark" : matchMedia("(prefers-color-scheme: dark)").matches;
}

/** Change from light to dark, or back. */
export function changeTheme(): void {
  document.documentElement.dataset["theme"] = isDark() ? "light" : "dark";
}

// Paper is light; boards, which listen later, draw themselves so before they are printed.
if (typeof document !== "undefined") { // the page that evolves is a worker's script as well
  const root = document.documentElement.dataset;
  let chosen = root["theme"];
  addEventListener("beforeprint", () => {
    chosen = root["theme"];
    root["theme"] = "light";
  });
  addEventListener("afterprint", () => {
    if (chosen) root["theme"] = chosen;
    else delete root["theme"];
  });
}

/** Return a button that changes the theme. */
export function themeButton(): HTMLButtonElement {
  return html("button", { type: "button", title: "Light or dark (D)", "aria-label": "Light or dark", onclick: changeTheme }, "◐");
}
