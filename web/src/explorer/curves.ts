// Training curve and ratings.

import { TEAMS } from "../engine/teams.ts";
import type { Team } from "../engine/teams.ts";
import { listenToArrows } from "./arrow_keys.ts";
import { band, chart, frame, legend, line, mark } from "./chart.ts";
import type { Run } from "./data.ts";
import { capital, rate, thousands } from "./format.ts";
import { gameWords, sidesOf } from "./game.ts";
import { card } from "./panel.ts";
import type { Panel } from "./panel.ts";
import type { Store } from "./store.ts";

const LEARNERS = ["of-pursuers", "of-evaders", "of-both"] as const;
/** More points than that fill the chart with thick lines. */
const MANY = 2500;
const KEYS = "Arrow keys choose generations.";

/** The score over training, in the colour of the team that learns. */
export function trainingPanel(run: Run, store: Store): Panel {
  const { training } = run;
  const { score, teams } = gameWords(run);
  const { capture_rate, generation, learner, epochs } = training;
  const epoch = capture_rate.map((_, i) => (i + 1) * epochs);
  const smooth = movingMean(capture_rate, training.window);
  const last = epoch.at(-1) ?? 1;
  const dense = epoch.length > MANY ? "dense" : "";
  const spanOf = (chosen: number, team: number): [number, number] | null => {
    const inside = generation.flatMap((each, i) =>
      each === chosen && (learner[i] === team || learner[i] === 2) ? [i] : [],
    );
    return inside.length ? [epoch[inside[0]!]!, epoch[inside.at(-1)!]!] : null;
  };
  const made = chart(
    `${capital(score)} in ${last} epochs of training. ${KEYS}`,
    (width, height) => {
      const into = frame(
        width,
        height,
        { low: 0, high: last, label: "epoch", whole: true },
        { low: 0, high: 1, label: score },
      );
      for (const [style, values] of [
        ["raw", capture_rate],
        [dense, smooth],
      ] as const) {
        for (const [team, name] of LEARNERS.entries()) {
          // A piece of the curve has the colour of the team that learned on the way to its end.
          const own = values.map((value, i) =>
            learner[i] === team || learner[i + 1] === team ? value : null,
          );
          if (own.some((value) => value !== null)) line(into, epoch, own, `${name} ${style}`);
        }
      }
      return into;
    },
    (into) =>
      TEAMS.forEach((team, learns) => {
        const span = spanOf(store.hover[team] ?? store.selected[team], learns);
        if (span) mark(into, (span[0] + span[1]) / 2, LEARNERS[learns]!);
      }),
    (value) => {
      const at = Math.min(epoch.length - 1, Math.max(0, Math.round(value / epochs) - 1));
      const chosen = generation[at]!;
      if (learner[at] !== 1) store.select({ pursuer: Math.min(chosen, run.payoff.shape[0] - 1) });
      if (learner[at] !== 0) store.select({ evader: Math.min(chosen, run.payoff.shape[1] - 1) });
    },
  );
  listenToArrows(made.element, store, () => run.payoff.shape);
  const learning = [...new Set(learner)]
    .sort()
    .map((team) => [`${[teams.pursuer, teams.evader, "both teams"][team]!} learn`, LEARNERS[team]!] as const);
  return {
    element: card(
      "Training",
      `${thousands(training.matches)} training matches. Lines: the generations that are selected.`,
      legend(...learning),
      made.element,
    ),
    update: made.update,
  };
}

/** The mean of both teams' own scores, against contemporaries. */
export function jointPanel(run: Run): Panel | null {
  const joint = run.findings?.joint;
  if (!joint) return null;
  const last = joint.mean.length - 1;
  const made = chart("Mean of both scores by generation.", (width, height) => {
    const into = frame(
      width,
      height,
      { low: 0, high: last, label: "generation", whole: true },
      { low: 0, high: 1, label: "mean of both scores" },
    );
    band(into, joint, "of-both");
    line(
      into,
      joint.mean.map((_, g) => g),
      joint.mean,
      "of-both",
    );
    return into;
  });
  const ends = `${rate(joint.mean[0] ?? null)} in the beginning, ${rate(joint.mean[last] ?? null)} at the end`;
  return {
    element: card(
      "Both sides together",
      `The mean of both scores against contemporaries: ${ends}. What one wins is not what the other loses here, so both may rise, or fall.`,
      made.element,
    ),
    update: made.update,
  };
}

/** Elo ratings of all generations. */
export function ratingPanel(run: Run, store: Store): Panel | null {
  const ratings = run.findings?.ratings;
  if (!ratings) return null;
  const bands = { pursuer: ratings.pursuers, evader: ratings.evaders };
  const curves = { pursuer: bands.pursuer.mean, evader: bands.evader.mean };
  const sides = sidesOf(run);
  const values = TEAMS.flatMap((team) => [bands[team].mean, bands[team].low ?? [], bands[team].high ?? []])
    .flat()
    .map((value) => value ?? 0);
  const low = Math.min(...values);
  const high = Math.max(...values);
  const room = 0.06 * (high - low || 1);
  const last = Math.max(...run.payoff.shape) - 1;
  const { teams } = gameWords(run);
  const made = chart(
    `Elo ratings by generation. ${KEYS}`,
    (width, height) => {
      const into = frame(
        width,
        height,
        { low: 0, high: last, label: "generation", whole: true },
        { low: low - room, high: high + room, label: "Elo points" },
      );
      for (const team of sides) {
        band(into, bands[team], `of-${team}s`);
        line(
          into,
          curves[team].map((_, g) => g),
          curves[team],
          `of-${team}s`,
        );
      }
      return into;
    },
    (into) => {
      for (const team of TEAMS) {
        const chosen = store.hover[team] ?? store.selected[team];
        mark(into, chosen, `of-${team}s`, curves[team][chosen] ?? null);
      }
    },
    (value, into, event) => {
      const generation = Math.round(value);
      const height = event.clientY - into.root.getBoundingClientRect().top;
      const away = (team: Team): number => Math.abs(into.y(curves[team][generation] ?? Infinity) - height);
      const team = away("pursuer") <= away("evader") ? "pursuer" : "evader";
      if (generation >= 0 && generation < curves[team].length) store.select({ [team]: generation });
    },
  );
  listenToArrows(made.element, store, () => run.payoff.shape);
  return {
    element: card(
      "Ratings",
      `One number for each generation, which cycles do not fit${bands.pursuer.low ? ", with 95 % intervals over episodes" : ""}.${sides.length > 1 ? ` The game itself: ${rate(ratings.offset, 0)} points for the ${teams.pursuer}.` : ""}`,
      legend(...sides.map((team) => [teams[team], `of-${team}s`] as const)),
      made.element,
    ),
    update: made.update,
  };
}

/** Return the centred mean of a window of points, and of fewer at both ends. */
function movingMean(values: readonly number[], window: number): number[] {
  const sums = [0];
  for (const value of values) sums.push(sums.at(-1)! + value);
  return values.map((_, i) => {
    const from = Math.max(0, i - Math.floor((window - 1) / 2));
    const to = Math.min(values.length, i + Math.floor(window / 2) + 1);
    return (sums[to]! - sums[from]!) / (to - from);
  });
}
