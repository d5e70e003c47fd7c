// What an agent sees, and what its policy answers.

import type { ShownInputs } from "../board/inputs.ts";
import { MOVES } from "../board/recording.ts";
import type { Engine, Match, Solution, World } from "../engine/engine.ts";
import type { Cell, TeamPolicy } from "../engine/types.ts";
import { html } from "../page/dom.ts";
import { ACTIONS, agentName } from "../page/names.ts";
import { policyOf, programOf } from "./data.ts";
import type { ProgramText, RatesMoves, Run } from "./data.ts";
import type { Selection } from "./store.ts";
import { shownInputs } from "./shown_inputs.ts";
import { drawView } from "./view.ts";
import { inputsRead, whyTable } from "./why.ts";

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
  readonly #onShow: ((inputs: ShownInputs | null) => void) | null;
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
  /** The move that a person asks about; null for the one that the agent takes. */
  #asked: number | null = null;
  /** What the pointer is on: an agent that is not the chosen one, or a move of the chosen one. */
  #pointed: { readonly agent: number; readonly move: number | null } | null = null;
  /** Agents at the step that is shown, as far as they have been looked at. */
  readonly #standings = new Map<number, Standing | null>();

  /** `onShow` gets the inputs of a move that are to be drawn on the board, where it draws any. */
  constructor(
    onChoose: (agent: number | null) => void,
    onShow: ((inputs: ShownInputs | null) => void) | null = null,
  ) {
    this.#onChoose = onChoose;
    this.#onShow = onShow;
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
    this.#forget();
  }

  /** The solution of the world of the match. */
  set solution(solution: Solution) {
    this.#solution = solution;
    this.at(this.#step);
  }

  /** Choose an agent; null for none. */
  choose(agent: number | null): void {
    this.#agent = agent;
    this.#forget();
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

  // ---- Moves that a person asks about -----------------------------------------------------------

  /** Ask about the next move of the chosen agent, or the one before. */
  ask(by: 1 | -1): void {
    const moves = this.#moves();
    if (!moves.length) return;
    const now = moves.indexOf(this.#asked ?? this.#taken(this.#agent!) ?? 0);
    this.#asked = moves[(now + by + moves.length) % moves.length]!;
    this.at(this.#step);
  }

  /** Ask about the move of the chosen agent that leads to a cell; return whether there is one. */
  askTo(cell: Cell): boolean {
    const move = this.#moveTo(cell);
    if (move === null) return false;
    this.#asked = move;
    this.#pointed = null;
    this.at(this.#step);
    return true;
  }

  /** Point at a cell and the agent there, if any; at none where the pointer leaves the board. */
  point(cell: Cell | null, agent: number | null): void {
    const move = cell && this.#moveTo(cell);
    const chosen = this.#agent;
    const pointed =
      move !== null && chosen !== null
        ? { agent: chosen, move }
        : agent !== null && agent !== chosen
          ? { agent, move: null }
          : null;
    if (pointed?.agent === this.#pointed?.agent && pointed?.move === this.#pointed?.move) return;
    this.#pointed = pointed;
    this.at(this.#step);
  }

  #forget(): void {
    this.#asked = this.#pointed = null;
    this.#standings.clear();
  }

  /** The moves of the chosen agent that a person may ask about: those that lead into no obstacle. */
  #moves(): number[] {
    const agent = this.#agent;
    if (agent === null || !this.#match || !this.#rates(agent)) return [];
    const { config } = this.#match;
    const view = this.#standing(agent)?.view;
    const half = Math.floor(config.fov / 2);
    return MOVES.slice(0, config.diagonal ? 9 : 5).flatMap(([row, col], move) =>
      view && !view[(2 * config.fov + half + row) * config.fov + half + col] ? [move] : [],
    );
  }

  #moveTo([row, col]: Cell): number | null {
    const agent = this.#agent;
    const at = agent === null ? null : this.#standing(agent)?.at;
    if (!at) return null;
    return (
      this.#moves().find((move) => at[0] + MOVES[move]![0] === row && at[1] + MOVES[move]![1] === col) ?? null
    );
  }

  // ---- A moment ---------------------------------------------------------------------------------

  #teamOf(agent: number): "pursuer" | "evader" {
    return agent < this.#match!.config.n_pursuers ? "pursuer" : "evader";
  }

  /** The policy of an agent, if it rates moves. */
  #rates(agent: number): RatesMoves | null {
    const policy = this.#policies?.[`${this.#teamOf(agent)}s`];
    return policy && typeof policy !== "string" && policy.kind !== "cells" ? policy : null;
  }

  #program(agent: number): ProgramText | null {
    const team = this.#teamOf(agent);
    return programOf(this.#run!, team, this.#selection![team]);
  }

  /** The action that an agent takes next. */
  #taken(agent: number): number | null {
    const { actions, n_agents } = this.#match!;
    return actions[this.#step * n_agents + agent] ?? null;
  }

  /** Return an agent where it decides; null if it is gone. */
  #standing(agent: number): Standing | null {
    if (!this.#standings.has(agent)) this.#standings.set(agent, this.#playTo(agent));
    return this.#standings.get(agent)!;
  }

  /** Play on to where an agent decides, in its own turn. */
  #playTo(agent: number): Standing | null {
    const [match, world, step] = [this.#match!, this.#world!, this.#step];
    match.seek(world, step, this.#policies!);
    const before = world.read("positions");
    const actions = match.actions.subarray(step * match.n_agents, (step + 1) * match.n_agents);
    while (actions.length && !world.over && (agent < world.actors[0] || agent >= world.actors[1])) {
      world.playTurn(actions);
    }
    const alive = world.read("alive");
    if (!match.alive[step * match.n_agents + agent] || !alive[agent]) return null;
    const positions = world.read("positions");
    const cell = (each: number): Cell => [positions[2 * each]!, positions[2 * each + 1]!];
    const moved = Array.from(alive, (_, each) => each).filter(
      (each) =>
        alive[each] &&
        (positions[2 * each] !== before[2 * each] || positions[2 * each + 1] !== before[2 * each + 1]),
    );
    return {
      at: cell(agent),
      view: world.view(agent),
      moved: moved.map((each) => ({ pursuer: this.#teamOf(each) === "pursuer", cell: cell(each) })),
    };
  }

  /** Draw on the board the inputs of the move that is pointed at or asked about, else of the one taken. */
  #draw(): void {
    if (!this.#onShow) return;
    const agent = this.#pointed?.agent ?? this.#agent;
    const policy = agent === null || !this.#match ? null : this.#rates(agent);
    const move = agent === null || !policy ? null : this.#shownMove(agent);
    const standing = agent === null || move === null ? null : this.#standing(agent);
    if (agent === null || !policy || move === null || !standing) return this.#onShow(null);
    const asked = { config: this.#match!.config, team: this.#teamOf(agent), move, ...standing };
    const read = inputsRead(policy, this.#program(agent));
    this.#onShow({ ...shownInputs(asked, read), moved: standing.moved });
  }

  /** The move whose inputs are on the board. */
  #shownMove(agent: number): number | null {
    const asked = agent === this.#agent ? this.#asked : null;
    return this.#pointed?.move ?? asked ?? this.#taken(agent);
  }

  /** Show a moment: what the agent sees there, and the action that it takes next. */
  at(step: number): void {
    if (step !== this.#step) this.#forget();
    this.#step = step;
    this.#tell();
    this.#draw();
  }

  #tell(): void {
    const match = this.#match;
    const world = this.#world;
    const run = this.#run;
    const selection = this.#selection;
    const policies = this.#policies;
    const agent = this.#agent;
    if (!match || !world || !run || !selection || !policies || agent === null) return;
    const team = this.#teamOf(agent);
    this.#memory.replaceChildren();
    this.#name.replaceChildren(html("span", { class: team }, agentName(agent, match.config.n_pursuers)));
    const standing = this.#playTo(agent); // the world is asked below
    drawView(this.#canvas, match.config, standing?.view ?? null, agent);
    this.#canvas.ariaLabel = `Field of view of ${agentName(agent, match.config.n_pursuers)}: evaders, pursuers and obstacles around it`;
    if (!standing) return this.#say([], "It is gone.");
    const taken = this.#taken(agent);
    const policy = policies[`${team}s`];
    const answer = typeof policy !== "string" && policy.kind === "cells" ? world.answer(policy, agent) : null;
    const own = answer?.probabilities ?? null;
    if (answer?.memory.length) {
      this.#memory.replaceChildren(
        html("p", { class: "small muted" }, "It remembers:"),
        units(answer.memory),
      );
    }
    const rates = this.#rates(agent);
    const shown = this.#onShow ? this.#shownMove(agent) : null;
    const rated = rates ? whyTable(rates, world.rate(rates, agent), taken, shown, this.#program(agent)) : [];
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

/** An agent where it decides: its cell, what it sees, and agents that have moved in turns before. */
interface Standing extends Pick<ShownInputs, "moved"> {
  readonly at: Cell;
  readonly view: Uint8Array;
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
