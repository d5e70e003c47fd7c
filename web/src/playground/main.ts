// The playground: conflicts on a small board, step by step, under any rules.

import "./playground.css";

import { EngineError, loadEngine } from "../engine/engine.ts";
import type { Engine } from "../engine/engine.ts";
import { html } from "../page/dom.ts";
import { changeTheme, themeButton } from "../page/theme.ts";
import { actKey, arena } from "./arena.ts";
import { agentsPanel } from "./agents_panel.ts";
import { pageData } from "./data.ts";
import type { Example, PageData } from "./data.ts";
import { keysDialog, shareDialog } from "./dialogs.ts";
import { gallery } from "./gallery.ts";
import { LinkError, linkOf, sceneOf } from "./link.ts";
import { rulesPanel } from "./rules_panel.ts";
import { Store } from "./store.ts";
import { story } from "./story.ts";
import { addAgent, removeChosen, toolbar, undoButton } from "./toolbar.ts";

/** Make the store of a text; without a scene in it, of the first example, and say what is wrong. */
function storeOf(engine: Engine, data: PageData, text: string): { store: Store; problem: string } {
  const made = (scene: string): Store => new Store(engine, data, sceneOf(scene, data), exampleOf(data, scene));
  const first = data.gallery[0]!.scene;
  try {
    return { store: made(text || first), problem: "" };
  } catch (error) {
    return { store: made(first), problem: problemOf(error) };
  }
}

/** Return what is wrong with a link; other errors are the page's own. */
function problemOf(error: unknown): string {
  if (error instanceof LinkError || error instanceof EngineError) return `This link holds no scene. ${error.message}`;
  throw error;
}

function exampleOf(data: PageData, scene: string): Example | null {
  return data.gallery.find((example) => example.scene === scene) ?? null;
}

function hash(): string {
  try {
    return decodeURIComponent(location.hash.slice(1));
  } catch {
    return location.hash.slice(1); // broken escapes are told as part of a link that is no scene
  }
}

function page(store: Store): { elements: HTMLElement[]; open: Record<"share" | "keys", () => void> } {
  const share = shareDialog(store);
  const keys = keysDialog();
  const open = { share: share.open, keys: () => keys.showModal() };
  const header = html("header", { class: "top" },
    html("h1", {}, html("span", { class: "muted" }, "matrixworld "), "playground"),
    html("div", { class: "buttons" }, undoButton(store),
      html("button", { type: "button", title: "Link to this scene (L)", onclick: open.share }, "Share"),
      html("button", { type: "button", title: "Keys (?)", onclick: open.keys }, "Keys"), themeButton()));
  const main = html("main", { class: "layout" },
    rulesPanel(store),
    html("section", { class: "card stage", "aria-label": "Board" }, arena(store), toolbar(store)),
    html("div", { class: "side" }, story(store), agentsPanel(store)));
  return { elements: [header, gallery(store), main, share.element, keys], open };
}

function listenToKeys(store: Store, open: Record<"share" | "keys", () => void>): void {
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
    if (event.defaultPrevented || document.querySelector("dialog[open]")) return;
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

/** Keep the scene in the address, so that a reload shows it and the address is a link to it. */
function followAddress(store: Store): void {
  let own = linkOf(store.scene, store.data);
  store.addEventListener("change", () => {
    const now = linkOf(store.scene, store.data);
    if (now === own) return;
    own = now;
    history.replaceState(null, "", `#${now}`);
  });
  window.addEventListener("hashchange", () => {
    if (hash() === own) return;
    try {
      store.change(sceneOf(hash(), store.data), { example: exampleOf(store.data, hash()) });
    } catch (error) {
      store.say(problemOf(error), true);
    }
  });
}

async function show(root: HTMLElement): Promise<void> {
  const data = pageData();
  const { store, problem } = storeOf(await loadEngine(), data, hash() || data.scene);
  const { elements, open } = page(store);
  root.append(...elements);
  listenToKeys(store, open);
  followAddress(store);
  if (problem) store.say(problem, true);
  Object.assign(window, { playground: store }); // for tests, and for the curious
}

const root = document.getElementById("page")!;
show(root)
  .catch((error: Error) => {
    root.append(html("p", { class: "card problem", role: "alert" }, `The playground could not start: ${error.message}`));
    throw error;
  })
  .finally(() => {
    document.body.dataset["ready"] = "true";
  });
