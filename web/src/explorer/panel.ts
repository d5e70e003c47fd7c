// A panel of a run: what it is, and the card that it is drawn on.

import { html } from "../page/dom.ts";

/** A panel of one run; `update` shows what is selected or under the pointer. */
export interface Panel {
  readonly element: HTMLElement;
  update?(): void;
}

/** Return a card with a title and a line that says how to read it. */
export function card(title: string, hint: string, ...content: (Node | null)[]): HTMLElement {
  return html("section", { class: "card panel", "aria-label": title },
    html("header", {}, html("h2", {}, title), html("p", { class: "small muted" }, hint)), ...content);
}
