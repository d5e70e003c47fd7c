// Rock, paper, scissors in turns: the remembered hands in a triangle, and what the best answer to them wins.

import { stillMotion } from "../board/board.ts";
import { Player } from "../board/player.ts";
import { playerBar } from "../board/player_bar.ts";
import { chart, frame, legend, line, mark } from "../explorer/chart.ts";
import { rate } from "../explorer/format.ts";
import { scaleOfRates } from "../explorer/heatmap.ts";
import { html, svg } from "../page/dom.ts";
import { matrixOf } from "./pictures.ts";
import type { WidgetPart } from "./data.ts";
import { slider } from "./inputs.ts";
import { HANDS, PAYOFF, alternate, bestAnswer, generator, sharesOf } from "./toys.ts";

const SEED = 1;
const TEAMS = ["pursuers", "evaders"] as const;
const CORNERS = [
  [150, 42],
  [266, 232],
  [34, 232],
] as const;
/** The marks of both teams do not cover each other: pixels to the left and right. */
const BESIDE = { pursuers: -7, evaders: 7 };

/** Return the place of shares in the triangle. */
const placeOf = (shares: readonly number[]): [x: number, y: number] =>
  [0, 1].map((axis) =>
    shares.reduce((sum, share, hand) => sum + share * CORNERS[hand]![axis as 0 | 1], 0),
  ) as [number, number];

/** A team's shares of remembered hands in each generation. */
const remembered = (hands: readonly number[], memory: number): number[][] =>
  hands.map((_, last) => sharesOf(hands.slice(0, last + 1), memory));

export function handsWidget({
  memories = [1],
  memory: first = memories[0]!,
  generations = 30,
}: WidgetPart): HTMLElement {
  const player = new Player(generations, { speed: generations > 100 ? 16 : 2, still: stillMotion() });
  let memory = first;
  let hands = alternate(generations, memory, generator(SEED));
  let shares = { pursuers: [] as number[][], evaders: [] as number[][] };
  const ways = {
    pursuers: svg("polyline", { class: "way of-pursuers" }),
    evaders: svg("polyline", { class: "way of-evaders" }),
  };
  const marks = {
    pursuers: svg("path", { class: "filled-pursuer", d: "M0 -11 11 9H-11z" }),
    evaders: svg("circle", { class: "filled-evader", r: 9 }),
  };
  const triangle = svg(
    "svg",
    {
      viewBox: "0 0 300 270",
      class: "hands-triangle",
      role: "img",
      "aria-label": "The shares of rock, paper and scissors among the remembered hands of both teams",
    },
    svg("polygon", { class: "frame", points: CORNERS.map((each) => each.join()).join(" ") }),
    svg("circle", { class: "middle", cx: 150, cy: 168.7, r: 4 }),
    svg("text", { x: 150, y: 192, "text-anchor": "middle" }, "one third each"),
    svg("text", { class: "label", x: 150, y: 18, "text-anchor": "middle" }, "rock"),
    svg("text", { class: "label", x: 266, y: 262, "text-anchor": "middle" }, "paper"),
    svg("text", { class: "label", x: 34, y: 262, "text-anchor": "middle" }, "scissors"),
    ...TEAMS.map((team) => ways[team]),
    ...TEAMS.map((team) => marks[team]),
  );
  const told = html("p", { class: "numbers" });
  const curves = chart(
    "What the best answer wins against the remembered hands, by generation",
    (width, height) => {
      const into = frame(
        width,
        height,
        { low: 0, high: generations, label: "generation", whole: true },
        { low: 0.4, high: 1, label: "best answer wins" },
      );
      line(into, [0, generations], [0.5, 0.5], "half");
      for (const team of TEAMS) {
        line(
          into,
          hands[team].map((_, g) => g),
          shares[team].map(bestAnswer),
          `of-${team}`,
        );
      }
      return into;
    },
    (into) => mark(into, player.step, "of-both"),
    (value) => player.jump(value),
  );
  const show = (): void => {
    const step = player.step;
    for (const team of TEAMS) {
      ways[team].setAttribute(
        "points",
        shares[team]
          .slice(0, step + 1)
          .map((each) =>
            placeOf(each)
              .map((at) => at.toFixed(1))
              .join(),
          )
          .join(" "),
      );
      const [x, y] = placeOf(shares[team][step]!);
      marks[team].setAttribute("transform", `translate(${x + BESIDE[team]} ${y})`);
    }
    const own = (team: "pursuers" | "evaders"): Node =>
      html("span", { class: team.slice(0, -1) }, `${team} show ${HANDS[hands[team][step]!]}`);
    told.replaceChildren(
      `Generation ${step}: `,
      own("pursuers"),
      ", ",
      own("evaders"),
      ".",
      ...(memories.length > 1
        ? [
            ` The best answer to the remembered hands of the pursuers wins ${rate(bestAnswer(shares.pursuers[step]!))}.`,
          ]
        : []),
    );
    curves.update();
  };
  const change = (): void => {
    hands = alternate(generations, memory, generator(SEED));
    shares = { pursuers: remembered(hands.pursuers, memory), evaders: remembered(hands.evaders, memory) };
    curves.redraw();
    show();
  };
  player.addEventListener("step", show);
  change();
  const most = memories.at(-1)!;
  const memorySlider = slider(
    "memory (hands)",
    memories,
    first,
    (each) => (each === most ? "all" : String(each)),
    (each) => {
      memory = each;
      change();
    },
  );
  return html(
    "div",
    { class: "widget" },
    memories.length > 1 && memorySlider,
    html(
      "div",
      { class: "two" },
      html("div", {}, triangle),
      memories.length > 1 &&
        html(
          "div",
          {},
          legend(["pursuers' hands", "of-pursuers"], ["evaders' hands", "of-evaders"]),
          curves.element,
        ),
    ),
    told,
    playerBar(player),
  );
}

/** All generations of pursuers against all generations of evaders. */
export function handsMatrix({ generations = 30 }: WidgetPart): HTMLElement {
  const { pursuers, evaders } = alternate(generations, 1, generator(SEED));
  const matrix = pursuers.map((own) => evaders.map((other) => PAYOFF[own]![other]!));
  const last = matrix.at(-1)!;
  return html(
    "div",
    { class: "widget" },
    html(
      "div",
      { class: "matrices" },
      matrixOf(
        matrix,
        `The last pursuers score ${rate(last.reduce((sum, each) => sum + each, 0) / last.length)} against all evaders.`,
      ),
    ),
    scaleOfRates("0 loses", "1 wins"),
  );
}
