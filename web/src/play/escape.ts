// "Can you escape it?": one evader, three rounds against pursuers of rising generation, a score.

import type { WorldConfig } from "../engine/types.ts";
import { html } from "../page/dom.ts";
import { ladder, randomSeed, resultOf } from "./played.ts";
import type { Player } from "./played.ts";
import type { PlayView } from "./view.ts";

const SIDE = 20;
const STEPS = 60;

/** Return the world of the game: small, and with as few pursuers as can capture. */
function worldOf(world: WorldConfig): WorldConfig {
  const most = world.rules.capture === "SURROUND" ? 8 : 4;
  const mapped = typeof world.obstacles !== "number";
  const side = (own: number): number => (mapped ? own : Math.min(own, SIDE));
  return {
    ...world, rows: side(world.rows), cols: side(world.cols), max_steps: STEPS, n_evaders: 1, n_pursuers: Math.min(world.n_pursuers, most),
  };
}

/** Play the rounds, one after the other. */
export function escapeGame(view: PlayView, world: WorldConfig, pursuers: readonly Player[]): void {
  const [config, rivals, scores] = [worldOf(world), ladder(pursuers), [] as number[]];
  const score = (): string => `${scores.reduce((sum, each) => sum + each, 0)} of ${STEPS * rivals.length}`;
  const round = (): void => view.play({
    title: `Can you escape it? Round ${scores.length + 1} of ${rivals.length}, pursuers: ${rivals[scores.length]!.name}`,
    about: rivals[scores.length]!.text && `${rivals[scores.length]!.name}: ${rivals[scores.length]!.text}`,
    played: {
      config, seed: randomSeed(), episode: 0, seat: config.n_pursuers, from: 0, moves: [],
      policies: { pursuer: rivals[scores.length]!.policy(), evader: "still" },
    },
    ending: (live) => {
      scores.push(resultOf(live, config.n_pursuers).lasted);
      const rows = rivals.map(({ name }, place) => html("tr", {}, html("th", { scope: "row" }, name), html("td", {}, scores[place] ?? "")));
      const left = scores.length < rivals.length;
      return [
        html("table", { class: "numbers" }, html("caption", {}, `Steps of ${STEPS} in each round`), ...rows),
        html("p", { class: "play-score" }, left ? "Score so far: " : "Your score: ", html("strong", {}, score())),
        left ? html("button", { type: "button", class: "primary", onclick: round }, "Next round") : "",
      ];
    },
    again: () => escapeGame(view, world, pursuers),
    link: () => null,
  });
  round();
}
