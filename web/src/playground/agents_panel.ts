// The agents in a table: what each does next, and what the step that is shown was worth to it.

import { html, svg } from "../page/dom.ts";
import { ACTIONS } from "../page/names.ts";
import { rulesName } from "./arena.ts";
import { CHAMPION, agentName, nAgents, teamOf, withNext } from "./scene.ts";
import type { Command, Scene, Team } from "./scene.ts";
import type { Store } from "./store.ts";
import { commandText, signed, sumOf } from "./words.ts";

/** Return the shape of a team's agents. */
export function glyph(team: Team): SVGSVGElement {
  const shape =
    team === "pursuers" ? svg("path", { d: "M12 3 22 20H2z" }) : svg("circle", { cx: 12, cy: 12, r: 9.5 });
  return svg("svg", { viewBox: "0 0 24 24", class: `glyph ${team}`, "aria-hidden": true }, shape);
}

interface Row {
  readonly element: HTMLTableRowElement;
  readonly choice: HTMLSelectElement;
  /** In place of the choice: why an agent does nothing. */
  readonly state: HTMLElement;
  readonly heard: HTMLElement;
  readonly rewards: readonly HTMLTableCellElement[];
}

/** Return the card with the table. */
export function agentsPanel(store: Store): HTMLElement {
  const heads = [0, 1].map(() => html("th", { class: "reward", scope: "col" }));
  const body = html("tbody");
  const table = html(
    "table",
    { class: "agents" },
    html(
      "thead",
      {},
      html("tr", {}, html("th", { scope: "col" }, "agent"), html("th", { scope: "col" }, "next"), ...heads),
    ),
    body,
  );
  const element = html(
    "section",
    { class: "card agents-card" },
    html("h2", {}, "Agents"),
    store.data.champions
      ? html(
          "button",
          {
            type: "button",
            title: "The policies of the match move all agents but the chosen one",
            onclick: () => letNetworksMove(store),
          },
          "Policies move all others",
        )
      : "",
    html("div", { class: "agents-scroll" }, table),
  );
  let rows: Row[] = [];
  let shape = "";
  const update = (): void => {
    const { scene } = store;
    const now = `${scene.pursuers.length} ${scene.evaders.length} ${scene.diagonal}`;
    if (now !== shape) {
      shape = now;
      rows = Array.from({ length: nAgents(scene) }, (_, agent) => row(store, agent));
      body.replaceChildren(...rows.map((each) => each.element));
    }
    heads.forEach((head, place) => {
      head.hidden = place >= store.games.length;
      head.textContent = store.games.length > 1 && store.games[place] ? rulesName(store, place) : "reward";
      head.title = "Reward of the step";
    });
    rows.forEach((each, agent) => fill(store, each, agent));
  };
  store.shownBy(update);
  return element;
}

function letNetworksMove(store: Store): void {
  store.stop();
  store.change({
    ...store.scene,
    next: store.scene.next.map((own, agent) => (agent === store.selected ? own : CHAMPION)),
  });
}

function row(store: Store, agent: number): Row {
  const { scene } = store;
  const name = agentName(scene, agent);
  const choice = html(
    "select",
    {
      "aria-label": `${name} does next`,
      onchange: () => {
        const chosen = choice.value;
        store.stop();
        store.change(
          withNext(store.scene, agent, /^\d$/.test(chosen) ? Number(chosen) : (chosen as Command)),
        );
      },
    },
    ...choices(store, scene, agent),
  );
  const state = html("span", { class: "state muted" });
  const heard = html("span", { class: "heard" });
  const select = html(
    "button",
    { type: "button", class: "agent-name", onclick: () => (store.selected = agent) },
    glyph(teamOf(scene, agent)),
    name,
    heard,
  );
  const rewards = [0, 1].map(() => html("td", { class: "reward numbers" }));
  const element = html(
    "tr",
    {},
    html("th", { scope: "row" }, select),
    html("td", {}, choice, state),
    ...rewards,
  );
  return { element, choice, state, heard, rewards };
}

function choices(store: Store, scene: Scene, agent: number): HTMLElement[] {
  const actions = ACTIONS.slice(0, scene.diagonal ? 9 : 5).map((_, action) =>
    html("option", { value: action }, commandText(action)),
  );
  const scripts = store.data.scripts.map(({ name, text }) =>
    html("option", { value: name, title: text }, name),
  );
  const groups = [
    html("optgroup", { label: "move" }, ...actions),
    html("optgroup", { label: "script" }, ...scripts),
  ];
  const champion = store.data.champions?.[agent < scene.pursuers.length ? "pursuer" : "evader"];
  return champion ? [html("option", { value: CHAMPION }, champion.name), ...groups] : groups;
}

function fill(store: Store, { element, choice, state, heard, rewards }: Row, agent: number): void {
  const { scene, game, player } = store;
  const moment = game.recording.moments[Math.min(player.step, game.length)]!;
  const evader = agent - scene.pursuers.length;
  const captured = evader >= 0 && Boolean(moment.captured[evader]);
  element.classList.toggle("chosen", store.selected === agent);
  element.classList.toggle("gone", !moment.alive[agent]);
  choice.value = String(scene.next[agent]);
  choice.disabled = !moment.alive[agent] || game.over;
  choice.hidden = !moment.alive[agent];
  state.hidden = Boolean(moment.alive[agent]);
  state.textContent = captured ? "captured" : "gone";
  // Captured evaders are hollow, as on the board.
  element.classList.toggle("captured", captured);
  heard.textContent = captured ? " captured" : "";
  rewards.forEach((cell, place) => {
    const other = store.games[place];
    cell.hidden = !other;
    const reward = other?.outcomes[player.step]?.rewards[agent];
    const sum = other ? sumOf(scene, other, player.step, agent) : "";
    cell.replaceChildren(
      player.step && reward !== undefined ? signed(reward) : "",
      store.games.length > 1 ? "" : html("span", { class: "sum small muted" }, sum),
    );
    cell.title = sum;
    const own = game.outcomes[player.step]?.rewards[agent];
    cell.classList.toggle("differs", place > 0 && reward !== undefined && own !== reward);
  });
}
