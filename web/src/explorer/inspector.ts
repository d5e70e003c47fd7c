// What an agent sees, and what its policy answers.

import type { Engine, Match, Solution, World } from "../engine/engine.ts";
import type { TeamPolicy } from "../engine/types.ts";
import { html } from "../page/dom.ts";
import { ACTIONS, agentName } from "../page/names.ts";
import { policyOf, programOf } from "./data.ts";
import type { Run } from "./data.ts";
import type { Selection } from "./store.ts";
import { drawView } from "./view.ts";
import { whyTable } from "./why.ts";

/** What plays for both teams. */
type Policies = Readonly<Record<"pursuers" | "evaders", TeamPolicy>>;

const policiesOf = (run: Run, { pursuer, evader }: Selection): Policies => ({
  pursuers: policyOf(run, "pursuer", pursuer),
  evaders: policyOf(run, "evader", evader),
});

const MEMORY = "What it remembers: a number for each unit, from -1 to 1";

export class Inspector {
  readonly element: HTMLElement;
  readonly #onChoose: (agent: number | null) => void;
  readonly #canvas = html("canvas", { class: "seen", role: "img" });
  readonly #name = html("h3");
  readonly #note = html("p", { class: "small muted" });
  readonly #bars = html("div", { class: "answers" });
  readonly #memory = html("div", { title: MEMORY });
  #world: World | null = null;
  #solution: Solution | null = null;
  #run: Run | null = null;
  #match: Match | null = null;
  #selection: Selection | null = null;
  #policies: Policies | null = null;
  #agent: number | null = null;
  #step = 0;

  constructor(onChoose: (agent: number | null) => void) {
    this.#onChoose = onChoose;
    this.element = html(
      "div",
      { class: "inspector", "data-open": "false" },
      html(
        "p",
        { class: "hint small muted" },
        "Click an agent, or press A: what it sees, and why it takes its move.",
      ),
      html(
        "div",
        { class: "inspected" },
        this.#canvas,
        html("div", { class: "answer" }, this.#name, this.#note, this.#memory),
        this.#bars,
      ),
    );
  }

  get agent(): number | null {
    return this.#agent;
  }

  /** Look at a match; the agent stays chosen. */
  show(
    engine: Engine,
    run: Run,
    match: Match,
    selection: Selection,
    policies = policiesOf(run, selection),
  ): void {
    // A new world: one of the same seed may have played other networks.
    this.#world?.free();
    this.#world = engine.world(match.config);
    if (this.#run !== run) {
      this.#solution = null;
      if (this.#agent !== null) this.choose(null);
    }
    this.#run = run;
    this.#match = match;
    this.#selection = selection;
    this.#policies = policies;
  }

  /** The solution of the world of the match. */
  set solution(solution: Solution) {
    this.#solution = solution;
    this.at(this.#step);
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
    const match = this.#match;
    const world = this.#world;
    const run = this.#run;
    const selection = this.#selection;
    const policies = this.#policies;
    const agent = this.#agent;
    if (!match || !world || !run || !selection || !policies || agent === null) return;
    const team = agent < match.config.n_pursuers ? "pursuer" : "evader";
    this.#memory.replaceChildren();
    this.#name.replaceChildren(html("span", { class: team }, agentName(agent, match.config.n_pursuers)));
    match.seek(world, step, policies);
    // As it decides, in its own turn.
    const actions = match.actions.subarray(step * match.n_agents, (step + 1) * match.n_agents);
    while (actions.length && !world.over && (agent < world.actors[0] || agent >= world.actors[1])) {
      world.playTurn(actions);
    }
    const alive = Boolean(match.alive[step * match.n_agents + agent] && world.read("alive")[agent]);
    drawView(this.#canvas, match.config, alive ? world.view(agent) : null, agent);
    this.#canvas.ariaLabel = `Field of view of ${agentName(agent, match.config.n_pursuers)}: evaders, pursuers and obstacles around it`;
    const taken = actions[agent] ?? null;
    if (!alive) return this.#say([], "It is gone.");
    const policy = policies[`${team}s`];
    const answer = typeof policy !== "string" && policy.kind === "cells" ? world.answer(policy, agent) : null;
    const own = answer?.probabilities ?? null;
    if (answer?.memory.length) {
      this.#memory.replaceChildren(
        html("p", { class: "small muted" }, "It remembers:"),
        units(answer.memory),
      );
    }
    const rated =
      typeof policy !== "string" && policy.kind !== "cells"
        ? whyTable(policy, world.rate(policy, agent), taken, programOf(run, team, selection[team]))
        : [];
    const game = this.#solution?.game(world) ?? null;
    const columns = [
      ["network", own],
      ["perfect", game?.marginal(agent) ?? null],
    ] as const;
    const line = (text: string): HTMLElement => html("p", { class: "small muted" }, text);
    this.#say(
      [
        ...(game ? [line(`Value ${game.value.toFixed(2)} under perfect play.`)] : []),
        ...table(columns, taken),
        ...rated,
      ],
      taken === null ? "The episode is over." : howTaken(policy, taken),
    );
  }

  #say(bars: readonly HTMLElement[], note: string): void {
    this.#bars.replaceChildren(...bars);
    this.#note.textContent = note;
  }
}

/** Say how a policy came to an action. */
function howTaken(policy: TeamPolicy, action: number): string {
  if (typeof policy === "string") return `The script "${policy}" plays for it; it goes ${ACTIONS[action]}.`;
  if (policy.kind !== "cells") return "It takes the best move that its mask allows; of equal ones any.";
  return policy.sampled
    ? "Its action is drawn from these probabilities."
    : "It takes the most probable action.";
}

type Column = readonly [name: string, probabilities: ArrayLike<number> | null];

/** Return a row for each action, with the bars of those who know its probability. */
function table(all: readonly Column[], taken: number | null): HTMLElement[] {
  const columns = all.filter(([, probabilities]) => probabilities) as [string, ArrayLike<number>][];
  if (!columns.length) return [];
  const head = html(
    "div",
    { class: "action muted" },
    html("span"),
    ...columns.map(([name]) => html("span", { class: "head" }, name)),
  );
  const rows = Array.from(columns[0]![1], (_, action) =>
    html(
      "div",
      { class: action === taken ? "action taken" : "action" },
      html("span", {}, ACTIONS[action]),
      ...columns.flatMap(([, probabilities]) => bar(probabilities[action]!)),
    ),
  );
  return columns.length > 1 || columns[0]![0] !== all[0]![0] ? [head, ...rows] : rows;
}

function bar(probability: number): HTMLElement[] {
  const filled = html("span", { class: "filled" });
  filled.style.width = `${100 * probability}%`;
  return [
    html("span", { class: "track" }, filled),
    html("span", { class: "numbers" }, probability.toFixed(2)),
  ];
}

/** Return a bar for each number that an agent remembers: up from the middle, or down. */
function units(memory: Float32Array): HTMLElement {
  const bars = Array.from(memory, (number) => {
    const bar = html("span", { title: number.toFixed(2) });
    bar.style.transform = `scaleY(${number})`;
    return bar;
  });
  return html("div", { class: "units", role: "img", "aria-label": MEMORY }, ...bars);
}
