// The settings of the run, those that differ from the defaults first.

import { html } from "../page/dom.ts";
import type { Run, Setting } from "./data.ts";
import { card } from "./panel.ts";
import type { Panel } from "./panel.ts";

export function settingsPanel(run: Run): Panel {
  const changed = run.settings.filter((setting) => setting.changed);
  const others = run.settings.filter((setting) => !setting.changed);
  const element = card("Settings", `${run.schedule}, seed ${run.seed}. Every setting is an option of matrixworld evolve.`,
    changed.length ? table(changed, "other than the default") : html("p", { class: "small" }, "All settings are the defaults."),
    html("details", { class: "small" }, html("summary", {}, `${others.length} settings with their defaults`), table(others, "defaults")));
  element.classList.add("settings");
  return { element };
}

function table(settings: readonly Setting[], caption: string): HTMLElement {
  return html("div", { class: "wide-table" }, html("table", { class: "small" }, html("caption", { class: "heard" }, `Settings: ${caption}`),
    ...settings.map(({ name, value, help }) => html("tr", {},
      html("th", { scope: "row" }, `--${name.replaceAll("_", "-")}`), html("td", { class: "numbers" }, value), html("td", { class: "muted" }, help)))));
}
