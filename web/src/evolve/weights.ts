// The weights of the best generation of both teams as bars that a person drags: the boards play
// with them at once.

import type { Engine } from "../engine/engine.ts";
import { INPUTS } from "../engine/tables.ts";
import { TEAMS } from "../engine/teams.ts";
import type { OfTeams, Team } from "../engine/teams.ts";
import type { InputName } from "../engine/types.ts";
import { signed } from "../explorer/format.ts";
import { html } from "../page/dom.ts";
import type { EvolveData } from "./data.ts";
import type { GrowingRun } from "./growing_run.ts";
import { mean } from "./measures.ts";
import { percent } from "./outcome.ts";
import { effectsOf, sentence } from "./words.ts";

/** The least end of the bars, and what a bar can become of the largest weight. */
const LEAST = 2;
const MORE = 1.5;

export class Weights {
  readonly element = html("section", {
    class: "card weights-card",
    "aria-label": "Weights of named inputs",
    hidden: true,
  });
  readonly #engine: Engine;
  readonly #data: EvolveData;
  readonly #changed: () => void;
  readonly #teams = html("div", { class: "evolved" });
  readonly #told = html("p", { class: "numbers", role: "status" });
  readonly #back = html("button", { type: "button", onclick: () => this.#reset() }, "As evolved");
  /** What each team does, in words. */
  readonly #words: OfTeams<HTMLElement> = { pursuer: html("p"), evader: html("p") };
  #run: GrowingRun | null = null;
  /** The weights that a person has set; null for those that evolved. */
  #own: OfTeams<Float32Array> | null = null;

  /** `changed` is called when other weights play. */
  constructor(engine: Engine, data: EvolveData, changed: () => void) {
    this.#engine = engine;
    this.#data = data;
    this.#changed = changed;
    this.element.append(
      html("h3", {}, "What they have learned"),
      html(
        "p",
        { class: "small muted" },
        "An agent takes the move with the largest sum of weight x input. Drag a weight, and see at once what becomes of the team.",
      ),
      html("div", { class: "doings" }, this.#back, this.#told),
      this.#teams,
    );
  }

  /** What plays for a team. */
  genome(team: Team): Float32Array {
    return this.#own?.[team] ?? this.#evolved[team];
  }

  /** The generations that are shown. */
  get #shown(): OfTeams<number> {
    const { newest, best } = this.#run!;
    return best ?? { pursuer: newest, evader: newest };
  }

  get #evolved(): OfTeams<Float32Array> {
    return this.#run!.genomesOf(this.#shown);
  }

  /** Show the best or the newest generation of a race, unless a person has set weights in it. */
  show(run: GrowingRun): void {
    if (run !== this.#run) this.#own = null;
    this.#run = run;
    const teams = TEAMS.flatMap((team) => {
      const { policy } = run.teams[team];
      return policy?.kind === "rating" ? [[team, policy.inputs] as const] : [];
    });
    this.element.hidden = !teams.length || run.newest < 1;
    if (this.element.hidden) return;
    if (!this.#own) this.#teams.replaceChildren(...teams.map((each) => this.#team(...each)));
    this.#tell();
  }

  #team(team: Team, inputs: readonly InputName[]): HTMLElement {
    const genome = this.genome(team);
    const most = Math.max(LEAST, MORE * Math.max(...genome.map(Math.abs)));
    return html(
      "div",
      { class: "weights" },
      html("h4", { class: team }, `${team}s`),
      this.#words[team],
      ...inputs.flatMap((input, place) => {
        const shown = html("span", { class: "numbers" }, signed(genome[place]!));
        const bar = html("input", {
          type: "range",
          class: team,
          min: -most,
          max: most,
          step: "any",
          value: genome[place]!,
          title: INPUTS[input],
          "aria-label": `${team}s: ${input}`,
        });
        bar.addEventListener("input", () => {
          shown.textContent = signed(Number(bar.value));
          this.#set(team, place, Number(bar.value));
        });
        return [html("span", { title: INPUTS[input] }, input.replaceAll("_", " ")), bar, shown];
      }),
    );
  }

  #set(team: Team, place: number, weight: number): void {
    this.#own ??= { pursuer: this.genome("pursuer").slice(), evader: this.genome("evader").slice() };
    this.#own[team][place] = weight;
    this.#tell();
    this.#changed();
  }

  #reset(): void {
    this.#own = null;
    this.show(this.#run!);
    this.#changed();
  }

  #tell(): void {
    this.#back.disabled = !this.#own;
    const evolved = percent(this.rate(this.#evolved));
    this.#told.textContent = this.#own
      ? `Yours: ${percent(this.rate(this.#own))} are caught; as evolved: ${evolved}`
      : `${evolved} are caught`;
    const run = this.#run!;
    const policies = {
      pursuer: run.playing("pursuer", this.genome("pursuer")),
      evader: run.playing("evader", this.genome("evader")),
    };
    const match = this.#engine.match(run.world, policies.pursuer, policies.evader, BigInt(run.seed));
    for (const team of TEAMS) {
      this.#words[team].textContent = sentence(
        this.#data,
        team,
        effectsOf(this.#engine, match, team, policies),
      );
    }
  }

  /**
   * The mean capture rate of the matches that generations have in the evaluation, with other
   * genomes: those of the cell, if they are its own.
   */
  rate({ pursuer, evader }: OfTeams<Float32Array>, at = this.#shown, run = this.#run!): number {
    const one = new Int32Array(1);
    const matches = {
      pursuer: one,
      evader: one,
      seed: BigUint64Array.of(BigInt(run.seeds[at.pursuer]![at.evader]!)),
    };
    return mean(
      this.#engine.rollouts(
        run.world,
        run.playing("pursuer", pursuer),
        run.playing("evader", evader),
        matches,
        run.payoff.episodes,
      ).capture_rate as Float32Array,
    );
  }
}
