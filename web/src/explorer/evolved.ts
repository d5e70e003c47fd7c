// What evolved in both teams, where it can be read: the weights of named inputs as bars, programs, and words.

import { INPUTS } from "../engine/tables.ts";
import { TEAMS } from "../engine/teams.ts";
import type { Team } from "../engine/teams.ts";
import type { InputName, TeamPolicy } from "../engine/types.ts";
import { html } from "../page/dom.ts";
import { policyOf, programOf, ratesMoves, weightsOf, whyNot } from "./data.ts";
import type { Run, WeightsOf } from "./data.ts";
import { capital, signed } from "./format.ts";
import { gameWords, generationName } from "./game.ts";
import { card } from "./panel.ts";
import type { Panel } from "./panel.ts";
import type { Store } from "./store.ts";

/** The selected generations; none for networks over cells of which nobody says anything. */
export function evolvedPanel(run: Run, store: Store): Panel | null {
  if (TEAMS.every((team) => !run.teams[team].evolved && !ratesMoves(run, team))) return null;
  const place = html("div", { class: "evolved" });
  return {
    element: card(
      "What evolved",
      "Each move is rated by named inputs of the cell that it leads to, and the best one is taken.",
      place,
    ),
    update: () => place.replaceChildren(...TEAMS.map((team) => ofTeam(run, team, store.selected[team]))),
  };
}

function ofTeam(run: Run, team: Team, generation: number): HTMLElement {
  const { evolved } = run.teams[team];
  const problem = whyNot(run, team, generation);
  const name = run.teams[team].script ?? generationName(run, team, generation);
  return html(
    "section",
    { "aria-label": gameWords(run).teams[team] },
    html("h3", { class: team }, capital(name)),
    ...(problem
      ? [html("p", { class: "small muted" }, problem)]
      : shownPolicy(run, team, generation, policyOf(run, team, generation))),
    evolved
      ? html(
          "p",
          { class: "small" },
          `Generation ${evolved.generation}, the best against strangers: ${evolved.sentence}`,
        )
      : null,
  );
}

function shownPolicy(run: Run, team: Team, generation: number, policy: TeamPolicy): HTMLElement[] {
  if (typeof policy === "string" || policy.kind === "cells") return [];
  const program = programOf(run, team, generation);
  const weights = weightsOf(policy, program);
  return [
    ...(program ? [html("p", {}, html("code", {}, program.expression))] : []),
    ...(weights ? [bars(team, weights)] : []),
    ...(policy.kind === "rating" && policy.hidden.length
      ? [
          html(
            "p",
            { class: "small muted" },
            `A network with ${policy.hidden.join(" and ")} hidden units rates each move by ${policy.inputs.length} inputs.`,
          ),
        ]
      : []),
  ];
}

/** Return weights of inputs as bars. */
function bars(team: Team, weights: WeightsOf): HTMLElement {
  const all = Object.entries(weights) as [InputName, number][];
  const most = Math.max(...all.map(([, weight]) => Math.abs(weight))) || 1;
  return html(
    "div",
    { class: "weights" },
    ...all.flatMap(([input, weight]) => {
      const bar = html("span", { class: `bar ${team}${weight < 0 ? " below" : ""}` });
      bar.style.width = `${(50 * Math.abs(weight)) / most}%`;
      return [
        html("span", { title: INPUTS[input] }, input.replaceAll("_", " ")),
        html("span", { class: "axis" }, bar),
        html("span", { class: "numbers" }, signed(weight)),
      ];
    }),
  );
}
