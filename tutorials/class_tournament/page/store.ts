// The pair that is selected and the one under the pointer; every panel shows both.

import type { Pair } from "./data.ts";

const same = (a: Pair | null, b: Pair | null): boolean =>
  a?.pursuer === b?.pursuer && a?.evader === b?.evader;

/** It dispatches `pair`, `hover` and `play`: the selected pair is to be shown from its start. */
export class Store extends EventTarget {
  #pair: Pair;
  #hover: Pair | null = null;

  constructor(pair: Pair) {
    super();
    this.#pair = pair;
  }

  get pair(): Pair {
    return this.#pair;
  }

  get hover(): Pair | null {
    return this.#hover;
  }

  select(pair: Pair): void {
    if (same(pair, this.#pair)) return;
    this.#pair = pair;
    this.dispatchEvent(new Event("pair"));
  }

  /** Select a pair and play it. */
  play(pair: Pair): void {
    this.select(pair);
    this.dispatchEvent(new Event("play"));
  }

  point(at: Pair | null): void {
    if (same(at, this.#hover)) return;
    this.#hover = at;
    this.dispatchEvent(new Event("hover"));
  }

  on(type: "pair" | "hover" | "play", act: () => void): void {
    this.addEventListener(type, act);
  }
}
