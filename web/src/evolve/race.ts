// A race of pursuers and evaders, as `matrixworld.coevolution.race` plays it: the same matches, fitness
// and learners, with random numbers of the learners from a source that the caller chooses.

import type { Engine, Statistics } from "../engine/engine.ts";
import { TEAMS, otherOf } from "../engine/teams.ts";
import type { OfTeams, Team } from "../engine/teams.ts";
import type { ScriptName, TeamPolicy } from "../engine/types.ts";
import { drawsOf } from "./draws.ts";
import type { Draws, Source } from "./draws.ts";
import { EvolutionStrategy, GeneticAlgorithm, NoiseTable } from "./learners.ts";
import type { Learner } from "./learners.ts";
import { mean } from "./measures.ts";
import { fixedOf, genesOf, masked, policyOf, reshaped, untrained } from "./network.ts";
import type { Mask, Shape } from "./network.ts";
import { pairings, tableMeans } from "./pairings.ts";
import { PHASE, evaluationSeed, seedsOf } from "./seeds.ts";
import { inputsOf, overlapPenalty } from "./settings.ts";
import type { RaceSettings } from "./settings.ts";

/** The results of a pair of generations: those of each episode, and means over episodes by team. */
export interface Cell {
  readonly pursuer: number;
  readonly evader: number;
  readonly capture_rates: readonly number[];
  readonly lengths: readonly number[];
  readonly means: Readonly<Record<"collisions" | "faults" | "agent_steps" | "survivors", readonly number[]>>;
}

/** The columns in the log of a run, in their order. */
export const COLUMNS = [
  "generation",
  "team",
  "epoch",
  "opponent",
  "fitness_mean",
  "fitness_std",
  "fitness_best",
  "capture_rate",
  "length",
  "pursuer_faults",
  "evader_faults",
  "matches",
  "steps",
] as const;

/** An epoch as it stands in the log. */
export type Row = Readonly<Record<Exclude<(typeof COLUMNS)[number], "team">, number> & { team: Team }>;

/** What happens in a race. */
export type RaceEvent =
  /** Epochs played, of all of the race. */
  | { readonly type: "epoch"; readonly done: number; readonly of: number }
  /** It has as many epochs as it may have for now. */
  | { readonly type: "rest" }
  | { readonly type: "generation"; readonly number: number; readonly genomes: OfTeams<Float32Array> }
  | { readonly type: "cell"; readonly cell: Cell }
  /** Mean scores of a generation against scripts, from 0 to 1. */
  | { readonly type: "scores"; readonly number: number; readonly scores: OfTeams<number> }
  /** Another world, view or mask: matrix and scores begin anew, with these genomes of all generations. */
  | {
      readonly type: "anew";
      readonly settings: RaceSettings;
      readonly genomes: OfTeams<readonly Float32Array[]>;
    };

/** Opponents that do not change, and matches of each generation against each. */
export const FIXED: OfTeams<readonly ScriptName[]> = {
  pursuer: ["random", "clumsy-fleer"],
  evader: ["random", "clumsy-chaser"],
};
const FIXED_EPISODES = 20;
/** Keeps the seeds of these matches apart from all others. */
const FIXED_PHASE = 8;
/** Opponent of an epoch with several. */
const SEVERAL = -1;

/** Return what plays for a team, without a genome. */
export function shapeOf({ world, policy }: RaceSettings, masks: OfTeams<Mask>, team: Team): Shape {
  if (policy.kind === "rating") return { ...policy, inputs: inputsOf(policy, team) };
  return {
    kind: "cells",
    fov: world.fov,
    hidden: policy.hidden,
    mask: policy.mask === "none" ? null : masks[team],
  };
}

/** A race that is played step by step, and whose settings may change meanwhile. */
export class Race {
  settings: RaceSettings;
  /** Epochs that were played, and those after which the race rests. */
  epochs = 0;
  until = Infinity;
  /** Genomes of generations 0, 1, ... of each team. */
  readonly archive: Record<Team, Float32Array[]> = { pursuer: [], evader: [] };
  readonly rows: Row[] = [];
  readonly cells = new Map<string, Cell>();
  /** Episodes, world steps and steps of living agents until the end of each generation of a team. */
  readonly counters: Record<Team, Record<"matches" | "steps" | "agent_steps", number>[]> = {
    pursuer: [],
    evader: [],
  };
  readonly #engine: Engine;
  readonly #masks: OfTeams<Mask>;
  readonly #source: Source;
  readonly #learners = {} as Record<Team, Learner>;
  readonly #scored = new Set<number>();
  /** How many opponents a team has met since opponent 0 had its turn. */
  readonly #met: Record<Team, number> = { pursuer: 0, evader: 0 };
  #matches = 0;
  #steps = 0;
  #agentSteps = 0;

  constructor(
    engine: Engine,
    settings: RaceSettings,
    masks: OfTeams<Mask>,
    source: Source = drawsOf(settings.seed),
  ) {
    this.#engine = engine;
    this.settings = settings;
    this.#masks = masks;
    this.#source = source;
    for (const team of TEAMS) {
      const draws = source("initial", TEAMS.indexOf(team));
      const count = settings.learner.kind === "ga" ? settings.learner.population : 1;
      const genomes = Array.from({ length: count }, () =>
        untrained(this.shape(team), draws, settings.policy),
      );
      this.#newLearner(team, genomes);
      this.archive[team].push(this.#learners[team].genome);
    }
    this.#count(...TEAMS);
  }

  /** The network of a team. */
  shape(team: Team): Shape {
    return shapeOf(this.settings, this.#masks, team);
  }

  /** Generations that both teams have finished. */
  get finished(): number {
    return Math.min(this.archive.pursuer.length, this.archive.evader.length);
  }

  /** Play the race, or go on with more generations; each step takes some milliseconds. */
  *run(): Generator<RaceEvent, void> {
    if (this.finished === 1) yield* this.#tell(0);
    for (let generation = this.finished; generation <= this.settings.schedule.generations; generation++) {
      if (this.settings.schedule.kind === "alternating") {
        for (const team of TEAMS) {
          yield* this.#learn(team, generation);
          this.#count(team);
        }
      } else {
        yield* this.#learnAtOnce(generation);
        this.#count(...TEAMS);
      }
      yield* this.#tell(generation);
    }
  }

  /** Go on with other settings, from where both teams are. The seed and the learner stay. */
  change(settings: RaceSettings): RaceEvent | null {
    const before = this.settings;
    const shapes = { pursuer: this.shape("pursuer"), evader: this.shape("evader") };
    const same = (part: (each: RaceSettings) => unknown): boolean =>
      JSON.stringify(part(before)) === JSON.stringify(part(settings));
    this.settings = settings;
    const network = same((each) => [each.world.fov, each.policy]);
    if (!network || !same((each) => each.learner)) {
      for (const team of TEAMS) {
        const changed = (genome: Float32Array): Float32Array =>
          reshaped(genome, shapes[team], this.shape(team));
        this.archive[team] = this.archive[team].map(changed);
        this.#newLearner(team, this.#population(team).map(changed));
      }
    }
    if (network && same((each) => each.world)) return null;
    this.cells.clear();
    this.#scored.clear();
    const { pursuer, evader } = this.archive; // a team may be a generation ahead of the other
    return {
      type: "anew",
      settings,
      genomes: { pursuer: pursuer.slice(0, this.finished), evader: evader.slice(0, this.finished) },
    };
  }

  /** The genomes from which a learner goes on: as many as its settings want. */
  #population(team: Team): Float32Array[] {
    const learner = this.#learners[team];
    if (!(learner instanceof GeneticAlgorithm)) return [learner.genome];
    const size = learner.genome.length;
    const genomes = Array.from({ length: learner.population.length / size }, (_, i) =>
      learner.population.slice(i * size, (i + 1) * size),
    );
    return Array.from({ length: this.settings.learner.population }, (_, i) =>
      i === 0 ? learner.genome : genomes[i % genomes.length]!,
    );
  }

  #newLearner(team: Team, genomes: readonly Float32Array[]): void {
    const { learner } = this.settings;
    const shape = this.shape(team);
    const sigma = learner.kind === "ga" ? learner.mutation : learner.sigma;
    const genes = fixedOf(shape);
    const table = new NoiseTable(
      genesOf(shape),
      this.#source("noise", TEAMS.indexOf(team)),
      sigma,
      genes?.fixed ?? null,
    );
    const start = genomes.map((genome) => masked(genome, genes));
    this.#learners[team] =
      learner.kind === "ga"
        ? new GeneticAlgorithm(joined(start), table, learner)
        : new EvolutionStrategy(start[0]!, table, learner);
  }

  // ---- Learning ---------------------------------------------------------------------------------

  /** One team learns for the epochs of a generation. */
  *#learn(team: Team, generation: number): Generator<RaceEvent, void> {
    // In turns of all opponents; once all but the newest have been met, opponent 0 comes again.
    if (this.#met[team] >= this.archive[otherOf(team)].length - 1) this.#met[team] = 0;
    for (let epoch = 0; epoch < this.#epochs(team); epoch++) {
      while (this.epochs >= this.until) yield { type: "rest" };
      const available = this.archive[otherOf(team)].length;
      const rule = this.settings.schedule[`${team}s_meet`];
      const opponent =
        rule === "latest"
          ? available - 1
          : rule === "round-robin"
            ? this.#met[team] % available
            : this.#source("opponents", TEAMS.indexOf(team), generation, epoch).choice(available, 1)[0]!;
      this.#met[team]++;
      const pair = team === "pursuer" ? [generation, opponent] : [opponent, generation];
      const learner = this.#learners[team];
      const { groups } = learner;
      const seeds = seedsOf([this.settings.seed, ...pair, PHASE[team], epoch], Math.max(...groups) + 1);
      const candidates = learner.ask(this.#source("learn", TEAMS.indexOf(team), generation, epoch));
      const own = Int32Array.from(groups.keys());
      const met = new Int32Array(groups.length);
      const sides = { [team]: candidates, [otherOf(team)]: this.archive[otherOf(team)][opponent]! } as Record<
        Team,
        Float32Array
      >;
      const places = { [team]: own, [otherOf(team)]: met } as Record<Team, Int32Array>;
      const scores = this.#play(
        sides,
        places,
        BigUint64Array.from(groups, (group) => seeds[group]!),
      );
      const fitness = this.#fitness(scores, team);
      this.#log(scores, fitness, { generation, team, epoch, opponent });
      learner.tell(fitness);
      yield* this.#between(generation, epoch, team);
    }
    this.archive[team].push(this.#learners[team].genome);
  }

  /** Both teams learn for the epochs of a generation (Rosin and Belew 1997). */
  *#learnAtOnce(generation: number): Generator<RaceEvent, void> {
    for (let epoch = 0; epoch < this.#epochs("pursuer"); epoch++) {
      while (this.epochs >= this.until) yield { type: "rest" };
      const {
        schedule,
        learner: { population: n },
      } = this.settings;
      const [hall, living] =
        schedule.kind === "hall-of-fame" ? [schedule.hall_sample, schedule.contemporaries] : [0, 1];
      const asked = {
        pursuer: this.#ask("pursuer", generation, epoch),
        evader: this.#ask("evader", generation, epoch),
      };
      const draws = this.#source("opponents", 0, generation, epoch);
      const sampled = { pursuer: this.#sample(hall, draws), evader: this.#sample(hall, draws) };
      const everyone = (team: Team): Float32Array =>
        joined([asked[team], ...Array.from(sampled[otherOf(team)], (member) => this.archive[team][member]!)]);
      const sizes = [sampled.evader.length, sampled.pursuer.length] as const; // members of each hall, pursuers' first
      const pairs = pairings(this.#learners.pursuer.groups, living, sizes, draws);
      const seeds = seedsOf(
        [this.settings.seed, generation, generation, PHASE.both, epoch],
        Math.max(...pairs.group) + 1,
      );
      const sides = { pursuer: everyone("pursuer"), evader: everyone("evader") };
      const scores = this.#play(
        sides,
        pairs,
        BigUint64Array.from(pairs.group, (group) => seeds[group]!),
      );
      for (const team of TEAMS) {
        const fitness = tableMeans(pairs[team], pairs[otherOf(team)], n, this.#fitness(scores, team));
        this.#log(scores, fitness, { generation, team, epoch, opponent: SEVERAL });
        this.#learners[team].tell(fitness);
      }
      yield* this.#between(generation, epoch, "both");
    }
    for (const team of TEAMS) this.archive[team].push(this.#learners[team].genome);
  }

  #ask(team: Team, generation: number, epoch: number): Float32Array {
    return this.#learners[team].ask(this.#source("learn", TEAMS.indexOf(team), generation, epoch));
  }

  #sample(count: number, draws: Draws): Int32Array {
    const size = this.archive.pursuer.length;
    return count ? draws.choice(size, Math.min(count, size)) : new Int32Array(0);
  }

  #epochs(team: Team): number {
    const { schedule } = this.settings;
    return schedule.kind === "hall-of-fame" ? schedule.joint_epochs : schedule[`${team}_epochs`];
  }

  /** After an epoch: how far the race is, and what a change of the settings has left to be played. */
  *#between(generation: number, epoch: number, team: Team | "both"): Generator<RaceEvent, void> {
    const [pursuers, evaders] =
      this.settings.schedule.kind === "hall-of-fame"
        ? [this.#epochs("pursuer"), 0]
        : [this.#epochs("pursuer"), this.#epochs("evader")];
    const inGeneration = epoch + 1 + (team === "evader" ? pursuers : 0);
    const each = pursuers + evaders;
    this.epochs += 1;
    yield {
      type: "epoch",
      done: (generation - 1) * each + inGeneration,
      of: this.settings.schedule.generations * each,
    };
    yield* this.catchUp();
  }

  // ---- Matches ----------------------------------------------------------------------------------

  #play(genomes: OfTeams<Float32Array>, places: OfTeams<Int32Array>, seed: BigUint64Array): Statistics {
    const config = { ...this.settings.world, max_steps: this.settings.train_steps };
    const scores = this.#engine.rollouts(
      config,
      this.#policy("pursuer", genomes.pursuer),
      this.#policy("evader", genomes.evader),
      { ...places, seed },
      1,
    );
    this.#matches += scores.length.length;
    for (const steps of scores.length) this.#steps += Number(steps);
    for (const steps of scores.agent_steps) this.#agentSteps += Number(steps);
    return scores;
  }

  #policy(team: Team, genome: Float32Array): TeamPolicy {
    return policyOf(this.shape(team), genome);
  }

  /**
   * The captured share of the evaders averaged over the steps, or 1 minus it and a penalty on
   * shared cells.
   */
  #fitness({ captured_fraction, overlap }: Statistics, team: Team): Float64Array {
    const penalty = overlapPenalty(this.settings);
    return Float64Array.from(captured_fraction as Float64Array, (captured, match) =>
      team === "pursuer" ? captured : 1 - captured - penalty * Number(overlap[2 * match + 1]),
    );
  }

  #log(
    scores: Statistics,
    fitness: Float64Array,
    head: Pick<Row, "generation" | "team" | "epoch" | "opponent">,
  ): void {
    const average = mean(fitness);
    const faults = [0, 0];
    scores.faults.forEach(
      (count: number | bigint, i: number) => (faults[Math.floor(i / 3) % 2]! += Number(count)),
    );
    this.rows.push({
      ...head,
      fitness_mean: average,
      fitness_std: Math.sqrt(mean(fitness.map((each) => (each - average) ** 2))),
      fitness_best: Math.max(...fitness),
      capture_rate: mean(scores.capture_rate as Float32Array),
      length: mean(scores.length as Int32Array),
      pursuer_faults: faults[0]! / scores.length.length,
      evader_faults: faults[1]! / scores.length.length,
      matches: this.#matches,
      steps: this.#steps,
    });
  }

  #count(...teams: Team[]): void {
    for (const team of teams) {
      this.counters[team].push({ matches: this.#matches, steps: this.#steps, agent_steps: this.#agentSteps });
    }
  }

  // ---- Evaluation -------------------------------------------------------------------------------

  *#tell(number: number): Generator<RaceEvent, void> {
    yield {
      type: "generation",
      number,
      genomes: { pursuer: this.archive.pursuer[number]!, evader: this.archive.evader[number]! },
    };
    yield* this.catchUp();
  }

  /** Play the cells and scores that are missing, those of the newest generations first. */
  *catchUp(): Generator<RaceEvent, void> {
    for (let newest = this.finished - 1; newest >= 0; newest--) {
      for (let before = newest; before >= 0; before--) {
        for (const [g, h] of before === newest
          ? [[newest, newest]]
          : [
              [newest, before],
              [before, newest],
            ]) {
          if (this.cells.has(`${g!} ${h!}`)) continue;
          const cell = this.#cell(g!, h!);
          this.cells.set(`${g!} ${h!}`, cell);
          yield { type: "cell", cell };
        }
      }
      if (this.#scored.has(newest)) continue;
      this.#scored.add(newest);
      yield {
        type: "scores",
        number: newest,
        scores: { pursuer: this.#score("pursuer", newest), evader: this.#score("evader", newest) },
      };
    }
  }

  #cell(pursuer: number, evader: number): Cell {
    const { world, evaluation_episodes: episodes, seed } = this.settings;
    const match = {
      pursuer: new Int32Array(1),
      evader: new Int32Array(1),
      seed: BigUint64Array.of(evaluationSeed(seed, pursuer, evader)),
    };
    const sides = TEAMS.map((team) =>
      this.#policy(team, this.archive[team][team === "pursuer" ? pursuer : evader]!),
    ) as [TeamPolicy, TeamPolicy];
    const scores = this.#engine.rollouts(world, ...sides, match, episodes);
    const means = (name: "collisions" | "faults" | "agent_steps" | "survivors"): number[] => {
      const values = Array.from(scores[name] as ArrayLike<number | bigint>, Number);
      const size = values.length / episodes;
      return Array.from({ length: size }, (_, item) => mean(values.filter((_value, i) => i % size === item)));
    };
    return {
      pursuer,
      evader,
      capture_rates: Array.from(scores.capture_rate as Float32Array),
      lengths: Array.from(scores.length as Int32Array),
      means: {
        collisions: means("collisions"),
        faults: means("faults"),
        agent_steps: means("agent_steps"),
        survivors: means("survivors"),
      },
    };
  }

  /** The mean capture rate, or escape rate, of a generation against scripts. */
  #score(team: Team, generation: number): number {
    const { world, seed } = this.settings;
    const own = this.#policy(team, this.archive[team][generation]!);
    const one = new Int32Array(1);
    return mean(
      FIXED[team].map((script, number) => {
        const seeds = seedsOf([seed, TEAMS.indexOf(team), number, FIXED_PHASE], 1);
        const sides: [TeamPolicy, TeamPolicy] = team === "pursuer" ? [own, script] : [script, own];
        const rate = mean(
          this.#engine.rollouts(world, ...sides, { pursuer: one, evader: one, seed: seeds }, FIXED_EPISODES)
            .capture_rate as Float32Array,
        );
        return team === "pursuer" ? rate : 1 - rate;
      }),
    );
  }
}

/** Return genomes one after the other. */
export function joined(genomes: readonly Float32Array[]): Float32Array {
  const made = new Float32Array(genomes.reduce((sum, { length }) => sum + length, 0));
  let at = 0;
  for (const genome of genomes) {
    made.set(genome, at);
    at += genome.length;
  }
  return made;
}
