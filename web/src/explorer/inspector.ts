// What an agent sees, and what its network answers.

import type { Engine, Match, World } from "../engine/engine.ts";
import { html } from "../page/dom.ts";
import { ACTIONS, agentName } from "../page/names.ts";
import { policyOf } from "./data.ts";
import type { Run } from "./data.ts";
import type { Selection } from "./store.ts";
import { drawView } from "./view.ts";

export class Inspector {
  readonly element: HTMLElement;
  readonly #onChoose: (agent: number | null) => void;
  readonly #canvas = html("canvas", { class: "seen", role: "img" });
  readonly #name = html("h3");
  readonly #note = html("p", { class: "small muted" });
  readonly #bars = html("div", { class: "answers" });
  #world: World | null = null;
  #run: Run | null = null;
  #match: Match | null = null;
  #selection: Selection | null = null;
  #agent: number | null = null;
  #step = 0;

  constructor(onChoose: (agent: number | null) => void) {
    this.#onChoose = onChoose;
    this.element = html(
      "div", { class: "inspector", "data-open": "false" },
      html("p", { class: "hint small muted" }, "Click an agent, or press A: what it sees, and what its network answers."),
      html("div", { class: "inspected" }, this.#canvas, html("div", { class: "answer" }, this.#name, this.#note), this.#bars),
    );
  }

  get agent(): number | null {
    return this.#agent;
  }

  /** Look at a match; the agent stays chosen. */
  show(engine: Engine, run: Run, match: Match, selection: Selection): void {
    if (this.#run !== run || !this.#world) {
      this.#world?.free();
      this.#world = engine.world(run.world);
      if (this.#agent !== null && this.#run !== run) this.choose(null);
    }
    [this.#run, this.#match, this.#selection] = [run, match, selection];
  }

  /** Choose an agent; null for none. */
  choose(agent: number | null): void {
    this.#agent = agent;
    this.element.dataset["open"] = String(agent !== null);
    this.#onChoose(agent);
    this.at(this.#step);
  }

  /** Choose the next agent that is in the world, or the one before. */
  next(by: 1 | -1): void {
    const match = this.#match;
    if (!match) return;
    let agent = this.#agent ?? (by > 0 ? -1 : 0);
    for (let tried = 0; tried < match.n_agents; tried++) {
      agent = (agent + by + match.n_agents) % match.n_agents;
      if (match.alive[this.#step * match.n_agents + agent]) return this.choose(agent);
    }
  }

  /** Show a moment: what the agent sees there, and the action that it takes next. */
  at(step: number): void {
    this.#step = step;
    const [match, world, run, selection, agent] = [this.#match, this.#world, this.#run, this.#selection, this.#agent];
    if (!match || !world || !run || !selection || agent === null) return;
    const team = agent < match.config.n_pursuers ? "pursuer" : "evader";
    this.#name.replaceChildren(html("span", { class: team }, agentName(agent, match.config.n_pursuers)));
    const alive = Boolean(match.alive[step * match.n_agents + agent]);
    match.seek(world, step);
    drawView(this.#canvas, match.config, alive ? world.view(agent) : null, agent);
    this.#canvas.ariaLabel = `Field of view of ${agentName(agent, match.config.n_pursuers)}: evaders, pursuers and obstacles around it`;
    const taken = step < match.length ? match.actions[step * match.n_agents + agent]! : null;
    if (!alive) return this.#say([], "It is gone.");
    const policy = policyOf(run, team, selection[team]);
    if (typeof policy === "string") return this.#say([], `The script "${policy}" plays for it${taken === null ? "" : `; it goes ${ACTIONS[taken]}`}.`);
    const { probabilities } = world.answer(policy, agent);
    const bars = Array.from(probabilities, (probability, action) => bar(ACTIONS[action]!, probability, action === taken));
    const drawn = policy.sampled ? "Its action is drawn from these probabilities." : "It takes the most probable action.";
    this.#say(bars, taken === null ? "The episode is over." : drawn);
  }

  #say(bars: readonly HTMLElement[], note: string): void {
    this.#bars.replaceChildren(...bars);
    this.#note.textContent = note;
  }
}

function bar(action: string, probability: number, taken: boolean): HTMLElement {
  const filled = html("span", { class: "filled" });
  filled.style.width = `${100 * probability}%`;
  return html(
    "div", { class: taken ? "action taken" : "action" },
    html("span", {}, action), html("span", { class: "track" }, filled),
    html("span", { class: "numbers" }, probability.toFixed(2)),
  );
}
