// The head of a page: what it is, a sentence about it, and its buttons.

import { html } from "./dom.ts";
import type { Child } from "./dom.ts";
import { themeButton } from "./theme.ts";

/** Return the head; the button of light and dark is the last one. */
export const top = (title: string, lead: Child, ...tools: Child[]): HTMLElement =>
  html(
    "header",
    { class: "top" },
    html("div", {}, html("h1", {}, title), lead ? html("p", { class: "lead" }, lead) : null),
    html("div", { class: "tools" }, ...tools, themeButton()),
  );
