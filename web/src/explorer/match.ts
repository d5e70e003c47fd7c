// The selected match: played by the engine in the page, drawn, and told in words step by step; of a game
// of one's own what the game shows of it.

import { Board, stillMotion } from "../board/board.ts";
import { recordingOf } from "../board/from_engine.ts";
import { legendOfInputs } from "../board/inputs.ts";
import type { ShownInputs } from "../board/inputs.ts";
import { legend } from "../board/legend.ts";
import { FITTING, Player } from "../board/player.ts";
import { playerBar } from "../board/player_bar.ts";
import { captureSteps } from "../board/recording.ts";
import type { Recording } from "../board/recording.ts";
import type { Engine, Match } from "../engine/engine.ts";
import { TEAMS } from "../engine/teams.ts";
import { html } from "../page/dom.ts";
import type { Champions, PageData } from "../playground/data.ts";
import { playedMatch, policyOf, ratesMoves, whyNot } from "./data.ts";
import type { Run } from "./data.ts";
import { EpisodeStrip } from "./episodes.ts";
import { capital } from "./format.ts";
import { generationName } from "./game.ts";
import { Inspector } from "./inspector.ts";
import { shownPair } from "./own_game.ts";
import type { Selection, Store } from "./store.ts";
import { playgroundButton } from "./to_playground.ts";
import type { Shown } from "./to_playground.ts";
import { lossText, lossesOf, solved, ticksOf } from "../page/solved.ts";
import type { Loss } from "../page/solved.ts";
import { wordsOf } from "./words.ts";

/** Milliseconds that a selection has to rest before its match is played. */
const REST = 60;

export class MatchPanel {
  readonly element: HTMLElement;
  readonly player = new Player(0, { speed: FITTING, still: stillMotion() });
  readonly inspector: Inspector;
  /** The match that is shown; null until the engine has played one. */
  match: Match | null = null;
  recording: Recording | null = null;
  /** The inputs of a move that are on the board. */
  inputs: ShownInputs | null = null;
  /** What can be done with the match that is shown. */
  readonly actions: HTMLElement;
  readonly #board: Board;
  readonly #runs: readonly Run[];
  readonly #store: Store;
  readonly #strip: EpisodeStrip;
  readonly #title = html("h2", { class: "match-title" });
  readonly #tally = html("p", { class: "tally numbers" });
  readonly #words = html("ol", {
    class: "words",
    tabindex: 0,
    "aria-live": "off",
    "aria-label": "What happened in this step",
  });
  readonly #problem = html("p", { class: "problem", role: "alert" });
  /** What is drawn of the inputs of moves. */
  readonly #signs = html("div", { class: "signs" });
  /** What a game of one's own shows. */
  readonly #shown = html("div", { class: "shown", "aria-live": "polite" });
  #engine: Engine | null = null;
  #champions: Champions | null = null;
  #due = 0;
  #plays = false;
  #goal = 0;
  #losses: readonly Loss[] = [];

  /** `playground`: what opens a step in the playground; null for a page without one. */
  constructor(runs: readonly Run[], store: Store, playground: PageData | null) {
    this.#runs = runs;
    this.#store = store;
    const canvas = html("canvas", {
      "aria-label": "The match",
      onclick: ({ clientX, clientY }: MouseEvent) => this.#press(clientX, clientY),
      onpointermove: ({ clientX, clientY, pointerType }: PointerEvent) =>
        pointerType === "mouse" && this.#point(clientX, clientY),
      onpointerleave: () => this.inspector.point(null, null),
    });
    this.#board = new Board(canvas, { numbers: false });
    this.#strip = new EpisodeStrip(store);
    this.inspector = new Inspector(
      (agent) => this.#look(agent),
      (inputs) => (this.#board.look = { inputs: (this.inputs = inputs) }),
    );
    this.actions = html(
      "div",
      { class: "match-actions" },
      html(
        "button",
        {
          type: "button",
          class: "to-play",
          title: "Move the chosen agent, or an evader, yourself from this step on (T)",
          onclick: () => this.element.dispatchEvent(new Event("takeover")),
        },
        "Take over",
      ),
      playground && playgroundButton(() => this.shown, playground),
    );
    this.element = html(
      "section",
      { class: "card match-card", "aria-label": "Match", id: "match" },
      html(
        "div",
        { class: "match" },
        html("header", { class: "match-head" }, this.#title, this.#tally),
        this.#problem,
        this.#shown,
        html("div", { class: "stage" }, canvas),
        html(
          "div",
          { class: "aside" },
          this.#words,
          legend(),
          this.#signs,
          this.actions,
          this.inspector.element,
        ),
        playerBar(this.player),
        this.#strip.element,
      ),
    );
    this.player.addEventListener(
      "frame",
      () => this.recording && this.#board.show(this.recording, this.player.time),
    );
    this.player.addEventListener("step", () => this.#tell());
    store.on("match", () => this.#rest());
    this.#entitle();
    this.#count(0, 0);
  }

  get #run(): Run {
    return this.#runs[this.#store.selected.run]!;
  }

  /** Bring the board into view; on a narrow page it is below what was clicked. */
  reveal(): void {
    (this.#run.game ? this.#shown : this.#board.canvas).scrollIntoView({ block: "nearest" });
  }

  /** The match and its step that is shown. */
  get shown(): Shown | null {
    return (
      this.match &&
      this.#champions && { match: this.match, step: this.player.step, champions: this.#champions }
    );
  }

  /** Begin to play matches; there is no engine in a page of other games. */
  start(engine: Engine | null): void {
    this.#engine = engine;
    this.#load();
  }

  /** Play the selected match from its first step, as soon as it is there. */
  playSoon(): void {
    this.#plays = true;
    if (!this.#due) this.#begin();
  }

  /** Show a step of the selected match, as soon as it is there. */
  goTo(step: number): void {
    this.#goal = step;
    if (!this.#due && this.match) this.#load();
  }

  #begin(): void {
    if (!this.#plays || !this.match) return;
    this.#plays = false;
    this.player.jump(0);
    if (!stillMotion()) this.player.play();
  }

  // Keys pass over many cells; only the one where they rest is played.
  #rest(): void {
    this.#entitle();
    clearTimeout(this.#due);
    this.#due = setTimeout(() => this.#load(), REST);
  }

  #load(): void {
    clearTimeout(this.#due);
    this.#due = 0;
    this.player.pause();
    this.#entitle();
    const { selected } = this.#store;
    const { game } = this.#run;
    this.#shown.replaceChildren(...(game ? shownPair(this.#run, game, selected, this.#store) : []));
    if (game) {
      this.match = this.recording = null;
      this.#plays = false;
      this.#say(selected);
      return;
    }
    const problem = TEAMS.map((team) => whyNot(this.#run, team, selected[team])).find(Boolean) ?? "";
    this.#problem.textContent = problem;
    if (problem || !this.#engine) return;
    this.match = playedMatch(this.#engine, this.#run, selected);
    const [pursuers, evaders] = this.names(selected);
    this.#champions = {
      pursuer: { name: pursuers, policy: policyOf(this.#run, "pursuer", selected.pursuer) },
      evader: { name: evaders, policy: policyOf(this.#run, "evader", selected.evader) },
    };
    this.recording = recordingOf(this.match);
    this.#strip.show(this.#run, this.match);
    this.inspector.show(this.#engine, this.#run, this.match, selected);
    this.player.length = this.match.length;
    this.player.marks = captureSteps(this.recording);
    this.#losses = this.player.ticks = [];
    this.player.jump(this.#goal);
    this.#goal = 0;
    this.#tell();
    void this.#solve(this.#engine, this.match);
    this.#say(selected);
    this.#begin();
  }

  /** The signs of the inputs that the teams have. */
  #legend(): HTMLElement[] {
    const { teams, world } = this.#run;
    const inputs = TEAMS.flatMap((team) => {
      const { policy } = teams[team];
      return policy && policy.kind !== "cells" ? policy.inputs : [];
    });
    const turns = world !== null && world.rules.interaction !== "SIMULTANEOUS";
    return legendOfInputs([...new Set(inputs)], turns);
  }

  /** Tell tests what is shown. */
  #say({ run, pursuer, evader, episode, seed }: Selection): void {
    this.element.dataset["played"] = `${run} ${pursuer} ${evader} ${episode} ${seed ?? ""}`;
  }

  /** Show what the teams lose, and perfect play beside the network's, as soon as the world is solved. */
  async #solve(engine: Engine, match: Match): Promise<void> {
    const solution = await solved(engine, match.config);
    if (this.match !== match || !solution) return;
    const world = engine.world(match.config);
    match.seek(world, 0);
    this.#losses = lossesOf(solution, world, actionsOf(match));
    world.free();
    this.player.ticks = ticksOf(this.#losses);
    this.inspector.solution = solution;
    this.#tell();
  }

  /** Return the names of what plays for the teams of a match. */
  names({ run, pursuer, evader }: Selection): [pursuers: string, evaders: string] {
    const shown = this.#runs[run]!;
    const { teams } = shown;
    return [
      teams.pursuer.script ?? generationName(shown, "pursuer", pursuer),
      teams.evader.script ?? generationName(shown, "evader", evader),
    ];
  }

  #entitle(): void {
    const { episode, seed } = this.#store.selected;
    const { game, payoff } = this.#run;
    this.element.classList.toggle("of-own-game", Boolean(game));
    this.element.classList.toggle(
      "of-ratings",
      TEAMS.some((team) => ratesMoves(this.#run, team)),
    );
    this.#signs.replaceChildren(...this.#legend());
    const [pursuers, evaders] = this.names(this.#store.selected);
    const place =
      seed === null
        ? episode < payoff.episodes
          ? `episode ${episode + 1} of ${payoff.episodes}`
          : `episode ${episode + 1}, not part of the cell`
        : `seed ${seed}`;
    this.#title.replaceChildren(
      html("span", { class: "pursuer" }, capital(pursuers)),
      " against ",
      html("span", { class: "evader" }, evaders),
      game ? "" : html("span", { class: "muted small" }, place),
    );
  }

  #tell(): void {
    const match = this.match;
    if (!match || !this.recording) return;
    const step = this.player.step;
    const moment = this.recording.moments[step]!;
    this.#count(Array.from(moment.everCaptured).filter(Boolean).length, step);
    this.#words.replaceChildren(
      ...this.#losses
        .filter((loss) => loss.step === step)
        .map((loss) => html("li", { class: `loss-${loss.team}` }, lossText(loss))),
      ...wordsOf(match, this.recording, step).map((word) =>
        html("li", { class: word.kind, "data-agents": word.agents.join(" ") }, word.text),
      ),
    );
    this.inspector.at(step);
    this.#mark();
  }

  #count(captured: number, step: number): void {
    const { world } = this.#run;
    if (world) {
      this.#tally.replaceChildren(
        html("strong", {}, captured),
        ` of ${world.n_evaders} captured`,
        html("span", { class: "muted" }, ` · step ${step}`),
      );
    }
  }

  /** Choose the agent at a point of the window, or ask about the move of the chosen one that leads there. */
  #press(x: number, y: number): void {
    const agent = this.#board.agentAt(x, y);
    const cell = this.#board.cellAt(x, y);
    if (agent === null && cell && this.inspector.askTo(cell)) return;
    this.inspector.choose(agent);
  }

  #point(x: number, y: number): void {
    this.inspector.point(this.#board.cellAt(x, y), this.#board.agentAt(x, y));
  }

  #look(agent: number | null): void {
    this.#board.look = { selected: agent, viewers: agent === null ? [] : [agent] };
    this.#mark();
  }

  /** Mark the sentences that speak of the selected agent. */
  #mark(): void {
    const agent = this.inspector.agent;
    for (const item of this.#words.children) {
      const agents = (item as HTMLElement).dataset["agents"]?.split(" ") ?? [];
      item.classList.toggle("about", agent !== null && agents.includes(String(agent)));
    }
  }
}

/** Return the actions (A,) of each step. */
const actionsOf = ({ actions, length, n_agents }: Match): Uint8Array[] =>
  Array.from({ length }, (_, step) => actions.subarray(step * n_agents, (step + 1) * n_agents));
