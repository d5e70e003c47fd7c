// What is selected on the page. Every panel shows it, and changes it here only.

import type { Team } from "../engine/teams.ts";

/** A match: a cell of the matrix and one of its episodes. */
export interface Selection extends Readonly<Record<"run" | "pursuer" | "evader" | "episode", number>> {
  /** Another seed than that of the cell; null for the cell's own. */
  readonly seed: string | null;
}

/** Generations under the pointer, in any panel; null where none is. */
type Hover = Readonly<Record<Team, number | null>>;
const NOTHING: Hover = { pursuer: null, evader: null };

/** The selection, and the pointer. It dispatches `run`, `match` and `hover` when they change. */
export class Store extends EventTarget {
  #selected: Selection;
  #hover: Hover = NOTHING;

  constructor(selected: Selection) {
    super();
    this.#selected = selected;
  }

  get selected(): Selection {
    return this.#selected;
  }

  get hover(): Hover {
    return this.#hover;
  }

  /** Change a part of the selection. Another cell begins with its episode 0 and its own seed. */
  select(change: Partial<Selection>): void {
    const before = this.#selected;
    const moved = (["run", "pursuer", "evader"] as const).some(
      (name) => name in change && change[name] !== before[name],
    );
    this.#selected = { ...before, ...(moved ? { episode: 0, seed: null } : {}), ...change };
    if (this.#selected.run !== before.run) this.dispatchEvent(new Event("run"));
    this.dispatchEvent(new Event("match"));
  }

  point(at: Partial<Hover>): void {
    const hover = { ...NOTHING, ...at };
    if (hover.pursuer === this.#hover.pursuer && hover.evader === this.#hover.evader) return;
    this.#hover = hover;
    this.dispatchEvent(new Event("hover"));
  }

  on(types: "run" | "match" | "match hover", act: () => void): void {
    for (const type of types.split(" ")) this.addEventListener(type, act);
  }
}
