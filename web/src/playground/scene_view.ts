// The parts that show a scene and what happens in it, put together.

import { html } from "../page/dom.ts";
import { agentsPanel } from "./agents_panel.ts";
import { arena } from "./arena.ts";
import { gallery } from "./gallery.ts";
import { keysDialog, listenToKeys } from "./keys.ts";
import { perfectPanel } from "./perfect.ts";
import { rulesPanel } from "./rules_panel.ts";
import type { Store } from "./store.ts";
import { story } from "./story.ts";
import { toolbar, undoButton } from "./toolbar.ts";

/**
 * Show what a store holds, and listen to keys while it is shown; `tools` are buttons for the head
 * of the page.
 */
export function sceneView(
  store: Store,
  shown: () => boolean,
): { element: HTMLElement; tools: HTMLElement[]; dialog: HTMLElement } {
  const keys = keysDialog();
  const openKeys = (): void => keys.showModal();
  listenToKeys(store, openKeys, shown);
  return {
    element: html(
      "section",
      { class: "scene", "aria-label": "Rules and conflicts" },
      gallery(store),
      html(
        "div",
        { class: "layout" },
        rulesPanel(store),
        html("section", { class: "card stage", "aria-label": "Board" }, arena(store), toolbar(store)),
        html("div", { class: "side" }, story(store), agentsPanel(store), perfectPanel(store)),
      ),
    ),
    tools: [
      undoButton(store),
      html("button", { type: "button", title: "Keys (?)", "aria-label": "Keys (?)", onclick: openKeys }, "?"),
    ],
    dialog: keys,
  };
}
