// Light and dark: an attribute of the page. It follows the system, until the reader chooses another one.

import { html } from "./dom.ts";

/** Return whether the page is dark now. */
const isDark = (): boolean => document.documentElement.dataset["theme"] === "dark";

function setDark(dark: boolean): void {
  document.documentElement.dataset["theme"] = dark ? "dark" : "light";
}

/** Change from light to dark, or back. */
export const changeTheme = (): void => setDark(!isDark());

if (typeof document !== "undefined") {
  // the page that evolves is a worker's script as well
  const system = matchMedia("(prefers-color-scheme: dark)");
  system.addEventListener("change", () => setDark(system.matches));
  setDark(system.matches);
  // Paper is light; boards, which listen later, draw themselves so before they are printed.
  let dark = false;
  addEventListener("beforeprint", () => {
    dark = isDark();
    setDark(false);
  });
  addEventListener("afterprint", () => setDark(dark));
}

/** Return a button that changes the theme. */
export function themeButton(): HTMLButtonElement {
  return html(
    "button",
    { type: "button", title: "Light or dark (D)", "aria-label": "Light or dark", onclick: changeTheme },
    "◐",
  );
}
