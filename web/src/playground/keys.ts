// The keys of the page, and the dialog that lists them; those of the board are in arena.ts.

import { dialog, keyList } from "../page/dialog.ts";
import type { Keys } from "../page/dialog.ts";
import { html } from "../page/dom.ts";
import { changeTheme } from "../page/theme.ts";
import { actKey } from "./arena.ts";
import type { Store } from "./store.ts";
import { addAgent, removeChosen } from "./toolbar.ts";

/** Listen to the keys while the scene is `shown` and no dialog is open. */
export function listenToKeys(store: Store, openKeys: () => void, shown: () => boolean): void {
  const names = Object.keys(store.data.variants);
  const acts: Record<string, () => void> = {
    Enter: () => store.step(),
    Backspace: () => store.back(),
    Home: () => store.restart(),
    " ": () => store.run(),
    m: () => (store.mode = store.mode === "act" ? "build" : "act"),
    d: changeTheme,
    "?": openKeys,
  };
  const building: Record<string, () => void> = {
    "+": () => addAgent(store, "pursuers"),
    "-": () => addAgent(store, "evaders"),
    Delete: () => removeChosen(store),
  };
  document.addEventListener("keydown", (event) => {
    if (!shown() || event.defaultPrevented || document.querySelector("dialog[open]")) return;
    const key = event.key.length === 1 ? event.key.toLowerCase() : event.key;
    if ((event.ctrlKey || event.metaKey) && !event.altKey) {
      const act = { z: () => (event.shiftKey ? store.redo() : store.undo()), y: () => store.redo() }[key];
      if (act && !isText(event.target)) {
        event.preventDefault();
        act();
      }
      return;
    }
    if (event.altKey || ownsKey(event.target, key)) return;
    const variant = names[Number(key) - 1];
    const act = acts[key] ?? (store.mode === "build" ? building[key] : undefined);
    if (act) act();
    else if (variant) store.change({ ...store.scene, rules: store.data.variants[variant]! });
    else if (store.mode !== "act" || !actKey(store, event)) return;
    event.preventDefault();
  });
}

const isText = (target: EventTarget | null): boolean =>
  target instanceof HTMLInputElement && !["radio", "checkbox"].includes(target.type);

/** Return whether a control with the focus needs the key itself. */
function ownsKey(target: EventTarget | null, key: string): boolean {
  if (isText(target) || target instanceof HTMLSelectElement) return true;
  if (target instanceof HTMLInputElement) return key === " " || key.startsWith("Arrow");
  if (target instanceof HTMLButtonElement) return key === " " || key === "Enter";
  // Lists that scroll are scrolled by the arrow keys.
  return target instanceof HTMLElement && target.classList.contains("story-body") && key.startsWith("Arrow");
}

const KEYS: Keys = [
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
  [["D"], "light or dark"],
  [["?"], "these keys"],
];
const BUILD_KEYS: Keys = [
  [["↑", "→", "↓", "←"], "move the cursor on the board"],
  [["Space"], "draw or erase an obstacle, or choose the agent there"],
  [["Shift ↑"], "carry the agent under the cursor"],
  [["+", "-"], "add a pursuer, an evader"],
  [["Delete"], "remove the agent under the cursor"],
];

/** Return the dialog that lists the keys. */
export const keysDialog = (): HTMLDialogElement =>
  dialog(
    "Keys",
    "",
    html(
      "div",
      { class: "keys-columns" },
      html("div", {}, html("h3", {}, "Anywhere"), keyList(KEYS)),
      html(
        "div",
        {},
        html("h3", {}, "On the board, in Build"),
        keyList(BUILD_KEYS),
        html("h3", {}, "With mouse or finger"),
        html(
          "p",
          {},
          "Move: press an agent and drag it towards a cell beside it, or choose it and press that cell.",
        ),
        html(
          "p",
          {},
          "Build: drag agents; draw on free cells to make obstacles, on obstacles to erase them.",
        ),
      ),
    ),
  );
