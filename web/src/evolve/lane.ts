// One race on the page: its worker, the boards of the newest generations, the matrix and the curve that grow.

import type { Engine, Match } from "../engine/engine.ts";
import { chart, frame, legend, line } from "../explorer/chart.ts";
import { MatchPanel } from "../explorer/match.ts";
import { MatrixPanel } from "../explorer/matrix.ts";
import { Store } from "../explorer/store.ts";
import { TakeOver } from "../explorer/take_over.ts";
import { html } from "../page/dom.ts";
import type { GenomePolicy } from "../engine/types.ts";
import { Chase } from "./chase.ts";
import type { EvolveData } from "./data.ts";
import { scheduleName } from "./data.ts";
import { GrowingRun } from "./growing_run.ts";
import { generalization, lateForgetting, mean } from "./measures.ts";
import { FIXED, Race } from "./race.ts";
import type { Cell, OfTeams } from "./race.ts";
import type { Finished } from "./save.ts";
import { TEAMS } from "./settings.ts";
import { Weights } from "./weights.ts";
import type { RaceSettings } from "./settings.ts";
import type { Order, Told } from "./worker.ts";

const percent = (rate: number): string => `${Math.round(100 * rate)} %`;
/** Milliseconds between two drawings of what grows. */
const REST = 100;
let count = 0;

/** A race, and all that shows it. It dispatches `state` when it begins, gets on or ends. */
export class Lane extends EventTarget {
  readonly element: HTMLElement;
  readonly newest: Chase;
  readonly beginning: Chase;
  settings: RaceSettings;
  state: "waiting" | "evolving" | "ended" | "stopped" = "waiting";
  /** Share of the epochs that have been played. */
  done = 0;
  seconds = 0;
  readonly #data: EvolveData;
  readonly #engine: Engine;
  readonly #worker: Worker;
  readonly #title = html("h2", { class: "lane-title" });
  readonly #facts = html("p", { class: "facts numbers" });
  readonly #room = html("div", { class: "lane-room", hidden: true });
  readonly #measures = html("section", { class: "card measures", hidden: true });
  readonly #dialogs = html("div");
  readonly #weights: Weights;
  #run!: GrowingRun;
  #scores: OfTeams<(number | null)[]> = { pursuer: [], evader: [] };
  #cells = new Map<string, Cell>();
  #store!: Store;
  #takeOver!: TakeOver;
  #drawChart: () => void = () => {};
  #episode = 0;
  #follows = true;
  #due = 0;
  #saved: ((race: Finished) => void) | null = null;

  constructor(data: EvolveData, engine: Engine, worker: Worker, settings: RaceSettings) {
    super();
    [this.#data, this.#engine, this.#worker, this.settings] = [data, engine, worker, settings];
    this.newest = new Chase(() => this.#match(this.#run.newest));
    this.beginning = new Chase(() => this.#match(0));
    this.beginning.element.classList.add("beginning");
    this.#weights = new Weights(engine, () => this.#renew(true));
    const boards = html("div", { class: "boards" }, this.newest.element, this.beginning.element);
    this.element = html("section", { class: "lane" }, this.#title, this.#facts, boards, this.#room, this.#weights.element, this.#measures, this.#dialogs);
    worker.onmessage = ({ data: told }: MessageEvent<Told>) => this.#hear(told);
    this.reset(settings);
  }

  /** Show generation 0 of a race that has not begun. */
  reset(settings: RaceSettings): void {
    this.#order({ type: "stop" });
    [this.settings, this.state, this.done] = [settings, "waiting", 0];
    this.#begin();
    const { archive } = new Race(this.#engine, settings, this.#data.masks);
    this.#run.add({ pursuer: archive.pursuer[0]!, evader: archive.evader[0]! });
    this.#room.hidden = this.#measures.hidden = true;
    this.#renew(true);
    this.#tell();
  }

  /** Begin the race anew. */
  start(): void {
    this.#begin();
    [this.state, this.done] = ["evolving", 0];
    this.#room.hidden = false;
    this.#measures.hidden = true;
    this.#order({ type: "start", settings: this.settings, masks: this.#data.masks });
    this.#tell();
  }

  stop(): void {
    this.#order({ type: "stop" });
    if (this.state === "evolving") this.state = "stopped";
    this.#tell();
  }

  /** Go on with other settings. */
  change(settings: RaceSettings): void {
    if (this.state === "waiting") return this.reset(settings);
    this.settings = settings;
    this.#order({ type: "change", settings });
    this.#tell();
  }

  /** Let a person play against the newest generation. */
  takeOver(): void {
    const newest = this.#run.newest;
    this.#takeOver.play({ run: 0, pursuer: newest, evader: newest, episode: 0, seed: null }, { seat: this.#run.world.n_pursuers, from: 0, moves: [] });
  }

  /** Return what can be saved. */
  saved(): Promise<Finished> {
    return new Promise((resolve) => {
      this.#saved = resolve;
      this.#order({ type: "save" });
    });
  }

  /** Generations that have been evolved. */
  get newestGeneration(): number {
    return this.#run.newest;
  }

  close(): void {
    this.#worker.terminate();
    this.newest.runs = this.beginning.runs = false;
  }

  #order(order: Order): void {
    this.#worker.postMessage(order);
  }

  // ---- What the worker tells --------------------------------------------------------------------

  #hear(told: Told): void {
    if (told.type === "generation") {
      if (this.state !== "evolving") return;
      this.#run.add(told.genomes);
      this.#renew(told.number === 0);
    } else if (told.type === "cell") {
      const { pursuer, evader } = told.cell;
      this.#run.addCell(told.cell);
      if (this.#follows && pursuer === evader && pursuer === this.#run.newest) this.#store.select({ pursuer, evader });
      this.#cells.set(`${pursuer} ${evader}`, told.cell);
    } else if (told.type === "scores") {
      for (const team of TEAMS) this.#scores[team][told.number] = told.scores[team];
    } else if (told.type === "anew") {
      this.#run.change(told.settings, told.genomes);
      this.#clear();
      this.#renew(true);
    } else if (told.type === "epoch") {
      this.done = told.done / told.of;
    } else if (told.type === "end") {
      if (this.state === "evolving") [this.state, this.seconds, this.done] = ["ended", told.seconds, 1];
      this.#showMeasures();
    } else if (told.type === "saved") {
      this.#saved?.(told.race);
    } else {
      this.#facts.textContent = `The race failed: ${told.message}`;
      this.state = "stopped";
    }
    // Cells come quicker than they need to be drawn.
    if (!this.#due) this.#due = setTimeout(() => requestAnimationFrame(() => this.#show()), REST);
  }

  #show(): void {
    this.#due = 0;
    this.#store.dispatchEvent(new Event("run"));
    this.#drawChart();
    this.#tell();
  }

  #clear(): void {
    this.#cells = new Map();
    this.#scores = { pursuer: [], evader: [] };
    this.#measures.hidden = true;
  }

  // ---- What is shown ----------------------------------------------------------------------------

  #begin(): void {
    const key = `race ${count++}`;
    const name = scheduleName(this.settings);
    this.#run = new GrowingRun(this.settings, this.#data.masks, name, key);
    this.#clear();
    this.#follows = true;
    this.#store = new Store({ run: 0, pursuer: 0, evader: 0, episode: 0, seed: null });
    const [matrix, match] = [new MatrixPanel([this.#run], this.#store), new MatchPanel([this.#run], this.#store, null)];
    matrix.element.ariaLabel = `Payoff matrix. ${name}`; // of two races, each has its own name
    this.#takeOver = new TakeOver([this.#run], this.#store, match, false);
    this.#takeOver.start(this.#engine);
    const dialog = html("dialog", { class: "of-cell-match", "aria-label": "Match", onclose: () => match.player.pause() },
      html("button", { type: "button", class: "leave", onclick: () => dialog.close() }, "Close"), match.element);
    let started = false;
    matrix.element.addEventListener("play", () => {
      const { pursuer, evader } = this.#store.selected;
      this.#follows = false;
      if (this.#run.payoff.capture_rate[pursuer]![evader] === undefined) return;
      dialog.showModal();
      if (!started) match.start(this.#engine);
      started = true;
      match.playSoon();
    });
    const made = chart(`Scores against scripts, by generation: ${FIXED.pursuer.join(", ")} and ${FIXED.evader.join(", ")}`,
      (width, height) => {
        const last = this.settings.schedule.generations;
        const into = frame(width, height, { low: 0, high: last, label: "generation", whole: true }, { low: 0, high: 1, label: "score" });
        for (const team of TEAMS) {
          const known = Array.from(this.#scores[team], (score) => score ?? null);
          line(into, [...known.keys()], known, `of-${team}s`);
        }
        return into;
      }, () => {}, (generation) => {
        const chosen = Math.min(this.#run.newest, Math.max(0, Math.round(generation)));
        this.#store.select({ pursuer: chosen, evader: chosen });
      });
    this.#drawChart = made.redraw;
    this.#room.replaceChildren(matrix.element,
      html("section", { class: "card scores" }, html("h3", {}, "Against opponents that never change"),
        html("p", { class: "small muted" }, "Captures of random walkers and of clumsy fleers; escapes from random walkers and from clumsy chasers."),
        legend(["pursuers", "of-pursuers"], ["evaders", "of-evaders"]), made.element));
    this.#dialogs.replaceChildren(dialog, this.#takeOver.dialog);
  }

  /** Play a match of the newest evaders, against pursuers of a generation. */
  #match(pursuer: number): Match | null {
    const evader = this.#run.newest;
    if (evader < 0 || pursuer < 0) return null;
    const { world, payoff, seeds } = this.#run;
    const episode = this.#episode++ % payoff.episodes;
    this.newest.title.textContent = evader ? "Newest against newest" : "Generation 0: nobody has learned anything yet";
    this.beginning.title.textContent = "Pursuers of generation 0, newest evaders";
    for (const chase of [this.newest, this.beginning]) chase.generation = evader;
    for (const chase of [this.newest, this.beginning]) chase.label = `A match. ${chase.title.textContent}`;
    const [pursuers, evaders] = TEAMS.map((team) => this.#run.playing(team, team === "pursuer" && pursuer < evader ? this.#run.genomes.pursuer[pursuer]! : this.#weights.genome(team))) as [GenomePolicy, GenomePolicy];
    return this.#engine.match(world, pursuers, evaders, BigInt(seeds[pursuer]![evader]!), episode);
  }

  #renew(at_once: boolean): void {
    this.#weights.show(this.#run);
    this.newest.renew(at_once);
    if (this.#run.newest > 0 || this.state !== "waiting") this.beginning.renew(at_once);
  }

  #tell(): void {
    this.element.dataset["state"] = this.state;
    this.#title.textContent = scheduleName(this.settings);
    const cell = this.#cells.get(`${this.#run.newest} ${this.#run.newest}`) ?? this.#cells.get(`${this.#run.newest - 1} ${this.#run.newest - 1}`);
    const parts = cell ? [
      `Generation ${this.#run.newest} of ${this.settings.schedule.generations}`,
      `the newest pursuers catch ${percent(mean(cell.capture_rates))} of the newest evaders`,
      `${collisions(cell).toFixed(0)} collisions in 1000 moves`,
    ] : [];
    this.#facts.replaceChildren(...parts.map((text) => html("span", {}, text)));
    this.dispatchEvent(new Event("state"));
  }

  #showMeasures(): void {
    this.#measures.ariaLabel = `What came out. ${scheduleName(this.settings)}`;
    const rates = this.#run.payoff.capture_rate.slice(0, this.#run.newest + 1).map((row) => row.slice(0, this.#run.newest + 1));
    if (rates.length < 2 || rates.some((row) => Array.from(row).includes(undefined as never))) return;
    const rows: readonly (readonly [string, (team: "pursuer" | "evader") => string])[] = [
      ["Score against scripts: generation 0", (team) => percent(this.#scores[team][0] ?? 0)],
      ["Score against scripts: newest generation", (team) => percent(this.#scores[team].at(-1) ?? 0)],
      ["Newest generation against all generations of the other team", (team) => percent(generalization(rates, team))],
      ["Below its own best so far, in the later half (forgetting)", (team) => percent(lateForgetting(rates, team))],
    ];
    this.#measures.replaceChildren(
      html("h3", {}, "What came out"),
      html("table", { class: "numbers" },
        html("thead", {}, html("tr", {}, html("td"), ...TEAMS.map((team) => html("th", { scope: "col", class: team }, `${team}s`)))),
        html("tbody", {}, ...rows.map(([name, value]) =>
          html("tr", {}, html("th", { scope: "row" }, name), ...TEAMS.map((team) => html("td", {}, value(team))))))),
      html("p", { class: "small muted" }, "These are measures without a verdict: one race proves little. Save it, and ",
        html("code", {}, "matrixworld judge"), " weighs luck and says what happened."));
    this.#measures.hidden = false;
  }
}

/** Collisions at fault of both teams, in 1000 moves. */
function collisions({ means: { faults, agent_steps } }: Cell): number {
  const sum = (values: readonly number[]): number => values.reduce((a, b) => a + b, 0);
  return (1000 * sum(faults)) / Math.max(1, sum(agent_steps));
}
