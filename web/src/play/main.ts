// The page of `matrixworld play`: a match against any generation or script, and "Can you escape it?".

import "./page.css";
import { EngineError, loadEngine } from "../engine/engine.ts";
import type { Engine } from "../engine/engine.ts";
import type { NetworkPolicy, ScriptName, TeamPolicy, WorldConfig } from "../engine/types.ts";
import { TEAMS, genomesOf, text } from "../explorer/data.ts";
import type { Team } from "../explorer/data.ts";
import { html } from "../page/dom.ts";
import { agentName } from "../page/names.ts";
import { top } from "../page/top.ts";
import { playOn } from "./ending.ts";
import { escapeGame } from "./escape.ts";
import { readEpisode } from "./file.ts";
import { picture } from "./pictures.ts";
import { ladder, movesOf, randomSeed } from "./played.ts";
import type { Moves, Player } from "./played.ts";
import { PlayView } from "./view.ts";

/** What can play for a team; `matrixworld.explorer.play_page` writes it. */
interface TeamData {
  readonly names: readonly string[];
  /** Of each name what it does. */
  readonly texts: readonly string[];
  /** The place of the one that a match begins with. */
  readonly usual: number;
  /** Of each name a script, or null: then the next genome plays. */
  readonly scripts: readonly (ScriptName | null)[];
  readonly network: (Omit<NetworkPolicy, "genome"> & { readonly genome_size: number }) | null;
}

interface Data {
  readonly version: string;
  readonly title: string;
  readonly world: WorldConfig;
  readonly teams: Readonly<Record<Team, TeamData>>;
}

/** What a person can play, and what a round of it is. */
const GAMES = { escape: "Can you escape it?", match: "One match", file: "A match from a file" } as const;
type GameName = keyof typeof GAMES;
const LEAD = "You move one agent. Scripts, or networks that evolved, move all others.";

const data = JSON.parse(text("data")) as Data;
const players = { pursuer: playersOf("pursuer"), evader: playersOf("evader") };

function playersOf(team: Team): Player[] {
  const { names, texts, scripts, network } = data.teams[team];
  const policy = (place: number): TeamPolicy => {
    const script = scripts[place];
    if (script || !network) return script!;
    const [size, genome] = [network.genome_size, scripts.slice(0, place).filter((each) => each === null).length];
    return { ...network, genome: genomesOf(team, size).subarray(genome * size, (genome + 1) * size) };
  };
  return names.map((name, place) => ({ name: name.replaceAll("-", " "), text: texts[place]!, policy: () => policy(place) }));
}

/** A match of the page: who plays for each team, and the seed. */
interface Choice extends Readonly<Record<Team, number>> {
  readonly seed: bigint;
}

function play(engine: Engine, view: PlayView, form: Form, choice: Choice, moves: Moves): void {
  form.show("match", { ...choice, seat: moves.seat });
  const [config, team] = [data.world, TEAMS[Number(moves.seat >= data.world.n_pursuers)]!];
  const names = TEAMS.map((each) => players[each][choice[each]]!.name);
  const policies = { pursuer: players.pursuer[choice.pursuer]!.policy(), evader: players.evader[choice.evader]!.policy() };
  const title = `You are ${agentName(moves.seat, config.n_pursuers)}. Pursuers: ${names[0]}; evaders: ${names[1]}`;
  playOn(engine, view, title, { config, seed: choice.seed, episode: 0, policies, ...moves }, players[team],
    { pursuers: choice.pursuer, evaders: choice.evader, seed: choice.seed });
}

/** Play on where the match of a link ends; return whether the address holds one. */
function follow(engine: Engine, view: PlayView, form: Form): boolean {
  const parts = new URLSearchParams(location.hash.slice(1));
  const moves = movesOf(parts, data.world);
  const [pursuer, evader] = [Number(parts.get("pursuers") ?? NaN), Number(parts.get("evaders") ?? NaN)];
  const seed = /^\d{1,20}$/.test(parts.get("seed") ?? "") ? BigInt.asUintN(64, BigInt(parts.get("seed")!)) : null;
  if (!moves || seed === null || !players.pursuer[pursuer] || !players.evader[evader]) return false;
  play(engine, view, form, { pursuer, evader, seed }, moves);
  return true;
}

const choiceOf = (names: readonly string[], chosen: number): HTMLSelectElement =>
  html("select", {}, ...names.map((name, place) => html("option", { value: place, selected: place === chosen }, name)));

/** The form at the top. It shows the game that runs. */
interface Form {
  readonly element: HTMLElement;
  show(game: GameName, match?: Readonly<Record<Team | "seat", number>>): void;
}

function setup(engine: Engine, view: PlayView): Form {
  const games = Object.keys(GAMES) as GameName[];
  const game = choiceOf(Object.values(GAMES), 0);
  const you = choiceOf(["an evader", "a pursuer"], 0);
  const teams = { pursuer: choiceOf(namesOf("pursuer"), data.teams.pursuer.usual), evader: choiceOf(namesOf("evader"), data.teams.evader.usual) };
  const ofMatch = html("div", { class: "of-match" },
    html("label", {}, "You are ", you), html("label", {}, "Pursuers ", teams.pursuer), html("label", {}, "Evaders ", teams.evader));
  const chosenOf = (team: Team): Player => players[team][teams[team].selectedIndex]!;
  const about = html("ul", { class: "small muted about" });
  const explain = (): void => {
    const chosen = games[game.selectedIndex]!;
    ofMatch.hidden = chosen !== "match";
    about.replaceChildren(...(chosen === "escape" ? ladder(players.pursuer).map(({ name }) => line(name, "pursuer"))
      : chosen === "match" ? TEAMS.map((team) => line(chosenOf(team).name, team, chosenOf(team).text)) : []));
  };
  for (const each of [game, ...Object.values(teams)]) each.addEventListener("change", explain);
  const problem = html("p", { class: "problem", role: "alert" });
  const file = html("input", { type: "file", accept: ".npz", hidden: true });
  const form: Form = {
    // On a phone the board comes first.
    element: html("details", { class: "card setup", open: matchMedia("(min-width: 761px)").matches }, html("summary", {}, "Play something else"), html("div", {},
      html("label", {}, "Game ", game), ofMatch, html("button", { type: "button", class: "primary", onclick: () => begin[games[game.selectedIndex]!]() }, "Play"),
      file, problem, about)),
    show: (name, match) => {
      game.selectedIndex = games.indexOf(name);
      if (match) {
        you.selectedIndex = Number(match.seat < data.world.n_pursuers);
        for (const team of TEAMS) teams[team].selectedIndex = match[team];
      }
      explain();
    },
  };
  const begin: Record<GameName, () => void> = {
    escape: () => escape(view, form),
    match: () => play(engine, view, form, { pursuer: teams.pursuer.selectedIndex, evader: teams.evader.selectedIndex, seed: randomSeed() },
      { seat: you.selectedIndex ? 0 : data.world.n_pursuers, from: 0, moves: [] }),
    file: () => file.click(),
  };
  file.addEventListener("change", () => {
    const [given] = file.files ?? [];
    problem.textContent = "";
    void given?.arrayBuffer().then((buffer) => readEpisode(engine, new Uint8Array(buffer)))
      .then(({ live, seat }) => {
        form.show("file");
        view.watch(live, seat, given.name);
      })
      .catch((error: Error) => (problem.textContent = `${given.name} holds no match: ${error.message}`));
    file.value = "";
  });
  return form;
}

const namesOf = (team: Team): string[] => players[team].map(({ name }) => name);

/** Return a player in a line: its picture, its name, and what it does. */
const line = (name: string, team: Team, text = ""): HTMLElement =>
  html("li", {}, picture(name, team), html("span", {}, html("span", { class: team }, name), text && `: ${text}`));

function escape(view: PlayView, form: Form): void {
  form.show("escape");
  escapeGame(view, data.world, players.pursuer);
}

async function show(): Promise<void> {
  const engine = await loadEngine();
  const view = new PlayView(engine);
  const form = setup(engine, view);
  document.getElementById("page")!.replaceWith(
    top("Play a chase", LEAD),
    html("main", {}, form.element, html("section", { class: "card", "aria-label": "Match" }, view.element)),
    html("footer", { class: "muted small" }, `${data.title} · matrixworld ${data.version}`));
  document.addEventListener("keydown", (event) => view.key(event) && event.preventDefault());
  window.addEventListener("hashchange", () => follow(engine, view, form));
  if (!follow(engine, view, form)) escape(view, form);
  Object.assign(window, { matrixworldPlay: view }); // for tests, and for the curious
}

show()
  .catch((error: unknown) => {
    const place = document.getElementById("page") ?? document.body;
    place.append(html("p", { class: "card problem", role: "alert" }, `The page could not start: ${error instanceof EngineError ? error.message : String(error)}`));
    throw error;
  })
  .finally(() => {
    document.body.dataset["ready"] = "true";
  });
