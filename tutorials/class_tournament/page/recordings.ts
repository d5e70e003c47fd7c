// Recorded actions, played again by the engine in the page.

import { unzlibSync } from "fflate";

import type { Engine } from "../../../web/src/engine/engine.ts";
import { bytesOf } from "../../../web/src/explorer/data.ts";
import { replayed } from "../../../web/src/board/live.ts";
import type { Live } from "../../../web/src/board/live.ts";
import type { Data, Pair } from "./data.ts";

/** The recordings of the page: an action a byte, one match after the other, row by row of the matrix. */
export class Recordings {
  readonly #data: Data;
  readonly #agents: number;
  readonly #starts = new Map<number, number>();
  #actions: Uint8Array | null = null;

  constructor(data: Data) {
    this.#data = data;
    this.#agents = data.world.n_pursuers + data.world.n_evaders;
    let start = 0;
    data.steps.forEach((row, g) =>
      row.forEach((steps, h) => {
        if (steps < 0) return;
        this.#starts.set(g * row.length + h, start);
        start += steps * this.#agents;
      }),
    );
  }

  /** Whether the page has a recording of a pair. */
  has({ pursuer, evader }: Pair): boolean {
    return this.#data.steps[pursuer]![evader]! >= 0;
  }

  /** Return the actions of each step. */
  actions({ pursuer, evader }: Pair): Uint8Array[] {
    this.#actions ??= unzlibSync(bytesOf("recordings"));
    const start = this.#starts.get(pursuer * this.#data.names.evader.length + evader)!;
    return Array.from({ length: this.#data.steps[pursuer]![evader]! }, (_, step) =>
      this.#actions!.slice(start + step * this.#agents, start + (step + 1) * this.#agents),
    );
  }

  /** Play the first episode of a pair again: same start, same actions. */
  play(engine: Engine, pair: Pair): Live {
    return replayed(engine, this.#data.world, { seed: BigInt(this.#data.match_seed) }, this.actions(pair));
  }
}
