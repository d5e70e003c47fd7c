// A page of runs that go on: it loads itself again when there is more to show.

import type { Run } from "./data.ts";
import type { Store } from "./store.ts";

/** As in `matrixworld.explorer.live`. */
const MILLISECONDS = 1000;
/** Milliseconds without a key and the pointer after which nobody is at work on the page. */
const IDLE = 8000;

/** Ask for the version of the page, and load it again when another one is there and nobody is `busy`. */
export function followRuns(version: string, runs: readonly Run[], store: Store, busy: () => boolean, ended: () => void): void {
  let acted = -IDLE;
  for (const type of ["pointerdown", "pointermove", "keydown", "wheel"]) {
    window.addEventListener(type, () => (acted = performance.now()), { passive: true });
  }
  const free = (): boolean => !busy() && performance.now() - acted > IDLE;
  const look = async (): Promise<void> => {
    const found = await fetch("version").then((answer) => answer.text(), () => null);
    if (found === null) {
      ended();
    } else if (found === "end" || (found !== version && free())) {
      showNewest(runs, store);
      location.reload();
    } else {
      setTimeout(() => void look(), MILLISECONDS);
    }
  };
  void look();
}

/** Leave the newest generations out of the address: the page that comes next shows its own. */
function showNewest(runs: readonly Run[], store: Store): void {
  const { run, pursuer, evader } = store.selected;
  const [rows, columns] = runs[run]!.payoff.shape;
  if (pursuer === rows - 1 && evader === columns - 1) history.replaceState(null, "", `#run=${run}`);
}
