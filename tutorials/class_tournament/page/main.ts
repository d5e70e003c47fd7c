// The page of a class tournament: standings, all matches, and their replays.

import "./class.css";
import { playerKey } from "../../../web/src/board/player.ts";
import { loadEngine } from "../../../web/src/engine/engine.ts";
import { html } from "../../../web/src/page/dom.ts";
import { changeTheme } from "../../../web/src/page/theme.ts";
import { top } from "../../../web/src/page/top.ts";
import type { Data } from "./data.ts";
import { readData } from "./data.ts";
import { MatchPanel } from "./match.ts";
import { MatrixPanel } from "./matrix.ts";
import { Store } from "./store.ts";
import { refusedList, standingsTable, votesTable } from "./tables.ts";

const data = readData();
const [best] = data.standings.pursuer;
const store = new Store({ pursuer: best!.number, evader: data.standings.evader[0]!.number });
const match = new MatchPanel(data, store);

function about({ world, episodes, seed, matrixworld }: Data): string {
  return (
    `${world.n_pursuers} pursuers and ${world.n_evaders} evaders on ${world.rows} x ${world.cols} cells, at most ` +
    `${world.max_steps} steps · ${episodes} episodes a pair · seed ${seed} · matrixworld ${matrixworld}`
  );
}

const READING = [
  "Every pursuer played every evader from the same starts. A score is a mean over all opponents, scripts included. Scripts are the package's own policies, for comparison; they have no rank.",
  "A rank such as 2 to 5 means that these episodes cannot tell which of these ranks is the true one: the difference to some others is within chance. Each range misses the true rank with a probability of at most 5 %.",
  "Keys: Space plays, ← and → step, D changes light and dark; in the matrix arrow keys choose a match and Enter plays it.",
];

document
  .getElementById("page")!
  .replaceWith(
    top(data.title, about(data)),
    html(
      "main",
      { class: "stages" },
      html(
        "div",
        { class: "tables" },
        standingsTable(data, "pursuer", store),
        standingsTable(data, "evader", store),
      ),
      new MatrixPanel(data, store).element,
      match.element,
    ),
    ...votesTable(data),
    ...refusedList(data.refusals),
    html(
      "section",
      { class: "card reading", "aria-label": "How to read this page" },
      html("h2", {}, "How to read this page"),
      ...READING.map((text) => html("p", {}, text)),
    ),
  );

document.addEventListener("keydown", (event) => {
  const field = event.target instanceof HTMLSelectElement || event.target instanceof HTMLInputElement;
  const pressed = event.target instanceof HTMLButtonElement && (event.key === " " || event.key === "Enter");
  if (field || pressed || event.defaultPrevented || event.ctrlKey || event.metaKey || event.altKey) return;
  if (event.key.toLowerCase() === "d") changeTheme();
  else if (!playerKey(match.player, event)) return;
  event.preventDefault();
});

// For the browser's console, and for tests.
Object.assign(window, {
  matrixworldClass: {
    get replay() {
      return match.replay;
    },
    get step() {
      return match.player.step;
    },
  },
});

// The page is drawn before the engine is compiled.
requestAnimationFrame(() =>
  setTimeout(() => {
    loadEngine().then(
      (engine) => {
        match.start(engine);
        document.body.dataset["ready"] = "true";
      },
      (error: unknown) => {
        match.element.prepend(
          html("p", { class: "problem", role: "alert" }, `The engine does not start here: ${String(error)}`),
        );
        document.body.dataset["ready"] = "true";
      },
    );
  }),
);
