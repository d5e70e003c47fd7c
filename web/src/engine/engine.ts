/**
 * The engine of matrixworld in a page: the same C++ as the Python package, as WebAssembly.
 *
 *     const engine = await loadEngine();
 *     const world = engine.world(config);
 *     world.reset({ seed: 7n });
 *     world.step([0, 2, 4]);
 *     for (const conflict of world.conflicts()) show(conflict.text);
 *
 *     const episode = engine.match(config, network, "fleer", seed, 0);
 *     draw(episode.positions, episode.conflicts(1));
 */

import type { Compiled } from "./heap.ts";
import { Match, playMatch, playMatches } from "./match.ts";
import type { Matches, Statistics } from "./match.ts";
import { Solution } from "./solution.ts";
import type { Payoff } from "./solution.ts";
import type { TeamPolicy, WorldConfig } from "./types.ts";
import { World } from "./world.ts";

export { agentName } from "./conflicts.ts";
export { EngineError } from "./errors.ts";
export { Match } from "./match.ts";
export type { Matches, Statistics } from "./match.ts";
export { Solution } from "./solution.ts";
export { World } from "./world.ts";

/** What the script engine.js sets: a function that starts the compiled engine from its binary. */
export interface CompiledFactory {
  (options: { wasmBinary: Uint8Array }): Promise<Compiled>;
  /** The binary as base64. */
  readonly binary: string;
}

declare global {
  var matrixworldEngine: CompiledFactory | undefined;
}

/** The engine, once it is loaded. */
export class Engine {
  private readonly compiled: Compiled;

  constructor(compiled: Compiled) {
    this.compiled = compiled;
  }

  /** Make a world, in its first episode of seed 0. Throws EngineError for settings out of range. */
  world(config: WorldConfig): World {
    return new World(this.compiled, config);
  }

  /** Begin to solve a world that `whyNotSolved` has nothing against. */
  solution(config: WorldConfig, payoff: Payoff = "capture-rate"): Solution {
    return new Solution(this.compiled, config, payoff);
  }

  /**
   * Play one episode and return every moment, as `matrixworld.record` and `SavedRun.record` do.
   * `seed` is the match's seed: that of `evaluation_seed` for a cell of a payoff matrix.
   */
  match(config: WorldConfig, pursuers: TeamPolicy, evaders: TeamPolicy, seed: bigint, episode = 0): Match {
    return playMatch(this.compiled, { config, pursuers, evaders }, seed, episode);
  }

  /**
   * Play episodes 0 to n - 1 of matches, as `matrixworld.rollout` does; a policy's `genome` holds
   * those of a population, one after the other.
   */
  rollouts(
    config: WorldConfig,
    pursuers: TeamPolicy,
    evaders: TeamPolicy,
    matches: Matches,
    n_episodes: number,
  ): Statistics {
    return playMatches(this.compiled, { config, pursuers, evaders }, matches, n_episodes);
  }
}

let loaded: Promise<Engine> | undefined;

/**
 * Load the engine; later calls return the same one. `engine.js` is a classic script that sets the
 * global `matrixworldEngine`; a page holds it in a `<script>` of its own, before the page's script.
 */
export function loadEngine(factory = globalThis.matrixworldEngine): Promise<Engine> {
  loaded ??= start(factory);
  return loaded;
}

async function start(factory: CompiledFactory | undefined): Promise<Engine> {
  if (!factory) throw new Error("matrixworldEngine: expected the script engine.js before this one, got none");
  const wasmBinary = Uint8Array.from(atob(factory.binary), (character) => character.charCodeAt(0));
  return new Engine(await factory({ wasmBinary }));
}
