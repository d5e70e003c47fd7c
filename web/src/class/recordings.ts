// Recorded actions, played again by the engine in the page.

import { momentOf, recording } from "../board/from_engine.ts";
import type { Moment, Recording } from "../board/recording.ts";
import type { Engine } from "../engine/engine.ts";
import type { Conflict } from "../engine/types.ts";
import { bytesOf } from "../explorer/data.ts";
import type { Told } from "../explorer/words.ts";
import type { Data, Pair } from "./data.ts";

/** A match that was played again: its pictures, and what is told of it. */
export interface Replay {
  readonly recording: Recording;
  readonly told: Told;
}

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
  play(engine: Engine, pair: Pair): Replay {
    const world = engine.world(this.#data.world);
    world.reset({ seed: BigInt(this.#data.match_seed), episode: 0 });
    const moments: Moment[] = [momentOf(world)];
    const conflicts: Conflict[][] = [[]];
    for (const actions of this.actions(pair)) {
      world.step(actions);
      conflicts.push(world.conflicts());
      moments.push(momentOf(world, actions));
    }
    const told: Told = {
      config: this.#data.world,
      length: moments.length - 1,
      statistics: { capture_rate: world.read("capture_rate")[0]! },
      conflicts: (step) => conflicts[step]!,
    };
    const replay = { recording: recording(this.#data.world, world.map(), moments), told };
    world.free();
    return replay;
  }
}
