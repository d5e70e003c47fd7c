// A race as the directory of a run of the package, in a zip archive: what `matrixworld judge`, `explore`
// and `replay` read (docs/files.md). It has no checkpoint, so that Python does not continue it.

import { strToU8, zipSync } from "fflate";
import { TEAMS } from "../engine/teams.ts";
import type { Team } from "../engine/teams.ts";
import { writeNpz } from "../page/npz.ts";
import type { NpyArray } from "../page/npz.ts";
import type { EvolveData } from "./data.ts";
import { mean } from "./measures.ts";
import { COLUMNS } from "./race.ts";
import type { Cell, Race } from "./race.ts";
import type { RaceSettings } from "./settings.ts";

/** What Python calls the format of a run's files, its version, and what they say of the game. */
type Format = Pick<EvolveData, "format" | "version" | "game">;

/** What is saved of a race. */
export type Finished = Pick<Race, "settings" | "archive" | "rows" | "cells" | "counters" | "finished">;

const json = (values: object): Uint8Array => strToU8(JSON.stringify(values, null, 2));
const doubles = (data: readonly number[], ...shape: number[]): NpyArray => ({
  dtype: "<f8",
  shape,
  data: Float64Array.from(data),
});
const spread = (values: readonly number[]): number =>
  Math.sqrt(mean(values.map((each) => (each - mean(values)) ** 2)));

/** What the stages of a race are: a generation of one team, or of both if they learn at once. */
type Stage = readonly [generation: number, teams: readonly Team[]];

function stagesOf({ settings, finished }: Finished): Stage[] {
  const phases: (readonly Team[])[] =
    settings.schedule.kind === "alternating" ? TEAMS.map((team) => [team]) : [TEAMS];
  return Array.from({ length: finished }, (_, generation) =>
    (generation ? phases : [TEAMS]).map((teams): Stage => [generation, teams]),
  ).flat();
}

/** Return what a stage has added. */
function stage(
  { archive, rows, counters }: Finished,
  number: number,
  [generation, teams]: Stage,
): Record<string, NpyArray> {
  const own = rows.filter((row) => row.generation === generation && teams.includes(row.team));
  const log = strToU8(
    own.map((row) => `${[number, ...COLUMNS.map((name) => row[name])].join(",")}\n`).join(""),
  );
  const genome = (team: Team): NpyArray => ({
    dtype: "<f4",
    shape: [1, archive[team][generation]!.length],
    data: archive[team][generation]!,
  });
  return {
    ...Object.fromEntries(teams.map((team) => [`${team}s`, genome(team)])),
    log: { dtype: `|S${Math.max(1, log.length)}`, shape: [], data: log.length ? log : new Uint8Array(1) },
    ...Object.fromEntries(
      Object.entries(counters[teams.at(-1)!][generation]!).map(([name, count]) => [name, doubles([count])]),
    ),
    ...(number
      ? { score: doubles([mean(own.slice(Math.floor(own.length / 2)).map((row) => row.capture_rate))]) }
      : {}),
  };
}

/** Return the arrays of `Payoff`. */
function payoff(race: Finished): Record<string, NpyArray> {
  const n = race.finished;
  const cells = Array.from({ length: n * n }, (_, at) => race.cells.get(`${Math.floor(at / n)} ${at % n}`)!);
  const episodes = cells[0]!.lengths.length;
  const each = (value: (cell: Cell) => number | readonly number[], ...shape: number[]): NpyArray =>
    doubles(cells.flatMap(value), n, n, ...shape);
  return {
    scores: {
      dtype: "<f4",
      shape: [n, n, episodes],
      data: Float32Array.from(cells.flatMap(({ capture_rates }) => capture_rates)),
    },
    mean: each(({ capture_rates }) => mean(capture_rates)),
    std: each(({ capture_rates }) => spread(capture_rates)),
    lengths: {
      dtype: "<i4",
      shape: [n, n, episodes],
      data: Int32Array.from(cells.flatMap(({ lengths }) => lengths)),
    },
    collisions: each(({ means }) => means.collisions, 2, 3),
    faults: each(({ means }) => means.faults, 2, 3),
    agent_steps: each(({ means }) => means.agent_steps, 2),
    pursuer_survivors: each(({ means }) => means.survivors[0]!),
    evader_survivors: each(({ means }) => means.survivors[1]!),
  };
}

/** Return the files of a run by their names. */
function filesOf(race: Finished, { format, version, game }: Format): Record<string, Uint8Array> {
  const generations = race.finished - 1;
  const settings: RaceSettings = { ...race.settings, schedule: { ...race.settings.schedule, generations } };
  const config = { format, matrixworld: version, game, settings, drawn_by: "page" };
  const stages = stagesOf(race);
  const { matches, steps, agent_steps } = race.counters.evader[generations]!;
  const counted = { training_matches: matches, training_steps: steps, training_agent_steps: agent_steps };
  const summary = {
    stages: stages.length - 1,
    ...counted,
    disengagement: [],
    evaluation_matches: race.finished ** 2 * race.settings.evaluation_episodes,
  };
  return {
    "config.json": json(config),
    ...Object.fromEntries(
      stages.map((each, number) => [
        `stage-${String(number).padStart(4, "0")}.npz`,
        writeNpz(stage(race, number, each)),
      ]),
    ),
    "payoff.npz": writeNpz(payoff(race)),
    "summary.json": json(summary),
  };
}

/** Return an archive of races: one run, or a run in a directory for each schedule. */
export function archiveOf(
  races: readonly { readonly name: string; readonly race: Finished }[],
  format: Format,
): Uint8Array {
  const files = races.flatMap(({ name, race }) =>
    Object.entries(filesOf(race, format)).map(
      ([file, bytes]) => [races.length > 1 ? `${name}/${file}` : file, bytes] as const,
    ),
  );
  return zipSync(Object.fromEntries(files));
}

/** Return whether a race can be saved: it has a generation, and all cells between its generations. */
export const canSave = (race: Finished): boolean =>
  race.finished > 1 &&
  race.cells.size >= race.finished ** 2 &&
  TEAMS.every((team) => race.archive[team].length);
