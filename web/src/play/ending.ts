// A match against players that are compared at its end: what each makes of the same seat.

import type { Engine } from "../engine/engine.ts";
import { html } from "../page/dom.ts";
import type { Live } from "./live.ts";
import { ladder, linkTo, resultInSeat, resultOf, teamOf } from "./played.ts";
import type { Played, Player, Result } from "./played.ts";
import type { PlayView } from "./view.ts";

/** Play a match on from its moves; `players` are compared, and `place` names the match in a link; null for none. */
export function playOn(engine: Engine, view: PlayView, title: string, played: Played, players: readonly Player[], place: Parameters<typeof linkTo>[0] | null): void {
  view.play({
    title, played,
    ending: (live, now) => [comparison(engine, live, now, ladder(players))],
    again: () => playOn(engine, view, title, { ...played, moves: played.moves.slice(0, played.from) }, players, place),
    link: (now) => place && linkTo(place, now),
  });
}

/** Return a table of the person and of others in the same seat of the same match. */
function comparison(engine: Engine, live: Live, played: Played, players: readonly Player[]): HTMLElement {
  const evader = teamOf(played.config, played.seat) === "evader";
  const most = evader ? played.config.max_steps : played.config.n_evaders;
  const table = html("table", { class: "numbers" },
    html("caption", {}, evader ? "Steps in your seat: same start, same others" : "Captures of your team: same start, same others"));
  const row = (name: string): ((result: Result) => void) => {
    const [bar, value] = [html("span", { class: evader ? "bar evader" : "bar pursuer" }), html("td", {}, "…")];
    table.append(html("tr", {}, html("th", { scope: "row" }, name), html("td", { class: "track", "aria-hidden": "true" }, bar), value));
    return ({ lasted, captured }) => {
      bar.style.width = `${(100 * (evader ? lasted : captured)) / most}%`;
      value.textContent = String(evader ? lasted : captured);
    };
  };
  row("You")(resultOf(live, played.seat));
  // Each is a whole match: the page shows the end before they are played.
  for (const { name, policy } of players) {
    const fill = row(name);
    setTimeout(() => fill(resultInSeat(engine, played, policy())));
  }
  const began = played.from ? `You took over at step ${played.from}. ` : "";
  return html("div", {}, table, html("p", { class: "small muted" }, `${began}One match: luck has its part in it.`));
}
