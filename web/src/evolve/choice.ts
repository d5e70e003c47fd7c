// What a person has chosen, and the settings of the race that follow from it. A link holds the choice.

import type { EvolveData, LearnerName } from "./data.ts";
import { SCHEDULES, scheduleOf } from "./data.ts";
import type { RaceSettings } from "./settings.ts";

export interface Choice {
  readonly schedule: string;
  /** The schedule of a second race beside it; null for none. */
  readonly beside: string | null;
  readonly learner: LearnerName;
  readonly seed: number;
  readonly pursuers: number;
  readonly evaders: number;
  readonly view: number;
  /** Whether agents have right of way, so that none is ever at fault. */
  readonly way: boolean;
  /** Candidates of an epoch; 0 for the usual number. */
  readonly population: number;
  readonly steps: number;
  /** The cells that are walls, row by row. */
  readonly walls: readonly number[];
}

export const MOST_AGENTS = 10;
export const MOST_SEED = 999_999;
export const VIEWS = [3, 5, 7, 9] as const;
/** The smallest view that shows all that right of way asks for. */
export const LEAST_VIEW = 5;
export const POPULATIONS = [8, 16, 32, 64] as const;
export const STEPS = [30, 60, 90, 120] as const;
/** The largest share of walls. */
const MOST_WALLS = 0.5;

/** Return the choice with which the page begins. */
export function usualChoice(data: EvolveData): Choice {
  const first = Object.values(data.races.es).find((race) => scheduleOf(race) === "generalist-generalist")!;
  const { world, seed } = first;
  return {
    schedule: scheduleOf(first), beside: null, learner: "es", seed, pursuers: world.n_pursuers, evaders: world.n_evaders,
    view: world.fov, way: false, population: 0, steps: world.max_steps, walls: [],
  };
}

/** Return the settings of the race that is chosen, or of the one beside it. */
export function settingsOf(data: EvolveData, choice: Choice, schedule = choice.schedule): RaceSettings {
  const base = data.races[choice.learner][schedule]!;
  const { rows, cols } = base.world;
  const walls = new Set(choice.walls);
  const map = Array.from({ length: rows }, (_, row) => Array.from({ length: cols }, (_none, col) => (walls.has(row * cols + col) ? "#" : ".")).join(""));
  const world = {
    ...base.world, n_pursuers: choice.pursuers, n_evaders: choice.evaders, fov: choice.view, max_steps: choice.steps,
    obstacles: walls.size ? map : base.world.obstacles,
  };
  return {
    ...base, world, train_steps: choice.steps, seed: choice.seed,
    policy: { ...base.policy, mask: choice.way ? "right-of-way" : "none" },
    learner: { ...base.learner, population: choice.population || base.learner.population },
  };
}

/** Return the walls with a cell added or taken away; the same ones if there would be too many. */
export function withWall(walls: readonly number[], cell: number, wall: boolean, cells: number): readonly number[] {
  const left = walls.filter((each) => each !== cell);
  return !wall ? left : left.length < MOST_WALLS * cells ? [...left, cell].sort((a, b) => a - b) : walls;
}

/** Return the part of an address that holds a choice. */
export function linkOf(choice: Choice): string {
  const { walls, way, beside, ...rest } = choice;
  const parts = { ...rest, ...(beside ? { beside } : {}), ...(way ? { way: 1 } : {}), ...(walls.length ? { walls: walls.join(".") } : {}) };
  return Object.entries(parts).map(([name, value]) => `${name}=${value}`).join("&");
}

/** Return the choice that an address holds; what is missing or not valid is as usual. */
export function choiceOf(data: EvolveData, hash: string): Choice {
  const usual = usualChoice(data);
  const parts = new URLSearchParams(hash.replace(/^#/, ""));
  const number = (name: keyof Choice & string, valid: (value: number) => boolean): number => {
    const given = parts.get(name) ?? "";
    return /^\d{1,6}$/.test(given) && valid(Number(given)) ? Number(given) : (usual[name] as number);
  };
  const schedule = (name: string): string | null => (Object.hasOwn(SCHEDULES, parts.get(name) ?? "") ? parts.get(name) : null);
  const { rows, cols } = data.races.es[usual.schedule]!.world;
  const walls = (parts.get("walls") ?? "").split(".").filter((each) => /^\d{1,4}$/.test(each)).map(Number);
  const view = number("view", (value) => VIEWS.includes(value as 3));
  const way = parts.get("way") === "1";
  return {
    schedule: schedule("schedule") ?? usual.schedule, beside: schedule("beside"),
    learner: parts.get("learner") === "ga" ? "ga" : usual.learner,
    seed: number("seed", (value) => value <= MOST_SEED),
    pursuers: number("pursuers", (value) => value >= 1 && value <= MOST_AGENTS),
    evaders: number("evaders", (value) => value >= 1 && value <= MOST_AGENTS),
    view: way ? Math.max(LEAST_VIEW, view) : view, way,
    population: number("population", (value) => POPULATIONS.includes(value as 8)),
    steps: number("steps", (value) => STEPS.includes(value as 30)),
    walls: walls.filter((cell) => cell < rows * cols).reduce<readonly number[]>((all, cell) => withWall(all, cell, true, rows * cols), []),
  };
}
