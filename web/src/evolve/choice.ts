// What a person has chosen, and the settings of the race that follow from it. A link holds the choice.

import type { WorldConfig } from "../engine/types.ts";
import { mapOf, withCell } from "../playground/scene.ts";
import type { EvolveData, LearnerName } from "./data.ts";
import { SCHEDULES, scheduleOf } from "./data.ts";
import type { RaceSettings } from "./settings.ts";

export interface Choice extends Readonly<Record<"seed" | "pursuers" | "evaders" | "view" | "steps", number>> {
  readonly schedule: string;
  /** The schedule of a second race beside it; null for none. */
  readonly beside: string | null;
  readonly learner: LearnerName;
  /** Whether a genome has weights of named inputs; otherwise it is a network over cells. */
  readonly ratings: boolean;
  /** Whether agents have right of way, so that none is ever at fault. */
  readonly way: boolean;
  /** Candidates of an epoch; 0 for the usual number. */
  readonly population: number;
  /** The cells that are walls, row by row. */
  readonly walls: readonly number[];
}

export const MOST_AGENTS = 10;
export const MOST_SEED = 999_999;
export const VIEWS = [3, 5, 7, 9, 11] as const;
/** The smallest view that shows all that right of way asks for. */
export const LEAST_VIEW = 5;
export const POPULATIONS = [8, 16, 32, 64] as const;
export const STEPS = [6, 10, 30, 60, 90, 120] as const;

/** Return the choice with which the page begins. */
export function usualChoice(data: EvolveData): Choice {
  const first = Object.values(data.races.es).find((race) => scheduleOf(race) === "generalist-generalist")!;
  const { n_pursuers, n_evaders, fov, max_steps } = first.world;
  return {
    schedule: scheduleOf(first), beside: null, learner: "es", ratings: false, seed: first.seed, way: false, population: 0,
    pursuers: n_pursuers, evaders: n_evaders, view: fov, steps: max_steps, walls: [],
  };
}

/** Return the world of a choice, without what it changes. */
export const worldOf = (data: EvolveData): WorldConfig => Object.values(data.races.es)[0]!.world;

/** Return the settings of the race that is chosen, or of the one beside it. */
export function settingsOf(data: EvolveData, choice: Choice, schedule = choice.schedule): RaceSettings {
  const base = data.races[choice.learner][schedule]!;
  const usual = worldOf(data);
  const world = {
    ...usual, n_pursuers: choice.pursuers, n_evaders: choice.evaders, fov: choice.view, max_steps: choice.steps,
    obstacles: choice.walls.length ? mapOf(choice.walls, usual.rows, usual.cols) : usual.obstacles,
  };
  return {
    ...base, world, train_steps: choice.steps, seed: choice.seed,
    policy: choice.ratings ? { ...data.ratings, mask: choice.way ? "right-of-way" : "obstacles" }
      : { ...base.policy, mask: choice.way ? "right-of-way" : "none" } as RaceSettings["policy"],
    learner: { ...base.learner, population: choice.population || base.learner.population },
  };
}

/** Return why a map cannot be played on; empty if it can. */
export function whyNotPlayed({ walls, pursuers, evaders }: Choice, { rows, cols }: WorldConfig): string {
  const free = new Set(Array.from({ length: rows * cols }, (_, cell) => cell).filter((cell) => !walls.includes(cell)));
  if (free.size < pursuers + evaders) return `There is no room: ${pursuers + evaders} agents need a free cell each.`;
  const found = [Math.min(...free)]; // the cells that can be reached from the first one
  free.delete(found[0]!);
  for (const cell of found) {
    const col = cell % cols;
    const beside = [cell - cols, cell + cols, ...(col > 0 ? [cell - 1] : []), ...(col < cols - 1 ? [cell + 1] : [])];
    found.push(...beside.filter((each) => free.delete(each)));
  }
  return free.size ? "Nobody may be walled in: all free cells have to be connected, side by side." : "";
}

/** Return the part of an address that holds a choice. */
export function linkOf(choice: Choice): string {
  const { walls, way, ratings, beside, ...rest } = choice;
  const parts = { ...rest, ...(beside ? { beside } : {}), ...(way ? { way: 1 } : {}), ...(ratings ? { ratings: 1 } : {}), ...(walls.length ? { walls: walls.join(".") } : {}) };
  return Object.entries(parts).map(([name, value]) => `${name}=${value}`).join("&");
}

/** Return the choice that an address holds; what is missing or not valid is as usual. */
export function choiceOf(data: EvolveData, hash: string): Choice {
  const parts = new URLSearchParams(hash.replace(/^#/, ""));
  const usual = usualChoice(data);
  const number = (name: keyof Choice & string, valid: (value: number) => boolean): number => {
    const given = parts.get(name) ?? "";
    return /^\d{1,6}$/.test(given) && valid(Number(given)) ? Number(given) : (usual[name] as number);
  };
  const schedule = (name: string): string | null => (Object.hasOwn(SCHEDULES, parts.get(name) ?? "") ? parts.get(name) : null);
  const world = worldOf(data);
  const walls = (parts.get("walls") ?? "").split(".").filter((each) => /^\d{1,4}$/.test(each)).map(Number);
  const view = number("view", (value) => VIEWS.includes(value as 3));
  const way = parts.get("way") === "1";
  const choice = {
    schedule: schedule("schedule") ?? usual.schedule, beside: schedule("beside"),
    learner: parts.get("learner") === "ga" ? "ga" : usual.learner, ratings: parts.get("ratings") === "1",
    seed: number("seed", (value) => value <= MOST_SEED),
    pursuers: number("pursuers", (value) => value >= 1 && value <= MOST_AGENTS),
    evaders: number("evaders", (value) => value >= 1 && value <= MOST_AGENTS),
    view: way ? Math.max(LEAST_VIEW, view) : view, way,
    population: number("population", (value) => POPULATIONS.includes(value as 8)),
    steps: number("steps", (value) => STEPS.includes(value as 30)),
    walls: walls.filter((cell) => cell < world.rows * world.cols).reduce<readonly number[]>((all, cell) => withCell(all, cell, true), []),
  } satisfies Choice;
  return whyNotPlayed(choice, world) ? { ...choice, walls: [] } : choice;
}
