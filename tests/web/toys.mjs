// The games of the lesson: hands, and a numbers game with the ones of all individuals and the mean score at its end.

import { NumbersGame, alternate, generator, meanScore } from "../../web/src/lesson/toys.ts";

const input = JSON.parse(await new Response(process.stdin).text());
const hands = input.memories.map((memory) => alternate(input.generations, memory, generator(input.seed)));
const games = input.games.map(({ game, settings, generations }) => {
  const playing = new NumbersGame(game, settings, generator(input.seed));
  for (let i = 0; i < generations; i++) playing.step();
  const ones = [playing.ones(0), playing.ones(1)];
  return { ones, score: meanScore(game, ...ones) };
});
process.stdout.write(JSON.stringify({ hands, games }));
