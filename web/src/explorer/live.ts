// A page of runs that go on: it loads itself again when there is more to show.

import type { Run } from "./data.ts";
import type { Store } from "./store.ts";

/** As in `matrixworld.explorer.live`. */
const MILLISECONDS = 1000;
/** Milliseconds without a key and the pointer after which nobody is at work on the page. */
const IDLE = 8000;

/** How far the runs are, from 0 to 1, and in words. */
export interface Progress {
  /** Of the page; "end" if the runs have ended. */
  readonly version: string;
  readonly share: number;
  readonly text: string;
}

/** Ask how far the runs are, and load the page again when there is a newer one and nobody is `busy`; null is told when the command has ended. */
export function followRuns(version: string, runs: readonly Run[], store: Store, busy: () => boolean, tell: (progress: Progress | null) => void): void {
  let acted = -IDLE;
  for (const type of ["pointerdown", "pointermove", "keydown", "wheel"]) {
    window.addEventListener(type, () => (acted = performance.now()), { passive: true });
  }
  const free = (): boolean => !busy() && performance.now() - acted > IDLE;
  const look = async (): Promise<void> => {
    const found = await fetch("progress").then((answer) => answer.json() as Promise<Progress>).catch(() => null);
    tell(found);
    if (found === null) return;
    if (found.version === "end" || (found.version !== version && free())) {
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
