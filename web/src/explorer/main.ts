// The explorer: payoff matrices of runs, and the matches behind them.

import "./explorer.css";
import { loadEngine } from "../engine/engine.ts";
import type { Engine } from "../engine/engine.ts";
import { html, started } from "../page/dom.ts";
import { top } from "../page/top.ts";
import { followAddress, placeOf, reloadWhileGrowing } from "./address.ts";
import { playedMatch, readData } from "./data.ts";
import { gameWords } from "./game.ts";
import { helpDialog, listenToKeys } from "./keys.ts";
import { MatchPanel } from "./match.ts";
import { MatrixPanel } from "./matrix.ts";
import { panels } from "./panels.ts";
import { raceTabs } from "./races.ts";
import { Store } from "./store.ts";
import { TakeOver } from "./take_over.ts";
import { openPlayground } from "./to_playground.ts";

const data = readData();
const { runs } = data;
const [rows, columns] = runs[0]!.payoff.shape;
const first = placeOf(location.hash, runs, {
  run: 0,
  pursuer: rows - 1,
  evader: columns - 1,
  episode: 0,
  seed: null,
});
const { step, ...selected } = first;
const store = new Store(selected);
const match = new MatchPanel(runs, store, data.playground);
const matrix = new MatrixPanel(runs, store);
const takeOver = new TakeOver(runs, store, match);
const help = helpDialog(runs);
const address = location.hash; // `followAddress` writes another one
let engine: Engine | null = null;

/** What happened in the race that is shown. */
const told = html("span", { class: "told", "aria-live": "polite" });
const lead = html("span", { class: "small muted" });
const tell = (): void => {
  const run = runs[store.selected.run]!;
  const sentence = run.findings?.sentence ?? "";
  told.textContent = run.together || sentence; // a job of several seeds opens with all of them
  lead.textContent = run.together
    ? `Seed ${run.seed}: ${sentence} ${gameWords(run).lead}`
    : gameWords(run).lead;
};
store.on("run", tell);
tell();
const playHere = (): void => {
  match.playSoon();
  match.reveal();
};
document.getElementById("page")!.replaceWith(
  top(
    data.heading,
    html("span", {}, told, lead),
    html(
      "button",
      {
        type: "button",
        class: "keys-button",
        title: "Keys (?)",
        "aria-label": "Keys (?)",
        onclick: () => help.showModal(),
      },
      "?",
    ),
  ),
  ...(data.note ? [html("aside", { class: "note small muted" }, data.note)] : []),
  raceTabs(runs, store),
  html("main", { class: "stages" }, matrix.element, match.element),
  panels(runs, store, playHere),
  html("footer", { class: "muted small" }, `${data.title} · matrixworld ${data.version}`),
  takeOver.dialog,
  help,
);
// For the browser's console, and for tests.
Object.assign(window, {
  matrixworldExplorer: {
    get match() {
      return match.match;
    },
    get step() {
      return match.player.step;
    },
    get pace() {
      return match.player.pace;
    },
    get inputs() {
      return match.inputs;
    },
    get playing() {
      return takeOver.view;
    },
    play: (episode: number) =>
      engine && playedMatch(engine, runs[store.selected.run]!, { ...store.selected, episode }),
    get shape() {
      return runs[store.selected.run]!.payoff.shape;
    },
  },
});
matrix.element.addEventListener("play", playHere);
match.goTo(step);
if (!step) match.playSoon();
followAddress(runs, store, match);
listenToKeys(
  runs,
  store,
  match,
  help,
  () => takeOver.open(),
  () => data.playground && openPlayground(match.shown, data.playground),
);
window.addEventListener("hashchange", ({ newURL }) => engine && takeOver.start(engine, new URL(newURL).hash));
if (data.growing) {
  reloadWhileGrowing(
    runs,
    store,
    () => match.player.playing || document.querySelector("dialog[open]") !== null,
  );
}

async function begin(): Promise<void> {
  engine = data.playground && (await loadEngine()); // pages of other games have none
  match.start(engine);
  if (engine) takeOver.start(engine, address);
}

// The page is drawn before the engine is compiled.
requestAnimationFrame(() => setTimeout(() => started(begin())));
