// A page of runs that go on: it loads itself again when nobody is at work on it, and keeps what is selected.

import type { Run } from "./data.ts";
import type { Store } from "./store.ts";

/** Milliseconds between two reloads, and those without a key and the pointer after which nobody is at work. */
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
    showNewest(runs, store);
    location.reload();
  }, EVERY);
}

/** Leave the newest generations out of the address: the page that comes next shows its own. */
function showNewest(runs: readonly Run[], store: Store): void {
  const { run, pursuer, evader } = store.selected;
  const [rows, columns] = runs[run]!.payoff.shape;
  if (pursuer === rows - 1 && evader === columns - 1) history.replaceState(null, "", `#run=${run}`);
}
