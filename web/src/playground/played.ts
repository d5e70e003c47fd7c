// A played match: a person in one seat, policies in all others. The page, the file and the link hold it.

import type { Engine } from "../engine/engine.ts";
import { TEAMS } from "../engine/teams.ts";
import type { Team } from "../engine/teams.ts";
import type { TeamPolicy, WorldConfig } from "../engine/types.ts";
import { Live } from "../board/live.ts";

/** What a person did: the agent in the seat and its moves. Those before `from` were its team's own. */
export interface Moves {
  readonly seat: number;
  readonly from: number;
  readonly moves: readonly number[];
}

/** A played match. Everything else that happens follows from it. */
export interface Played extends Moves {
  readonly config: WorldConfig;
  readonly seed: bigint;
  readonly episode: number;
  /** What moves all other agents of each team. */
  readonly policies: Readonly<Record<Team, TeamPolicy>>;
}

/** A policy with the name that readers know it by. */
export interface Player {
  readonly name: string;
  /** What it does. */
  readonly text: string;
  readonly policy: () => TeamPolicy;
}

export const teamOf = (config: WorldConfig, agent: number): Team =>
  TEAMS[Number(agent >= config.n_pursuers)]!;

/** Return the match as far as it was played. */
export function liveOf(engine: Engine, played: Played): Live {
  const live = new Live(engine, played.config, { seed: played.seed, episode: played.episode });
  for (const move of played.moves) {
    if (!live.over) live.step(played.policies, played.seat, move);
  }
  return live;
}

/** What came out for an agent: the steps until it was captured or gone, or of the whole match. */
export interface Result {
  readonly lasted: number;
  readonly out: boolean;
  /** Evaders captured until then. */
  readonly captured: number;
}

export function resultOf(live: Live, agent: number): Result {
  const { moments, nPursuers } = live.recording;
  const found = moments.findIndex(
    ({ alive, captured }) => !alive[agent] || Boolean(captured[agent - nPursuers]),
  );
  const lasted = found < 0 ? live.length : found;
  return {
    lasted,
    out: found >= 0,
    captured: Array.from(moments[lasted]!.everCaptured).filter(Boolean).length,
  };
}

/** Return whether nothing is left to do in a seat. */
export const isDone = (live: Live, seat: number): boolean => live.over || resultOf(live, seat).out;

/** Return what a policy in the seat makes of the same match, from where the person took over. */
export function resultInSeat(engine: Engine, played: Played, policy: TeamPolicy): Result {
  const live = liveOf(engine, { ...played, moves: played.moves.slice(0, played.from) });
  while (!isDone(live, played.seat)) live.step(played.policies, played.seat, policy);
  return resultOf(live, played.seat);
}

/** Return the first player, that after a third, and the last: of 31 generations 0, 10 and 30. */
export function ladder(players: readonly Player[]): Player[] {
  const last = players.length - 1;
  return [...new Set([0, Math.round(last / 3), last])].map((place) => players[place]!);
}

// ---- In a link:  seat=12&from=4&moves=001234

/** Return the address of this page with parts that name a match, and the moves of a person in it. */
export function linkTo(
  place: Readonly<Record<string, string | number | bigint>>,
  { seat, from, moves }: Moves,
): string {
  const parts = { ...place, seat, ...(from ? { from } : {}), moves: moves.join("") };
  return `${location.href.split("#")[0]}#${Object.entries(parts)
    .map(([name, value]) => `${name}=${value}`)
    .join("&")}`;
}

/** Return the moves that the parts of an address hold, or null. A text from elsewhere may hold anything. */
export function movesOf(parts: URLSearchParams, config: WorldConfig): Moves | null {
  const seat = parts.get("seat") ?? "";
  const from = parts.get("from") ?? "0";
  const text = parts.get("moves") ?? "";
  const valid =
    /^\d{1,6}$/.test(seat) &&
    Number(seat) < config.n_pursuers + config.n_evaders &&
    (config.diagonal ? /^[0-8]+$/ : /^[0-4]+$/).test(text) &&
    text.length <= config.max_steps &&
    /^\d{1,6}$/.test(from) &&
    Number(from) <= text.length;
  return valid ? { seat: Number(seat), from: Number(from), moves: [...text].map(Number) } : null;
}

export const randomSeed = (): bigint => crypto.getRandomValues(new BigUint64Array(1))[0]!;

/** Starts of which a game takes the one whose nearest opponent is the farthest. */
const STARTS = 8;

/** Return a random seed whose match does not begin with an opponent beside the person. */
export function fairSeed(engine: Engine, config: WorldConfig, seat: number): bigint {
  const { n_pursuers, n_evaders } = config;
  const others = Array.from({ length: n_pursuers + n_evaders }, (_, agent) => agent).filter(
    (agent) => teamOf(config, agent) !== teamOf(config, seat),
  );
  const nearest = (seed: bigint): number => {
    const cells = new Live(engine, config, { seed }).recording.moments[0]!.positions;
    const away = (axis: number, other: number): number =>
      Math.abs(cells[2 * seat + axis]! - cells[2 * other + axis]!);
    return Math.min(...others.map((other) => away(0, other) + away(1, other)));
  };
  const seeds = Array.from({ length: STARTS }, randomSeed).map((seed) => [seed, nearest(seed)] as const);
  return seeds.reduce((best, each) => (each[1] > best[1] ? each : best))[0];
}
