// The playground as elements: a page of its own, or a dialog of another page.

import "./playground.css";

import { html } from "../page/dom.ts";
import { themeButton } from "../page/theme.ts";
import { agentsPanel } from "./agents_panel.ts";
import { arena } from "./arena.ts";
import { keysDialog, shareDialog } from "./dialogs.ts";
import { gallery } from "./gallery.ts";
import { listenToKeys } from "./keys.ts";
import { rulesPanel } from "./rules_panel.ts";
import type { Store } from "./store.ts";
import { story } from "./story.ts";
import { toolbar, undoButton } from "./toolbar.ts";

/**
 * Show what a store holds inside an element, and listen to keys; returns what ends that.
 *
 * `own`: whether the page is the playground's own, so that its address is a link to the scene; other
 * pages give what closes it.
 */
export function showPlayground(root: HTMLElement, store: Store, own: true | (() => void)): () => void {
  const share = shareDialog(store, own === true);
  const keys = keysDialog();
  const openKeys = (): void => keys.showModal();
  const close = own === true ? null : html("button", { type: "button", onclick: own }, "Close");
  const header = html("header", { class: "top" },
    html("h1", {}, html("span", { class: "muted" }, "matrixworld "), "playground"),
    html("div", { class: "buttons" }, undoButton(store),
      html("button", { type: "button", title: "Link to this scene (L)", onclick: share.open }, "Share"),
      html("button", { type: "button", title: "Keys (?)", onclick: openKeys }, "Keys"), themeButton(), close));
  const main = html("main", { class: "layout" },
    rulesPanel(store),
    html("section", { class: "card stage", "aria-label": "Board" }, arena(store), toolbar(store)),
    html("div", { class: "side" }, story(store), agentsPanel(store)));
  root.classList.add("playground");
  root.replaceChildren(header, gallery(store), main, share.element, keys);
  return listenToKeys(store, root, { share: share.open, keys: openKeys });
}
