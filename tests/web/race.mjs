// A race of the page, with random numbers from elsewhere or its own: genomes, matrix, log and archive as JSON.

import { engine, input, output } from "./engine.mjs";

const { Race } = await import(new URL("../../web/src/evolve/race.ts", import.meta.url));

const { settings, changes, masks, draws, format } = input();

/** Return a generator that gives the numbers drawn for a key, method by method, in their order. */
function source(...key) {
  const left = draws?.[key.join(" ")];
  if (!left) throw new Error(`draws: expected numbers for ${key.join(" ")}, got none`);
  const next = (method) => left[method].shift();
  return {
    normals: () => Float32Array.from(next("standard_normal")),
    integers: () => Int32Array.from(next("integers")),
    permutation: () => Int32Array.from(next("permutation")),
    choice: () => Int32Array.from(next("choice")),
  };
}

const race = new Race(engine, settings, masks, draws ? source : undefined);
const events = [];
const scores = { pursuer: [], evader: [] };
for (const event of race.run()) {
  events.push(event.type);
  if (event.type === "scores") {
    for (const team of ["pursuer", "evader"]) scores[team][event.number] = event.scores[team];
  }
  // Other settings from a generation on.
  const change = event.type === "generation" && changes?.[event.number];
  if (change && race.change(change)) events.push("anew");
}
let saved;
if (format) {
  // Only here: it takes a package of npm.
  const { archiveOf } = await import(new URL("../../web/src/evolve/save.ts", import.meta.url));
  saved = Buffer.from(archiveOf([{ name: "race", race }], format)).toString("base64");
}
output({ archive: race.archive, cells: [...race.cells.values()], rows: race.rows, events, scores, saved });
