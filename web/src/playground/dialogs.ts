// Dialogs of the page: the link of a scene, and the keys.

import { copy, hasAddress, html } from "../page/dom.ts";
import { linkOf } from "./link.ts";
import type { Store } from "./store.ts";

function dialog(title: string, ...children: (Node | string)[]): HTMLDialogElement {
  const close = html("button", { type: "button", class: "close", "aria-label": "Close" }, "✕");
  const made = html("dialog", { "aria-label": title }, html("div", { class: "dialog-head" }, html("h2", {}, title), close), ...children);
  close.addEventListener("click", () => made.close());
  // A press on the ground around it closes it.
  made.addEventListener("click", (event) => event.target === made && made.close());
  return made;
}

/** Return the dialog with the link to the scene, and what opens it. */
export function shareDialog(store: Store): { element: HTMLDialogElement; open: () => void } {
  const link = html("input", { type: "text", readonly: true, "aria-label": "Link" });
  const code = html("input", { type: "text", readonly: true, "aria-label": "Scene" });
  const told = html("p", { class: "muted small", role: "status" });
  const element = dialog("Share this scene",
    html("p", {}, "The link holds the whole scene: board, agents, rules and moves. Nothing is sent anywhere."),
    html("label", { class: "copy", hidden: !hasAddress() }, html("span", {}, "Link to this page"), link, html("button", { type: "button", onclick: () => copy(link, told) }, "Copy")),
    html("label", { class: "copy" }, html("span", {}, "Scene, for any copy of the playground"), code, html("button", { type: "button", onclick: () => copy(code, told) }, "Copy")),
    told);
  return {
    element,
    open: () => {
      code.value = `#${linkOf(store.scene, store.data)}`;
      link.value = location.href.split("#")[0]! + code.value;
      told.textContent = "";
      element.showModal();
    },
  };
}

export const KEYS: readonly (readonly [keys: readonly string[], text: string])[] = [
  [["Enter"], "play a step"],
  [["Backspace"], "take the last step back"],
  [["Home"], "back to the start"],
  [["Space"], "run, or stop"],
  [["N", "P"], "choose the next agent, or the one before"],
  [["↑", "→", "↓", "←"], "the chosen agent moves there next"],
  [["Q", "E", "C", "Y"], "the same on a diagonal, where the board allows it"],
  [["S"], "the chosen agent stays"],
  [["1", "… 9"], "choose a variant"],
  [["M"], "change between Move and Build"],
  [["Ctrl Z", "Ctrl Y"], "undo, redo"],
  [["L"], "link to this scene"],
  [["D"], "light or dark"],
  [["?"], "these keys"],
];
const BUILD_KEYS: typeof KEYS = [
  [["↑", "→", "↓", "←"], "move the cursor on the board"],
  [["Space"], "draw or erase an obstacle, or choose the agent there"],
  [["Shift ↑"], "carry the agent under the cursor"],
  [["+", "-"], "add a pursuer, an evader"],
  [["Delete"], "remove the agent under the cursor"],
];

/** Return the dialog that lists the keys. */
export function keysDialog(): HTMLDialogElement {
  const list = (keys: typeof KEYS): HTMLElement =>
    html("dl", { class: "keys" }, ...keys.flatMap(([names, text]) => [
      html("dt", {}, ...names.map((name) => html("kbd", {}, name))), html("dd", {}, text),
    ]));
  const parts = html("div", { class: "keys-columns" },
    html("div", {}, html("h3", {}, "Anywhere"), list(KEYS)),
    html("div", {}, html("h3", {}, "On the board, in Build"), list(BUILD_KEYS),
      html("h3", {}, "With mouse or finger"),
      html("p", {}, "Move: press an agent and drag it towards a cell beside it, or choose it and press that cell."),
      html("p", {}, "Build: drag agents; draw on free cells to make obstacles, on obstacles to erase them.")));
  return dialog("Keys", parts);
}
