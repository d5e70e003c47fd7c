// A scene: all that the page shows follows from it. Scenes never change; edits return new ones.

import { agentName as nameOf } from "../page/names.ts";
import type { Cell, Rewards, Rules, ScriptName, WorldConfig } from "../engine/types.ts";

/** Stands for the network of an agent's team, in a scene from the explorer. */
export const CHAMPION = "champion";

/** What an agent does in a step: an action, 0 to 8, or what a script or its team's network decides. */
export type Command = number | ScriptName | typeof CHAMPION;

/** An agent at the start. One that is gone stands where it disappeared. */
export interface Start {
  readonly cell: Cell;
  readonly gone: boolean;
  /** Only of evaders: captured at this moment, and at any time until now. */
  readonly captured: boolean;
  readonly everCaptured: boolean;
}

export interface Scene {
  readonly rules: Rules;
  /** Rules to compare with: the same start and commands are played by both. */
  readonly others: Rules | null;
  readonly rewards: Rewards;
  readonly rows: number;
  readonly cols: number;
  readonly diagonal: boolean;
  readonly fov: number;
  readonly maxSteps: number;
  /** What random numbers depend on, with the number of steps before the start. */
  readonly seed: bigint;
  readonly episode: bigint;
  readonly steps: number;
  /** Whether the episode had ended at the start. */
  readonly ended: boolean;
  /** Obstacles, row * cols + col, ascending. */
  readonly walls: readonly number[];
  readonly pursuers: readonly Start[];
  readonly evaders: readonly Start[];
  /** What all agents did in each step since the start, and what they do next. */
  readonly played: readonly (readonly Command[])[];
  readonly next: readonly Command[];
}

export const STAY = 0;
export const MOST_SIDE = 64;
export const MOST_AGENTS = 100;
export const MOST_STEPS = 300;

export type Team = "pursuers" | "evaders";

/** An agent that stands on a cell at the beginning of an episode. */
export const standing = (cell: Cell): Start => ({ cell, gone: false, captured: false, everCaptured: false });

export const agents = (scene: Scene): readonly Start[] => [...scene.pursuers, ...scene.evaders];

export const nAgents = (scene: Scene): number => scene.pursuers.length + scene.evaders.length;

export const teamOf = (scene: Scene, agent: number): Team =>
  agent < scene.pursuers.length ? "pursuers" : "evaders";

export const agentName = (scene: Scene, agent: number): string => nameOf(agent, scene.pursuers.length);

export const sameRules = (a: Rules, b: Rules): boolean =>
  (Object.keys(a) as (keyof Rules)[]).every((name) => a[name] === b[name]);

/** Return the name of the variant that has these rules, or null. */
export function variantOf(rules: Rules, variants: Readonly<Record<string, Rules>>): string | null {
  return Object.keys(variants).find((name) => sameRules(variants[name]!, rules)) ?? null;
}

/** Return a map with walls on cells row * cols + col: rows of "." and "#". */
export function mapOf(walls: readonly number[], rows: number, cols: number): string[] {
  const found = new Set(walls);
  return Array.from({ length: rows }, (_, row) =>
    Array.from({ length: cols }, (_none, col) => (found.has(row * cols + col) ? "#" : ".")).join(""),
  );
}

/** Return walls with a cell added or taken away, ascending. */
export function withCell(walls: readonly number[], cell: number, wall: boolean): readonly number[] {
  const left = walls.filter((each) => each !== cell);
  return wall ? [...left, cell].sort((a, b) => a - b) : left;
}

/** Return the settings of the world of a scene under some rules. */
export function configOf(scene: Scene, rules: Rules): WorldConfig {
  const { rows, cols, fov, diagonal, rewards } = scene;
  return {
    rules,
    rows,
    cols,
    n_pursuers: scene.pursuers.length,
    n_evaders: scene.evaders.length,
    fov,
    diagonal,
    max_steps: scene.maxSteps,
    obstacles: mapOf(scene.walls, rows, cols),
    rewards,
  };
}

// Edits that keep what was played, because the same commands are played again:

export const withNext = (scene: Scene, agent: number, command: Command): Scene => ({
  ...scene,
  next: scene.next.map((old, each) => (each === agent ? command : old)),
});

/** Add a step. Scripts go on; actions are made once, so that the next step starts from rest. */
export const stepped = (scene: Scene): Scene => ({
  ...scene,
  played: [...scene.played, scene.next],
  next: scene.next.map((command) => (typeof command === "number" ? STAY : command)),
});

/** Take the last step back: what agents did in it is what they do next. */
export const steppedBack = (scene: Scene): Scene => ({
  ...scene,
  played: scene.played.slice(0, -1),
  next: scene.played.at(-1) ?? scene.next,
});

// Edits of the board. They begin a new start: `now` is the scene whose start is the present moment.

export function moved(now: Scene, agent: number, cell: Cell): Scene {
  const change = (team: readonly Start[], own: number): readonly Start[] =>
    team.map((start, each) => (each === own ? { ...start, cell } : start));
  return {
    ...now,
    pursuers: change(now.pursuers, agent),
    evaders: change(now.evaders, agent - now.pursuers.length),
  };
}

export function added(now: Scene, team: Team, cell: Cell): Scene {
  const at = team === "pursuers" ? now.pursuers.length : nAgents(now);
  return {
    ...now,
    [team]: [...now[team], standing(cell)],
    next: [...now.next.slice(0, at), STAY, ...now.next.slice(at)],
    ended: false,
  };
}

export function removed(now: Scene, agent: number): Scene {
  const team = teamOf(now, agent);
  const own = team === "pursuers" ? agent : agent - now.pursuers.length;
  return {
    ...now,
    [team]: now[team].filter((_, each) => each !== own),
    next: now.next.filter((_, each) => each !== agent),
  };
}

export const withWall = (now: Scene, [row, col]: Cell, wall: boolean): Scene => ({
  ...now,
  walls: withCell(now.walls, row * now.cols + col, wall),
});

/** Change the size of the grid; what lies outside goes. */
export function resized(now: Scene, rows: number, cols: number): Scene {
  const inside = ([row, col]: Cell): boolean => row < rows && col < cols;
  const kept = agents(now).map(({ cell }) => inside(cell));
  return {
    ...now,
    rows,
    cols,
    walls: now.walls
      .map((index): Cell => [Math.floor(index / now.cols), index % now.cols])
      .filter(inside)
      .map(([row, col]) => row * cols + col),
    pursuers: now.pursuers.filter((_, agent) => kept[agent]),
    evaders: now.evaders.filter((_, evader) => kept[now.pursuers.length + evader]),
    next: now.next.filter((_, agent) => kept[agent]),
  };
}

/** Return the agent alive on a cell, or null. */
export function agentOn(now: Scene, [row, col]: Cell): number | null {
  const found = agents(now).findIndex(({ cell, gone }) => !gone && cell[0] === row && cell[1] === col);
  return found < 0 ? null : found;
}

export const isWall = (now: Scene, [row, col]: Cell): boolean => now.walls.includes(row * now.cols + col);

/** Return a free cell near the middle of the grid, or null if it is full. */
export function freeCell(now: Scene): Cell | null {
  const cells = Array.from({ length: now.rows * now.cols }, (_, i): Cell => [
    Math.floor(i / now.cols),
    i % now.cols,
  ]);
  const distance = ([row, col]: Cell): number =>
    Math.abs(row - (now.rows - 1) / 2) + Math.abs(col - (now.cols - 1) / 2);
  const free = cells.filter((cell) => agentOn(now, cell) === null && !isWall(now, cell));
  return free.length ? free.reduce((a, b) => (distance(b) < distance(a) ? b : a)) : null;
}
