// The games of the page: "Can you escape it?", a match against any generation or script, and a
// match from a file.

import type { Engine } from "../engine/engine.ts";
import { TEAMS } from "../engine/teams.ts";
import type { Team } from "../engine/teams.ts";
import type { TeamPolicy } from "../engine/types.ts";
import { genomesOf } from "../explorer/data.ts";
import { html, select } from "../page/dom.ts";
import { agentName } from "../page/names.ts";
import type { OpponentsData } from "./data.ts";
import { readEpisode } from "./file.ts";
import { escapeGame, playOn } from "./games.ts";
import { linkTo, movesOf, randomSeed } from "./played.ts";
import type { Moves, Player } from "./played.ts";
import { PlayView } from "./view.ts";

export const GAMES = {
  escape: "Can you escape it?",
  match: "One match",
  file: "A match from a file",
} as const;
export type GameName = keyof typeof GAMES;

/** A match of the page: who plays for each team, and the seed. */
type Choice = Readonly<Record<Team, number>> & { readonly seed: bigint };

/** The games, with what is chosen for them. It dispatches `game` when a link or a file begins another one. */
export class Games extends EventTarget {
  readonly element: HTMLElement;
  readonly view: PlayView;
  game: GameName = "escape";
  readonly #engine: Engine;
  readonly #data: OpponentsData;
  readonly #players: Readonly<Record<Team, readonly Player[]>>;
  readonly #you = select(
    [
      [0, "an evader"],
      [1, "a pursuer"],
    ],
    () => {},
  );
  readonly #teams: Readonly<Record<Team, HTMLSelectElement>>;
  readonly #ofMatch: HTMLElement;
  readonly #ofFile: HTMLElement;
  readonly #about = html("ul", { class: "small muted about" });
  readonly #problem = html("p", { class: "problem", role: "alert" });
  readonly #file = html("input", {
    type: "file",
    accept: ".npz",
    hidden: true,
    onchange: () => this.#read(),
  });
  readonly #card: HTMLElement;

  constructor(engine: Engine, data: OpponentsData) {
    super();
    this.#engine = engine;
    this.#data = data;
    this.view = new PlayView(engine);
    this.#players = { pursuer: playersOf(data, "pursuer"), evader: playersOf(data, "evader") };
    const choice = (team: Team): HTMLSelectElement =>
      select(
        this.#players[team].map(({ name }, place) => [place, name]),
        () => this.#explain(),
      );
    this.#teams = { pursuer: choice("pursuer"), evader: choice("evader") };
    for (const team of TEAMS) this.#teams[team].selectedIndex = data.teams[team].usual;
    this.#ofMatch = html(
      "div",
      { class: "of-match" },
      html("label", {}, "You are ", this.#you),
      html("label", {}, "Pursuers ", this.#teams.pursuer),
      html("label", {}, "Evaders ", this.#teams.evader),
      html("button", { type: "button", class: "primary", onclick: () => this.#match() }, "Play"),
      this.#about,
    );
    this.#ofFile = html(
      "div",
      { class: "of-match" },
      html(
        "button",
        { type: "button", class: "primary", onclick: () => this.#file.click() },
        "Choose a file",
      ),
      this.#file,
      html(
        "span",
        { class: "small muted" },
        "A match that this page or matrixworld.Episode has saved (.npz).",
      ),
      this.#problem,
    );
    this.#card = html("section", { class: "card", "aria-label": "Match" }, this.view.element);
    this.element = html(
      "section",
      { class: "games", "aria-label": "Play" },
      html("div", { class: "card setup" }, this.#ofMatch, this.#ofFile),
      this.#card,
    );
  }

  /** Begin a game. */
  begin(game: GameName): void {
    this.#show(game);
    if (game === "escape") {
      escapeGame(this.#engine, this.view, this.#data, this.#players.pursuer);
    } else if (game === "match") {
      this.#match();
    } else {
      this.view.stop();
      this.#card.hidden = true; // until there is a match
    }
  }

  /** Play on where the match of a link ends; return whether the parts of an address hold one. */
  follow(parts: URLSearchParams): boolean {
    const moves = movesOf(parts, this.#data.world);
    const pursuer = Number(parts.get("pursuers") ?? NaN);
    const evader = Number(parts.get("evaders") ?? NaN);
    const seed = /^\d{1,20}$/.test(parts.get("seed") ?? "")
      ? BigInt.asUintN(64, BigInt(parts.get("seed")!))
      : null;
    if (!moves || seed === null || !this.#players.pursuer[pursuer] || !this.#players.evader[evader]) {
      return false;
    }
    this.#teams.pursuer.selectedIndex = pursuer;
    this.#teams.evader.selectedIndex = evader;
    this.#you.selectedIndex = Number(moves.seat < this.#data.world.n_pursuers);
    this.#show("match");
    this.#play({ pursuer, evader, seed }, moves);
    return true;
  }

  #show(game: GameName): void {
    this.game = game;
    this.#ofMatch.hidden = game !== "match";
    this.#ofFile.hidden = game !== "file";
    this.#ofMatch.parentElement!.hidden = game === "escape";
    this.#card.hidden = false;
    this.#problem.textContent = "";
    this.#explain();
    this.dispatchEvent(new Event("game"));
  }

  /** Say what the chosen players do. */
  #explain(): void {
    this.#about.replaceChildren(
      ...TEAMS.map((team) => {
        const { name, text } = this.#players[team][this.#teams[team].selectedIndex]!;
        return html("li", {}, html("span", { class: team }, name), text && `: ${text}`);
      }),
    );
  }

  #match(): void {
    const { pursuer, evader } = this.#teams;
    const seat = this.#you.selectedIndex ? 0 : this.#data.world.n_pursuers;
    this.#play(
      { pursuer: pursuer.selectedIndex, evader: evader.selectedIndex, seed: randomSeed() },
      { seat, from: 0, moves: [] },
    );
  }

  #play(choice: Choice, moves: Moves): void {
    const config = this.#data.world;
    const players = this.#players;
    const team = TEAMS[Number(moves.seat >= config.n_pursuers)]!;
    const pursuer = players.pursuer[choice.pursuer]!;
    const evader = players.evader[choice.evader]!;
    const policies = { pursuer: pursuer.policy(), evader: evader.policy() };
    const title = `You are ${agentName(moves.seat, config.n_pursuers)}. Pursuers: ${pursuer.name}; evaders: ${evader.name}`;
    playOn(
      this.#engine,
      this.view,
      { config, seed: choice.seed, episode: 0, policies, ...moves },
      {
        title,
        players: players[team],
        link: (now) => linkTo({ pursuers: choice.pursuer, evaders: choice.evader, seed: choice.seed }, now),
      },
    );
  }

  #read(): void {
    const [given] = this.#file.files ?? [];
    this.#problem.textContent = "";
    void given
      ?.arrayBuffer()
      .then((buffer) => readEpisode(this.#engine, new Uint8Array(buffer)))
      .then(({ live, seat }) => {
        this.#show("file");
        this.view.watch(live, seat, given.name);
      })
      .catch(
        (error: Error) => (this.#problem.textContent = `${given.name} holds no match: ${error.message}`),
      );
    this.#file.value = "";
  }
}

/** Return what can play for a team. */
function playersOf({ teams }: OpponentsData, team: Team): Player[] {
  const { names, texts, scripts, policy } = teams[team];
  const playing = (place: number): TeamPolicy => {
    const script = scripts[place];
    if (script || !policy) return script!;
    const size = policy.genome_size;
    const genome = scripts.slice(0, place).filter((each) => each === null).length;
    return { ...policy, genome: genomesOf(team, size).subarray(genome * size, (genome + 1) * size) };
  };
  return names.map((name, place) => ({
    name: name.replaceAll("-", " "),
    text: texts[place]!,
    policy: () => playing(place),
  }));
}
