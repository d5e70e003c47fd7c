// What a board draws: the moments of a world, one after each step, as plain arrays.

import type { Cell, Interaction } from "../engine/types.ts";

export type { Cell };

/** One number or flag for each entry; typed arrays and plain ones both serve. */
export type Numbers = ArrayLike<number>;
export type Flags = ArrayLike<number | boolean>;

/** A world after one step, and that step. Agents are numbered as in the engine, pursuers first. */
export interface Moment {
  /** Row and column of each agent, 2 numbers per agent; where a gone agent disappeared. */
  readonly positions: Numbers;
  /** Whether each agent is in the world. */
  readonly alive: Flags;
  /** Whether each evader is captured at this moment, and whether it ever was. */
  readonly captured: Flags;
  readonly everCaptured: Flags;
  /** The actions of the step that led here. The first moment has none. */
  readonly actions?: Numbers | undefined;
  /** Collisions of that step, 3 flags per agent: obstacle, teammate, adversary. */
  readonly involved?: Flags | undefined;
  readonly fault?: Flags | undefined;
  /** The cells that agents were in conflict over in that step. */
  readonly contested?: readonly Cell[] | undefined;
}

/** An episode: the grid, and its moments. Moment 0 is the start; step t leads to moment t. */
export interface Recording {
  readonly rows: number;
  readonly cols: number;
  readonly nPursuers: number;
  /** Side of the square that an agent sees. */
  readonly fov: number;
  /** The order in which agents move in a step. */
  readonly interaction: Interaction;
  /** 1 for an obstacle, row by row. */
  readonly obstacles: Flags;
  readonly moments: readonly Moment[];
}

/** Change of row and column by each action: stay, N, E, S, W, NE, SE, SW, NW. */
export const MOVES: readonly Cell[] = [
  [0, 0],
  [-1, 0],
  [0, 1],
  [1, 0],
  [0, -1],
  [-1, 1],
  [1, 1],
  [1, -1],
  [-1, -1],
];

/** Return the action that leads from a cell towards another one. */
export function towards(from: Cell, to: Cell, diagonal: boolean): number {
  let down = to[0] - from[0];
  let right = to[1] - from[1];
  if (!diagonal && Math.abs(down) > Math.abs(right)) right = 0;
  else if (!diagonal) down = 0;
  return MOVES.findIndex(([row, col]) => row === Math.sign(down) && col === Math.sign(right));
}

export const isPursuer = (recording: Recording, agent: number): boolean => agent < recording.nPursuers;

export const cellOf = (moment: Moment, agent: number): Cell => [
  moment.positions[2 * agent]!,
  moment.positions[2 * agent + 1]!,
];

export const isCell = ({ rows, cols }: { rows: number; cols: number }, [row, col]: Cell): boolean =>
  row >= 0 && col >= 0 && row < rows && col < cols;

/** Return whether an agent was in any collision of the given flags. */
const inAny = (flags: Flags | undefined, agent: number, kinds = 3): boolean =>
  flags !== undefined && [0, 1, 2].slice(0, kinds).some((kind) => flags[3 * agent + kind]);

export const atFault = (moment: Moment, agent: number): boolean => inAny(moment.fault, agent);

/** Return whether an agent collided without fault. Contact of adversaries is the aim of the game. */
export const innocent = (moment: Moment, agent: number): boolean =>
  !atFault(moment, agent) && inAny(moment.involved, agent, 2);

/** Return whether the step `before` -> `after` held the agent on its cell although it meant to move. */
export function bounced(before: Moment, after: Moment, agent: number): boolean {
  const from = cellOf(before, agent);
  const to = cellOf(after, agent);
  const moved = from[0] !== to[0] || from[1] !== to[1];
  // An agent that a turn before its own has stopped from acting did not collide.
  const collided = after.involved === undefined || inAny(after.involved, agent);
  return Boolean(after.alive[agent] && after.actions?.[agent] && !moved && collided);
}

/** Return the cell that an agent headed for in the step that led to a moment. */
export function target(before: Moment, after: Moment, agent: number): Cell {
  const [row, col] = cellOf(before, agent);
  const [down, right] = MOVES[after.actions?.[agent] ?? 0]!;
  return [row + down, col + right];
}

/** Return the evaders, as agents, that the step `before` -> `after` captured for the first time. */
export function newlyCaptured(recording: Recording, before: Moment, after: Moment): number[] {
  const evaders = Array.from({ length: after.everCaptured.length }, (_, evader) => evader);
  return evaders
    .filter((evader) => after.everCaptured[evader] && !before.everCaptured[evader])
    .map((evader) => recording.nPursuers + evader);
}

/** Return the steps of a recording in which evaders are captured. */
export const captureSteps = (recording: Recording): number[] =>
  recording.moments.flatMap((after, step) =>
    step && newlyCaptured(recording, recording.moments[step - 1]!, after).length ? [step] : [],
  );

/** Return the agents that disappeared in the step `before` -> `after`. */
export function disappeared(before: Moment, after: Moment): number[] {
  const agents = Array.from({ length: after.alive.length }, (_, agent) => agent);
  return agents.filter((agent) => before.alive[agent] && !after.alive[agent]);
}
