// Play races of the page evolve.html in node: a line of JSON for each in ({settings, masks}), and one out.
//
//     node web/play_races.mjs < races.jsonl

import { readFileSync } from "node:fs";
import { createInterface } from "node:readline";
import vm from "node:vm";

const { loadEngine } = await import("./src/engine/engine.ts");
const { Race } = await import("./src/evolve/race.ts");
const BUILT = new URL("../python/matrixworld/explorer/built/engine.js", import.meta.url);
vm.runInThisContext(readFileSync(BUILT, "utf8"));
const engine = await loadEngine();

const mean = (values) => values.reduce((sum, each) => sum + each, 0) / values.length;
/** Seconds of this thread, without the compiler's. */
const seconds = () => process.threadCpuUsage().user / 1e6;

for await (const line of createInterface({ input: process.stdin })) {
  const { settings, masks } = JSON.parse(line);
  const began = seconds();
  const race = new Race(engine, settings, masks);
  const scores = { pursuer: [], evader: [] };
  let first = 0;
  for (const event of race.run()) {
    if (event.type === "generation" && event.number === 1) first = seconds() - began;
    if (event.type === "scores") {
      for (const team of Object.keys(scores)) scores[team][event.number] = event.scores[team];
    }
  }
  const took = seconds() - began;
  const capture = mean([...race.cells.values()].map(({ capture_rates }) => mean(capture_rates)));
  const { agent_steps } = race.counters.evader.at(-1);
  console.log(JSON.stringify({ seconds: took, first, agent_steps, capture, scores }));
}
