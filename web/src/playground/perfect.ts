// Perfect play of a small scene, for readers who open it.

import { whyNotSolved } from "../engine/solution.ts";
import { html } from "../page/dom.ts";
import { lossText, perfectText, worthText } from "../page/solved.ts";
import { agentName, configOf, nAgents } from "./scene.ts";
import type { Store } from "./store.ts";

/** Return the card; it solves the scene while it is open. */
export function perfectPanel(store: Store): HTMLElement {
  const body = html("ul", { class: "lines", "aria-live": "polite" });
  const element = html(
    "details",
    { class: "card perfect" },
    html("summary", {}, html("h2", {}, "Perfect play")),
    body,
    html(
      "p",
      { class: "small muted" },
      "A team is one player here. An agent's shares are its part of the joint moves.",
    ),
  );
  let asked = 0;
  const tell = (...lines: string[]): void =>
    body.replaceChildren(...lines.filter(Boolean).map((line) => html("li", { class: "line" }, `${line}.`)));
  const update = async (): Promise<void> => {
    const mine = ++asked;
    if (!element.open) return;
    const why = whyNotSolved(configOf(store.scene, store.scene.rules));
    if (why) return tell(`Not known: ${why}`);
    const solution = await store.solution();
    if (mine !== asked || !solution) return;
    const { game, losses } = store.game.perfect(solution);
    const plays = Array.from({ length: nAgents(store.scene) }, (_, agent) => {
      const play = game && perfectText(game, agent);
      return play ? `${agentName(store.scene, agent)}: ${play}` : "";
    });
    const none = store.game.over
      ? "The episode has ended"
      : "Not known: no start on distinct free cells leads to this moment";
    tell(
      ...losses.map((loss) => `In the last step: ${lossText(loss)}`),
      game ? `From here: ${worthText(solution, game, store.game.length)}` : none,
      ...plays,
    );
  };
  for (const [target, type] of [
    [store, "change"],
    [element, "toggle"],
  ] as const) {
    target.addEventListener(type, () => void update());
  }
  return element;
}
