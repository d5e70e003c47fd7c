// A race of pursuers and evaders that evolves before your eyes. The same script is the worker that plays it.

import "./evolve.css";
import { loadEngine } from "../engine/engine.ts";
import type { Engine } from "../engine/engine.ts";
import { saveFile } from "../page/dialog.ts";
import { hasAddress, html, started } from "../page/dom.ts";
import { changeTheme } from "../page/theme.ts";
import { top } from "../page/top.ts";
import { legend } from "../board/legend.ts";
import { choiceOf, linkOf, settingsOf, whyNotPlayed, worldOf } from "./choice.ts";
import type { Choice } from "./choice.ts";
import { withCell } from "../playground/scene.ts";
import { controls } from "./controls.ts";
import type { Ask } from "./controls.ts";
import { readData, scheduleOf } from "./data.ts";
import type { EvolveData } from "./data.ts";
import { Lane } from "./lane.ts";
import { archiveOf, canSave } from "./save.ts";
import { startWorker, work } from "./worker.ts";

/** Milliseconds after the last stroke until a race goes on among new walls. */
const REST = 250;

class Page {
  readonly #data: EvolveData;
  readonly #engine: Engine;
  readonly lanes: Lane[] = [];
  readonly #room = html("div", { class: "lanes" });
  readonly #evolve = html("button", { type: "button", class: "evolve", onclick: () => this.#press() });
  readonly #progress = html("progress", { max: 1, value: 0, "aria-label": "Progress of the race" });
  readonly #status = html("p", { class: "small muted numbers", role: "status" });
  readonly #side = html("button", {
    type: "button", class: "side", title: "A second race of the same seed with another schedule", onclick: () => this.#sideBySide(),
  }, "Side by side");
  readonly #walls = html("button", {
    type: "button", "aria-pressed": "false", title: "Drag over the board to draw walls, and over walls to remove them",
    onclick: () => this.#toggleWalls(),
  }, "Draw walls");
  readonly #noWalls = html("button", { type: "button", onclick: () => this.#ask({ walls: [] }) }, "No walls");
  readonly #rest = html("button", { type: "button", onclick: () => this.#toggleBoards() });
  readonly #told = html("span", { class: "small muted", role: "status" });
  readonly #controls = controls((change, anew) => this.#ask(change, anew));
  readonly #save = html("button", { type: "button", onclick: () => void this.#saveRaces(), title: "An archive that matrixworld judge, explore and replay read" }, "Save");
  #pens: ((on: boolean) => void)[] = [];
  #choice: Choice;
  #due = 0;

  constructor(data: EvolveData, engine: Engine) {
    [this.#data, this.#engine, this.#choice] = [data, engine, choiceOf(data, location.hash)];
    const tools = html("div", { class: "doings", role: "group", "aria-label": "What can be done" },
      this.#side,
      html("button", { type: "button", class: "to-play", title: "Play an evader against the newest pursuers", onclick: () => this.lanes[0]!.takeOver() }, "Take over"),
      this.#walls, this.#noWalls,
      this.#rest, this.#save, this.#told);
    document.getElementById("page")!.replaceWith(
      top("Evolve a chase", "Triangles chase discs. Nobody has told either team how. Press Evolve, and both learn by trial and error, against each other."),
      html("main", {},
        html("div", { class: "start" }, this.#evolve, tools, html("div", { class: "progress" }, this.#progress, this.#status)),
        this.#controls.now, this.#room, this.#controls.anew,
        html("div", { class: "card below" }, legend(),
          html("p", { class: "small muted" }, "The page plays and learns with the engine of matrixworld, in this browser; nothing is sent."),
          html("p", { class: "small muted of-saving" }, "A saved race is an archive: ", html("code", {}, "matrixworld judge"), ", ", html("code", {}, "explore"),
            " and ", html("code", {}, "replay"), " read it. Python plays its matches again, and does not continue it."))),
      html("footer", { class: "muted small" }, `matrixworld ${data.version}`));
    this.#makeLanes();
    this.#nameRest();
  }

  #schedules(): string[] {
    return [this.#choice.schedule, ...(this.#choice.beside ? [this.#choice.beside] : [])];
  }

  #makeLanes(): void {
    for (const lane of this.lanes.splice(0)) lane.close();
    for (const schedule of this.#schedules()) {
      const lane = new Lane(this.#data, this.#engine, startWorker("evolve"), settingsOf(this.#data, this.#choice, schedule));
      lane.addEventListener("state", () => this.#tell());
      this.lanes.push(lane);
    }
    this.#pens = this.lanes.map((lane) => lane.newest.drawWalls(([row, col], wall) => this.#draw(row, col, wall)));
    this.#walls.ariaPressed = "false";
    this.#room.dataset["count"] = String(this.lanes.length);
    this.#room.replaceChildren(...this.lanes.map(({ element }) => element));
    this.#controls.show(this.#choice);
    this.#tell();
  }

  // ---- Races ------------------------------------------------------------------------------------

  #press(): void {
    if (this.lanes.some(({ state }) => state === "evolving")) this.lanes.forEach((lane) => lane.stop());
    else this.#start();
  }

  #start(): void {
    this.#told.textContent = "";
    for (const [number, schedule] of this.#schedules().entries()) {
      const lane = this.lanes[number]!;
      lane.settings = settingsOf(this.#data, this.#choice, schedule);
      lane.start();
    }
  }

  #sideBySide(): void {
    const other = this.#choice.schedule === "specialist-specialist" ? "generalist-generalist" : "specialist-specialist";
    this.#ask({ beside: this.#choice.beside ? null : other }, true);
  }

  /** Follow a control: at once, or by a new race. */
  readonly #ask: Ask = (change, anew = false) => {
    const lanes = this.#schedules().length;
    const waiting = this.lanes.every(({ state }) => state === "waiting");
    const asked = { ...this.#choice, ...change };
    const why = whyNotPlayed(asked, worldOf(this.#data));
    if (!why) this.#choice = asked;
    this.#controls.show(this.#choice);
    this.#told.textContent = why;
    if (why) return;
    if (hasAddress()) history.replaceState(null, "", `#${linkOf(this.#choice)}`); // the address is a link to this race
    if (this.#schedules().length !== lanes) this.#makeLanes();
    if (anew && !waiting) this.#start();
    else this.#schedules().forEach((schedule, number) => this.lanes[number]!.change(settingsOf(this.#data, this.#choice, schedule)));
  };

  /** Draw a wall or remove it; returns why not. */
  #draw(row: number, col: number, wall: boolean): string {
    const { rows, cols } = this.lanes[0]!.settings.world;
    const drawn = { ...this.#choice, walls: withCell(this.#choice.walls, row * cols + col, wall) };
    const why = whyNotPlayed(drawn, this.lanes[0]!.settings.world);
    if (why) return why;
    const { walls } = this.#choice = drawn;
    const flags = Uint8Array.from({ length: rows * cols }, (_, cell) => Number(walls.includes(cell)));
    for (const lane of this.lanes) lane.newest.show(flags);
    clearTimeout(this.#due);
    this.#due = setTimeout(() => this.#ask({ walls }), REST);
    return "";
  }

  #toggleWalls(): void {
    const on = this.#walls.ariaPressed !== "true";
    this.#walls.ariaPressed = String(on);
    for (const pen of this.#pens) pen(on);
  }

  // ---- What is shown ----------------------------------------------------------------------------

  #toggleBoards(): void {
    const runs = !this.lanes[0]!.newest.runs;
    for (const { newest, beginning } of this.lanes) newest.runs = beginning.runs = runs;
    this.#nameRest();
  }

  #nameRest(): void {
    this.#rest.textContent = this.lanes[0]!.newest.runs ? "Pause boards" : "Play boards";
  }

  #tell(): void {
    if (!this.lanes.length) return;
    const states = this.lanes.map(({ state }) => state);
    const evolving = states.includes("evolving");
    document.body.dataset["state"] = states.every((state) => state === "waiting") ? "waiting" : evolving ? "evolving" : "ended";
    this.#evolve.textContent = evolving ? "Stop" : states[0] === "waiting" ? "Evolve" : "Again";
    this.#side.ariaPressed = String(this.lanes.length > 1);
    this.#noWalls.hidden = !this.#choice.walls.length;
    this.#progress.value = Math.min(...this.lanes.map(({ done }) => done));
    const seconds = Math.max(...this.lanes.map((lane) => lane.seconds));
    const ended = states.every((state) => state === "ended");
    const { seed } = this.#choice;
    this.#status.textContent = evolving ? `Seed ${seed}: generation ${this.lanes.map((lane) => lane.newestGeneration).join(" and ")}`
      : ended ? `Seed ${seed}: the race took ${seconds.toFixed(1)} seconds.` : states.includes("stopped") ? "Stopped." : "";
  }

  async #saveRaces(): Promise<void> {
    const races = await Promise.all(this.lanes.map(async (lane) => ({ name: scheduleOf(lane.settings), race: await lane.saved() })));
    if (!races.every(({ race }) => canSave(race))) {
      this.#told.textContent = "Wait for the next generation, and save then.";
      return;
    }
    const name = `${races.map((each) => each.name).join("-and-")}-seed-${this.#choice.seed}.zip`;
    saveFile(name, archiveOf(races, this.#data) as BlobPart);
    this.#told.textContent = `Saved as ${name}.`;
  }
}

async function show(): Promise<void> {
  const page = new Page(readData(), await loadEngine());
  document.addEventListener("keydown", ({ key, target, ctrlKey, metaKey, altKey }) => {
    const busy = target instanceof HTMLInputElement || target instanceof HTMLSelectElement || document.querySelector("dialog[open]");
    if (key.toLowerCase() === "d" && !busy && !ctrlKey && !metaKey && !altKey) changeTheme();
  });
  window.addEventListener("hashchange", () => location.reload()); // another link
  Object.assign(window, { matrixworldEvolve: page }); // for tests, and for the curious
}

if (typeof document === "undefined") work();
else void started(show());
