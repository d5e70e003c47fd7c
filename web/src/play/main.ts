// The page of `matrixworld play`: a match against any generation or script, and "Can you escape it?".

import "./page.css";
import { EngineError, loadEngine } from "../engine/engine.ts";
import type { Engine } from "../engine/engine.ts";
import type { NetworkPolicy, ScriptName, TeamPolicy, WorldConfig } from "../engine/types.ts";
import { TEAMS, genomesOf, text } from "../explorer/data.ts";
import type { Team } from "../explorer/data.ts";
import { html } from "../page/dom.ts";
import { agentName } from "../page/names.ts";
import { themeButton } from "../page/theme.ts";
import { playOn } from "./ending.ts";
import { escapeGame } from "./escape.ts";
import { readEpisode } from "./file.ts";
import { movesOf, randomSeed } from "./played.ts";
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
  return names.map((name, place) => ({ name, text: texts[place]!, policy: () => policy(place) }));
}

/** A match of the page: who plays for each team, and the seed. */
interface Choice extends Readonly<Record<Team, number>> {
  readonly seed: bigint;
}

function play(engine: Engine, view: PlayView, choice: Choice, moves: Moves): void {
  const [config, team] = [data.world, TEAMS[Number(moves.seat >= data.world.n_pursuers)]!];
  const names = TEAMS.map((each) => players[each][choice[each]]!.name);
  const policies = { pursuer: players.pursuer[choice.pursuer]!.policy(), evader: players.evader[choice.evader]!.policy() };
  const title = `You are ${agentName(moves.seat, config.n_pursuers)}: pursuers ${names[0]}, evaders ${names[1]}`;
  playOn(engine, view, title, { config, seed: choice.seed, episode: 0, policies, ...moves }, players[team],
    { pursuers: choice.pursuer, evaders: choice.evader, seed: choice.seed });
}

/** Play on where the match of a link ends; return whether the address holds one. */
function follow(engine: Engine, view: PlayView): boolean {
  const parts = new URLSearchParams(location.hash.slice(1));
  const moves = movesOf(parts, data.world);
  const [pursuer, evader] = [Number(parts.get("pursuers") ?? NaN), Number(parts.get("evaders") ?? NaN)];
  const seed = /^\d{1,20}$/.test(parts.get("seed") ?? "") ? BigInt.asUintN(64, BigInt(parts.get("seed")!)) : null;
  if (!moves || seed === null || !players.pursuer[pursuer] || !players.evader[evader]) return false;
  play(engine, view, { pursuer, evader, seed }, moves);
  return true;
}

const choiceOf = (names: readonly string[], chosen: number): HTMLSelectElement =>
  html("select", {}, ...names.map((name, place) => html("option", { value: place, selected: place === chosen }, name)));

function setup(engine: Engine, view: PlayView): HTMLElement {
  const [you, pursuers, evaders] = [
    choiceOf(["an evader", "a pursuer"], 0),
    ...TEAMS.map((team) => choiceOf(data.teams[team].names, data.teams[team].usual)),
  ] as [HTMLSelectElement, HTMLSelectElement, HTMLSelectElement];
  const about = html("p", { class: "small muted about" });
  const explain = (): void => {
    const chosen = [players.pursuer[Number(pursuers.value)]!, players.evader[Number(evaders.value)]!];
    about.textContent = chosen.filter((each) => each.text).map((each) => `${each.name}: ${each.text}.`).join(" ");
  };
  for (const each of [pursuers, evaders]) each.addEventListener("change", explain);
  explain();
  const problem = html("p", { class: "problem", role: "alert" });
  const begin = (): void => play(engine, view, { pursuer: Number(pursuers.value), evader: Number(evaders.value), seed: randomSeed() },
    { seat: you.value === "0" ? data.world.n_pursuers : 0, from: 0, moves: [] });
  const file = html("input", { type: "file", accept: ".npz", hidden: true });
  file.addEventListener("change", () => {
    const [given] = file.files ?? [];
    problem.textContent = "";
    void given?.arrayBuffer().then((buffer) => readEpisode(engine, new Uint8Array(buffer)))
      .then(({ live, seat }) => view.watch(live, seat, given.name))
      .catch((error: Error) => (problem.textContent = `${given.name} holds no match: ${error.message}`));
    file.value = "";
  });
  // On a phone the board comes first.
  return html("details", { class: "card setup", open: matchMedia("(min-width: 761px)").matches }, html("summary", {}, "Play something else"), html("div", {},
    html("label", {}, "You are ", you), html("label", {}, "Pursuers ", pursuers), html("label", {}, "Evaders ", evaders),
    html("button", { type: "button", class: "primary", onclick: begin }, "Play"),
    html("button", { type: "button", onclick: () => escapeGame(view, data.world, players.pursuer) }, "Can you escape it?"),
    html("button", { type: "button", onclick: () => file.click() }, "Open a file"), file, problem, about));
}

async function show(): Promise<void> {
  const engine = await loadEngine();
  const view = new PlayView(engine);
  document.getElementById("page")!.replaceWith(
    html("header", { class: "top" }, html("h1", {}, data.title), themeButton()),
    html("main", {}, setup(engine, view), html("section", { class: "card", "aria-label": "Match" }, view.element)));
  document.addEventListener("keydown", (event) => view.key(event) && event.preventDefault());
  window.addEventListener("hashchange", () => follow(engine, view));
  if (!follow(engine, view)) escapeGame(view, data.world, players.pursuer);
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
