// The buttons below the boards: steps, the two modes, and what is added to the board.

import { icon } from "../board/player_bar.ts";
import type { Icon } from "../board/player_bar.ts";
import { html } from "../page/dom.ts";
import { ACTIONS } from "../page/names.ts";
import { glyph } from "./agents_panel.ts";
import { command } from "./arena.ts";
import { MOST_AGENTS, added, freeCell, nAgents, removed } from "./scene.ts";
import type { Team } from "./scene.ts";
import type { Control, Mode, Store } from "./store.ts";
import { ARROWS } from "./words.ts";

/** Return the bar, with a line for messages. */
export function toolbar(store: Store): HTMLElement {
  const steps = stepButtons(store);
  const modes = modeButtons(store);
  const pad = padButtons(store);
  const build = buildButtons(store);
  const message = html("p", { class: "message", role: "status" });
  store.addEventListener("message", (event) => {
    const { text, problem } = (event as CustomEvent<{ text: string; problem: boolean }>).detail;
    message.textContent = text;
    message.classList.toggle("problem", problem);
  });
  const controls = [steps, modes, pad, build];
  store.addEventListener("change", () => {
    message.textContent = "";
    message.classList.remove("problem");
  });
  store.shownBy(() => controls.forEach((control) => control.update()));
  return html("div", { class: "toolbar" }, ...controls.map((control) => control.element), message);
}

function button(name: Icon, label: string, keys: string, act: () => void): HTMLButtonElement {
  return html(
    "button",
    { type: "button", title: `${label} (${keys})`, onclick: act },
    icon(name),
    html("span", {}, label),
  );
}

function stepButtons(store: Store): Control {
  const restart = button("first", "Restart", "Home", () => store.restart());
  const back = button("back", "Back", "Backspace", () => store.back());
  const step = button("forward", "Step", "Enter", () => store.step());
  const run = button("play", "Run", "Space", () => store.run());
  step.classList.add("primary");
  step.id = "step";
  return {
    element: html(
      "div",
      { class: "buttons", role: "group", "aria-label": "Steps" },
      restart,
      back,
      step,
      run,
    ),
    update: () => {
      // Buttons that cannot be used stay where the focus is: disabled ones would lose it.
      for (const each of [restart, back]) each.setAttribute("aria-disabled", String(!store.game.length));
      step.setAttribute("aria-disabled", String(!store.canStep));
      run.setAttribute("aria-disabled", String(!store.canStep && !store.running));
      run.replaceChildren(
        icon(store.running ? "pause" : "play"),
        html("span", {}, store.running ? "Stop" : "Run"),
      );
    },
  };
}

function modeButtons(store: Store): Control {
  const names: Record<Mode, string> = { act: "Move", build: "Build" };
  const titles: Record<Mode, string> = {
    act: "Choose agents and their moves (M)",
    build: "Place agents and draw obstacles (M)",
  };
  const modes = Object.keys(names) as Mode[];
  const buttons = modes.map((mode) =>
    html("button", { type: "button", title: titles[mode], onclick: () => (store.mode = mode) }, names[mode]),
  );
  return {
    element: html(
      "div",
      { class: "buttons joined", role: "group", "aria-label": "What the board does" },
      ...buttons,
    ),
    update: () =>
      modes.forEach((mode, place) =>
        buttons[place]!.setAttribute("aria-pressed", String(store.mode === mode)),
      ),
  };
}

function buildButtons(store: Store): Control {
  const add = (team: Team, name: string, key: string): HTMLButtonElement =>
    html(
      "button",
      {
        type: "button",
        title: `Add ${name} (${key})`,
        "aria-label": `Add ${name}`,
        onclick: () => addAgent(store, team),
      },
      "+",
      glyph(team),
    );
  const remove = html(
    "button",
    { type: "button", title: "Remove the chosen agent (Delete)", onclick: () => removeChosen(store) },
    "Remove",
  );
  const building = [add("pursuers", "a pursuer", "+"), add("evaders", "an evader", "-"), remove];
  const element = html("div", { class: "buttons", role: "group", "aria-label": "Agents" }, ...building);
  return {
    element,
    update: () => {
      element.hidden = store.mode !== "build";
      remove.setAttribute("aria-disabled", String(store.selected === null));
    },
  };
}

/** Directions for the chosen agent, in the order west to east. */
function padButtons(store: Store): Control {
  const order = [8, 7, 4, 1, 0, 3, 2, 5, 6];
  const buttons = order.map((action) =>
    html(
      "button",
      {
        type: "button",
        "aria-label": ACTIONS[action],
        title: `The chosen agent: ${ACTIONS[action]}`,
        onclick: () => command(store, action),
      },
      ARROWS[action],
    ),
  );
  const element = html(
    "div",
    { class: "buttons pad", role: "group", "aria-label": "Move of the chosen agent" },
    ...buttons,
  );
  return {
    element,
    update: () => {
      element.hidden = store.mode === "build";
      const chosen = store.selected === null ? undefined : store.scene.next[store.selected];
      order.forEach((action, place) => {
        const button = buttons[place]!;
        button.hidden = action > 4 && !store.scene.diagonal;
        button.setAttribute("aria-disabled", String(store.selected === null || store.game.over));
        button.setAttribute("aria-pressed", String(chosen === action));
      });
    },
  };
}

/** Return the button that undoes changes, for the head of the page. */
export function undoButton(store: Store): HTMLButtonElement {
  const undo = html(
    "button",
    { type: "button", title: "Undo the last change (Ctrl+Z)", onclick: () => store.undo() },
    "Undo",
  );
  store.shownBy(() => undo.setAttribute("aria-disabled", String(!store.canUndo)));
  return undo;
}

/** Add an agent on a free cell near the middle, and choose it. */
export function addAgent(store: Store, team: Team): void {
  const now = store.game.scene();
  const cell = freeCell(now);
  if (!cell) return store.say("Every cell is taken.", true);
  if (now[team].length >= MOST_AGENTS) return store.say(`${team}: expected at most ${MOST_AGENTS}`, true);
  const agent = team === "pursuers" ? now.pursuers.length : nAgents(now);
  if (store.change(added(now, team, cell))) store.selected = agent;
}

/** Remove the chosen agent; a team keeps at least one. */
export function removeChosen(store: Store): void {
  const { selected } = store;
  if (selected === null) return store.say("Choose an agent to remove.", true);
  const scene = removed(store.game.scene(), selected);
  if (scene.pursuers.length && scene.evaders.length) store.change(scene);
  else store.say("A team needs at least one agent.", true);
}
