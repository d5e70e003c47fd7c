/** Recorded episodes: what `matrixworld.record` and `matrixworld.rollout` return in Python. */

import { CONFLICT_WIDTH, conflictsOf } from "./conflicts.ts";
import { expected } from "./errors.ts";
import { call, lastOutputs } from "./heap.ts";
import type { Compiled, Inputs, NumberArray, Outputs } from "./heap.ts";
import { configInputs, policyInputs, word } from "./inputs.ts";
import type { Conflict, EpisodeArrays, EpisodeStatistics, TeamPolicy, WorldConfig } from "./types.ts";
import type { World } from "./world.ts";

/** What the names of statistics begin with. */
const STATISTICS = "statistics.";

/** What plays: the settings and the policies of both teams. */
export interface Pair {
  config: WorldConfig;
  pursuers: TeamPolicy;
  evaders: TeamPolicy;
}

export interface Match extends EpisodeArrays {}

/** A recorded episode of T steps. Step t (from 1) leads from moment t - 1 to moment t. */
export class Match {
  readonly config: WorldConfig;
  readonly seed: bigint;
  readonly episode: number;
  readonly n_agents: number;
  readonly statistics: EpisodeStatistics;
  declare private readonly conflict_table: Int32Array;
  private readonly first_conflict: Int32Array; // by step: its first row of the table

  constructor(config: WorldConfig, seed: bigint, episode: number, outputs: Outputs) {
    this.config = config;
    this.seed = seed;
    this.episode = episode;
    this.n_agents = config.n_pursuers + config.n_evaders;
    this.statistics = episodeOf(statisticsIn(outputs));
    Object.assign(this, outputs); // they have the names of the arrays
    this.first_conflict = firstOfSteps(this.conflict_table, this.length);
  }

  /** T */
  get length(): number {
    return this.actions.length / this.n_agents;
  }

  /** Return the conflicts of step t, 1 to T; none for the moment 0. */
  conflicts(step: number): Conflict[] {
    this.check(step);
    const first = this.first_conflict[step]!;
    const last = this.first_conflict[step + 1]!;
    const rows = this.conflict_table.subarray(first * CONFLICT_WIDTH, last * CONFLICT_WIDTH);
    return conflictsOf(rows, this.config.n_pursuers);
  }

  /**
   * Set a world of the same settings to moment t, before step t + 1, with what agents remember for
   * the policies.
   */
  seek(world: World, step: number, policies?: Pick<Pair, "pursuers" | "evaders">): void {
    this.check(step);
    const here = world.seed === this.seed && world.episode === BigInt(this.episode);
    if (!here || world.turn !== 0 || world.steps > step) {
      world.reset({ seed: this.seed, episode: this.episode });
    }
    for (let t = world.steps; t < step; ++t) {
      const actions = this.actions.subarray(t * this.n_agents, (t + 1) * this.n_agents);
      if (policies) world.replay(actions, { pursuer: policies.pursuers, evader: policies.evaders });
      else world.step(actions);
    }
  }

  private check(step: number): void {
    if (Number.isInteger(step) && step >= 0 && step <= this.length) return;
    throw expected("step", `0 to ${this.length}`, step);
  }
}

/** Return the first row of each step 0 to T + 1 in a table of conflicts. */
function firstOfSteps(table: Int32Array, length: number): Int32Array {
  const first = new Int32Array(length + 2);
  for (let at = 0; at < table.length; at += CONFLICT_WIDTH) ++first[table[at]! + 1]!;
  for (let step = 1; step < first.length; ++step) first[step]! += first[step - 1]!;
  return first;
}

/** Return the statistics of one episode: single numbers as such. */
export function episodeOf(statistics: Statistics): EpisodeStatistics {
  const single = ["capture_rate", "ever_capture_rate", "captured_fraction", "length"];
  return Object.fromEntries(
    Object.entries(statistics).map(([name, values]) => [
      name,
      single.includes(name) ? Number(values[0]) : values,
    ]),
  ) as unknown as EpisodeStatistics;
}

/** Return statistics by their own names. */
const statisticsIn = (outputs: Outputs): Statistics =>
  Object.fromEntries(
    Object.entries(outputs).flatMap(([name, array]) =>
      name.startsWith(STATISTICS) ? [[name.slice(STATISTICS.length), array]] : [],
    ),
  ) as unknown as Statistics;

type Play = "_play_match" | "_play_rollout";

function play(engine: Compiled, name: Play, pair: Pair, last: Inputs): Outputs {
  const inputs = [
    configInputs(pair.config),
    policyInputs(pair.pursuers),
    policyInputs(pair.evaders),
    last,
  ] as const;
  call(engine, (block) => {
    const [config, pursuers, evaders, rest] = inputs.map((each) => block.arrays(each)) as [
      ...[number, number, number, number],
    ];
    return engine[name](config, pursuers, evaders, rest);
  });
  return lastOutputs(engine);
}

/** Play one episode and return every moment. */
export function playMatch(engine: Compiled, pair: Pair, seed: bigint, episode: number): Match {
  const key = { seed: word("seed", seed), episode: word("episode", episode) };
  return new Match(pair.config, seed, episode, play(engine, "_play_match", pair, key));
}

/** Matches of a genome of each team's population, by its number, with a seed for each match. */
export interface Matches {
  readonly pursuer: Int32Array;
  readonly evader: Int32Array;
  readonly seed: BigUint64Array;
}

/**
 * The statistics of n episodes of M matches, (M, n, ...) flat: the arrays of
 * `matrixworld.EpisodeStatistics`.
 */
export type Statistics = Readonly<Record<keyof EpisodeStatistics, NumberArray>>;

/** Play episodes 0 to n - 1 of each match; the genomes of a team are one after the other in its policy. */
export function playMatches(engine: Compiled, pair: Pair, matches: Matches, n_episodes: number): Statistics {
  if (!Number.isInteger(n_episodes) || n_episodes < 1) throw expected("n_episodes", "at least 1", n_episodes);
  const outputs = play(engine, "_play_rollout", pair, { ...matches, n_episodes: Int32Array.of(n_episodes) });
  return statisticsIn(outputs);
}
