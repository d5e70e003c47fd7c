// What the page holds; `matrixworld.explorer.evolve_page` writes it.

import { text } from "../explorer/data.ts";
import type { Mask } from "./network.ts";
import type { OfTeams } from "./race.ts";
import type { RaceSettings, Ratings } from "./settings.ts";

export type LearnerName = "es" | "ga";

export interface EvolveData {
  readonly version: string;
  readonly format: number;
  /** The settings with which the page begins, by learner and schedule. */
  readonly races: Readonly<Record<LearnerName, Readonly<Record<string, RaceSettings>>>>;
  /** Policies that rate moves, instead of the networks of these races. */
  readonly ratings: Ratings;
  readonly masks: OfTeams<Mask>;
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
export const scheduleName = (settings: RaceSettings): string => SCHEDULES[scheduleOf(settings)] ?? scheduleOf(settings);
