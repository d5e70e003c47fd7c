// Recorded actions, played again by the engine in the page.

import type { Engine } from "../engine/engine.ts";
import { bytesOf } from "../explorer/data.ts";
import { replayed } from "../play/live.ts";
import type { Live } from "../play/live.ts";
import type { Data, Pair } from "./data.ts";

/** The recordings of the page: one after the other, row by row of the matrix. */
export class Recordings {
  readonly #data: Data;
  readonly #agents: number;
  readonly #digits: number;
  readonly #starts = new Map<number, number>();
  #bytes: Uint8Array | null = null;

  constructor(data: Data) {
    this.#data = data;
    this.#agents = data.world.n_pursuers + data.world.n_evaders;
    this.#digits = Math.floor(Math.log(256) / Math.log(data.n_actions));
    let start = 0;
    data.steps.forEach((row, g) => row.forEach((steps, h) => {
      if (steps < 0) return;
      this.#starts.set(g * row.length + h, start);
      start += Math.ceil((steps * this.#agents) / this.#digits);
    }));
  }

  /** Whether the page has a recording of a pair. */
  has({ pursuer, evader }: Pair): boolean {
    return this.#data.steps[pursuer]![evader]! >= 0;
  }

  /** Return the actions of each step, read from numbers whose digits they are. */
  actions({ pursuer, evader }: Pair): Uint8Array[] {
    this.#bytes ??= bytesOf("recordings");
    const start = this.#starts.get(pursuer * this.#data.names.evader.length + evader)!;
    const at = (place: number): number => {
      const number = this.#bytes![start + Math.floor(place / this.#digits)]!;
      return Math.floor(number / this.#data.n_actions ** (place % this.#digits)) % this.#data.n_actions;
    };
    return Array.from({ length: this.#data.steps[pursuer]![evader]! }, (_, step) =>
      Uint8Array.from({ length: this.#agents }, (_, agent) => at(step * this.#agents + agent)));
  }

  /** Play the first episode of a pair again: same start, same actions. */
  play(engine: Engine, pair: Pair): Live {
    return replayed(engine, this.#data.world, { seed: BigInt(this.#data.match_seed) }, this.actions(pair));
  }
}
