// The scene in the address of the page: it is a link, and a reload shows it again.

import { EngineError } from "../engine/engine.ts";
import type { Engine } from "../engine/engine.ts";
import type { Example, PageData } from "./data.ts";
import { LinkError, linkOf, sceneOf } from "./link.ts";
import { Store } from "./store.ts";

/** Make the store of a text; without a scene in it, of the first example, and say what is wrong. */
export function storeOf(engine: Engine, data: PageData, text: string): { store: Store; problem: string } {
  const made = (scene: string): Store =>
    new Store(engine, data, sceneOf(scene, data), exampleOf(data, scene));
  const first = data.gallery[0]!.scene;
  try {
    return { store: made(text || first), problem: "" };
  } catch (error) {
    return { store: made(first), problem: problemOf(error) };
  }
}

/** Return what is wrong with a link; other errors are the page's own. */
function problemOf(error: unknown): string {
  if (error instanceof LinkError || error instanceof EngineError) {
    return `This link holds no scene. ${error.message}`;
  }
  throw error;
}

function exampleOf(data: PageData, scene: string): Example | null {
  return data.gallery.find((example) => example.scene === scene) ?? null;
}

/** Return the part of the address that holds a scene. */
export function hash(): string {
  try {
    return decodeURIComponent(location.hash.slice(1));
  } catch {
    return location.hash.slice(1); // broken escapes are told as part of a link that is no scene
  }
}

/** Return whether a link holds a match that a person has played, and not a scene. */
export const isMatch = (link: string): boolean => new URLSearchParams(link).has("moves");

/** Milliseconds between changes of the address: browsers refuse many in a short time. */
const REST = 100;

/**
 * Keep the scene in the address while it is `shown`, so that a reload shows it; a link to another
 * one calls `show`.
 */
export function followAddress(store: Store, shown: () => boolean, show: () => void): void {
  let own = linkOf(store.scene, store.data);
  let written = hash();
  let due = 0;
  const write = (): void => {
    due = 0;
    if (hash() !== written || !shown()) return; // another link was followed meanwhile
    written = own;
    history.replaceState(null, "", `#${own}`);
  };
  store.addEventListener("change", () => {
    own = linkOf(store.scene, store.data);
    if (!shown()) return;
    written = hash();
    if (own !== written && !due) due = setTimeout(write, REST);
  });
  window.addEventListener("hashchange", () => {
    written = hash();
    if (!written || written === own || isMatch(written)) return;
    if (!shown()) show();
    try {
      store.change(sceneOf(written, store.data), { example: exampleOf(store.data, written) });
    } catch (error) {
      store.say(problemOf(error), true);
    }
  });
}
