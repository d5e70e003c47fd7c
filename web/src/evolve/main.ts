// A race of pursuers and evaders that evolves before your eyes. The same script is the worker that plays it.

import "./evolve.css";
import { loadEngine } from "../engine/engine.ts";
import type { Engine } from "../engine/engine.ts";
import type { Team } from "../engine/teams.ts";
import { copyLink, readOnly, saveFile } from "../page/dialog.ts";
import { hasAddress, html, started } from "../page/dom.ts";
import { changeTheme } from "../page/theme.ts";
import { top } from "../page/top.ts";
import { legend } from "../board/legend.ts";
import { withCell } from "../playground/scene.ts";
import { fairSeed } from "../playground/played.ts";
import { GENERATIONS, MOST_GENERATIONS, settingsOf, whyNotPlayed } from "./choice.ts";
import type { Choice } from "./choice.ts";
import { controls } from "./controls.ts";
import type { Ask } from "./controls.ts";
import { readData, scheduleOf } from "./data.ts";
import type { EvolveData } from "./data.ts";
import { Duel } from "./duel.ts";
import { Lane } from "./lane.ts";
import { percent } from "./outcome.ts";
import { archiveOf, canSave } from "./save.ts";
import type { RaceSettings } from "./settings.ts";
import { cardOf, filmOf } from "./share.ts";
import type { Shown } from "./share.ts";
import { found, keep, kept } from "./shelf.ts";
import { LONGEST, addressOf, lastChoice, storyOf } from "./story.ts";
import type { Dare, Story } from "./story.ts";
import { work } from "./worker.ts";

/** Milliseconds after the last stroke until a race goes on among new walls. */
const REST = 250;

const button = (text: string, title: string, onclick: () => void, style = ""): HTMLButtonElement =>
  html("button", { type: "button", title: title || null, class: style || null, onclick }, text);

class Page {
  readonly #data: EvolveData;
  readonly #engine: Engine;
  readonly lanes: Lane[] = [];
  readonly #room = html("div", { class: "lanes" });
  /** What can be done with a race: below the boards of one, above those of two. */
  readonly #doings = html("div", { class: "of-race" });
  readonly #evolve = button("Evolve", "", () => this.#press(), "evolve");
  readonly #progress = html("progress", { max: 1, value: 0, "aria-label": "Progress of the race" });
  readonly #status = html("p", { class: "small muted numbers", role: "status" });
  readonly #walls = button(
    "Draw walls",
    "Drag over the board to draw walls, and over walls to remove them",
    () => this.#toggleWalls(),
  );
  readonly #noWalls = button("Usual walls", "Each match draws its walls anew", () =>
    this.#ask({ walls: null }),
  );
  readonly #rest = button("Pause", "", () => this.#toggleBoards());
  readonly #again = button("Again", "Another race, with other luck", () =>
    this.#ask({ seed: this.#choice.seed + 1 }, true),
  );
  readonly #more = button(`${GENERATIONS} more generations`, "", () =>
    this.#ask({ generations: this.#choice.generations + GENERATIONS }),
  );
  readonly #field = readOnly("Link to this race");
  readonly #told = html("span", { class: "told small", role: "status" });
  readonly #shelf = html("nav", { class: "shelf small", "aria-label": "Races of this visit", hidden: true });
  readonly #controls: ReturnType<typeof controls>;
  readonly #duel: Duel;
  #pens: ((on: boolean) => void)[] = [];
  /** The story of the race: its choice, the changes on its way, and the choice that it has come to. */
  #first: Choice;
  #changes: Partial<Choice>[] = [];
  #choice: Choice;
  #due = 0;
  /** Whether a race is played again, with changes that are still to come. */
  #replays = false;
  #kept = "";

  constructor(data: EvolveData, engine: Engine) {
    this.#data = data;
    this.#engine = engine;
    const { story, dare, problem } = storyOf(data, hasAddress() ? location.hash : "");
    this.#first = story.choice;
    this.#changes = story.changes.map(({ change }) => change);
    this.#choice = lastChoice(story);
    this.#controls = controls(data, (change, anew) => this.#ask(change, anew));
    this.#duel = new Duel(engine, (of) => (hasAddress() ? this.#link(of) : null));
    this.#doings.append(
      html(
        "div",
        { class: "ending", role: "group", "aria-label": "What to do now" },
        button(
          "Can you escape them?",
          "Be an evader, against the best pursuers",
          () => this.#play("evader"),
          "primary largest",
        ),
        button("Can you catch them?", "Be a pursuer, against the best evaders", () => this.#play("pursuer")),
        this.#more,
        this.#again,
      ),
      html(
        "div",
        { class: "doings", role: "group", "aria-label": "What can be done" },
        this.#rest,
        this.#walls,
        this.#noWalls,
        hasAddress() &&
          button("Link", "An address at which this race evolves again, on any computer", () => this.#copy()),
        button("GIF", "Both boards as a film", () => this.#saveFilm()),
        button("Picture", "Both boards and what came out", () => void this.#saveCard()),
        button(
          "Save",
          "An archive that matrixworld judge, explore and replay read",
          () => void this.#saveRaces(),
        ),
        this.#field,
        this.#told,
      ),
    );
    document
      .getElementById("page")!
      .replaceWith(
        top(
          "Evolve a chase",
          "Triangles chase discs. Nobody has told either team how. Press Evolve, and both learn by trial and error, against each other.",
        ),
        html(
          "main",
          {},
          html(
            "div",
            { class: "start" },
            this.#evolve,
            html("div", { class: "progress" }, this.#progress, this.#status),
          ),
          this.#room,
          this.#shelf,
          this.#controls.main,
          this.#controls.more,
          html(
            "div",
            { class: "card below" },
            legend(),
            html(
              "p",
              { class: "small muted" },
              "The page plays and learns with the engine of matrixworld, in this browser; nothing is sent.",
            ),
            html(
              "p",
              { class: "small muted of-saving" },
              "A saved race is an archive: ",
              html("code", {}, "matrixworld judge"),
              ", ",
              html("code", {}, "explore"),
              " and ",
              html("code", {}, "replay"),
              " read it. Python plays its matches again, and does not continue it.",
            ),
          ),
        ),
        html("footer", { class: "muted small" }, `matrixworld ${data.version}`),
        this.#duel.dialog,
      );
    this.#makeLanes();
    this.#told.textContent = problem;
    this.#open(story, dare);
  }

  /** Show what an address holds: a race that is kept, one that is played again, a game. */
  #open(story: Story, dare: Dare | null): void {
    const races = story.watched.length ? found(addressOf(this.#data, story)) : null;
    if (races?.length === this.lanes.length) {
      this.#kept = addressOf(this.#data, story);
      for (const [number, lane] of this.lanes.entries()) {
        lane.restore(
          this.#settings(number),
          races[number]!,
          story.watched[number]!,
          story.changes.map(({ at }) => at[number]!),
        );
      }
    }
    const replay = (): void => {
      if (story.watched.length && !races) this.#replay(story);
    };
    if (!dare) return replay();
    const settings = this.#settings(0);
    const policies = {
      pursuer: this.lanes[0]!.run.playing("pursuer", dare.pursuer),
      evader: this.lanes[0]!.run.playing("evader", dare.evader),
    };
    const team = dare.seat < settings.world.n_pursuers ? "pursuer" : "evader";
    const players = [{ name: `the best ${team}s`, text: "", policy: () => policies[team] }];
    this.#duel.play(
      team,
      { world: settings.world, policies, players, seed: settings.seed, rate: dare.rate, friend: dare },
      dare,
    );
    this.#duel.dialog.addEventListener("close", replay, { once: true });
  }

  #schedules(choice = this.#choice): string[] {
    return [choice.schedule, ...(choice.beside ? [choice.beside] : [])];
  }

  #settings(lane: number, choice = this.#choice): RaceSettings {
    return settingsOf(this.#data, choice, this.#schedules(choice)[lane]);
  }

  #makeLanes(): void {
    for (const lane of this.lanes.splice(0)) lane.close();
    for (const [number] of this.#schedules().entries()) {
      const lane = new Lane(this.#data, this.#engine, "evolve", this.#settings(number));
      lane.addEventListener("state", () => this.#tell());
      this.lanes.push(lane);
    }
    this.#pens = this.lanes.map((lane) =>
      lane.after.drawWalls(([row, col], wall) => this.#draw(row, col, wall)),
    );
    this.#walls.ariaPressed = "false";
    this.#room.dataset["count"] = String(this.lanes.length);
    this.#room.replaceChildren(...this.lanes.map(({ element }) => element));
    if (this.lanes.length > 1) this.#room.before(this.#doings);
    else this.lanes[0]!.boards.after(this.#doings);
    this.#controls.show(this.#choice);
    this.#tell();
  }

  // ---- Races ------------------------------------------------------------------------------------

  #press(): void {
    const states = this.lanes.map(({ state }) => state);
    if (states.includes("evolving")) this.lanes.forEach((lane) => lane.stop());
    else if (states.includes("stopped")) this.lanes.forEach((lane) => lane.state === "stopped" && lane.go());
    else this.#start();
  }

  #start(): void {
    this.#told.textContent = "";
    this.#kept = "";
    for (const [number, lane] of this.lanes.entries()) lane.start(this.#settings(number));
  }

  /** Play a story again, and let it rest where it was watched to. */
  #replay({ choice, changes, watched }: Story): void {
    this.#replays = true;
    let now = choice;
    const choices = changes.map(({ change }) => (now = { ...now, ...change }));
    for (const [number, lane] of this.lanes.entries()) {
      const plan = changes.map(({ at }, place) => ({
        at: at[number]!,
        settings: this.#settings(number, choices[place]),
      }));
      lane.start(this.#settings(number, choice), plan, watched[number]);
    }
  }

  get #story(): Story {
    const waiting = this.lanes.some(({ state }) => state === "waiting");
    return {
      choice: this.#first,
      changes: this.#changes.map((change, place) => ({
        change,
        at: this.lanes.map(({ changed, epochs }) => changed[place] ?? epochs),
      })),
      watched: waiting
        ? []
        : this.lanes.map(({ state, epochs }) => (state === "evolving" ? Infinity : epochs)),
    };
  }

  /** Follow a control: at once, or by a new race. */
  readonly #ask: Ask = (change, anew = false) => {
    const lanes = this.#schedules().length;
    const waiting = this.lanes.every(({ state }) => state === "waiting");
    if (this.#replays && !anew) {
      // from here on it is another race than the one of the link
      this.#changes = this.#changes.slice(0, Math.min(...this.lanes.map(({ changed }) => changed.length)));
      this.#choice = this.#changes.reduce<Choice>((last, each) => ({ ...last, ...each }), this.#first);
    }
    this.#replays = false;
    const asked = { ...this.#choice, ...change };
    const why =
      asked.generations > MOST_GENERATIONS
        ? `A race has at most ${MOST_GENERATIONS} generations here.`
        : whyNotPlayed(asked, this.#data.worlds[asked.world]!);
    this.#controls.show(why ? this.#choice : asked);
    this.#told.textContent = why;
    if (why) return;
    this.#choice = asked;
    const story = this.#story;
    if (anew || waiting) {
      this.#first = { ...asked, generations: GENERATIONS };
      this.#changes = [];
      this.#choice = this.#first;
      if (!waiting && hasAddress()) history.pushState(null, "", "#"); // Back leads to the race before
      if (this.#schedules().length !== lanes) this.#makeLanes();
      if (!waiting) return this.#start();
    } else {
      this.#changes.push(change);
    }
    if (this.lanes.some((lane) => lane.kept)) {
      this.#kept = "";
      this.#replay({
        ...story,
        changes: [...story.changes, { change, at: story.watched }],
        watched: this.lanes.map(() => Infinity),
      });
    } else {
      for (const [number, lane] of this.lanes.entries()) lane.change(this.#settings(number));
    }
  };

  /** Draw a wall or remove it; returns why not. */
  #draw(row: number, col: number, wall: boolean): string {
    const {
      settings: {
        world: { rows, cols },
      },
      after,
    } = this.lanes[0]!;
    const shown = Array.from({ length: rows * cols }, (_, cell) => cell).filter(
      (cell) => after.recording!.obstacles[cell],
    );
    const drawn = { ...this.#choice, walls: withCell(this.#choice.walls ?? shown, row * cols + col, wall) };
    const why = whyNotPlayed(drawn, this.#data.worlds[drawn.world]!);
    if (why) return why;
    this.#choice = drawn;
    const { walls } = drawn;
    const flags = Uint8Array.from({ length: rows * cols }, (_, cell) => Number(walls.includes(cell)));
    for (const lane of this.lanes) lane.after.showWalls(flags);
    clearTimeout(this.#due);
    this.#due = setTimeout(() => this.#ask({ walls }), REST);
    return "";
  }

  #toggleWalls(): void {
    const on = this.#walls.ariaPressed !== "true";
    this.#walls.ariaPressed = String(on);
    for (const pen of this.#pens) pen(on);
  }

  // ---- Games ------------------------------------------------------------------------------------

  /** Let a person play against the champions that have just evolved. */
  #play(team: Team): void {
    const { run, champions, outcome } = this.lanes[0]!;
    const policies = {
      pursuer: run.playing("pursuer", champions.pursuer),
      evader: run.playing("evader", champions.evader),
    };
    const players = Array.from({ length: (run.best?.[team] ?? run.newest) + 1 }, (_, generation) => ({
      name: `generation ${generation}`,
      text: "",
      policy: () => run.policy(team, generation),
    }));
    this.#duel.play(
      team,
      {
        world: run.world,
        policies,
        players,
        seed: this.#choice.seed,
        rate: Math.round(100 * (outcome?.rate ?? 0)),
        friend: null,
      },
      {
        seed: String(fairSeed(this.#engine, run.world, team === "evader" ? run.world.n_pursuers : 0)),
        episode: 0,
      },
    );
  }

  // ---- What is shown ----------------------------------------------------------------------------

  #toggleBoards(): void {
    const runs = !this.lanes[0]!.chases.runs;
    for (const { chases } of this.lanes) chases.runs = runs;
    this.#tell();
  }

  /** The state of all races together. */
  #state(): Lane["state"] {
    const states = this.lanes.map(({ state }) => state);
    if (states.every((each) => each === "waiting")) return "waiting";
    if (states.includes("evolving")) return "evolving";
    return states.includes("stopped") ? "stopped" : "ended";
  }

  #tell(): void {
    if (!this.lanes.length) return;
    const state = this.#state();
    document.body.dataset["state"] = state;
    this.#evolve.textContent = { waiting: "Evolve", evolving: "Stop", stopped: "Go on", ended: "" }[state];
    this.#evolve.hidden = state === "ended";
    this.#rest.textContent = this.lanes[0]!.chases.runs ? "Pause" : "Play";
    this.#noWalls.hidden = !this.#choice.walls;
    this.#again.textContent = `Again, with seed ${this.#choice.seed + 1}`;
    this.#progress.value = Math.min(...this.lanes.map(({ done }) => done));
    const seconds = Math.max(...this.lanes.map((lane) => lane.seconds));
    const { seed } = this.#choice;
    const generations = this.lanes.map((lane) => lane.newestGeneration).join(" and ");
    this.#status.textContent = {
      waiting: "",
      evolving: `Seed ${seed}: generation ${generations}`,
      stopped: `Seed ${seed}: stopped at generation ${generations}.`,
      ended: `Seed ${seed}: ${generations} generations in ${seconds.toFixed(1)} seconds.`,
    }[state];
    const address = addressOf(this.#data, this.#story);
    this.#field.hidden = this.#field.value !== this.#link();
    // Browsers allow few changes of the address in a second.
    if (hasAddress() && address.length <= LONGEST && location.hash.slice(1) !== address) {
      history.replaceState(null, "", `#${address}`);
    }
    if (state === "ended" || state === "stopped") this.#replays = false;
    if (state === "ended" && this.lanes.every(({ outcome }) => outcome)) void this.#keep(address);
    this.#showShelf();
  }

  /** Keep a race that has ended. */
  async #keep(address: string): Promise<void> {
    if (this.#kept === address || !hasAddress()) return;
    this.#kept = address;
    const title = `${this.#choice.world}, seed ${this.#choice.seed}: ${percent(this.lanes[0]!.outcome!.rate)} are caught`;
    const lanes = await Promise.all(this.lanes.map((lane) => lane.keep()));
    if (this.#kept !== address || !lanes.every(canSave)) return;
    keep({ address, title }, lanes);
    this.#showShelf();
  }

  #showShelf(): void {
    const others = hasAddress() ? kept().filter(({ address }) => address !== location.hash.slice(1)) : [];
    const shown = others.map(({ address }) => address).join(" ");
    if (this.#shelf.dataset["shown"] === shown) return; // a link that has the focus keeps it
    this.#shelf.dataset["shown"] = shown;
    this.#shelf.hidden = !others.length;
    this.#shelf.replaceChildren(
      "Races before: ",
      ...others.map(({ address, title }) => html("a", { href: `#${address}` }, title)),
    );
  }

  // ---- To take away -----------------------------------------------------------------------------

  /** Return the link to the race, or to a game against its champions; null if it is too long. */
  #link(dare?: Dare): string | null {
    const address = addressOf(this.#data, this.#story, dare);
    return address.length > LONGEST ? null : `${location.href.split("#")[0]}#${address}`;
  }

  #copy(): void {
    const link = this.#link();
    if (link) copyLink(this.#field, link);
    else this.#told.textContent = "This race has too many changes for a link: save it.";
  }

  /** The link as a picture may show it: without the folders of a person's own disk. */
  get #public(): string {
    const link = this.#link() ?? location.href;
    return location.protocol === "file:" ? link.slice(link.split("#")[0]!.lastIndexOf("/") + 1) : link;
  }

  get #shown(): Shown[] {
    const { before, after } = this.lanes[0]!;
    return [before, after]
      .filter(({ recording }) => recording)
      .map((each) => ({ title: each.title.split(":")[0]!, recording: each.recording! }));
  }

  #saveFilm(): void {
    saveFile(`chase-seed-${this.#choice.seed}.gif`, filmOf(this.#shown));
  }

  async #saveCard(): Promise<void> {
    const { outcome, settings } = this.lanes[0]!;
    const lines = [
      ...(outcome?.sentence.split(/(?<=\.) /) ?? [`Generation ${this.lanes[0]!.newestGeneration}`]),
      `${this.#choice.world}, seed ${settings.seed}, ${settings.schedule.generations} generations of pursuers and evaders that learn against each other`,
      this.#public,
    ];
    saveFile(`chase-seed-${this.#choice.seed}.png`, await cardOf(this.#shown, lines));
  }

  async #saveRaces(): Promise<void> {
    const races = await Promise.all(
      this.lanes.map(async (lane) => ({ name: scheduleOf(lane.settings), race: await lane.saved() })),
    );
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
    const busy =
      target instanceof HTMLInputElement ||
      target instanceof HTMLSelectElement ||
      document.querySelector("dialog[open]");
    if (busy || ctrlKey || metaKey || altKey) return;
    if (key.toLowerCase() === "d") changeTheme();
    else if (key.toLowerCase() === "a") page.lanes[0]!.askNext();
  });
  window.addEventListener("hashchange", () => location.reload()); // another race
  Object.assign(window, { matrixworldEvolve: page }); // for tests, and for the curious
}

if (typeof document === "undefined") work(globalThis as unknown as Parameters<typeof work>[0]);
else void started(show());
