// Who meets whom where both teams learn at once, as in `matrixworld.coevolution.race`.

import type { Team } from "../engine/teams.ts";
import type { Draws } from "./draws.ts";

/**
 * Matches of two populations of n individuals; numbers from n on are members of a hall of fame, and
 * matches of the same group have the same seed.
 */
type Pairings = Readonly<Record<Team | "group", Int32Array>>;

/**
 * Return matches of each individual against some living opponents, and each member of the other
 * team's hall.
 */
export function pairings(
  seedGroups: Int32Array,
  contemporaries: number,
  hall: readonly [number, number],
  draws: Draws,
): Pairings {
  const n = seedGroups.length;
  const groups = Math.max(...seedGroups) + 1;
  const size = groups > 1 ? n / groups : 1;
  const individuals = Array.from(seedGroups.keys()).sort((a, b) => seedGroups[a]! - seedGroups[b]!);
  const rounds: [number[], number[]][] = [];
  let opponents: number[] = [];
  for (let meeting = 0; meeting < contemporaries; meeting++) {
    const turn = meeting % size;
    if (turn === 0) {
      opponents = Array.from(draws.permutation(n / size)).flatMap((block) =>
        individuals.slice(block * size, (block + 1) * size),
      );
    }
    rounds.push([
      individuals,
      opponents.map((_, i) => opponents[i - (i % size) + (((i % size) - turn + size) % size)]!),
    ]);
  }
  const member = (number: number): number[] => individuals.map(() => n + number);
  for (let each = 0; each < hall[1]; each++) rounds.push([individuals, member(each)]);
  for (let each = 0; each < hall[0]; each++) rounds.push([member(each), individuals]);
  return {
    pursuer: Int32Array.from(rounds.flatMap(([pursuers]) => pursuers)),
    evader: Int32Array.from(rounds.flatMap(([, evaders]) => evaders)),
    group: Int32Array.from(
      rounds.flatMap((_, round) => individuals.map((each) => round * groups + seedGroups[each]!)),
    ),
  };
}

/** Return the mean over opponents of the values of each of n individuals; equal pairs count once. */
export function tableMeans(
  own: Int32Array,
  opponents: Int32Array,
  n: number,
  values: Float64Array,
): Float64Array {
  const width = Math.max(...opponents) + 1;
  const sums = new Float64Array(n * width);
  const counts = new Float64Array(n * width);
  values.forEach((value, match) => {
    if (own[match]! >= n) return;
    const pair = own[match]! * width + opponents[match]!;
    sums[pair]! += value;
    counts[pair]! += 1;
  });
  const means = sums.map((sum, pair) => (counts[pair] ? sum / counts[pair]! : 0));
  return Float64Array.from({ length: n }, (_, i) => {
    const row = means.subarray(i * width, (i + 1) * width);
    return pairwiseSum(row) / counts.subarray(i * width, (i + 1) * width).filter(Boolean).length;
  });
}

/** Numbers that NumPy adds in one loop, with eight sums beside each other. */
const BLOCK = 128;
const LANES = 8;

/** Return the sum in the order in which NumPy adds: fitness that is equal there is equal here. */
function pairwiseSum(values: Float64Array): number {
  const { length } = values;
  if (length > BLOCK) {
    const half = Math.floor(length / 2) - (Math.floor(length / 2) % LANES);
    return pairwiseSum(values.subarray(0, half)) + pairwiseSum(values.subarray(half));
  }
  if (length < LANES) return values.reduce((sum, each) => sum + each, 0);
  const lanes = values.slice(0, LANES);
  const whole = length - (length % LANES);
  for (let i = LANES; i < whole; i++) lanes[i % LANES]! += values[i]!;
  const [a, b, c, d, e, f, g, h] = lanes as unknown as [
    number,
    number,
    number,
    number,
    number,
    number,
    number,
    number,
  ];
  return values.subarray(whole).reduce((sum, each) => sum + each, a + b + (c + d) + (e + f + (g + h)));
}
