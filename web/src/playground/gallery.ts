// The examples: one press shows a scene and asks a question; another one reveals what it teaches.

import { sceneOf } from "./link.ts";
import { html } from "../page/dom.ts";
import type { Store } from "./store.ts";
import { unbroken } from "./words.ts";

/** Return the row of examples, with the question of the one that is shown, and its answer on demand. */
export function gallery(store: Store): HTMLElement {
  const buttons = store.data.gallery.map((example) =>
    html(
      "button",
      {
        type: "button",
        class: "chip",
        onclick: () => {
          store.stop();
          store.mode = "act";
          store.change(sceneOf(example.scene, store.data), { example });
          store.selected = 0;
        },
      },
      example.title,
    ),
  );
  const ask = html("p", { class: "example-text" });
  const text = html("p");
  const reveal = html("details", { class: "reveal" }, html("summary", {}, "Reveal"), text);
  const element = html(
    "nav",
    { class: "gallery", "aria-label": "Examples" },
    html("div", { class: "chips" }, ...buttons),
    ask,
    reveal,
  );
  let shown: unknown;
  store.shownBy(() => {
    store.data.gallery.forEach((example, place) =>
      buttons[place]!.setAttribute("aria-pressed", String(example === store.example)),
    );
    ask.replaceChildren(
      ...unbroken(store.example?.ask ?? "A scene of your own. Choose an example, or change this one."),
    );
    text.replaceChildren(...unbroken(store.example?.text ?? ""));
    reveal.hidden = !store.example;
    // A step of the same example leaves it as it is.
    if (shown !== store.example) reveal.open = false;
    shown = store.example;
  });
  return element;
}
