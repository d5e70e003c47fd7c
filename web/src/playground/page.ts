// The parts of the page, put together.

import "./playground.css";

import { html } from "../page/dom.ts";
import { top } from "../page/top.ts";
import { agentsPanel } from "./agents_panel.ts";
import { arena } from "./arena.ts";
import { keysDialog, shareDialog } from "./dialogs.ts";
import { gallery } from "./gallery.ts";
import { listenToKeys } from "./keys.ts";
import { perfectPanel } from "./perfect.ts";
import { rulesPanel } from "./rules_panel.ts";
import type { Store } from "./store.ts";
import { story } from "./story.ts";
import { toolbar, undoButton } from "./toolbar.ts";

/** Show what a store holds inside an element, and listen to keys. */
export function showPlayground(root: HTMLElement, store: Store): void {
  const share = shareDialog(store);
  const keys = keysDialog();
  const openKeys = (): void => keys.showModal();
  const header = top("Playground", "Give agents their moves, predict what happens, and play the step.", undoButton(store),
    html("button", { type: "button", title: "Link to this scene (L)", onclick: share.open }, "Share"),
    html("button", { type: "button", title: "Keys (?)", "aria-label": "Keys (?)", onclick: openKeys }, "?"));
  const main = html("main", { class: "layout" },
    rulesPanel(store),
    html("section", { class: "card stage", "aria-label": "Board" }, arena(store), toolbar(store)),
    html("div", { class: "side" }, story(store), agentsPanel(store), perfectPanel(store)));
  root.classList.add("playground");
  root.replaceChildren(header, gallery(store), main, share.element, keys);
  listenToKeys(store, { share: share.open, keys: openKeys });
}
