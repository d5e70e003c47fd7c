// The settings of the run that differ from the defaults.

import { html } from "../page/dom.ts";
import type { Run } from "./data.ts";
import { card } from "./panel.ts";
import type { Panel } from "./panel.ts";

export function settingsPanel({ settings, schedule, seed }: Run): Panel {
  const rows = settings.map(({ name, value, help }) => html("tr", {},
    html("th", { scope: "row" }, `--${name.replaceAll("_", "-")}`), html("td", { class: "numbers" }, value), html("td", { class: "muted" }, help)));
  const table = html("table", { class: "small" }, html("caption", { class: "heard" }, "Settings other than the default"), ...rows);
  const element = card("Settings", `${schedule}, seed ${seed}; all others are the defaults of matrixworld evolve.`,
    rows.length ? html("div", { class: "wide-table" }, table) : null);
  element.classList.add("settings");
  return { element };
}
