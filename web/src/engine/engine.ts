/**
 * The engine of matrixworld in a page: the same C++ as the Python package, as WebAssembly.
 *
 *     const engine = await loadEngine();
 *     const world = engine.world(config);
 *     world.reset({ seed: 7n });
 *     world.step([0, 2, 4]);
 *     for (const conflict of world.conflicts()) show(conflict.text);
 *
 *     const episode = engine.match(config, genome, "fleer", seed, 0);
 *     draw(episode.positions, episode.conflicts(1));
 */

import type {
  Answer,
  Conflict,
  EpisodeArrays,
  EpisodeStatistics,
  Snapshot,
  Start,
  TeamPolicy,
  WorldArrays,
  WorldConfig,
} from "./types.ts";

/** Bad input; the message is the engine's own: "<name>: expected X, got Y". */
export class EngineError extends Error {}

/**
 * The engine, once it is loaded. `engine.js` is a classic script that sets the global
 * `matrixworldEngine`; the page holds it in a `<script>` of its own, before the page's script.
 */
export interface Engine {
  /** Make a world, in its first episode of seed 0. Throws EngineError for settings out of range. */
  world(config: WorldConfig): World;

  /**
   * Play one episode and return every moment, as `matrixworld.record` and `SavedRun.record` do.
   * `seed` is the match's seed: that of `evaluation_seed` for a cell of a payoff matrix.
   */
  match(
    config: WorldConfig,
    pursuers: TeamPolicy,
    evaders: TeamPolicy,
    seed: bigint,
    episode?: number,
  ): Match;

  /** Play episodes 0 to n - 1 of a match and return their statistics, as `matrixworld.rollout` does. */
  rollout(
    config: WorldConfig,
    pursuers: TeamPolicy,
    evaders: TeamPolicy,
    seed: bigint,
    n_episodes: number,
  ): EpisodeStatistics[];
}

/** One world, to play and to look at. Arrays that it returns are copies. */
export interface World {
  readonly config: WorldConfig;
  readonly n_agents: number;
  readonly n_actions: number;

  /** Start an episode. The world stays as it was if the start is refused. */
  reset(start?: Start): void;
  /** Play one round with the actions (A,) of all agents; those of gone agents are ignored. */
  step(actions: ArrayLike<number>): void;
  /** Play the next turn of a round; only the actions of the living `actors` are read. */
  playTurn(actions: ArrayLike<number>): void;

  /** Turns in a round: 1 where all agents move at once, 2 for teams, A for single agents. */
  readonly n_turns: number;
  /** Number of the next turn, from 0. */
  readonly turn: number;
  /** The agents [first, last) that act in the next turn. */
  readonly actors: readonly [first: number, last: number];
  readonly steps: number;
  readonly seed: bigint;
  readonly episode: bigint;
  /** Whether the episode has ended, by captures or at max_steps. */
  readonly over: boolean;

  /** Return one array. */
  read<Name extends keyof WorldArrays>(name: Name): WorldArrays[Name];
  /** Return the view of one agent, (3, fov, fov): evaders, pursuers, obstacles. */
  view(agent: number): Uint8Array;
  /** Return the obstacles of this episode, (rows, cols). */
  map(): Uint8Array;
  /** Return the conflicts of the last round (of its turns so far, in the middle of one). */
  conflicts(): Conflict[];

  /**
   * Return the actions (A,) with those that a policy chooses now for the living agents of its team;
   * other entries are those of `actions`. It uses the random numbers of a match for the same seed,
   * episode and step.
   */
  decide(policy: TeamPolicy, team: "pursuer" | "evader", actions: ArrayLike<number>): Uint8Array;
  /** Return what a network answers to the view of a living agent. */
  answer(policy: TeamPolicy, agent: number): Answer;

  /** Return the whole state, from which any world of these settings can go on; or go on from one. */
  snapshot(): Snapshot;
  restore(snapshot: Snapshot): void;

  /** Give the memory back; otherwise that happens some time after the last use. */
  free(): void;
}

/** A recorded episode of T steps. Step t (from 1) leads from moment t - 1 to moment t. */
export interface Match extends EpisodeArrays {
  readonly config: WorldConfig;
  readonly seed: bigint;
  readonly episode: number;
  readonly n_agents: number;
  /** T */
  readonly length: number;
  readonly statistics: EpisodeStatistics;
  /** Return the conflicts of step t, 1 to T; none for the moment 0. */
  conflicts(step: number): Conflict[];
  /** Set a world of the same settings to moment t: the state before step t + 1. */
  seek(world: World, step: number): void;
}

/** Load the engine; later calls return the same one. */
export function loadEngine(): Promise<Engine> {
  return Promise.reject(new EngineError("the engine has no body yet"));
}
