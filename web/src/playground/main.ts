// The playground: conflicts on a small board, step by step, under any rules.

import { loadEngine } from "../engine/engine.ts";
import { hasAddress, html } from "../page/dom.ts";
import { followAddress, hash, storeOf } from "./address.ts";
import { pageData } from "./data.ts";
import { showPlayground } from "./page.ts";

async function show(root: HTMLElement): Promise<void> {
  const data = pageData();
  const { store, problem } = storeOf(await loadEngine(), data, hash() || data.scene);
  showPlayground(root, store);
  if (hasAddress()) followAddress(store);
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
