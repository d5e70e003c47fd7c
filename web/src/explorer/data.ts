// What the page holds of its runs; `matrixworld.explorer.runs_page` writes it.

import { unzlibSync } from "fflate";
import type { Engine, Match } from "../engine/engine.ts";
import type { Team } from "../engine/teams.ts";
import type {
  InputName,
  PolicyShape,
  ProgramPolicy,
  RatingPolicy,
  ScriptName,
  TeamPolicy,
  WorldConfig,
} from "../engine/types.ts";
import type { PageData } from "../playground/data.ts";
import { generationName } from "./game.ts";
import type { OwnGame } from "./game.ts";
import type { Selection } from "./store.ts";

/** Rows of a matrix; null where a number is not defined. */
export type Matrix = readonly (readonly number[])[];
export type Curve = readonly (number | null)[];

/** What rates moves by named inputs. */
export type RatesMoves = RatingPolicy | ProgramPolicy;

/** Weights by input; those of programs that are 0 are left out. */
export type WeightsOf = Readonly<Partial<Record<InputName, number>>>;

export interface TeamData {
  readonly script: ScriptName | null;
  readonly policy: PolicyShape | null;
  /** The generations whose genomes the page holds. */
  readonly kept: readonly number[];
  readonly genomes: string;
  /** Of programs, that of each kept generation as an expression. */
  readonly expressions?: readonly string[];
  /** The same as weights by input, where the program is a weighted sum of inputs. */
  readonly weights?: readonly (WeightsOf | null)[];
  /** What the best generation against held-out opponents does, in words, where it has been played. */
  readonly evolved?: { readonly generation: number; readonly sentence: string };
}

export interface Payoff {
  /** Generations of the first cell that was played, and of the whole matrix. */
  readonly first: readonly [number, number];
  readonly shape: readonly [number, number];
  readonly episodes: number;
  readonly capture_rate: Matrix;
  readonly capture_rates: readonly Matrix[];
  readonly lengths: readonly Matrix[];
  /** Means of the second team, where it has scores of its own. */
  readonly others?: Matrix | null;
  /** Other means of a game of one's own, by name. */
  readonly extras?: Readonly<Record<string, Matrix>>;
}

export interface Training {
  readonly capture_rate: readonly number[];
  readonly generation: readonly number[];
  /** 0: the pursuers learn, 1: the evaders, 2: both. */
  readonly learner: readonly number[];
  readonly epochs: number;
  readonly window: number;
  readonly matches: number;
}

export interface Band {
  readonly mean: Curve;
  readonly low: Curve | null;
  readonly high: Curve | null;
}

type OfTeams<Value> = Readonly<Record<"pursuers" | "evaders", Value>>;
export type Checkerboard = OfTeams<readonly [number, number]> & { readonly margin: number };

export interface Findings {
  /** What happened, in plain words. */
  readonly sentence: string;
  readonly table: readonly (readonly [string, string, string, string])[];
  readonly reasons: readonly string[];
  /** Conditions that have no meaning in such a game, and why. */
  readonly refused?: Readonly<Record<string, string>>;
  readonly generalization: OfTeams<Band>;
  readonly ciao: OfTeams<{
    readonly fading: number | null;
    readonly stripes: number;
    readonly period: number | null;
  }>;
  /** Of games in which one team wins what the other loses. */
  readonly ratings: (OfTeams<Band> & { readonly offset: number }) | null;
  /** The mean of both teams' own scores against contemporaries. */
  readonly joint?: Band | null;
  /** Of games in which one team wins what the other loses. */
  readonly checkerboards: readonly Checkerboard[] | null;
  readonly margin: number;
}

export interface Run {
  readonly name: string;
  /** What all seeds show together; empty for a single one. */
  readonly together?: string;
  readonly schedule: string;
  readonly learning: readonly Team[];
  readonly seed: string;
  /** Of pursuit alone. */
  readonly world: WorldConfig | null;
  /** A game of one's own. */
  readonly game?: OwnGame | null;
  readonly settings: readonly Readonly<Record<"name" | "value" | "help", string>>[];
  /** What plays the run again. */
  readonly command: string;
  readonly training: Training;
  readonly payoff: Payoff;
  readonly seeds: readonly (readonly string[])[];
  readonly findings: Findings | null;
  readonly limits: string;
  readonly teams: Readonly<Record<Team, TeamData>>;
}

export interface Data {
  readonly version: string;
  /** The name of the directory, and what the page shows in words. */
  readonly title: string;
  readonly heading: string;
  readonly note: string;
  /** Whether the runs go on. */
  readonly growing: boolean;
  /** Of a page with runs of pursuit. */
  readonly playground: PageData | null;
  readonly runs: readonly Run[];
}

/** Return the data of the page. */
export const readData = (): Data => JSON.parse(text("data")) as Data;

/** Return what was measured of a cell; null where no episodes were played for it. */
export function cellOf(
  run: Run,
  g: number,
  h: number,
): { rate: number; rates: readonly number[]; lengths: readonly number[] } | null {
  const row = g - run.payoff.first[0];
  const column = h - run.payoff.first[1];
  const rate = run.payoff.capture_rate[row]?.[column];
  if (rate === undefined) return null;
  return {
    rate,
    rates: run.payoff.capture_rates[row]![column]!,
    lengths: run.payoff.lengths[row]?.[column] ?? [],
  };
}

/** Return why the page cannot play a generation of a team; empty if it can. */
export function whyNot(run: Run, team: Team, generation: number): string {
  const { script, policy, kept, genomes } = run.teams[team];
  if (script !== null || policy === null) return "";
  if (!kept.includes(generation)) {
    return `The page holds no genome of ${generationName(run, team, generation)}: it would be too large. Choose a generation of ${kept.join(", ")}.`;
  }
  const expected = kept.length * policy.genome_size;
  if (genomesOf(genomes, policy.genome_size).length === expected) return "";
  return `The page is damaged: it does not hold the ${expected} numbers of the ${team}s' genomes. Write it again from its run.`;
}

/** Return what plays for a team: the genome of a generation, or a script. */
export function policyOf(run: Run, team: Team, generation: number): TeamPolicy {
  const { script, policy, kept, genomes } = run.teams[team];
  if (script !== null || policy === null) return script ?? "random";
  const place = kept.indexOf(generation);
  if (place < 0) {
    throw new RangeError(`${team}: expected a generation whose genome the page holds, got ${generation}`);
  }
  const size = policy.genome_size;
  const genome = genomesOf(genomes, size).subarray(place * size, (place + 1) * size);
  return { ...policy, genome };
}

/** Return whether a team's policy rates moves by named inputs. */
export const ratesMoves = ({ teams }: Run, team: Team): boolean =>
  (teams[team].policy ?? { kind: "cells" }).kind !== "cells";

/** A program in words: an expression, and weights by input where it is a weighted sum. */
export interface ProgramText {
  readonly expression: string;
  readonly weights: WeightsOf | null;
}

/** Return the program of a generation in words; null for other policies. */
export function programOf({ teams }: Run, team: Team, generation: number): ProgramText | null {
  const { kept, expressions, weights } = teams[team];
  const place = kept.indexOf(generation);
  const expression = expressions?.[place];
  return expression ? { expression, weights: weights?.[place] ?? null } : null;
}

/** Return the weights of what rates moves by a weighted sum of inputs; null for all else. */
export function weightsOf(policy: RatesMoves, program: ProgramText | null): WeightsOf | null {
  if (policy.kind === "program") return program?.weights ?? null;
  if (policy.hidden.length) return null;
  return Object.fromEntries(policy.inputs.map((input, place) => [input, policy.genome[place]!]));
}

/** Play a match with the engine: the very one of the evaluation, unless another seed is chosen. */
export function playedMatch(engine: Engine, run: Run, { pursuer, evader, episode, seed }: Selection): Match {
  const own = run.seeds[pursuer]![evader]!;
  return engine.match(
    run.world!,
    policyOf(run, "pursuer", pursuer),
    policyOf(run, "evader", evader),
    BigInt(seed ?? own),
    episode,
  );
}

/** Bytes of a number. */
const BYTES = 4;
const decoded = new Map<string, Float32Array>();

/** Keep genomes that the page has made itself, one after the other, under an identifier. */
export const keepGenomes = (identifier: string, genomes: Float32Array): void =>
  void decoded.set(identifier, genomes);

/** Return the genomes of an archive, decoded when a match first needs them; none if damaged. */
export function genomesOf(identifier: string, size: number): Float32Array {
  const known = decoded.get(identifier);
  if (known) return known;
  let genomes = new Float32Array();
  try {
    const found = unpacked(bytesOf(identifier), size);
    if (found.every(Number.isFinite)) genomes = found;
  } catch (error) {
    // Text that is no base64, or a part of the bytes: `whyNot` says so.
    if (!(error instanceof DOMException || error instanceof RangeError || isCut(error))) throw error;
  }
  decoded.set(identifier, genomes);
  return genomes;
}

const isCut = (error: unknown): boolean => error instanceof Error && "code" in error;

/** Return genomes of so many numbers, as `matrixworld.explorer.runs_page` packs them. */
function unpacked(packed: Uint8Array, size: number): Float32Array<ArrayBuffer> {
  const planes = unzlibSync(packed);
  const count = planes.length / BYTES;
  const bytes = new Uint8Array(planes.length);
  for (let at = 0; at < bytes.length; at++) {
    bytes[at] = planes[(at % BYTES) * count + Math.floor(at / BYTES)]!;
  }
  const bits = new Uint32Array(bytes.buffer);
  for (let at = size; at < bits.length; at++) bits[at]! ^= bits[at - size]!;
  return new Float32Array(bytes.buffer);
}

/** Return what a data element of the page holds as base64. */
export function bytesOf(identifier: string): Uint8Array<ArrayBuffer> {
  const binary = atob(text(identifier));
  const bytes = new Uint8Array(binary.length);
  for (let i = 0; i < bytes.length; i++) bytes[i] = binary.charCodeAt(i);
  return bytes;
}

/** Return the text of a data element. */
export const text = (identifier: string): string => document.getElementById(identifier)?.textContent ?? "";
