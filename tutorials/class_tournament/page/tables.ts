// The standings of a team, and what was refused.

import { otherOf } from "../../../web/src/engine/teams.ts";
import type { Team } from "../../../web/src/engine/teams.ts";
import { html } from "../../../web/src/page/dom.ts";
import { rate } from "../../../web/src/explorer/format.ts";
import type { Data, Pair, Refusal, Standing } from "./data.ts";
import type { Store } from "./store.ts";

/** Return the table of a team. A click on an opponent plays the match against it. */
export function standingsTable(data: Data, team: Team, store: Store): HTMLElement {
  const rows = data.standings[team].map((standing) => row(data, team, standing, store));
  const score = team === "pursuer" ? "Mean capture rate" : "Mean escape rate";
  const heads = ["Rank", "Name", "Score", "Best, worst"];
  return html(
    "section",
    { class: "card standings", "aria-label": `Standings of ${team}s` },
    html(
      "header",
      {},
      html("h2", {}, html("span", { class: team }, `${team[0]!.toUpperCase()}${team.slice(1)}s`)),
      html(
        "p",
        { class: "small muted" },
        `${score} against ${data.names[otherOf(team)].length} opponents, with 95 % interval`,
      ),
    ),
    html(
      "div",
      { class: "scroll", tabindex: "0" },
      html(
        "table",
        {},
        html("thead", {}, html("tr", {}, ...heads.map((head) => html("th", { scope: "col" }, head)))),
        html("tbody", {}, ...rows),
      ),
    ),
  );
}

function row(data: Data, team: Team, standing: Standing, store: Store): HTMLElement {
  const { kind, name, file, rank, number } = standing;
  const made = html(
    "tr",
    { class: kind, "data-number": number },
    html("td", { class: "rank numbers" }, rank || "–"),
    html(
      "th",
      { scope: "row", title: file },
      html("span", { class: "who", title: name }, name),
      html("span", { class: "kind small muted" }, kind),
    ),
    html("td", { class: "numbers score" }, bar(standing, team), numbers(standing)),
    html(
      "td",
      { class: "matches" },
      ...(["best", "worst"] as const).map((which) => matchButton(data, team, standing, which, store)),
    ),
  );
  const mark = (): void => {
    made.classList.toggle("about", number === (store.hover ?? store.pair)[team]);
  };
  store.on("pair", mark);
  store.on("hover", mark);
  mark();
  return made;
}

function numbers({ score, low, high }: Standing): HTMLElement {
  const ends = low === null || high === null ? "" : `${rate(low)} – ${rate(high)}`;
  return html(
    "span",
    { class: "score-text" },
    html("strong", {}, rate(score)),
    html("span", { class: "small muted" }, ends),
  );
}

/** The score as a bar from 0 to 1, and its interval as a line. */
function bar({ score, low, high }: Standing, team: Team): HTMLElement {
  const filled = html("span", { class: `filled of-${team}` });
  const whisker = html("span", { class: "whisker" });
  filled.style.width = `${100 * score}%`;
  if (low !== null && high !== null) {
    whisker.style.left = `${100 * low}%`;
    whisker.style.width = `${100 * (high - low)}%`;
  }
  return html("span", { class: "bar", "aria-hidden": "true" }, filled, whisker);
}

function matchButton(
  data: Data,
  team: Team,
  standing: Standing,
  which: "best" | "worst",
  store: Store,
): HTMLElement {
  const rival = standing[which];
  const pair: Pair =
    team === "pursuer"
      ? { pursuer: standing.number, evader: rival }
      : { pursuer: rival, evader: standing.number };
  const opponent = data.names[otherOf(team)][rival]!;
  const captured = data.capture_rate[pair.pursuer]![pair.evader]!;
  const value = rate(team === "pursuer" ? captured : 1 - captured);
  return html(
    "button",
    {
      type: "button",
      class: "to-match",
      title: `Watch the ${which} match: against ${opponent}, ${value}`,
      "aria-label": `Watch the ${which} match of ${standing.name}: against ${opponent}, ${value}`,
      onclick: () => store.play(pair),
    },
    which === "best" ? "▲ " : "▼ ",
    opponent,
  );
}

/** Return how the class voted on predictions of the course; nothing if no predictions were handed in. */
export function votesTable({ votes }: Data): HTMLElement[] {
  const names = Object.keys(votes);
  if (!names.length) return [];
  const rows = names.map((name) => {
    const counts = Object.entries(votes[name]!);
    const all = counts.reduce((sum, [, count]) => sum + count, 0);
    const choices = counts.map(([choice, count]) => {
      const filled = html("span", { class: "filled" });
      filled.style.width = `${(100 * count) / all}%`;
      return html(
        "div",
        { class: "vote" },
        html("span", {}, choice),
        html("span", { class: "bar", "aria-hidden": "true" }, filled),
        html("span", { class: "numbers" }, `${count} of ${all}`),
      );
    });
    return html("tr", {}, html("th", { scope: "row" }, name), html("td", {}, ...choices));
  });
  return [
    html(
      "section",
      { class: "card votes", "aria-label": "Predictions" },
      html(
        "header",
        {},
        html("h2", {}, "How the class voted"),
        html(
          "p",
          { class: "small muted" },
          "Predictions of the course: the first choice of each student, before the experiment.",
        ),
      ),
      html("table", {}, html("tbody", {}, ...rows)),
    ),
  ];
}

/** Return the list of what was refused; nothing if all could play. */
export function refusedList(refusals: readonly Refusal[]): HTMLElement[] {
  if (!refusals.length) return [];
  const items = refusals.map(({ file, reason }) =>
    html("div", { class: "refusal" }, html("dt", {}, file), html("dd", {}, reason)),
  );
  return [
    html(
      "section",
      { class: "card refused", "aria-label": "Refused" },
      html(
        "header",
        {},
        html("h2", {}, `Refused (${refusals.length})`),
        html(
          "p",
          { class: "small muted" },
          "These did not play, or broke a rule while they played; their matches count for no one.",
        ),
      ),
      html("dl", {}, ...items),
    ),
  ];
}
