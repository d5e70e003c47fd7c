// Seeds of matches and of generators: the words of `numpy.random.SeedSequence`, as Python's runs have them.

/** What a generator is for; the numbers are those of `matrixworld.coevolution.seeding.Purpose`. */
export const PURPOSE = { initial: 1, noise: 2, learn: 3, opponents: 4 } as const;
export type Purpose = keyof typeof PURPOSE;

/** What the matches of a seed are for, as in `matrixworld.coevolution.seeding.Phase`. */
export const PHASE = { pursuer: 1, evader: 2, both: 3 } as const;

const POOL = 4;
const WORD = 2n ** 32n;

/** Return the words of a whole number, the lowest first; 0 has one. */
function wordsOf(number: number | bigint): number[] {
  const words: number[] = [];
  let left = BigInt(number);
  do {
    words.push(Number(left % WORD));
    left /= WORD;
  } while (left > 0n);
  return words;
}

/** Return the mixing function of a multiplier: its constant changes with each word. */
function hash(start: number, factor: number): (word: number) => number {
  let constant = start;
  return (word) => {
    let value = word ^ constant;
    constant = Math.imul(constant, factor);
    value = Math.imul(value, constant);
    return value ^ (value >>> 16);
  };
}

function mix(a: number, b: number): number {
  const value = (Math.imul(0xca01f9dd, a) - Math.imul(0x4973f715, b)) | 0;
  return value ^ (value >>> 16);
}

/** Return the first words of 32 bits of `SeedSequence(entropy, spawn_key=spawn)`. */
export function seedWords(
  entropy: readonly (number | bigint)[],
  spawn: readonly number[],
  count: number,
): Uint32Array {
  const words = entropy.flatMap(wordsOf);
  if (spawn.length) {
    while (words.length < POOL) words.push(0);
    words.push(...spawn.flatMap(wordsOf));
  }
  const hashed = hash(0x43b0d7e5, 0x931e8875);
  const pool = Array.from({ length: POOL }, (_, i) => hashed(words[i] ?? 0));
  for (let from = 0; from < POOL; from++) {
    for (let to = 0; to < POOL; to++) {
      if (from !== to) pool[to] = mix(pool[to]!, hashed(pool[from]!));
    }
  }
  for (const word of words.slice(POOL)) {
    for (let to = 0; to < POOL; to++) pool[to] = mix(pool[to]!, hashed(word));
  }
  const told = hash(0x8b51f9dd, 0x58f38ded);
  return Uint32Array.from({ length: count }, (_, i) => told(pool[i % POOL]!));
}

/** Return seeds of 64 bits: the first words of `SeedSequence(key)`. */
export function seedsOf(key: readonly (number | bigint)[], count: number): BigUint64Array {
  const words = seedWords(key, [], 2 * count);
  return BigUint64Array.from(
    { length: count },
    (_, i) => BigInt(words[2 * i]!) + WORD * BigInt(words[2 * i + 1]!),
  );
}

/** Return the seed of a cell of the payoff matrix, that of `evaluation_seed`. */
export const evaluationSeed = (seed: number, pursuer: number, evader: number): bigint =>
  seedsOf([seed, pursuer, evader], 1)[0]!;
