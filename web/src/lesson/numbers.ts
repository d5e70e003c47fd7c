// Numbers games: three at once with hidden names, and one to play with, whose CIAO triangles grow.

import { chart, frame, legend, line } from "../explorer/chart.ts";
import type { Frame } from "../explorer/chart.ts";
import { capital } from "../explorer/format.ts";
import { scaleOfRates } from "../explorer/heatmap.ts";
import { html, svg } from "../page/dom.ts";
import type { WidgetPart } from "./data.ts";
import { choice, slider } from "./inputs.ts";
import { matrixOf } from "./pictures.ts";
import { BITS, GAMES, NumbersGame, USUAL, generator, meanScore } from "./toys.ts";
import type { GameName, Settings } from "./toys.ts";

const GENERATIONS = 600;
/** Generations between two that are kept. */
const EVERY = 20;
const SEEDS = 5;
const RACES = 10;
/** How prediction 0.d names the games. */
const UNNAMED: Readonly<Record<string, GameName>> = {
  "Game A": "intransitive",
  "Game B": "scalar",
  "Game C": "focusing",
};
const ALONG = { low: 0, high: GENERATIONS, label: "generation", whole: true };
const ONES = { low: 0, high: BITS, label: "ones of side 1" };
const nothing = (): undefined => undefined;
const rest = (): Promise<void> => new Promise((resolve) => setTimeout(resolve));

/**
 * Play a game to its end, and call `see` at each generation that is kept; the page rests there, and
 * `goes` may end it.
 */
async function play(game: NumbersGame, see: () => void, goes: () => boolean): Promise<void> {
  for (see(); game.generation < GENERATIONS && goes(); see()) {
    for (let i = 0; i < EVERY; i++) game.step();
    await rest();
  }
}

type Curves = Readonly<Record<"score" | "ones", number[]>>;
const unnamed = new Map<string, Curves[]>();
const redraws: (() => void)[] = [];

/** Play the races of the three games once, for both figures. */
async function playUnnamed(): Promise<void> {
  for (const name of Object.keys(UNNAMED)) unnamed.set(name, []);
  for (let seed = 0; seed < SEEDS; seed++) {
    for (const [name, each] of Object.entries(UNNAMED)) {
      const curves: Curves = { score: [], ones: [] };
      unnamed.get(name)!.push(curves);
      const game = new NumbersGame(each, USUAL, generator(seed));
      await play(
        game,
        () => {
          curves.score.push(meanScore(each, game.ones(0), game.ones(1)));
          curves.ones.push(game.objective(0));
        },
        () => true,
      );
      redraws.forEach((redraw) => redraw());
    }
  }
}

/** Three charts side by side: the score against the current opponent, or the ones. */
export function gamesWidget({ shows = "score" }: WidgetPart): HTMLElement {
  if (!unnamed.size) void playUnnamed();
  const vertical = shows === "score" ? { low: 0, high: 1, label: "score of side 1" } : ONES;
  const charts = Object.entries(UNNAMED).map(([name, game]) => {
    const title = shows === "score" ? name : `${name}: ${game}`;
    const made = chart(
      `${title}: ${vertical.label} in ${SEEDS} races`,
      (width, height) => {
        const into = frame(width, height, ALONG, vertical);
        for (const curves of unnamed.get(name)!) {
          line(
            into,
            curves[shows].map((_, at) => at * EVERY),
            curves[shows],
            "of-both dense",
          );
        }
        return into;
      },
      nothing,
      nothing,
    );
    redraws.push(made.redraw);
    return html("figure", {}, html("figcaption", {}, title), made.element);
  });
  return html(
    "div",
    { class: "widget" },
    html("div", { class: "matrices" }, ...charts),
    html(
      "p",
      { class: "small muted" },
      `Each line is a race; there are ${SEEDS} of each game, played now, in this page.`,
    ),
  );
}

const POPULATIONS = [5, 10, 15, 25, 40, 60];
const MUTATIONS = [0.0005, 0.001, 0.002, 0.005, 0.01, 0.02, 0.05];
const HALLS = [0, 1, 5, 15, 30];
/** The hall of prediction 0.e. */
const WITH_HALL = 15;
const SEED_NUMBERS = Array.from({ length: 20 }, (_, seed) => seed);

/**
 * One game with sliders. With `hall` there is one for the hall of fame, and ten races can be
 * compared with ten.
 */
export function numbersWidget({ hall = false }: WidgetPart): HTMLElement {
  let game: GameName = "scalar";
  let seed = 0;
  let settings: Settings = { ...USUAL, hall: hall ? WITH_HALL : 0 };
  let race = 0; // the number of the race that plays: a newer one ends it
  const set = (change: Partial<Settings>): void => {
    settings = { ...settings, ...change };
  };
  const rows: [number[][], number[][]] = [[], []];
  const triangles = [
    matrixOf(rows[0], "Score of side 1", GENERATIONS / EVERY + 1),
    matrixOf(rows[1], "Score of side 2", GENERATIONS / EVERY + 1),
  ];
  triangles.forEach((each) =>
    each.querySelector("p")!.replaceChildren(`↑ generation, → opponent (${EVERY} a cell)`),
  );
  const ones: [number[], number[]] = [[], []];
  const curve = chart(
    "Ones of both sides by generation",
    (width, height) => {
      const into = frame(width, height, ALONG, { ...ONES, label: "ones" });
      ones.forEach((each, side) =>
        line(
          into,
          each.map((_, at) => at * EVERY),
          each,
          side ? "of-evaders" : "of-pursuers",
        ),
      );
      return into;
    },
    nothing,
    nothing,
  );
  const told = html("p", { class: "numbers", role: "status" });
  const tell = (text: string): void => {
    told.textContent = text;
  };
  const one = async (): Promise<void> => {
    const own = ++race;
    for (const list of [...rows, ...ones]) list.length = 0;
    const kept: [ReturnType<NumbersGame["ones"]>[], ReturnType<NumbersGame["ones"]>[]] = [[], []];
    const playing = new NumbersGame(game, settings, generator(seed));
    await play(
      playing,
      () => {
        for (const side of [0, 1] as const) {
          kept[side].push(playing.ones(side));
          ones[side].push(playing.objective(side));
        }
        for (const side of [0, 1] as const) {
          rows[side].push(kept[1 - side]!.map((past) => meanScore(playing.game, kept[side].at(-1)!, past)));
        }
        triangles.forEach((each) => each.draw?.());
        curve.redraw();
      },
      () => race === own,
    );
    if (race === own) {
      tell(
        `${capital(playing.game)} game, seed ${seed}: after ${GENERATIONS} generations side 1 has ${ones[0].at(-1)!.toFixed(0)} ones, side 2 ${ones[1].at(-1)!.toFixed(0)}.`,
      );
    }
  };
  let compared: readonly Row[] = [];
  const dots = chart(
    "Ones of side 1 at the end of ten races, a row for each choice of settings",
    (width, height) => dotsOf(compared, width, height),
    nothing,
    nothing,
  );
  dots.element.classList.add("dots");
  const ten = async (settings: Settings): Promise<void> => {
    const own = ++race;
    const ends: number[] = [];
    const { population, mutation } = settings;
    const name = `${game}${population === USUAL.population ? "" : `, ${population} players`}${mutation === USUAL.mutation ? "" : `, mutation ${mutation}`}, hall ${settings.hall}`;
    // Only complete rows stay, and one of each choice.
    compared = [
      ...compared.filter((row) => row.ends.length === RACES && row.text !== name).slice(1 - MOST_ROWS),
      { text: name, ends },
    ];
    for (let at = 0; at < RACES && race === own; at++) {
      const playing = new NumbersGame(game, settings, generator(at));
      await play(playing, nothing, () => race === own);
      if (race === own) ends.push(playing.objective(0));
      dots.redraw();
    }
    if (race === own) {
      tell(`${capital(name)}: side 1 ends with ${meanOf(ends)} ones in the mean of ${RACES} races.`);
    }
  };
  const press = (act: () => Promise<void>, text: string, style = ""): HTMLElement =>
    html("button", { type: "button", class: style, onclick: () => void act() }, text);
  const inputs = html(
    "div",
    { class: "sliders" },
    choice("game", Object.keys(GAMES), (each) => (game = each as GameName)),
    slider("population", POPULATIONS, settings.population, String, (population) => set({ population })),
    slider("mutation", MUTATIONS, settings.mutation, String, (mutation) => set({ mutation })),
    ...(hall
      ? [slider("hall of fame", HALLS, WITH_HALL, String, (each) => set({ hall: each }))]
      : [slider("seed", SEED_NUMBERS, 0, String, (each) => (seed = each))]),
  );
  if (hall) {
    void ten(USUAL).then(() => (race === 1 ? ten(settings) : undefined)); // unless something else was pressed
    return html(
      "div",
      { class: "widget" },
      inputs,
      html(
        "div",
        { class: "buttons" },
        press(() => ten(settings), "Play ten races", "primary"),
      ),
      told,
      dots.element,
    );
  }
  return html(
    "div",
    { class: "widget" },
    inputs,
    html(
      "div",
      { class: "buttons" },
      press(one, "Play a race", "primary"),
      press(async () => void race++, "Stop"),
    ),
    html(
      "div",
      { class: "matrices" },
      ...triangles,
      html(
        "figure",
        {},
        html("figcaption", {}, "The truth: ones"),
        legend(["side 1", "of-pursuers"], ["side 2", "of-evaders"]),
        curve.element,
      ),
    ),
    scaleOfRates("0 loses", "1 wins"),
    told,
  );
}

const MOST_ROWS = 6;
const meanOf = (ends: readonly number[]): string =>
  (ends.reduce((sum, each) => sum + each, 0) / ends.length).toFixed(1);

/** Races with one choice of settings, and the ones at their ends so far. */
interface Row {
  readonly text: string;
  readonly ends: readonly number[];
}

/** Rows of dots, a dot for each race, and the mean of all. */
function dotsOf(compared: readonly Row[], width: number, height: number): Frame {
  const into = frame(
    width,
    height,
    { low: 0, high: BITS, label: "ones of side 1 at the end", whole: true },
    { low: 0, high: MOST_ROWS, label: "" },
  );
  into.root.querySelectorAll(".axes .grid, .axes [text-anchor=end]").forEach((each) => each.remove());
  compared.forEach(({ text, ends }, row) => {
    const y = into.y(MOST_ROWS - row - 0.7);
    into.marks.before(
      svg(
        "text",
        { class: "label", x: into.left, y: y - 12 },
        `${text}: ${ends.length < RACES ? `${ends.length} of ${RACES} races` : `mean ${meanOf(ends)}`}`,
      ),
    );
    ends.forEach((each) =>
      into.marks.before(svg("circle", { class: "dot of-both", cx: into.x(each), cy: y, r: 5 })),
    );
  });
  return into;
}
