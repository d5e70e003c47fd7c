// Random numbers of a race. Whoever starts a race supplies them: the page by a generator of its own, a
// test those that NumPy has drawn.

import { PURPOSE, seedWords } from "./seeds.ts";
import type { Purpose } from "./seeds.ts";

/** A generator; its methods are those of `numpy.random.Generator` that a race uses. */
export type Draws = Pick<Generator, "normals" | "integers" | "permutation" | "choice">;

/** Returns the generator for a purpose at a position of the race, such as (team, generation, epoch). */
export type Source = (purpose: Purpose, ...key: readonly number[]) => Draws;

/** Return the page's generators of a seed. */
export const drawsOf =
  (seed: number): Source =>
  (purpose, ...key) =>
    new Generator(seedWords([seed], [PURPOSE[purpose], ...key], 3));

/** The small fast counting generator of Chris Doty-Humphrey's PractRand, with words of 32 bits. */
class Generator {
  #a: number;
  #b: number;
  #c: number;
  #counter = 1;

  constructor(words: Uint32Array) {
    this.#a = words[0]!;
    this.#b = words[1]!;
    this.#c = words[2]!;
    for (let i = 0; i < 12; i++) this.#word();
  }

  #word(): number {
    const word = (this.#a + this.#b + this.#counter++) | 0;
    this.#a = this.#b ^ (this.#b >>> 9);
    this.#b = (this.#c + (this.#c << 3)) | 0;
    this.#c = (((this.#c << 21) | (this.#c >>> 11)) + word) | 0;
    return word >>> 0;
  }

  /** A number in (0, 1). */
  #unit(): number {
    return (this.#word() + 0.5) / 2 ** 32;
  }

  /** `count` normal numbers as float32, two at a time by the method of Box and Muller (1958). */
  normals(count: number): Float32Array {
    const made = new Float32Array(count);
    for (let i = 0; i < count; i += 2) {
      const length = Math.sqrt(-2 * Math.log(this.#unit()));
      const angle = 2 * Math.PI * this.#unit();
      made[i] = length * Math.cos(angle);
      if (i + 1 < count) made[i + 1] = length * Math.sin(angle);
    }
    return made;
  }

  /** `count` whole numbers from 0 to `end` - 1. */
  integers(end: number, count: number): Int32Array {
    return Int32Array.from({ length: count }, () => Math.floor(this.#unit() * end));
  }

  /** The numbers from 0 to `count` - 1 in random order. */
  permutation(count: number): Int32Array {
    return this.choice(count, count);
  }

  /** `count` different numbers below `end`. */
  choice(end: number, count: number): Int32Array {
    const numbers = Int32Array.from({ length: end }, (_, i) => i);
    for (let i = 0; i < count; i++) {
      const j = i + Math.floor(this.#unit() * (end - i));
      [numbers[i], numbers[j]] = [numbers[j]!, numbers[i]!];
    }
    return numbers.slice(0, count);
  }
}
