// The examples: one press shows a scene and what it teaches.

import { sceneOf } from "./link.ts";
import { html } from "../page/dom.ts";
import type { Store } from "./store.ts";
import { unbroken } from "./words.ts";

/** Return the row of examples, with the text of the one that is shown. */
export function gallery(store: Store): HTMLElement {
  const buttons = store.data.gallery.map((example) => html("button", {
    type: "button", class: "chip",
    onclick: () => {
      store.stop();
      store.mode = "act";
      store.change(sceneOf(example.scene, store.data), { example });
      store.selected = 0;
    },
  }, example.title));
  const text = html("p", { class: "example-text" });
  const element = html("nav", { class: "gallery", "aria-label": "Examples" }, html("div", { class: "chips" }, ...buttons), text);
  const update = (): void => {
    store.data.gallery.forEach((example, place) => buttons[place]!.setAttribute("aria-pressed", String(example === store.example)));
    text.replaceChildren(...unbroken(store.example?.text ?? "A scene of your own. Choose an example, or change this one."));
  };
  store.addEventListener("change", update);
  update();
  return element;
}
