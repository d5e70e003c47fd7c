// Measure the built engine in node: rounds a second of matches, in the processor's own time.
//
//     python -c 'import json, matrixworld as mw; print(json.dumps(mw.WorldConfig().to_json()))' | node web/measure_engine.mjs
//
// The world comes as JSON on standard input.

import { readFileSync } from "node:fs";
import vm from "node:vm";

const BUILT = new URL("../python/matrixworld/explorer/built/engine.js", import.meta.url);
const { loadEngine } = await import("./src/engine/engine.ts");

/** Return a network with a genome of small random numbers. */
function network(hidden, fov) {
  const sizes = [3 * fov ** 2, ...hidden, 5];
  const genes = sizes.slice(1).reduce((sum, n_out, i) => sum + (sizes[i] + 1) * n_out, 0);
  const genome = Float32Array.from({ length: genes }, () => 0.1 * (Math.random() - 0.5));
  return { kind: "cells", hidden, activation: "relu", sampled: true, memory: "none", genome };
}

/** Return seconds of this process, without the compiler's other threads. */
function seconds() {
  return process.threadCpuUsage().user / 1e6;
}

const start = performance.now();
vm.runInThisContext(readFileSync(BUILT, "utf8"));
const engine = await loadEngine();
console.log(`loaded in ${(performance.now() - start).toFixed(0)} ms`);

const config = { ...JSON.parse(readFileSync(0, "utf8")), n_pursuers: 20, n_evaders: 20 };
for (const hidden of [[], [32], [64, 64], [400, 300]]) {
  const policy = network(hidden, config.fov);
  engine.match({ ...config, max_steps: 100 }, policy, policy, 1n, 0); // until it is compiled
  const begin = seconds();
  const match = engine.match(config, policy, policy, 2n, 0);
  const took = seconds() - begin;
  const rounds = Math.round(match.length / took).toLocaleString("en");
  console.log(
    `[${hidden}]: ${rounds} rounds a second, a match of ${match.length} in ${(1000 * took).toFixed(0)} ms`,
  );
}
