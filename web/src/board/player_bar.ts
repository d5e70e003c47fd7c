// The buttons of a player: the same on every page.

import { html, svg } from "../page/dom.ts";
import { FITTING, Player, SPEEDS, WHOLE, playerKey } from "./player.ts";

const ICONS = {
  first: "M6 5v14M19 5 9 12l10 7z",
  back: "M17 5 7 12l10 7z",
  play: "M7 4.5 19 12 7 19.5z",
  pause: "M8 5v14M16 5v14",
  forward: "M7 5l10 7-10 7z",
  last: "M18 5v14M5 5l10 7-10 7z",
} as const;

export type Icon = keyof typeof ICONS;

/** Return an icon that has the colour of the text around it. */
export function icon(name: Icon): SVGSVGElement {
  return svg(
    "svg",
    { viewBox: "0 0 24 24", "aria-hidden": "true", class: "icon" },
    svg("path", { d: ICONS[name] }),
  );
}

function button(name: Icon, label: string, keys: string, act: () => void): HTMLButtonElement {
  return html(
    "button",
    {
      type: "button",
      class: "player-button",
      "aria-label": label,
      title: `${label} (${keys})`,
      onclick: act,
    },
    icon(name),
  );
}

/**
 * Return a bar with the buttons, the position and the speed of a player.
 *
 * Its keys work while the focus is in the bar. A page that gives them to a larger part calls
 * `playerKey` there.
 */
export function playerBar(player: Player): HTMLElement {
  const play = button("play", "Play", "Space", () => player.toggle());
  const scrub = html("input", {
    type: "range",
    class: "player-scrub",
    min: 0,
    step: 1,
    "aria-label": "Step",
    oninput: () => {
      player.pause();
      player.jump(Number(scrub.value));
    },
  });
  const marks = html("div", { class: "captures", "aria-hidden": "true", title: "Captures" });
  const ticks = html("div", { class: "losses", "aria-hidden": "true" });
  const speed = html(
    "select",
    {
      class: "player-speed",
      "aria-label": "Speed",
      title: `Steps a second, or the whole in ${WHOLE} s (+ and -)`,
      onchange: () => (player.speed = Number(speed.value)),
    },
    html("option", { value: FITTING }, `in ${WHOLE} s`),
    ...SPEEDS.map((each) => html("option", { value: each }, `${each} / s`)),
  );
  const count = html("output", { class: "player-count" });
  const bar = html(
    "div",
    { class: "player", role: "group", "aria-label": "Player" },
    button("first", "First step", "Home", () => player.move(-player.length)),
    button("back", "Step back", "←", () => player.move(-1)),
    play,
    button("forward", "Step forward", "→", () => player.move(1)),
    button("last", "Last step", "End", () => player.move(player.length)),
    html("div", { class: "scrub" }, marks, ticks, scrub),
    count,
    speed,
  );
  const at = (step: number, attributes = {}): HTMLElement => {
    const tick = html("i", attributes);
    tick.style.left = `${(100 * step) / Math.max(1, player.length)}%`;
    return tick;
  };
  const mark = (): void => {
    marks.replaceChildren(...player.marks.map((step) => at(step)));
    ticks.replaceChildren(
      ...player.ticks.map(({ step, kind, size, text }) => {
        const tick = at(step, { class: kind, title: `Step ${step}: ${text}` });
        tick.style.height = `${100 * size}%`;
        return tick;
      }),
    );
  };
  const update = (): void => {
    play.replaceChildren(icon(player.playing ? "pause" : "play"));
    play.ariaLabel = player.playing ? "Pause" : "Play";
    play.title = `${play.ariaLabel} (Space)`;
    scrub.max = String(player.length);
    scrub.value = String(player.step);
    scrub.ariaValueText = `step ${player.step} of ${player.length}`;
    // As wide as the longest number, so that nothing moves while it counts.
    count.textContent = `${player.step} / ${player.length}`;
    count.style.minWidth = `${2 * String(player.length).length + 3}ch`;
    speed.value = String(player.speed);
  };
  player.addEventListener("step", update);
  player.addEventListener("state", update);
  player.addEventListener("state", mark);
  bar.addEventListener("keydown", (event) => {
    // A list keeps its own keys, and a button Space, which clicks it.
    const own = event.target instanceof HTMLSelectElement || (event.key === " " && event.target !== scrub);
    if (!own && playerKey(player, event)) event.preventDefault();
  });
  update();
  return bar;
}
