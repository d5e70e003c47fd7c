// Perfect play in small worlds: solved while the page is at rest, and what a match loses by other moves.

import type { Tick } from "../board/player.ts";
import type { Engine, Solution, World } from "../engine/engine.ts";
import { whyNotSolved } from "../engine/solution.ts";
import type { TurnGame } from "../engine/solution.ts";
import type { WorldConfig } from "../engine/types.ts";
import { ACTIONS } from "./names.ts";

/** The least loss that is told: smaller ones are shown as 0.00. */
const LEAST = 0.005;
const TEAMS = ["pursuer", "evader"] as const;

const known = new Map<string, Promise<Solution | null>>();

/** Return the solution of a world, which other work of the page can interrupt; null where it is not solved. */
export function solved(engine: Engine, config: WorldConfig): Promise<Solution | null> {
  const key = JSON.stringify({ ...config, rewards: null, fov: null });
  if (!known.has(key)) known.set(key, whyNotSolved(config) ? Promise.resolve(null) : solve(engine, config));
  return known.get(key)!;
}

const rest = (): Promise<void> => new Promise((resolve) => setTimeout(resolve));

async function solve(engine: Engine, config: WorldConfig): Promise<Solution> {
  await rest(); // what is shown now is drawn first
  const solution = engine.solution(config);
  while (solution.goBack()) await rest();
  return solution;
}

/** What a team lost in a step against a perfect opponent: that much of the capture rate. */
export interface Loss {
  readonly step: number;
  readonly team: "pursuer" | "evader";
  readonly lost: number;
}

/** Play actions (A,) step by step in a world at its start, and return the losses. */
export function lossesOf(solution: Solution, world: World, steps: readonly ArrayLike<number>[]): Loss[] {
  return steps.flatMap((actions, at) => {
    const lost = [0, 0];
    for (let turn = world.n_turns; turn > 0 && !world.over; turn--) {
      solution.game(world)?.lost(actions).forEach((part, team) => (lost[team]! += part));
      world.playTurn(actions);
    }
    return TEAMS.map((team, place) => ({ step: at + 1, team, lost: lost[place]! })).filter((each) => each.lost >= LEAST);
  });
}

export const ticksOf = (losses: readonly Loss[]): Tick[] =>
  losses.map((loss) => ({ step: loss.step, kind: loss.team, size: loss.lost, text: lossText(loss) }));

export const lossText = ({ team, lost }: Loss): string => `The ${team}s lose ${lost.toFixed(2)} against a perfect opponent`;

/** Return how an agent plays perfectly, in words, such as "north 0.67, stay 0.33". */
export function perfectText(game: TurnGame, agent: number): string {
  const shares = (game.marginal(agent) ?? []).map((share, action) => ({ share, action })).filter(({ share }) => share >= LEAST);
  return shares.sort((a, b) => b.share - a.share)
    .map(({ share, action }) => (share > 1 - LEAST ? ACTIONS[action] : `${ACTIONS[action]} ${share.toFixed(2)}`)).join(", ");
}
