// The keyboard of the page, and the dialog that lists it.

import { playerKey } from "../board/player.ts";
import { dialog, keyList } from "../page/dialog.ts";
import type { Keys } from "../page/dialog.ts";
import { html } from "../page/dom.ts";
import { changeTheme } from "../page/theme.ts";
import type { Run } from "./data.ts";
import { gameWords } from "./game.ts";
import type { MatchPanel } from "./match.ts";
import { choose } from "./races.ts";
import type { Store } from "./store.ts";

const keysOf = (run: Run): Keys => [
  [["Space"], "play or pause"],
  [["←", "→"], "step back or forward; with Shift ten steps"],
  [["Home", "End"], "first or last step"],
  [["+", "−"], "faster or slower"],
  [["N"], "next episode of the same pair; with Shift the one before"],
  [["R"], "another seed, not one of the evaluation"],
  [["O"], "the cell's own seed again"],
  [["P"], `next ${gameWords(run).generation.pursuer}; with Shift the one before`],
  [["E"], `next ${gameWords(run).generation.evader}; with Shift the one before`],
  [
    ["M"],
    `to the matrix: arrow keys choose a ${run.game ? "pair, Enter shows it" : "match, Enter plays it"}`,
  ],
  [["A"], "next agent: what it sees; with Shift the one before"],
  [["I"], "inputs of the next move of that agent on the board; with Shift of the one before"],
  [["Esc"], "no agent"],
  [["T"], "take over the chosen agent, or an evader, from this step on"],
  [["G"], "this step in the playground: any other rules, actions and places"],
  [["1", "9"], "first to ninth run"],
  [["D"], "light or dark"],
  [["?"], "this list"],
];

/** Keys of a page that plays no matches. */
const OF_OWN_GAMES = ["P", "E", "M", "1", "D", "?"];
const HOLDS =
  "The page holds the genomes and the engine of this run. A click on a cell plays that very match: same seed, same moves. ";

/** Return the dialog that lists the keys. */
export function helpDialog(runs: readonly Run[]): HTMLDialogElement {
  const played = runs.find(({ game }) => !game);
  const keys = keysOf(played ?? runs[0]!).filter(([[name]]) => played || OF_OWN_GAMES.includes(name!));
  return dialog(
    "Keys",
    "help",
    keyList(keys),
    html(
      "p",
      { class: "muted small" },
      `${played ? HOLDS : ""}The page loads nothing from elsewhere; share the file as it is.`,
    ),
  );
}

/** Listen to the keys of the page. */
export function listenToKeys(
  runs: readonly Run[],
  store: Store,
  match: MatchPanel,
  help: HTMLDialogElement,
  takeOver: () => void,
  playground: () => void,
): void {
  const step = (name: "pursuer" | "evader", by: number) => (): void => {
    const count = runs[store.selected.run]!.payoff.shape[name === "pursuer" ? 0 : 1];
    store.select({ [name]: Math.min(count - 1, Math.max(0, store.selected[name] + by)) });
  };
  const actions: Record<string, () => void> = {
    n: () => store.select({ episode: store.selected.episode + 1 }),
    N: () => store.select({ episode: Math.max(0, store.selected.episode - 1) }),
    r: () => store.select({ seed: String(crypto.getRandomValues(new BigUint64Array(1))[0]), episode: 0 }),
    o: () => store.select({ seed: null, episode: 0 }),
    p: step("pursuer", 1),
    P: step("pursuer", -1),
    e: step("evader", 1),
    E: step("evader", -1),
    m: () => document.getElementById("matrix")?.focus(),
    a: () => match.inspector.next(1),
    A: () => match.inspector.next(-1),
    i: () => match.inspector.ask(1),
    I: () => match.inspector.ask(-1),
    Escape: () => match.inspector.choose(null),
    t: takeOver,
    g: playground,
    d: changeTheme,
    "?": () => help.showModal(),
  };
  document.addEventListener("keydown", (event) => {
    const field = event.target instanceof HTMLSelectElement || event.target instanceof HTMLInputElement;
    const pressed = event.target instanceof HTMLButtonElement && (event.key === " " || event.key === "Enter");
    if (
      document.querySelector("dialog[open]") ||
      field ||
      pressed ||
      event.defaultPrevented ||
      event.ctrlKey ||
      event.metaKey ||
      event.altKey
    ) {
      return;
    }
    const action = actions[event.key] ?? actions[event.key.toLowerCase()];
    const number = Number(event.key) - 1;
    if (playerKey(match.player, event) || action) action?.();
    else if (runs[number]) choose(runs[number], number, store);
    else return;
    event.preventDefault();
  });
}
