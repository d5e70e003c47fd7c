// The built engine as a page loads it, and numbers as JSON can hold them.

import { readFileSync } from "node:fs";
import vm from "node:vm";

const ROOT = new URL("../../", import.meta.url);
const BUILT = new URL("python/matrixworld/explorer/built/engine.js", ROOT);

export const wrapper = await import(new URL("web/src/engine/engine.ts", ROOT));
const { episodeOf } = await import(new URL("web/src/engine/match.ts", ROOT));
export const { whyNotSolved } = await import(new URL("web/src/engine/solution.ts", ROOT));
export const conflicts = await import(new URL("web/src/engine/conflicts.ts", ROOT));
vm.runInThisContext(readFileSync(BUILT, "utf8"), { filename: BUILT.pathname });
export const engine = await wrapper.loadEngine();

/** Return a policy whose genome is the base64 of its float32 numbers, or the name of a script. */
export function policyOf(given) {
  if (typeof given === "string") return given;
  const bytes = Uint8Array.from(Buffer.from(given.genome, "base64"));
  return { ...given, genome: new Float32Array(bytes.buffer) };
}

/** Play episodes of a match, and return the statistics of each. */
export function rollout(config, pursuers, evaders, seed, episodes) {
  const match = { pursuer: Int32Array.of(0), evader: Int32Array.of(0), seed: BigUint64Array.of(seed) };
  const all = Object.entries(engine.rollouts(config, pursuers, evaders, match, episodes));
  const of = (values, episode) =>
    values.slice((episode * values.length) / episodes, ((episode + 1) * values.length) / episodes);
  return Array.from({ length: episodes }, (_, episode) =>
    episodeOf(Object.fromEntries(all.map(([name, values]) => [name, of(values, episode)]))),
  );
}

/** Return a value as JSON can hold it: arrays as lists, large integers as text. */
export function plain(value) {
  if (typeof value === "bigint") return String(value);
  if (ArrayBuffer.isView(value)) return Array.from(value, plain);
  return value;
}

/** Return the input of the program, which is JSON. */
export function input() {
  return JSON.parse(readFileSync(0, "utf8"));
}

/** Write the output of the program. */
export function output(value) {
  process.stdout.write(JSON.stringify(value, (_, each) => plain(each)));
}
