// The keys of the page; those of the board are in arena.ts.

import { changeTheme } from "../page/theme.ts";
import { actKey } from "./arena.ts";
import type { Store } from "./store.ts";
import { addAgent, removeChosen } from "./toolbar.ts";

/** Listen to the keys while the scene is `shown` and no dialog is open. */
export function listenToKeys(store: Store, open: Record<"share" | "keys", () => void>, shown: () => boolean): void {
  const names = Object.keys(store.data.variants);
  const acts: Record<string, () => void> = {
    Enter: () => store.step(),
    Backspace: () => store.back(),
    Home: () => store.restart(),
    " ": () => store.run(),
    m: () => (store.mode = store.mode === "act" ? "build" : "act"),
    l: open.share,
    d: changeTheme,
    "?": open.keys,
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
      if (act && !isText(event.target)) (event.preventDefault(), act());
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

const isText = (target: EventTarget | null): boolean => target instanceof HTMLInputElement && !["radio", "checkbox"].includes(target.type);

/** Return whether a control with the focus needs the key itself. */
function ownsKey(target: EventTarget | null, key: string): boolean {
  if (isText(target) || target instanceof HTMLSelectElement) return true;
  if (target instanceof HTMLInputElement) return key === " " || key.startsWith("Arrow");
  if (target instanceof HTMLButtonElement) return key === " " || key === "Enter";
  // Lists that scroll are scrolled by the arrow keys.
  return target instanceof HTMLElement && target.classList.contains("story-body") && key.startsWith("Arrow");
}
