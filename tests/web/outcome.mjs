// What the page says of races, and of what agents do.

import { input, output } from "./engine.mjs";

const { outcomeOf } = await import(new URL("../../web/src/evolve/outcome.ts", import.meta.url));
const { sentence } = await import(new URL("../../web/src/evolve/words.ts", import.meta.url));

const { races, told, data } = input();
const outcomes = races.map((scores) =>
  outcomeOf(
    new Map(scores.flatMap((row, g) => row.map((capture_rates, h) => [`${g} ${h}`, { capture_rates }]))),
    scores.length,
  ),
);
output({ outcomes, sentences: told.map(([team, effects]) => sentence(data, team, effects)) });
