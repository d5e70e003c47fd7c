// How teams learn, as in `matrixworld.coevolution.learners`: an evolution strategy and a genetic
// algorithm. Arrays are float32 and rounded after each operation, as NumPy does it.

import type { Draws } from "./draws.ts";

const f = Math.fround;

/** What a race asks of a learner: candidates, and to learn from their fitness. */
export interface Learner {
  /** The genome that represents the team. */
  readonly genome: Float32Array;
  /** Group of each candidate; one group is scored on the same match seed. */
  readonly groups: Int32Array;
  /** Return the candidates, one genome after the other. */
  ask(draws: Draws): Float32Array;
  tell(fitness: Float64Array): void;
}

interface EvolutionStrategySettings extends Readonly<
  Record<"population" | "sigma" | "learning_rate" | "relative_sigma", number>
> {
  readonly kind: "es";
}

interface GeneticAlgorithmSettings extends Readonly<Record<"population" | "mutation" | "elites", number>> {
  readonly kind: "ga";
  /** Individuals in a tournament; null for the usual number. */
  readonly tournament: number | null;
}

export type LearnerSettings = EvolutionStrategySettings | GeneticAlgorithmSettings;

const TOURNAMENT = 5;
const VECTORS_PER_TABLE = 256;

/** Noise vectors as windows of one long row of normal numbers, as in `NoiseTable`. */
export class NoiseTable {
  readonly size: number;
  readonly sigma: number;
  /** Flags of genes without noise, such as those of a mask. */
  readonly fixed: Uint8Array | null;
  readonly #numbers: Float32Array;

  constructor(size: number, draws: Draws, sigma: number, fixed: Uint8Array | null) {
    this.size = size;
    this.sigma = sigma;
    this.fixed = fixed;
    this.#numbers = draws.normals((1 + VECTORS_PER_TABLE) * size);
    for (let i = 0; i < this.#numbers.length; i++) this.#numbers[i]! *= f(sigma);
  }

  draw(count: number, draws: Draws): Float32Array[] {
    const starts = draws.integers(this.#numbers.length - this.size + 1, count);
    return Array.from(starts, (start) => {
      const window = this.#numbers.subarray(start, start + this.size);
      return this.fixed ? window.map((noise, i) => (this.fixed![i] ? 0 : noise)) : window;
    });
  }
}

/** Steps of Adam, in ascent (Kingma and Ba 2015). */
class Adam {
  readonly #mean: Float32Array;
  readonly #square: Float32Array;
  #updates = 0;

  constructor(size: number) {
    this.#mean = new Float32Array(size);
    this.#square = new Float32Array(size);
  }

  /** Add the step of a gradient at a rate to a genome, and return the sum. */
  moved(genome: Float32Array, gradient: Float32Array, rate: number): Float32Array {
    const beta1 = 0.9;
    const beta2 = 0.999;
    const epsilon = f(1e-8);
    this.#updates += 1;
    const mixed1 = f(1 - beta1);
    const mixed2 = f(1 - beta2);
    const left1 = f(1 - beta1 ** this.#updates);
    const left2 = f(1 - beta2 ** this.#updates);
    return genome.map((gene, i) => {
      const slope = gradient[i]!;
      const mean = (this.#mean[i]! += f(mixed1 * f(slope - this.#mean[i]!)));
      const square = (this.#square[i]! += f(mixed2 * f(f(slope * slope) - this.#square[i]!)));
      const scale = f(f(Math.sqrt(f(f(square) / left2))) + epsilon);
      return f(gene + f(f(f(rate) * f(f(mean) / left1)) / scale));
    });
  }
}

/** Return the ranks of fitness values, scaled to [-0.5, 0.5]; equal ones share the middle of theirs. */
export function centredRanks(fitness: Float64Array): Float64Array {
  const order = Array.from(fitness).sort((a, b) => a - b);
  return fitness.map(
    (value) => (order.indexOf(value) + order.lastIndexOf(value)) / (2 * (fitness.length - 1)) - 0.5,
  );
}

/** The evolution strategy of Salimans et al. (2017): mirrored samples, ranks, Adam. */
export class EvolutionStrategy implements Learner {
  genome: Float32Array;
  readonly groups: Int32Array;
  readonly #settings: EvolutionStrategySettings;
  readonly #table: NoiseTable;
  readonly #adam: Adam;
  #noise: readonly Float32Array[] = [];

  constructor(genome: Float32Array, table: NoiseTable, settings: EvolutionStrategySettings) {
    this.genome = genome;
    this.#table = table;
    this.#settings = settings;
    this.#adam = new Adam(genome.length);
    this.groups = Int32Array.from({ length: settings.population }, (_, i) => i % (settings.population / 2));
  }

  /** Standard deviation of the next samples: it grows with the genome, without genes that do not change. */
  get #sigma(): number {
    const { sigma, fixed } = this.#table;
    let sum = 0;
    let count = 0;
    this.genome.forEach((gene, i) => {
      if (fixed?.[i]) return;
      sum += gene * gene;
      count += 1;
    });
    return Math.max(sigma, this.#settings.relative_sigma * Math.sqrt(sum / count));
  }

  ask(draws: Draws): Float32Array {
    const pairs = this.#settings.population / 2;
    const size = this.genome.length;
    this.#noise = this.#table.draw(pairs, draws);
    const scale = f(this.#sigma / this.#table.sigma);
    const candidates = new Float32Array(2 * pairs * size);
    this.#noise.forEach((noise, pair) => {
      for (let i = 0; i < size; i++) {
        const step = f(scale * noise[i]!);
        candidates[pair * size + i] = this.genome[i]! + step;
        candidates[(pairs + pair) * size + i] = this.genome[i]! - step;
      }
    });
    return candidates;
  }

  tell(fitness: Float64Array): void {
    const ranks = centredRanks(fitness);
    const pairs = this.#noise.length;
    const gradient = new Float32Array(this.genome.length);
    this.#noise.forEach((noise, pair) => {
      const weight = f((ranks[pair]! - ranks[pairs + pair]!) / (2 * pairs * this.#table.sigma ** 2));
      for (let i = 0; i < gradient.length; i++) gradient[i]! += f(weight * noise[i]!);
    });
    this.genome = this.#adam.moved(this.genome, gradient, this.#settings.learning_rate);
  }
}

/** A generational genetic algorithm: tournaments, elites, mutation from a table. */
export class GeneticAlgorithm implements Learner {
  /** Genomes, one after the other. */
  population: Float32Array;
  readonly groups: Int32Array;
  readonly #settings: GeneticAlgorithmSettings;
  readonly #table: NoiseTable;
  #fitness: Float64Array = new Float64Array(0);
  #champion = 0;

  constructor(population: Float32Array, table: NoiseTable, settings: GeneticAlgorithmSettings) {
    this.population = population;
    this.#table = table;
    this.#settings = settings;
    this.groups = new Int32Array(settings.population);
  }

  get genome(): Float32Array {
    return this.#individual(this.#champion).slice();
  }

  #individual(number: number): Float32Array {
    const { size } = this.#table;
    return this.population.subarray(number * size, (number + 1) * size);
  }

  /** Parents: each the fittest of some random individuals; of equals the first. */
  #select(count: number, draws: Draws): number[] {
    const size = this.#settings.tournament ?? TOURNAMENT;
    const entrants = draws.integers(this.#fitness.length, count * size);
    return Array.from({ length: count }, (_, child) =>
      entrants
        .subarray(child * size, (child + 1) * size)
        .reduce((best, each) => (this.#fitness[each]! > this.#fitness[best]! ? each : best)),
    );
  }

  ask(draws: Draws): Float32Array {
    if (!this.#fitness.length) return this.population;
    const { size } = this.#table;
    const { population, elites } = this.#settings;
    const children = population - elites;
    const fathers = this.#select(children, draws);
    this.#select(children, draws); // mothers, who matter with crossover only: Python draws them, too
    const elite = Array.from(this.#fitness.keys())
      .sort((a, b) => this.#fitness[b]! - this.#fitness[a]!)
      .slice(0, elites);
    const offspring = new Float32Array(this.population.length);
    [...elite, ...fathers].forEach((parent, at) => offspring.set(this.#individual(parent), at * size));
    this.#table.draw(children, draws).forEach((noise, child) => {
      const first = (elites + child) * size;
      for (let i = 0; i < size; i++) offspring[first + i]! += noise[i]!;
    });
    this.population = offspring;
    return offspring;
  }

  tell(fitness: Float64Array): void {
    this.#fitness = fitness;
    this.#champion = fitness.indexOf(Math.max(...fitness));
  }
}
