// Games with known answers, as `tutorials/course/toys.py` has them: the page computes every number
// that it shows of them.

/** Returns numbers from [0, 1). */
export type Draw = () => number;

/** Return a generator of random numbers (mulberry32, T. Ettinger 2017): equal seeds, equal numbers. */
export function generator(seed: number): Draw {
  let state = seed >>> 0;
  return () => {
    state = (state + 0x6d2b79f5) >>> 0;
    let mixed = Math.imul(state ^ (state >>> 15), state | 1);
    mixed ^= mixed + Math.imul(mixed ^ (mixed >>> 7), mixed | 61);
    return ((mixed ^ (mixed >>> 14)) >>> 0) / 2 ** 32;
  };
}

// ---- Rock, paper, scissors ------------------------------------------------------------------------

export const HANDS = ["rock", "paper", "scissors"] as const;
/** What the hand of a row wins against that of a column; a draw is one half. */
export const PAYOFF: readonly (readonly number[])[] = [
  [0.5, 0, 1],
  [1, 0.5, 0],
  [0, 1, 0.5],
];
/** Sums of payoffs that differ by less are equal. */
const ROUNDING = 1e-9;

/** Return what each hand wins on average against shares of hands. */
const wins = (shares: readonly number[]): number[] =>
  PAYOFF.map((row) => row.reduce((sum, each, hand) => sum + each * shares[hand]!, 0));

/** Return the share of each hand among the last `memory` ones. */
export function sharesOf(hands: readonly number[], memory: number): number[] {
  const seen = hands.slice(-memory);
  return HANDS.map((_, hand) => seen.filter((each) => each === hand).length / seen.length);
}

/**
 * Return what the best answer to shares of hands wins: 1 against a single hand, one half against
 * equal shares.
 */
export const bestAnswer = (shares: readonly number[]): number => Math.max(...wins(shares));

function answer(hands: readonly number[], memory: number, draw: Draw): number {
  const found = wins(sharesOf(hands, memory));
  const best = found.flatMap((each, hand) => (each > Math.max(...found) - ROUNDING ? [hand] : []));
  return best[best.length > 1 ? Math.floor(draw() * best.length) : 0]!;
}

/** The hand of each generation, by team. */
type Hands = Readonly<Record<"pursuers" | "evaders", number[]>>;

/**
 * Play in turns: first the pursuers answer the last `memory` hands of the evaders, then these
 * answer the pursuers. Both begin with rock. With all hands remembered this is fictitious play
 * (Brown 1951).
 */
export function alternate(generations: number, memory: number, draw: Draw): Hands {
  const hands: Hands = { pursuers: [0], evaders: [0] };
  for (let generation = 1; generation <= generations; generation++) {
    hands.pursuers.push(answer(hands.evaders, memory, draw));
    hands.evaders.push(answer(hands.pursuers, memory, draw));
  }
  return hands;
}

// ---- Numbers games --------------------------------------------------------------------------------

export const BITS = 100;

/** Dimensions, and whether the one with the greatest or with the least difference decides. */
export const GAMES = {
  scalar: { dimensions: 1, greatest: true },
  focusing: { dimensions: 10, greatest: true },
  intransitive: { dimensions: 2, greatest: false },
} as const;
export type GameName = keyof typeof GAMES;

/** Ones of an individual in each dimension. */
type Ones = readonly number[];

/** Return 1 if a beats b, 0 if b beats a, and one half for a draw. The first of equal differences decides. */
export function score(game: GameName, a: Ones, b: Ones): number {
  const { greatest } = GAMES[game];
  let decides = a[0]! - b[0]!;
  for (let dimension = 1; dimension < a.length; dimension++) {
    const difference = a[dimension]! - b[dimension]!;
    if (greatest ? Math.abs(difference) > Math.abs(decides) : Math.abs(difference) < Math.abs(decides)) {
      decides = difference;
    }
  }
  return (1 + Math.sign(decides)) / 2;
}

/** Return the mean score of all individuals of a population against all of another one. */
export const meanScore = (game: GameName, a: readonly Ones[], b: readonly Ones[]): number =>
  a.reduce((sum, one) => sum + b.reduce((own, other) => own + score(game, one, other), 0), 0) /
  (a.length * b.length);

export interface Settings {
  readonly population: number;
  /** Probability that a bit is flipped. */
  readonly mutation: number;
  /** Living opponents of each individual. */
  readonly opponents: number;
  /** Champions of past generations that each individual meets, too. */
  readonly hall: number;
}

export const USUAL: Settings = { population: 25, mutation: 0.005, opponents: 15, hall: 0 };

/**
 * Two populations of bit strings that evolve against each other, from all zeros (Watson and Pollack 2001).
 * Selection sees wins alone, and never counts the ones.
 */
export class NumbersGame {
  readonly game: GameName;
  readonly settings: Settings;
  generation = 0;
  readonly #draw: Draw;
  readonly #bits: [Uint8Array[], Uint8Array[]];
  readonly #champions: [Ones[], Ones[]] = [[], []];

  constructor(game: GameName, settings: Settings, draw: Draw) {
    this.game = game;
    this.settings = settings;
    this.#draw = draw;
    const zeros = (): Uint8Array[] => Array.from({ length: settings.population }, () => new Uint8Array(BITS));
    this.#bits = [zeros(), zeros()];
  }

  /** Return the ones of each individual of a side. */
  ones(side: 0 | 1): Ones[] {
    const { dimensions } = GAMES[this.game];
    const size = BITS / dimensions;
    return this.#bits[side].map((bits) =>
      Array.from({ length: dimensions }, (_, at) => sum(bits.subarray(at * size, (at + 1) * size))),
    );
  }

  /** Return the mean number of ones of a side. */
  objective = (side: 0 | 1): number => sum(this.#bits[side].map(sum)) / this.settings.population;

  /** Play a generation: matches, then both sides breed in proportion to their wins. */
  step(): void {
    const ones = [this.ones(0), this.ones(1)] as const;
    const won = this.#play(ones);
    for (const side of [0, 1] as const) {
      this.#champions[side].push(ones[side][won[side].indexOf(Math.max(...won[side]))]!);
      const parents = this.#parents(won[side]);
      this.#bits[side] = parents.map((parent) => this.#mutant(this.#bits[side][parent]!));
    }
    this.generation++;
  }

  #play(ones: readonly [Ones[], Ones[]]): [number[], number[]] {
    const { population, opponents, hall } = this.settings;
    const won: [number[], number[]] = [new Array(population).fill(0), new Array(population).fill(0)];
    for (let round = 0; round < opponents; round++) {
      shuffled(population, this.#draw).forEach((other, own) => {
        const result = score(this.game, ones[0][own]!, ones[1][other]!);
        won[0][own]! += Number(result === 1);
        won[1][other]! += Number(result === 0);
      });
    }
    for (const side of [0, 1] as const) {
      const past = this.#champions[1 - side]!;
      for (const champion of shuffled(past.length, this.#draw, hall)) {
        ones[side].forEach(
          (own, at) => (won[side][at]! += Number(score(this.game, own, past[champion]!) === 1)),
        );
      }
    }
    return won;
  }

  #mutant(parent: Uint8Array): Uint8Array {
    const bits = parent.slice();
    for (let at = 0; at < bits.length; at++) {
      if (this.#draw() < this.settings.mutation) bits[at]! ^= 1;
    }
    return bits;
  }

  #parents(won: readonly number[]): number[] {
    const total = sum(won);
    const chances = total ? won : won.map(() => 1); // without any win all are equal
    return won.map(() => {
      let left = this.#draw() * (total || won.length);
      const found = chances.findIndex((chance) => (left -= chance) < 0);
      return found < 0 ? won.length - 1 : found;
    });
  }
}

/** Return the numbers 0 to n - 1 in random order, or the first `most` of them. */
function shuffled(n: number, draw: Draw, most = n): number[] {
  const order = Array.from({ length: n }, (_, at) => at);
  const count = Math.min(most, n);
  for (let at = 0; at < count; at++) {
    const other = at + Math.floor(draw() * (n - at));
    [order[at], order[other]] = [order[other]!, order[at]!];
  }
  return order.slice(0, count);
}

function sum(values: ArrayLike<number>): number {
  let total = 0;
  for (let at = 0; at < values.length; at++) total += values[at]!;
  return total;
}
