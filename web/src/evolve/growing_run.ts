// A race that goes on, as the explorer's parts show a run: cells and generations are added.

import { TEAMS } from "../engine/teams.ts";
import type { OfTeams, Team } from "../engine/teams.ts";
import { keepGenomes } from "../explorer/data.ts";
import type { Band, Curve, Findings, Payoff, Run, TeamData } from "../explorer/data.ts";
import type { GenomePolicy, WorldConfig } from "../engine/types.ts";
import { mean } from "./measures.ts";
import { policyOf } from "./network.ts";
import type { Mask } from "./network.ts";
import { joined, shapeOf } from "./race.ts";
import type { Cell } from "./race.ts";
import { evaluationSeed } from "./seeds.ts";
import type { RaceSettings } from "./settings.ts";

/** Empty rows of a matrix; cells without a value are missing. */
const rowsOf = <Value>(size: number): Value[][] => Array.from({ length: size }, () => Array<Value>(size));

export class GrowingRun implements Run {
  readonly learning = TEAMS;
  readonly settings = [];
  readonly command = "";
  readonly training = { capture_rate: [], generation: [], learner: [], epochs: 1, window: 1, matches: 0 };
  readonly limits = "";
  readonly name: string;
  readonly schedule: string;
  readonly seed: string;
  seeds: readonly (readonly string[])[] = [];
  world: WorldConfig;
  payoff: Payoff & { capture_rate: number[][]; capture_rates: number[][][]; lengths: number[][][] };
  teams: OfTeams<TeamData>;
  findings: Findings | null = null;
  /** Genomes of all generations so far. */
  readonly genomes: Record<Team, Float32Array[]> = { pursuer: [], evader: [] };
  /** The best generation of each team, if it is known. */
  best: OfTeams<number> | null = null;
  readonly #masks: OfTeams<Mask>;
  /** Tells the genomes of this race from those of others on the page. */
  readonly #key: string;
  #settings: RaceSettings;

  constructor(settings: RaceSettings, masks: OfTeams<Mask>, name: string, key: string) {
    this.#settings = settings;
    this.#masks = masks;
    this.#key = key;
    this.name = name;
    this.schedule = name;
    this.world = settings.world;
    this.seed = String(settings.seed);
    this.payoff = this.#empty();
    this.teams = this.#teams();
  }

  /** Number of the newest generation; -1 before the first. */
  get newest(): number {
    return this.genomes.pursuer.length - 1;
  }

  #empty(): GrowingRun["payoff"] {
    const {
      seed,
      schedule: { generations },
    } = this.#settings;
    const size = generations + 1;
    this.seeds = Array.from({ length: size }, (_, g) =>
      Array.from({ length: size }, (_none, h) => String(evaluationSeed(seed, g, h))),
    );
    return {
      first: [0, 0],
      shape: [size, size],
      episodes: this.#settings.evaluation_episodes,
      capture_rate: rowsOf(size),
      capture_rates: rowsOf(size),
      lengths: rowsOf(size),
    };
  }

  #teams(): OfTeams<TeamData> {
    const of = (team: Team): TeamData => {
      const genomes = `${this.#key} ${team}`;
      keepGenomes(genomes, joined(this.genomes[team]));
      const { genome, ...policy } = policyOf(
        shapeOf(this.#settings, this.#masks, team),
        this.genomes[team][0] ?? new Float32Array(0),
      );
      return {
        script: null,
        policy: { ...policy, genome_size: genome.length },
        kept: [...this.genomes[team].keys()],
        genomes,
      };
    };
    return { pursuer: of("pursuer"), evader: of("evader") };
  }

  /** Return what plays for a team: a generation in the present world. */
  policy(team: Team, generation: number): GenomePolicy {
    return this.playing(team, this.genomes[team][generation]!);
  }

  /** Return the same with any genome. */
  playing(team: Team, genome: Float32Array): GenomePolicy {
    return policyOf(shapeOf(this.#settings, this.#masks, team), genome);
  }

  /** Return the genomes of generations. */
  genomesOf({ pursuer, evader }: OfTeams<number>): OfTeams<Float32Array> {
    return { pursuer: this.genomes.pursuer[pursuer]!, evader: this.genomes.evader[evader]! };
  }

  /** The race goes on to more generations. */
  extend(settings: RaceSettings): void {
    const {
      capture_rate,
      capture_rates,
      lengths,
      shape: [size],
    } = this.payoff;
    this.#settings = { ...this.#settings, schedule: settings.schedule };
    if (size > settings.schedule.generations) return;
    this.payoff = this.#empty();
    for (let g = 0; g < size; g++) {
      Object.assign(this.payoff.capture_rate[g]!, capture_rate[g]);
      Object.assign(this.payoff.capture_rates[g]!, capture_rates[g]);
      Object.assign(this.payoff.lengths[g]!, lengths[g]);
    }
  }

  add(genomes: OfTeams<Float32Array>): void {
    for (const team of TEAMS) this.genomes[team].push(genomes[team]);
    this.teams = this.#teams();
  }

  /** All generations play in another world, or see it with other eyes. */
  change(settings: RaceSettings, genomes: OfTeams<readonly Float32Array[]>): void {
    this.#settings = settings;
    this.world = settings.world;
    for (const team of TEAMS) this.genomes[team] = [...genomes[team]];
    this.best = null;
    this.payoff = this.#empty();
    this.teams = this.#teams();
    this.findings = null;
  }

  addCell({ pursuer, evader, capture_rates, lengths }: Cell): void {
    this.payoff.capture_rate[pursuer]![evader] = mean(capture_rates);
    this.payoff.capture_rates[pursuer]![evader] = [...capture_rates];
    this.payoff.lengths[pursuer]![evader] = [...lengths];
    this.findings = { generalization: this.#scores() } as Findings;
  }

  /** Mean capture and escape rates of each generation in the cells so far. */
  #scores(): Findings["generalization"] {
    const rates = this.payoff.capture_rate;
    const band = (curve: Curve): Band => ({ mean: curve, low: null, high: null });
    const ofKnown = (values: readonly (number | undefined)[]): number | null => {
      const known = values.filter((value) => value !== undefined);
      return known.length ? mean(known) : null;
    };
    const generations = [...this.genomes.pursuer.keys()];
    return {
      pursuers: band(generations.map((g) => ofKnown(rates[g]!))),
      evaders: band(
        generations.map((h) => ofKnown(rates.map((row) => (row[h] === undefined ? undefined : 1 - row[h]!)))),
      ),
    };
  }
}
