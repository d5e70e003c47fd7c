/**
 * Small worlds solved, by the solver of the Python package: see `matrixworld.solve`.
 *
 *     const solution = new Solution(compiled, config);
 *     while (solution.goBack()) await a moment;
 *     solution.game(world)?.value;
 */

import { call, lastOutputs } from "./heap.ts";
import type { Compiled, Inputs, Outputs } from "./heap.ts";
import { configInputs } from "./inputs.ts";
import type { WorldConfig } from "./types.ts";
import type { World } from "./world.ts";

/** The most successors that the states of a world may have together, for a page to solve it. */
export const MOST_SUCCESSORS = 7_000_000;

const released = new FinalizationRegistry<readonly [Compiled, number]>(([engine, states]) =>
  engine._states_free(states),
);

/** Return at most how many successors the states have, as `matrixworld.solve.states.size_of` counts them. */
function successorsOf({
  rules,
  rows,
  cols,
  obstacles,
  diagonal,
  n_pursuers,
  n_evaders,
}: WorldConfig): number {
  const walls =
    typeof obstacles === "number" || rules.obstacle === "REACH"
      ? 0
      : obstacles.join("").split("#").length - 1;
  const free = rows * cols - walls;
  const dies = [rules.obstacle, rules.teammate, rules.pursuer].includes("DISAPPEAR");
  const lives_on = rules.capture === "SURROUND" || rules.evader === "REACH";
  const one_by_one = rules.interaction === "AGENT_TURNS";
  const ways = (n: number, k: number): number =>
    Array.from({ length: k }, (_, i) => (one_by_one ? n : (n + i) / (i + 1))).reduce((a, b) => a * b, 1);
  const count = ways(free + Number(dies), n_pursuers) * ways(free * (1 + Number(lives_on)) + 2, n_evaders);
  const acting = {
    SIMULTANEOUS: [n_pursuers + n_evaders],
    SWARM_TURNS: [n_pursuers, n_evaders],
    AGENT_TURNS: Array<number>(n_pursuers + n_evaders).fill(1),
  };
  return acting[rules.interaction].reduce((sum, agents) => sum + count * (diagonal ? 9 : 5) ** agents, 0);
}

/** Return why a page does not solve a world; empty if it does. */
export function whyNotSolved(config: WorldConfig): string {
  if (typeof config.obstacles === "number" && config.obstacles > 0) {
    return "obstacles are drawn anew in each episode";
  }
  return successorsOf(config) > MOST_SUCCESSORS ? "the world is too large to be solved on the page" : "";
}

/** The game of one turn at a moment: all that the teams can do, and what it leads to. */
export class TurnGame {
  /**
   * What both teams guarantee from here on when they play perfectly: the capture rate, or minus the
   * rounds after this one.
   */
  readonly value: number;
  /**
   * Of the pursuers and of the evaders: the agents that act, and the probabilities of their joint
   * actions.
   */
  readonly teams: readonly { readonly agents: readonly number[]; readonly play: Float64Array }[];
  private readonly matrix: Float64Array; // values of what follows, (pursuers' joint actions, evaders')
  private readonly n_actions: number;

  constructor(world: World, found: Outputs) {
    const { matrix, rows, cols, value, agents } = found as { [name: string]: Float64Array };
    const [first, last] = world.actors;
    const acting = Array.from(agents!).filter((agent) => first <= agent && agent < last);
    const pursues = (agent: number): boolean => agent < world.config.n_pursuers;
    this.value = value![0]!;
    this.matrix = matrix!;
    this.n_actions = world.n_actions;
    this.teams = [
      { agents: acting.filter(pursues), play: rows! },
      { agents: acting.filter((agent) => !pursues(agent)), play: cols! },
    ];
  }

  /**
   * Return with which probabilities an agent takes each action when its team plays perfectly; null
   * if it does not act.
   */
  marginal(agent: number): number[] | null {
    const team = this.teams.find(({ agents }) => agents.includes(agent));
    if (!team) return null;
    const weight = this.n_actions ** (team.agents.length - 1 - team.agents.indexOf(agent));
    const sums = Array<number>(this.n_actions).fill(0);
    team.play.forEach((share, joint) => (sums[Math.floor(joint / weight) % this.n_actions]! += share));
    return sums;
  }

  /** Return what the pursuers and the evaders lose by actions (A,) against a perfect opponent. */
  lost(actions: ArrayLike<number>): [pursuers: number, evaders: number] {
    const [row, col] = this.teams.map(({ agents }) =>
      agents.reduce((joint, agent) => joint * this.n_actions + actions[agent]!, 0),
    ) as [number, number];
    const [rows, cols] = this.teams.map(({ play }) => play) as [Float64Array, Float64Array];
    const against = cols.reduce((sum, share, at) => sum + share * this.matrix[row * cols.length + at]!, 0);
    const conceded = rows.reduce((sum, share, at) => sum + share * this.matrix[at * cols.length + col]!, 0);
    return [Math.max(0, this.value - against), Math.max(0, conceded - this.value)];
  }
}

/** What the teams play for: the capture rate at the end, or the rounds until all evaders are captured. */
export type Payoff = "capture-rate" | "capture-time";
/** Rounds that perfect play for time looks ahead: it may gain by every further one. */
export const HORIZON = 60;

/** Values of all moments of a small world, by backward induction. */
export class Solution {
  readonly config: WorldConfig;
  readonly payoff: Payoff;
  private readonly engine: Compiled;
  private readonly states: number;
  private readonly n_turns: number;
  /** By rounds left, values of the states of each turn; more rounds have the values of the last row. */
  private readonly values: Float64Array[][];

  /** List the states; no rounds are known yet. */
  constructor(engine: Compiled, config: WorldConfig, payoff: Payoff) {
    this.engine = engine;
    this.config = config;
    this.payoff = payoff;
    this.states = call(engine, (block) => engine._states_new(block.arrays(configInputs(config))));
    released.register(this, [engine, this.states]);
    const turns = { SIMULTANEOUS: 1, SWARM_TURNS: 2, AGENT_TURNS: config.n_pursuers + config.n_evaders };
    this.n_turns = turns[config.rules.interaction];
    const { payoffs } = this.call(() => engine._states_payoffs(this.states));
    const rates = payoffs as Float64Array;
    this.values = [[payoff === "capture-rate" ? rates : rates.fill(0)]];
  }

  /** Go back by one more round; return whether there are more to come. */
  goBack(): boolean {
    const before = this.values.at(-1)![0]!;
    const row: Float64Array[] = [];
    for (let turn = this.n_turns - 1; turn >= 0; turn--) {
      const next = row[turn + 1] ?? before;
      row[turn] = this.backup(turn, { next });
    }
    if (this.payoff === "capture-time") {
      row[0] = row[0]!.map((value, state) => (state === this.config.n_evaders ? 0 : value - 1));
    }
    this.values.push(row);
    const rounds =
      this.payoff === "capture-rate" ? this.config.max_steps : Math.min(this.config.max_steps, HORIZON);
    return this.values.length <= rounds && row[0]!.some((value, state) => value !== before[state]);
  }

  private backup(turn: number, given: Inputs): Float64Array {
    return this.call((block) => this.engine._states_backup(this.states, turn, block.arrays(given)))[
      "values"
    ] as Float64Array;
  }

  /**
   * Return the game of a world's next turn; null at an end, and where no start on distinct free
   * cells leads.
   */
  game(world: World): TurnGame | null {
    const left = this.config.max_steps - world.steps;
    const { turn } = world;
    const last = turn + 1 === this.n_turns;
    const next =
      left > 0
        ? this.values[Math.min(left - Number(last), this.values.length - 1)]?.[last ? 0 : turn + 1]
        : undefined;
    if (!next) return null;
    const found = this.call((block) =>
      this.engine._states_game(this.states, world.address, block.arrays({ next })),
    );
    return found["agents"]!.length ? new TurnGame(world, found) : null;
  }

  private call(invoke: Parameters<typeof call>[1]): Outputs {
    call(this.engine, invoke);
    return lastOutputs(this.engine);
  }
}
