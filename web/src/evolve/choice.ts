// What a person has chosen, and the settings of the race that follow from it. A link holds the choice.

import type { WorldConfig } from "../engine/types.ts";
import { mapOf, withCell } from "../playground/scene.ts";
import type { EvolveData, LearnerName, PolicyName } from "./data.ts";
import { SCHEDULES } from "./data.ts";
import type { RaceSettings } from "./settings.ts";

export interface Choice extends Readonly<
  Record<"seed" | "generations" | "pursuers" | "evaders" | "view" | "steps", number>
> {
  readonly world: string;
  readonly schedule: string;
  /** The schedule of a second race beside it; empty for none. */
  readonly beside: string;
  readonly learner: LearnerName;
  readonly policy: PolicyName;
  /** Whether agents have right of way, so that none is ever at fault. */
  readonly way: boolean;
  /** Candidates of an epoch; 0 for the usual number. */
  readonly population: number;
  /** The cells that are walls, row by row; null for those of the world, which each match draws anew. */
  readonly walls: readonly number[] | null;
}

export const MOST_AGENTS = 10;
export const MOST_SEED = 999_999;
/** Generations of a race, and the most that it can go on to. */
export const GENERATIONS = 15;
export const MOST_GENERATIONS = 90;
export const VIEWS = [3, 5, 7, 9, 11] as const;
/** The smallest view that shows all that right of way asks for. */
export const LEAST_VIEW = 5;
export const POPULATIONS = [8, 16, 32, 64] as const;
export const STEPS = [6, 10, 30, 60, 90, 120, 200] as const;

/** Return what is usual in a world, by default that with which the page begins. */
export function usualChoice(data: EvolveData, name = ""): Choice {
  const world = Object.hasOwn(data.worlds, name) ? name : Object.keys(data.worlds)[0]!;
  const { n_pursuers, n_evaders, fov, max_steps } = data.worlds[world]!;
  return {
    world,
    schedule: "generalist-generalist",
    beside: "",
    learner: "es",
    policy: "rating",
    seed: 0,
    generations: GENERATIONS,
    way: false,
    population: 0,
    pursuers: n_pursuers,
    evaders: n_evaders,
    view: fov,
    steps: max_steps,
    walls: null,
  };
}

/** Return the settings of the race that is chosen, or of the one beside it. */
export function settingsOf(data: EvolveData, choice: Choice, schedule = choice.schedule): RaceSettings {
  const base = data.races[choice.policy][choice.learner][schedule]!;
  const usual = data.worlds[choice.world]!;
  const world = {
    ...usual,
    n_pursuers: choice.pursuers,
    n_evaders: choice.evaders,
    fov: choice.view,
    max_steps: choice.steps,
    obstacles: choice.walls ? mapOf(choice.walls, usual.rows, usual.cols) : usual.obstacles,
  };
  const mask = choice.way ? "right-of-way" : choice.policy === "rating" ? "obstacles" : "none";
  return {
    ...base,
    world,
    train_steps: choice.steps,
    seed: choice.seed,
    policy: { ...base.policy, mask } as RaceSettings["policy"],
    learner: { ...base.learner, population: choice.population || base.learner.population },
    schedule: { ...base.schedule, generations: choice.generations },
  };
}

/** Return why a map cannot be played on; empty if it can. */
export function whyNotPlayed({ walls, pursuers, evaders }: Choice, { rows, cols }: WorldConfig): string {
  if (!walls) return "";
  const free = new Set(
    Array.from({ length: rows * cols }, (_, cell) => cell).filter((cell) => !walls.includes(cell)),
  );
  if (free.size < pursuers + evaders) {
    return `There is no room: ${pursuers + evaders} agents need a free cell each.`;
  }
  const found = [Math.min(...free)]; // the cells that can be reached from the first one
  free.delete(found[0]!);
  for (const cell of found) {
    const col = cell % cols;
    const beside = [
      cell - cols,
      cell + cols,
      ...(col > 0 ? [cell - 1] : []),
      ...(col < cols - 1 ? [cell + 1] : []),
    ];
    found.push(...beside.filter((each) => free.delete(each)));
  }
  return free.size ? "Nobody may be walled in: all free cells have to be connected, side by side." : "";
}

// ---- As text:  world=thicket&seed=7&walls=60.61.62

/** A choice, or a part of it, as the parts of an address. */
export type Parts = Readonly<Record<string, string>>;

function textOf(value: Choice[keyof Choice]): string {
  if (Array.isArray(value)) return (value as readonly number[]).join(".") || "none";
  if (value === null) return "usual";
  return String(typeof value === "boolean" ? Number(value) : value);
}

/** Return the parts of a choice that are not as usual in its world. */
export function partsOf(data: EvolveData, choice: Choice): Parts {
  const usual = usualChoice(data, choice.world);
  const first = usualChoice(data);
  return Object.fromEntries(
    (Object.keys(choice) as (keyof Choice)[])
      .filter((name) => textOf(choice[name]) !== textOf((name === "world" ? first : usual)[name]))
      .map((name) => [name, textOf(choice[name])]),
  );
}

/** Return a choice as text, with all of its parts: a change of a race on its way. */
export const changeOf = (change: Partial<Choice>): Parts =>
  Object.fromEntries(Object.entries(change).map(([name, value]) => [name, textOf(value)]));

/**
 * Return a choice changed by parts of an address. A text from elsewhere may hold anything: `wrong`
 * gets what is not valid.
 */
export function choiceOf(
  data: EvolveData,
  parts: Parts,
  wrong: (text: string) => void,
  before?: Choice,
): Choice {
  const usual = before ?? usualChoice(data, parts["world"]);
  const { rows, cols } = data.worlds[usual.world]!;
  const within =
    (least: number, most: number) =>
    (text: string): number | undefined =>
      /^\d{1,6}$/.test(text) && Number(text) >= least && Number(text) <= most ? Number(text) : undefined;
  const among =
    (...names: (string | number)[]) =>
    (text: string): string | number | undefined =>
      names.find((name) => String(name) === text);
  const walls = (text: string): readonly number[] | null | undefined => {
    if (text === "usual" || text === "none") return text === "usual" ? null : [];
    const cells = text.split(".").map((each) => within(0, rows * cols - 1)(each));
    return cells.includes(undefined)
      ? undefined
      : (cells as number[]).reduce<readonly number[]>((all, cell) => withCell(all, cell, true), []);
  };
  const valid: Readonly<Record<keyof Choice, (text: string) => unknown>> = {
    world: among(...Object.keys(data.worlds)),
    schedule: among(...Object.keys(SCHEDULES)),
    beside: among("", ...Object.keys(SCHEDULES)),
    learner: among("es", "ga"),
    policy: among("rating", "cells"),
    way: (text) => (/^[01]$/.test(text) ? text === "1" : undefined),
    seed: within(0, MOST_SEED),
    generations: within(GENERATIONS, MOST_GENERATIONS),
    pursuers: within(1, MOST_AGENTS),
    evaders: within(1, MOST_AGENTS),
    view: among(...VIEWS),
    steps: among(...STEPS),
    population: among(0, ...POPULATIONS),
    walls,
  };
  const read = Object.entries(parts).map(([name, text]) => {
    const value = Object.hasOwn(valid, name) ? valid[name as keyof Choice](text) : undefined;
    if (value === undefined) wrong(`${name}=${text}`);
    return [name, value] as const;
  });
  const choice: Choice = { ...usual, ...Object.fromEntries(read.filter(([, value]) => value !== undefined)) };
  const seen = choice.way ? { ...choice, view: Math.max(LEAST_VIEW, choice.view) } : choice;
  const why = whyNotPlayed(seen, data.worlds[seen.world]!);
  if (why) wrong(why);
  return why ? { ...seen, walls: null } : seen;
}
