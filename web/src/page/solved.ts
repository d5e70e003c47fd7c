// Perfect play in small worlds: solved while the page is at rest, and what a match loses by other moves.

import type { Tick } from "../board/player.ts";
import type { Engine, Solution, World } from "../engine/engine.ts";
import { HORIZON, whyNotSolved } from "../engine/solution.ts";
import type { Payoff, TurnGame } from "../engine/solution.ts";
import { TEAMS } from "../engine/teams.ts";
import type { Team } from "../engine/teams.ts";
import type { WorldConfig } from "../engine/types.ts";
import { ACTIONS } from "./names.ts";

/**
 * The least probability or capture rate that is told, and the least number of steps: smaller ones
 * are shown as 0.
 */
const LEAST = 0.005;
const LEAST_STEPS = 0.05;

/** The most solutions that are kept: each may take 30 MB. */
const MOST_KEPT = 4;
const known = new Map<string, Promise<Solution | null>>();

/**
 * Return the solution of a world, which other work of the page can interrupt; null where it is not
 * solved.
 */
export function solved(
  engine: Engine,
  config: WorldConfig,
  payoff: Payoff = "capture-rate",
): Promise<Solution | null> {
  const key = JSON.stringify([{ ...config, rewards: null }, payoff]);
  const found =
    known.get(key) ?? (whyNotSolved(config) ? Promise.resolve(null) : solve(engine, config, payoff));
  known.delete(key); // it becomes the newest
  known.set(key, found);
  if (known.size > MOST_KEPT) known.delete([...known.keys()][0]!);
  return found;
}

/**
 * What perfect play is for where a person plays: with one evader the steps that it lasts, which are
 * the score.
 */
export const scoreOf = ({ n_evaders }: WorldConfig): Payoff =>
  n_evaders === 1 ? "capture-time" : "capture-rate";

const rest = (): Promise<void> => new Promise((resolve) => setTimeout(resolve));

async function solve(engine: Engine, config: WorldConfig, payoff: Payoff): Promise<Solution> {
  await rest(); // what is shown now is drawn first
  const solution = engine.solution(config, payoff);
  while (solution.goBack()) await rest();
  return solution;
}

/** What a team lost in a step against a perfect opponent: that much of the capture rate, or so many steps. */
export interface Loss {
  readonly step: number;
  readonly team: Team;
  readonly lost: number;
  readonly payoff: Payoff;
}

/** Play actions (A,) step by step in a world at its start, and return the losses. */
export function lossesOf(solution: Solution, world: World, steps: readonly ArrayLike<number>[]): Loss[] {
  const { payoff } = solution;
  return steps.flatMap((actions, at) => {
    const lost = [0, 0];
    for (let turn = world.n_turns; turn > 0 && !world.over; turn--) {
      solution
        .game(world)
        ?.lost(actions)
        .forEach((part, team) => (lost[team]! += part));
      world.playTurn(actions);
    }
    const least = payoff === "capture-rate" ? LEAST : LEAST_STEPS;
    return TEAMS.map((team, place) => ({ step: at + 1, team, lost: lost[place]!, payoff })).filter(
      (each) => each.lost >= least,
    );
  });
}

export const ticksOf = (losses: readonly Loss[]): Tick[] =>
  losses.map((loss) => ({
    step: loss.step,
    kind: loss.team,
    size: loss.lost / Math.max(1, ...losses.map(({ lost }) => lost)),
    text: lossText(loss),
  }));

const amount = ({ lost, payoff }: Loss): string =>
  payoff === "capture-rate" ? `${lost.toFixed(2)} of the capture rate` : `${lost.toFixed(1)} steps`;

export const lossText = (loss: Loss): string =>
  `The ${loss.team}s lose ${amount(loss)} against a perfect opponent`;

/**
 * Return a team's worst step in words. Losses do not add up: an imperfect opponent gives some of
 * them back.
 */
export function worstText(losses: readonly Loss[]): string {
  const worst = losses.reduce((a, b) => (b.lost > a.lost ? b : a));
  return `Your team's worst moves, in step ${worst.step}, lost ${amount(worst)} against a perfect opponent.`;
}

/** Return what a moment is worth, such as "value 0.57". */
export function worthText({ config, payoff }: Solution, { value }: TurnGame, step: number): string {
  if (payoff === "capture-rate") return `value ${value.toFixed(2)}`;
  const rounds = 1 - value;
  const most = Math.min(config.max_steps - step, HORIZON); // with this one
  return rounds > most - LEAST_STEPS ? `free for ${most} steps` : `captured after ${rounds.toFixed(1)} steps`;
}

/** Return how an agent plays perfectly, in words, such as "north 0.67, stay 0.33". */
export function perfectText(game: TurnGame, agent: number): string {
  const shares = (game.marginal(agent) ?? [])
    .map((share, action) => ({ share, action }))
    .filter(({ share }) => share >= LEAST);
  return shares
    .sort((a, b) => b.share - a.share)
    .map(({ share, action }) =>
      share > 1 - LEAST ? ACTIONS[action] : `${ACTIONS[action]} ${share.toFixed(2)}`,
    )
    .join(", ");
}
