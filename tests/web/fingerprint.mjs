// The episodes of the fingerprint (tests/contract/test_fingerprint.py) in the built engine.

import { createHash } from "node:crypto";

import { engine, input, output, policyOf, rollout } from "./engine.mjs";

const { worlds: N_WORLDS, steps: STEPS, cents: CENTS, arrays, scores, games } = input();
const TEAMS = ["pursuer", "evader"];
const digest = createHash("sha256");

/** Round to the nearest whole number, halves to the even one. */
function rounded(number) {
  const below = Math.floor(number);
  if (number - below !== 0.5) return Math.round(number);
  return below % 2 === 0 ? below : below + 1;
}

/** Add numbers as 64-bit integers, rewards in hundredths. */
function add(numbers) {
  const float = numbers instanceof Float32Array || numbers instanceof Float64Array;
  const words = new Int32Array(2 * numbers.length); // the lower word first
  for (let i = 0; i < numbers.length; ++i) {
    const number = float ? rounded(CENTS * numbers[i]) : numbers[i];
    words[2 * i] = number;
    words[2 * i + 1] = number < 0 ? -1 : 0;
  }
  digest.update(words);
}

/** Play one step of a world of a batch that resets at once; return its arrays as a batch writes them. */
function stepOf(world, actions) {
  world.step(actions);
  const told = new Map(arrays.of_step.map((name) => [name, world.read(name)]));
  if (world.over) world.reset({ seed: world.seed, episode: world.episode + 1n });
  for (const name of arrays.of_moment) told.set(name, world.read(name));
  return told;
}

function batch(config, seed, actions) {
  const worlds = Array.from({ length: N_WORLDS }, (_, w) => {
    const world = engine.world(config);
    world.reset({ seed: BigInt(seed + w) });
    return world;
  });
  for (let step = 0; step < STEPS; ++step) {
    const told = worlds.map((world, w) => stepOf(world, actions[step][w]));
    for (const name of arrays.all) {
      for (const each of told) add(each.get(name));
    }
  }
  for (const world of worlds) world.free();
}

/** Return a score of an episode by the name that it has in Python: "pursuer_return" is return[0]. */
function score(statistics, name) {
  const team = TEAMS.findIndex((each) => name.startsWith(`${each}_`));
  if (team < 0) {
    const value = statistics[name];
    if (typeof value !== "number") return value;
    return Number.isInteger(value) && name === "length" ? [value] : Float64Array.of(value);
  }
  return statistics[name.slice(TEAMS[team].length + 1)].slice(team, team + 1);
}

function rollouts({ config, team, matches }) {
  const player = policyOf(team);
  for (const [pursuers, evaders] of [
    [player, "fleer"],
    ["chaser", player],
    ["random", "still"],
  ]) {
    const played = matches.flatMap(([seed, episodes]) =>
      rollout(config, pursuers, evaders, BigInt(seed), episodes),
    );
    for (const name of scores) {
      for (const statistics of played) add(score(statistics, name));
    }
  }
}

games.forEach(({ config, actions }, number) => batch(config, 1000 * number, actions));
games.forEach(rollouts);
output(digest.digest("hex").slice(0, 8));
