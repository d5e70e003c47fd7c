// One race on the page: its boards before and after learning, what came out, and the matrix and the
// curve that grow.

import type { Engine, Match } from "../engine/engine.ts";
import { TEAMS } from "../engine/teams.ts";
import type { OfTeams, Team } from "../engine/teams.ts";
import type { GenomePolicy } from "../engine/types.ts";
import { chart, frame, legend, line } from "../explorer/chart.ts";
import type { Frame } from "../explorer/chart.ts";
import { Inspector } from "../explorer/inspector.ts";
import { MatchPanel } from "../explorer/match.ts";
import { MatrixPanel } from "../explorer/matrix.ts";
import { Store } from "../explorer/store.ts";
import { html } from "../page/dom.ts";
import { Chase, Chases } from "./chase.ts";
import type { EvolveData } from "./data.ts";
import { scheduleName } from "./data.ts";
import { GrowingRun } from "./growing_run.ts";
import { mean } from "./measures.ts";
import { evidenceOf, outcomeOf, percent } from "./outcome.ts";
import type { Outcome } from "./outcome.ts";
import { FIXED, Race } from "./race.ts";
import type { Cell } from "./race.ts";
import type { Finished } from "./save.ts";
import type { RaceSettings } from "./settings.ts";
import { Weights } from "./weights.ts";
import { Mate } from "./worker.ts";
import type { Order, Planned, Told } from "./worker.ts";

/** Milliseconds between two drawings of what grows. */
const REST = 100;
/** If generation 0 catches more than this, it is said why. */
const MANY = 0.3;
const BY_CHANCE =
  "By chance: evaders that have not learned to flee run into pursuers that have not learned to hunt.";
/** Generation 0 of both teams. */
const FIRST: OfTeams<number> = { pursuer: 0, evader: 0 };
/** Races that were begun on this page. */
let count = 0;

/** A race that has ended, as it is kept: what can be saved, and what is shown besides. */
export interface Kept extends Finished {
  readonly scores: OfTeams<readonly (number | null)[]>;
  readonly seconds: number;
}

/** A race, and all that shows it. It dispatches `state` when it begins, gets on or ends. */
export class Lane extends EventTarget {
  readonly element: HTMLElement;
  readonly chases: Chases;
  readonly boards: HTMLElement;
  readonly before = new Chase();
  readonly after = new Chase();
  settings: RaceSettings;
  state: "waiting" | "evolving" | "ended" | "stopped" = "waiting";
  /** Share of the epochs that have been played, how many, and those after which each change came. */
  done = 0;
  epochs = 0;
  readonly changed: number[] = [];
  seconds = 0;
  outcome: Outcome | null = null;
  /** Whether the worker knows nothing of the race: it was kept, and is shown again. */
  kept: Kept | null = null;
  readonly #data: EvolveData;
  readonly #engine: Engine;
  readonly #mate: Mate;
  readonly #title = html("h2", { class: "lane-title" });
  readonly #facts = html("p", { class: "facts numbers" });
  readonly #room = html("div", { class: "lane-room" });
  readonly #measures = html("section", { class: "card measures" });
  readonly #more = html(
    "details",
    { class: "lane-more", hidden: true },
    html("summary", {}, "More: every generation against every other, scores and collisions"),
    this.#room,
    this.#measures,
  );
  readonly #dialogs = html("div");
  readonly #inspector = new Inspector(() => {});
  /** The card of the agent that is asked. */
  readonly #asked = html(
    "section",
    { class: "card asked", "aria-label": "An agent", hidden: true },
    html("button", { type: "button", class: "leave", onclick: () => this.#ask(null, null) }, "Close"),
    this.#inspector.element,
  );
  readonly #weights: Weights;
  #run!: GrowingRun;
  #scores: OfTeams<(number | null)[]> = { pursuer: [], evader: [] };
  #cells = new Map<string, Cell>();
  #store!: Store;
  #drawChart: () => void = () => {};
  #episode = 0;
  #follows = true;
  #heard = false;
  #due = 0;
  #saved: ((race: Finished) => void) | null = null;

  /** `page`: the name of the script that carries out the race in a worker. */
  constructor(data: EvolveData, engine: Engine, page: string, settings: RaceSettings) {
    super();
    this.#data = data;
    this.#engine = engine;
    this.settings = settings;
    this.#mate = new Mate(page, (told) => this.#hear(told));
    this.chases = new Chases(() => this.#play(), this.before, this.after);
    this.before.element.classList.add("before");
    this.boards = html("div", { class: "pair" }, this.before.element, this.after.element);
    this.#weights = new Weights(engine, data, () => this.#renew(true));
    for (const chase of [this.before, this.after]) {
      chase.addEventListener("agent", () => chase.agent !== null && this.#ask(chase, chase.agent));
      chase.addEventListener("step", () => !this.#asked.hidden && chase.agent !== null && this.#look(chase));
    }
    this.element = html(
      "section",
      { class: "lane" },
      this.#title,
      this.#facts,
      this.boards,
      html("p", { class: "hint small muted" }, "Click an agent, or press A: what it sees, and why it moves."),
      this.#asked,
      this.#weights.element,
      this.#more,
      this.#dialogs,
    );
    this.reset(settings);
  }

  /** Show generation 0 of a race that has not begun. */
  reset(settings: RaceSettings): void {
    this.#mate.send({ type: "stop" });
    this.#begin(settings);
    this.state = "waiting";
    const { archive } = new Race(this.#engine, settings, this.#data.masks);
    this.#run.add({ pursuer: archive.pursuer[0]!, evader: archive.evader[0]! });
    this.#renew(true);
    this.#tell();
  }

  /** Begin the race anew, with the changes that are planned, and let it rest after `until` epochs. */
  start(settings: RaceSettings, plan: readonly Planned[] = [], until = Infinity): void {
    this.#begin(settings);
    this.state = "evolving";
    this.settings = plan.at(-1)?.settings ?? settings; // those that the race ends with
    this.#order({ type: "start", settings, masks: this.#data.masks, plan, until });
    this.#tell();
  }

  /** Show a race that was kept. */
  restore(settings: RaceSettings, kept: Kept, epochs: number, changed: readonly number[]): void {
    this.#begin(kept.settings);
    this.settings = settings;
    this.kept = kept;
    for (let number = 0; number < kept.finished; number++) {
      this.#run.add({ pursuer: kept.archive.pursuer[number]!, evader: kept.archive.evader[number]! });
    }
    for (const [name, cell] of kept.cells) {
      this.#run.addCell(cell);
      this.#cells.set(name, cell);
    }
    this.#scores = { pursuer: [...kept.scores.pursuer], evader: [...kept.scores.evader] };
    this.seconds = kept.seconds;
    this.done = 1;
    this.epochs = epochs;
    this.changed.push(...changed);
    this.#end("ended");
    this.#show();
  }

  stop(): void {
    this.#order({ type: "stop" });
  }

  /** Go on after a stop. */
  go(): void {
    this.state = "evolving";
    this.#order({ type: "go" });
    this.#tell();
  }

  /** Go on with other settings. */
  change(settings: RaceSettings): void {
    if (this.state === "waiting") return this.reset(settings);
    this.settings = settings;
    this.#order({ type: "change", settings });
    this.#tell();
  }

  /** Return what can be saved. */
  saved(): Promise<Finished> {
    if (this.kept) return Promise.resolve(this.kept);
    return new Promise((resolve) => {
      this.#saved = resolve;
      this.#order({ type: "save" });
    });
  }

  /** Return what is kept of a race that has ended. */
  async keep(): Promise<Kept> {
    return { ...(await this.saved()), scores: this.#scores, seconds: this.seconds };
  }

  /** Generations that have been evolved. */
  get newestGeneration(): number {
    return this.#run.newest;
  }

  /**
   * What plays for both teams: the best generations of a race that has ended, or weights that a
   * person has set.
   */
  get champions(): OfTeams<Float32Array> {
    return { pursuer: this.#weights.genome("pursuer"), evader: this.#weights.genome("evader") };
  }

  get run(): GrowingRun {
    return this.#run;
  }

  close(): void {
    this.#mate.close();
    this.chases.runs = false;
  }

  #order(order: Order): void {
    this.#mate.send(order);
  }

  // ---- What the worker tells --------------------------------------------------------------------

  #hear(told: Told): void {
    if (told.type === "began") this.#heard = true;
    if (!this.#heard) return; // of a race that is no longer shown
    if (told.type === "generation") {
      this.#run.add(told.genomes);
      this.#renew(told.number === 0);
    } else if (told.type === "cell") {
      const { pursuer, evader } = told.cell;
      this.#run.addCell(told.cell);
      if (this.#follows && pursuer === evader && pursuer === this.#run.newest) {
        this.#store.select({ pursuer, evader });
      }
      this.#cells.set(`${pursuer} ${evader}`, told.cell);
      if (this.state === "stopped" || this.state === "ended") this.#end(this.state);
    } else if (told.type === "scores") {
      for (const team of TEAMS) this.#scores[team][told.number] = told.scores[team];
    } else if (told.type === "changed") {
      this.#run.extend(told.settings);
      this.changed.push(told.at);
      this.epochs = told.at;
      if (told.settings.schedule.generations > this.#run.newest && this.state === "ended") this.#goOn();
    } else if (told.type === "anew") {
      this.#run.change(told.settings, told.genomes);
      this.#clear();
      this.#renew(true);
    } else if (told.type === "epoch") {
      this.epochs += 1;
      this.done = told.done / told.of;
    } else if (told.type === "stopped") {
      this.#end("stopped");
    } else if (told.type === "end") {
      this.seconds = told.seconds;
      this.done = 1;
      this.#end("ended");
    } else if (told.type === "saved") {
      this.#saved?.(told.race);
    } else if (told.type === "failed") {
      this.#facts.textContent = `The race failed: ${told.message}`;
      this.state = "stopped";
    }
    // Cells come quicker than they need to be drawn.
    if (!this.#due) this.#due = setTimeout(() => requestAnimationFrame(() => this.#show()), REST);
  }

  #goOn(): void {
    this.state = "evolving";
    this.outcome = null;
    this.#run.best = null;
  }

  /** The race rests: show what came out, as far as all matches are played. */
  #end(state: "stopped" | "ended"): void {
    const before = this.outcome;
    this.state = state;
    this.outcome = outcomeOf(this.#cells, this.#run.newest + 1);
    this.#run.best = this.outcome?.best ?? null;
    if (this.outcome && !before) this.#renew(true);
    this.#showMeasures();
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
    this.outcome = null;
    this.#measures.hidden = true;
  }

  // ---- What is shown ----------------------------------------------------------------------------

  /** Show an empty race with these settings, of which nothing has been played. */
  #begin(settings: RaceSettings): void {
    this.settings = settings;
    this.done = 0;
    this.epochs = 0;
    this.changed.splice(0);
    this.kept = null;
    const name = scheduleName(settings);
    this.#run = new GrowingRun(settings, this.#data.masks, name, `race ${count}`);
    count += 1;
    this.#clear();
    this.#ask(null, null);
    this.#follows = true;
    this.#heard = false;
    this.#store = new Store({ run: 0, pursuer: 0, evader: 0, episode: 0, seed: null });
    const matrix = new MatrixPanel([this.#run], this.#store);
    matrix.element.ariaLabel = `Payoff matrix. ${name}`; // of two races, each has its own name
    this.#dialogs.replaceChildren(this.#matchDialog(matrix));
    this.#room.replaceChildren(matrix.element, this.#scoresCard());
  }

  /** Return a dialog that plays the match of a cell when it is clicked. */
  #matchDialog(matrix: MatrixPanel): HTMLDialogElement {
    const match = new MatchPanel([this.#run], this.#store, null);
    match.actions.remove();
    const dialog = html(
      "dialog",
      { class: "of-cell-match", "aria-label": "Match", onclose: () => match.player.pause() },
      html("button", { type: "button", class: "leave", onclick: () => dialog.close() }, "Close"),
      match.element,
    );
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
    return dialog;
  }

  /** Return the card with the scores against scripts, and keep what draws its chart anew. */
  #scoresCard(): HTMLElement {
    const scripts = `${FIXED.pursuer.join(", ")} and ${FIXED.evader.join(", ")}`;
    const made = chart(
      `Scores against scripts, by generation: ${scripts}`,
      (width, height) => this.#scoresFrame(width, height),
      () => {},
      (generation) => {
        const chosen = Math.min(this.#run.newest, Math.max(0, Math.round(generation)));
        this.#store.select({ pursuer: chosen, evader: chosen });
      },
    );
    this.#drawChart = made.redraw;
    const told =
      "Captures of random walkers and of clumsy fleers; escapes from random walkers and from clumsy chasers.";
    return html(
      "section",
      { class: "card scores" },
      html("h3", {}, "Against opponents that never change"),
      html("p", { class: "small muted" }, told),
      legend(["pursuers", "of-pursuers"], ["evaders", "of-evaders"]),
      made.element,
    );
  }

  #scoresFrame(width: number, height: number): Frame {
    const { generations } = this.settings.schedule;
    const across = { low: 0, high: generations, label: "generation", whole: true };
    const into = frame(width, height, across, { low: 0, high: 1, label: "score" });
    for (const team of TEAMS) {
      const known = Array.from(this.#scores[team], (score) => score ?? null);
      line(into, [...known.keys()], known, `of-${team}s`);
    }
    return into;
  }

  /** Show the next matches: of generation 0, and of the newest or the best one, from the same start. */
  #play(): void {
    if (this.#run.newest < 0) return;
    const seed = BigInt(this.#run.seeds[0]![0]!);
    const episode = this.#episode % this.#run.payoff.episodes;
    this.#episode += 1;
    const match = (genomes: OfTeams<Float32Array>): Match =>
      this.#engine.match(this.#run.world, ...this.#policies(genomes), seed, episode);
    this.before.show(match(this.#run.genomesOf(FIRST)), "Before: generation 0");
    this.after.show(match(this.champions), this.#titleOfNow());
    for (const chase of [this.before, this.after]) {
      if (chase.agent !== null) this.#look(chase, true);
    }
  }

  /** Say which generations play in the match of now. */
  #titleOfNow(): string {
    const { newest, best } = this.#run;
    if (newest === 0) return "Generation 0: nobody has learned anything yet";
    const { pursuer, evader } = best ?? { pursuer: newest, evader: newest };
    const both =
      pursuer === evader
        ? `generation ${pursuer}`
        : `pursuers of generation ${pursuer}, evaders of generation ${evader}`;
    return best ? `After: ${both}` : `Now: ${both}`;
  }

  #policies({ pursuer, evader }: OfTeams<Float32Array>): [GenomePolicy, GenomePolicy] {
    return [this.#run.playing("pursuer", pursuer), this.#run.playing("evader", evader)];
  }

  #renew(at_once: boolean): void {
    this.#weights.show(this.#run);
    this.chases.renew(at_once);
  }

  /** Tell what an agent on a board sees, and why it moves; null for none. */
  #ask(chase: Chase | null, agent: number | null): void {
    for (const each of [this.before, this.after]) {
      if (each !== chase && each.agent !== null) each.choose(null);
    }
    this.#asked.hidden = !chase;
    if (!chase) return;
    this.#look(chase, true);
    this.#inspector.choose(agent);
  }

  /** Ask the next living agent on the board of now. */
  askNext(): void {
    const { match, player, agent } = this.after;
    if (!match) return;
    const count = match.n_agents;
    const after = (agent ?? -1) + 1;
    const order = Array.from({ length: count }, (_, place) => (after + place) % count);
    const next = order.find((each) => match.alive[player.step * count + each]);
    if (next !== undefined) this.after.choose(next);
  }

  #look(chase: Chase, anew = false): void {
    if (anew) {
      const before = chase === this.before;
      const [pursuers, evaders] = this.#policies(before ? this.#run.genomesOf(FIRST) : this.champions);
      const at = before ? 0 : this.#run.newest;
      this.#inspector.show(
        this.#engine,
        this.#run,
        chase.match!,
        { run: 0, pursuer: at, evader: at, episode: 0, seed: null },
        { pursuers, evaders },
      );
    }
    this.#inspector.at(chase.player.step);
  }

  #tell(): void {
    const { newest } = this.#run;
    this.element.dataset["state"] = this.state;
    this.#title.textContent = scheduleName(this.settings);
    this.#more.hidden = this.state === "waiting";
    this.#facts.replaceChildren(...this.#told().map((text) => html("span", {}, text)));
    this.element.dataset["newest"] = String(newest);
    this.dispatchEvent(new Event("state"));
  }

  /** What is to be said of the race now. */
  #told(): string[] {
    const { newest } = this.#run;
    if (this.outcome) return [this.outcome.sentence];
    if (newest < 0) return [];
    const rate = (number: number): number | null => {
      const cell = this.#cells.get(`${number} ${number}`);
      return cell ? mean(cell.capture_rates) : null;
    };
    if (this.state === "waiting" || newest < 1) {
      const caught = rate(0) ?? this.#weights.rate(this.#run.genomesOf(FIRST), FIRST);
      const told = `${percent(caught)} of the evaders are caught.`;
      return caught > MANY ? [told, BY_CHANCE] : [told];
    }
    const generation = `Generation ${newest} of ${this.settings.schedule.generations}`;
    const now = rate(newest) ?? rate(newest - 1);
    const first = rate(0);
    if (now === null || first === null) return [`${generation}.`];
    return [
      `${generation}: the pursuers catch ${percent(now)} of the evaders; ` +
        `those of generation 0 caught ${percent(first)}.`,
    ];
  }

  #showMeasures(): void {
    const { outcome } = this;
    this.#measures.hidden = !outcome;
    this.#measures.ariaLabel = `What came out. ${scheduleName(this.settings)}`;
    if (!outcome) return;
    const newest = this.#cells.get(`${this.#run.newest} ${this.#run.newest}`)!;
    const rows: readonly (readonly [string, (team: Team, place: number) => string])[] = [
      ["Score against scripts: generation 0", (team) => percent(this.#scores[team][0] ?? 0)],
      ["Score against scripts: newest generation", (team) => percent(this.#scores[team].at(-1) ?? 0)],
      [
        "Collisions at fault in 1000 moves of the newest generation",
        (_, place) => collisions(newest, place).toFixed(1),
      ],
    ];
    this.#measures.replaceChildren(
      html("h3", {}, "In numbers"),
      ...TEAMS.map((team) => html("p", {}, evidenceOf(team, outcome.teams[team]))),
      html(
        "table",
        { class: "numbers" },
        html(
          "thead",
          {},
          html(
            "tr",
            {},
            html("td"),
            ...TEAMS.map((team) => html("th", { scope: "col", class: team }, `${team}s`)),
          ),
        ),
        html(
          "tbody",
          {},
          ...rows.map(([name, value]) =>
            html(
              "tr",
              {},
              html("th", { scope: "row" }, name),
              ...TEAMS.map((team, place) => html("td", {}, value(team, place))),
            ),
          ),
        ),
      ),
      html(
        "p",
        { class: "small muted" },
        "One race proves little: save it, and ",
        html("code", {}, "matrixworld judge"),
        " says what happened on its way, and how surely.",
      ),
    );
  }
}

/** Collisions at fault of a team, in 1000 moves. */
function collisions({ means: { faults, agent_steps } }: Cell, team: number): number {
  const each = faults.length / TEAMS.length;
  return (
    (1000 * faults.slice(team * each, (team + 1) * each).reduce((a, b) => a + b, 0)) /
    Math.max(1, agent_steps[team]!)
  );
}
