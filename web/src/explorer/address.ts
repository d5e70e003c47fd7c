// The match that is shown, in the address of the page: a link or a bookmark leads to the same one.
//
//     explorer.html#run=1&pursuers=12&evaders=7&episode=3&step=40

import type { MatchPanel } from "./match.ts";
import type { Run } from "./data.ts";
import type { Selection, Store } from "./store.ts";

/** Milliseconds within which one choice after another is one view: keys pass over many cells. */
const ONE_VIEW = 800;
const LARGEST_SEED = 2n ** 64n - 1n;

/** What an address names; numbers start at 0. */
export type Place = Selection & { readonly step: number };

/** Return the place that an address names; parts that are missing or not valid are those of `usual`. */
export function placeOf(hash: string, runs: readonly Run[], usual: Selection): Place {
  const parts = new URLSearchParams(hash.replace(/^#/, ""));
  const number = (name: string, count: number, missing: number): number => {
    const given = parts.get(name) ?? "";
    return /^\d{1,9}$/.test(given) && Number(given) < count ? Number(given) : missing;
  };
  const run = number("run", runs.length, usual.run);
  const [rows, columns] = runs[run]!.payoff.shape;
  const seed = parts.get("seed") ?? "";
  return {
    run,
    pursuer: number("pursuers", rows, Math.min(usual.pursuer, rows - 1)),
    evader: number("evaders", columns, Math.min(usual.evader, columns - 1)),
    episode: number("episode", Infinity, usual.episode),
    seed: /^\d{1,20}$/.test(seed) && BigInt(seed) <= LARGEST_SEED ? seed : null,
    step: number("step", Infinity, 0),
  };
}

/**
 * Keep the match and its step in the address, and follow it: another match is another view, to
 * which Back returns.
 */
export function followAddress(runs: readonly Run[], store: Store, match: MatchPanel): void {
  let own = "";
  let shown = JSON.stringify(store.selected);
  let since = -ONE_VIEW;
  const write = (): void => {
    const { run, pursuer, evader, episode, seed } = store.selected;
    const parts = {
      run,
      pursuers: pursuer,
      evaders: evader,
      episode,
      ...(seed === null ? {} : { seed }),
      step: match.player.step,
    };
    const view = JSON.stringify(store.selected);
    const another = view !== shown && performance.now() - since > ONE_VIEW;
    if (view !== shown) {
      shown = view;
      since = performance.now();
    }
    own = `#${Object.entries(parts)
      .map(([name, value]) => `${name}=${value}`)
      .join("&")}`;
    try {
      if (another) history.pushState(null, "", own);
      else history.replaceState(null, "", own);
    } catch {
      // Frames of notebooks have no address of their own.
    }
  };
  write();
  store.on("match", write);
  match.player.addEventListener("state", () => match.player.playing || write());
  match.player.addEventListener("step", () => match.player.playing || write());
  window.addEventListener("hashchange", () => {
    if (location.hash === own) return;
    const { step, ...selection } = placeOf(location.hash, runs, store.selected);
    for (const dialog of document.querySelectorAll<HTMLDialogElement>("dialog[open]")) dialog.close();
    shown = JSON.stringify(selection); // it has its place in the history
    store.select(selection);
    match.goTo(step);
  });
}

// ---- While runs go on

/**
 * Milliseconds between two reloads, and those without a key and the pointer after which nobody is
 * at work.
 */
const EVERY = 5000;
const IDLE = 8000;

/** Load the page again and again, but not while it is `busy`; the file is written anew meanwhile. */
export function reloadWhileGrowing(runs: readonly Run[], store: Store, busy: () => boolean): void {
  let acted = -IDLE;
  for (const type of ["pointerdown", "pointermove", "keydown", "wheel"]) {
    window.addEventListener(type, () => (acted = performance.now()), { passive: true });
  }
  setInterval(() => {
    if (busy() || performance.now() - acted < IDLE) return;
    // Leave the newest generations out of the address: the page that comes next shows its own.
    const { run, pursuer, evader } = store.selected;
    const [rows, columns] = runs[run]!.payoff.shape;
    if (pursuer === rows - 1 && evader === columns - 1) history.replaceState(null, "", `#run=${run}`);
    location.reload();
  }, EVERY);
}
