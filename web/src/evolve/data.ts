// What the page holds; `matrixworld.explorer.evolve_page` writes it.

import type { OfTeams } from "../engine/teams.ts";
import { text } from "../explorer/data.ts";
import type { Mask } from "./network.ts";
import type { WorldConfig } from "../engine/types.ts";
import type { RaceSettings } from "./settings.ts";

export type LearnerName = "es" | "ga";

/** What a genome is: weights of named inputs that rate moves, or a network over cells. */
export type PolicyName = "rating" | "cells";

/** What the files of a run say of its game (`matrixworld.coevolution.runs.stored.Facts`). */
export interface GameFacts {
  readonly teams: readonly [string, string];
  readonly keys: readonly [string, string];
  readonly exact: boolean;
  readonly score: string;
  /** The names of the log's columns, and of their types. */
  readonly columns: Readonly<Record<string, string>>;
}

export interface EvolveData {
  readonly version: string;
  readonly format: number;
  readonly game: GameFacts;
  /** By name; the page begins with the first one. */
  readonly worlds: Readonly<Record<string, WorldConfig>>;
  /** The settings of races, by policy, learner and schedule; their worlds are those of a choice. */
  readonly races: Readonly<
    Record<PolicyName, Readonly<Record<LearnerName, Readonly<Record<string, RaceSettings>>>>>
  >;
  readonly masks: OfTeams<Mask>;
  /** What an agent does by an input: whose rating falls with it, rises with it; and what it minds. */
  readonly phrases: Readonly<Record<string, readonly [falls: string, rises: string, minds: string]>>;
  /** What fills the places of phrases. */
  readonly words: OfTeams<Readonly<Record<string, string>>>;
}

export const readData = (): EvolveData => JSON.parse(text("data")) as EvolveData;

/** The schedules in plain words. */
export const SCHEDULES: Readonly<Record<string, string>> = {
  "specialist-specialist": "Specialists: both teams meet only the newest opponent",
  "generalist-specialist": "Pursuers meet all earlier evaders, evaders only the newest pursuers",
  "generalist-generalist": "Generalists: both teams meet all earlier opponents",
  "hall-of-fame": "Halls of fame: both teams learn at once, and meet earlier champions",
};

/** Return the name of a race's schedule, as Python has it. */
export function scheduleOf({ schedule }: RaceSettings): string {
  if (schedule.kind === "hall-of-fame") return schedule.kind;
  const names = { latest: "specialist", "round-robin": "generalist", uniform: "uniform" } as const;
  return `${names[schedule.pursuers_meet]}-${names[schedule.evaders_meet]}`;
}

/** Return the schedule in plain words. */
export const scheduleName = (settings: RaceSettings): string =>
  SCHEDULES[scheduleOf(settings)] ?? scheduleOf(settings);
