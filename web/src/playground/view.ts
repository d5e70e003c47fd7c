// A match that a person plays, or watches: the board, what can be pressed, and what came out.

import { Board, stillMotion } from "../board/board.ts";
import { Player, playerKey } from "../board/player.ts";
import { playerBar } from "../board/player_bar.ts";
import { cellOf } from "../board/recording.ts";
import type { Engine, Solution } from "../engine/engine.ts";
import { whyNotSolved } from "../engine/solution.ts";
import type { TurnGame } from "../engine/solution.ts";
import { otherOf } from "../engine/teams.ts";
import type { WorldConfig } from "../engine/types.ts";
import { wordsOf } from "../explorer/words.ts";
import { copyLink, readOnly, saveFile } from "../page/dialog.ts";
import { hasAddress, html, select } from "../page/dom.ts";
import { agentName } from "../page/names.ts";
import {
  lossText,
  lossesOf,
  perfectText,
  scoreOf,
  solved,
  ticksOf,
  worstText,
  worthText,
} from "../page/solved.ts";
import type { Loss } from "../page/solved.ts";
import { actionOf, bearing, listenToPointer, pad } from "./controls.ts";
import { episodeFile } from "./file.ts";
import type { Live } from "../board/live.ts";
import { isDone, liveOf, resultOf, teamOf } from "./played.ts";
import type { Played } from "./played.ts";

/** Steps a second that can be chosen; 0 waits for each move. */
const PACES = [0, 1, 2, 4, 8] as const;

/** A match to play. */
export interface Game {
  readonly played: Played;
  readonly title: string;
  /** What the opponents do, told at the start. */
  readonly about?: string;
  /** What is shown at the end, and what plays it again. */
  ending(live: Live, played: Played): readonly (Node | string)[];
  again(): void;
  /** The link to a played match; null where the page has no address for it. */
  link(played: Played): string | null;
  /** What the link is for. */
  readonly linkName?: string;
}

export class PlayView {
  readonly element: HTMLElement;
  readonly player = new Player(0, { speed: 4, still: stillMotion() });
  readonly #engine: Engine;
  readonly #board: Board;
  readonly #canvas = html("canvas", { tabindex: 0, "aria-describedby": "play-keys" });
  readonly #title = html("h2");
  readonly #told = html("p", { class: "play-told", role: "status" });
  readonly #pad = pad((action) => this.act(action));
  readonly #pace = select(
    PACES.map((each) => [each, each ? `${each} / s` : "step by step"]),
    () => this.#rest(),
  );
  readonly #fog = html("input", { type: "checkbox", onchange: () => this.#look() });
  readonly #best = html("input", { type: "checkbox", onchange: () => this.#tell() });
  /** Shown where the world can be solved. */
  readonly #bestChoice = html("label", { class: "play-choice" }, this.#best, "Best move");
  readonly #keys = html("p", { class: "small muted play-keys", id: "play-keys" });
  readonly #ending = html("section", {
    class: "play-ending",
    tabindex: -1,
    "aria-labelledby": "play-headline",
  });
  readonly #bar = playerBar(this.player);
  #game: Game | null = null;
  #live: Live | null = null;
  #moves: number[] = [];
  #seat: number | null = null;
  #solution: Solution | null = null;
  #losses: readonly Loss[] = [];
  #held = 0;
  #clock = 0;

  constructor(engine: Engine) {
    this.#engine = engine;
    this.#board = new Board(this.#canvas, { numbers: false });
    this.#canvas.setAttribute("role", "application");
    listenToPointer(
      this.#board,
      () => {
        const cell =
          this.#seat !== null && this.#live && cellOf(this.#live.recording.moments.at(-1)!, this.#seat);
        return cell ? { cell, diagonal: this.#live!.config.diagonal } : null;
      },
      (action) => this.act(action),
    );
    this.player.addEventListener(
      "frame",
      () => this.#live && this.#board.show(this.#live.recording, this.player.time),
    );
    this.player.addEventListener("step", () => this.#tell());
    this.element = html(
      "div",
      { class: "play" },
      html("header", { class: "play-head" }, this.#title, this.#told),
      html("div", { class: "play-stage" }, this.#canvas),
      html(
        "div",
        { class: "play-side" },
        this.#ending,
        this.#pad.element,
        html("label", { class: "play-choice", title: "Steps a second" }, "Pace ", this.#pace),
        html(
          "label",
          { class: "play-choice" },
          this.#fog,
          html("span", {}, "Fog", html("span", { class: "at-length" }, ": see only what it sees")),
        ),
        this.#bestChoice,
        this.#keys,
      ),
      this.#bar,
    );
  }

  /** What was played so far; null while a match is watched only. */
  get played(): Played | null {
    return this.#game && { ...this.#game.played, moves: this.#moves };
  }

  get live(): Live | null {
    return this.#live;
  }

  /** Let a person play from where the moves of a match end. */
  play(game: Game): void {
    this.#show(liveOf(this.#engine, game.played), game.played.seat, game.title);
    this.#game = game;
    this.#moves = [...game.played.moves];
    this.#held = 0;
    this.element.dataset["state"] = "playing";
    this.#canvas.focus({ preventScroll: true });
    if (isDone(this.#live!, game.played.seat)) this.#finish();
  }

  /** Show a match from its start; `seat` is the agent that a person has moved. */
  watch(live: Live, seat: number | null, title: string): void {
    this.#game = null;
    this.#show(live, seat, title);
    this.#watch();
  }

  /** Stop the clock: the match is left. */
  stop(): void {
    this.#rest();
    this.player.pause();
    this.#game = null;
  }

  /** Make a move; at a speed, the move is repeated until there is another one. */
  act(action: number): void {
    const game = this.#game;
    const live = this.#live;
    if (!game || !live || this.element.dataset["state"] !== "playing") return;
    this.#held = action;
    const pace = Number(this.#pace.value);
    if (this.#clock) return;
    this.#step();
    if (pace && this.element.dataset["state"] === "playing") {
      this.#clock = setInterval(() => this.#step(), 1000 / pace);
    }
  }

  /** Listen to keys; return whether one was done. */
  key(event: KeyboardEvent): boolean {
    const { target, key } = event;
    const own =
      target instanceof HTMLSelectElement ||
      (target instanceof HTMLInputElement && (target.type === "text" || key === " "));
    if (own || (target instanceof HTMLButtonElement && (key === " " || key === "Enter")) || !this.#live) {
      return false;
    }
    if (this.element.dataset["state"] !== "playing") return playerKey(this.player, event);
    const action = actionOf(event, this.#live.config.diagonal);
    if (action !== undefined) this.act(action);
    return action !== undefined;
  }

  #show(live: Live, seat: number | null, title: string): void {
    this.#rest();
    this.player.pause();
    this.#live = live;
    this.#seat = seat;
    this.#title.textContent = title;
    this.#canvas.ariaLabel = `Board, ${live.config.rows} by ${live.config.cols} cells`;
    this.#pad.show(live.config.diagonal);
    this.#keys.replaceChildren(
      html(
        "span",
        { class: "at-length" },
        `W A S D or the arrow keys move, Space stays${live.config.diagonal ? "; Q E Z C and the numeric keypad move diagonally" : ""}. `,
      ),
      "On the board: swipe, or tap where to go.",
    );
    this.#solve(live);
    this.#ending.replaceChildren();
    this.player.length = live.length;
    this.player.jump(live.length);
    this.#tell();
  }

  #look(): void {
    this.#board.look = {
      you: this.#seat,
      fog: this.#fog.checked,
      viewers: this.#seat === null ? [] : [this.#seat],
      plan: this.#plan(),
    };
  }

  /** Solve the world of a match, for the best moves and for what its teams lose. */
  #solve(live: Live): void {
    this.#solution = null;
    this.#losses = this.player.ticks = [];
    this.#bestChoice.hidden = this.#best.disabled = Boolean(whyNotSolved(live.config));
    void solved(this.#engine, live.config, scoreOf(live.config)).then((solution) => {
      if (this.#live !== live) return;
      this.#solution = solution;
      this.#judge();
      this.#tell();
    });
  }

  /** Mark the steps in which teams lost value, when the match is over. */
  #judge(): void {
    const live = this.#live!;
    const solution = this.#solution;
    if (!solution || this.element.dataset["state"] === "playing") return;
    const world = this.#engine.world(live.config);
    world.reset(live.start);
    this.#losses = lossesOf(solution, world, live.actions);
    world.free();
    this.player.ticks = ticksOf(this.#losses);
  }

  /** Perfect play of the next step, while a person plays and wants to know. */
  get #perfect(): TurnGame | null {
    const shown = this.#best.checked && this.#game && this.element.dataset["state"] === "playing";
    return (shown && this.#solution && this.#live!.game(this.#solution)) || null;
  }

  /** The best move as an arrow: the most probable one, where perfect play mixes. */
  #plan(): number[] | null {
    const seat = this.#seat;
    const shares = this.#seat !== null && this.#perfect?.marginal(this.#seat);
    return seat !== null && shares
      ? Object.assign(Array<number>(seat).fill(0), { [seat]: shares.indexOf(Math.max(...shares)) })
      : null;
  }

  #rest(): void {
    clearInterval(this.#clock);
    this.#clock = 0;
    // At a speed, a sentence for each step would not be heard to its end.
    this.#told.ariaLive = Number(this.#pace.value) ? "off" : "polite";
  }

  #step(): void {
    const { policies, seat } = this.#game!.played;
    const live = this.#live!;
    live.step(policies, seat, this.#held);
    this.#moves.push(this.#held);
    this.player.length = live.length;
    this.player.glide = Math.min(0.22, 0.9 / (Number(this.#pace.value) || 4));
    this.player.move(live.length - this.player.step);
    if (isDone(live, seat)) this.#finish();
  }

  #finish(): void {
    this.#rest();
    const game = this.#game!;
    const live = this.#live!;
    const played = this.played!;
    const link = hasAddress() ? game.link(played) : null;
    const name = `${agentName(played.seat, live.config.n_pursuers)}-${live.length}-steps.npz`;
    const save = (): void => saveFile(name, episodeFile(this.#engine, live, played.seat) as BlobPart);
    const field = readOnly("Link to this match");
    field.hidden = true;
    this.#ending.replaceChildren(
      html("h3", { id: "play-headline" }, headline(live, played.seat)),
      ...game.ending(live, played),
      html(
        "div",
        { class: "play-buttons" },
        html("button", { type: "button", class: "primary", onclick: () => game.again() }, "Again"),
        html("button", { type: "button", onclick: () => this.#watch() }, "Watch it"),
        html("button", { type: "button", onclick: save }, "Save"),
        link &&
          html("button", { type: "button", onclick: () => copyLink(field, link) }, game.linkName ?? "Link"),
      ),
      field,
    );
    this.element.dataset["state"] = "ended";
    this.player.jump(live.length); // what is said of the last step stands beside the result
    this.#judge();
    const own = this.#losses.filter(({ team }) => team === teamOf(live.config, played.seat));
    if (own.length) this.#ending.children[0]!.after(html("p", { class: "small muted" }, worstText(own)));
    this.#ending.focus({ preventScroll: true });
    this.#ending.scrollIntoView({ block: "nearest" });
  }

  #watch(): void {
    this.element.dataset["state"] = "watched";
    this.player.length = this.#live!.length;
    this.player.jump(0);
    if (!stillMotion()) this.player.play();
  }

  #tell(): void {
    const live = this.#live;
    const seat = this.#seat;
    const { step } = this.player;
    if (!live || step > live.length) return;
    const about = wordsOf(live, live.recording, step).filter(
      ({ agents }) => seat === null || agents.includes(seat),
    );
    const begins = this.#game && step === 0;
    const sentences = begins
      ? [goal(live.config, seat!), this.#game!.about ?? ""]
      : [`Step ${step} of ${live.config.max_steps}`, ...about.map(({ text }) => text)];
    if (!begins && seat !== null) sentences.push(nearest(live, step, seat));
    sentences.push(...this.#losses.filter((loss) => loss.step === step).map(lossText));
    const perfect = step === live.length && seat !== null ? this.#perfect : null;
    if (perfect) {
      sentences.push(
        `Perfect play: ${perfectText(perfect, seat!) || "decided in its turn"}; ${worthText(this.#solution!, perfect, step)}`,
      );
    }
    this.#look();
    this.#told.textContent = sentences
      .filter(Boolean)
      .map((text) => `${text}.`)
      .join(" ");
  }
}

/** Return what the agent in a seat is after. */
function goal(config: WorldConfig, seat: number): string {
  const all = config.rules.capture === "SURROUND";
  return teamOf(config, seat) === "evader"
    ? `Run away: you win if ${all ? "the pursuers do not surround you" : "no pursuer reaches your cell"} in ${config.max_steps} steps`
    : `Capture evaders: ${all ? "surround them with your team" : "move onto their cells"}`;
}

/** Return where the nearest opponent is that an agent sees. */
function nearest({ config, recording }: Live, step: number, seat: number): string {
  const moment = recording.moments[step]!;
  const team = teamOf(config, seat);
  const other = otherOf(team);
  if (!moment.alive[seat]) return "";
  const own = cellOf(moment, seat);
  const distance = (agent: number): number => {
    const [row, col] = cellOf(moment, agent);
    return Math.max(Math.abs(row - own[0]), Math.abs(col - own[1]));
  };
  const seen = Array.from({ length: moment.alive.length }, (_, agent) => agent).filter(
    (agent) =>
      teamOf(config, agent) === other &&
      moment.alive[agent] &&
      !moment.captured[agent - config.n_pursuers] &&
      2 * distance(agent) < config.fov,
  );
  if (!seen.length) return `No ${other} in view`;
  const found = seen.reduce((a, b) => (distance(b) < distance(a) ? b : a));
  return `Nearest ${other}: ${bearing(own, cellOf(moment, found))}`;
}

/** Return what came out for the person, in a sentence. */
export function headline(live: Live, seat: number): string {
  const { lasted, out, captured } = resultOf(live, seat);
  const { config } = live;
  if (teamOf(config, seat) === "pursuer") {
    return `Your team captured ${captured} of ${evaders(config)} in ${lasted} steps.`;
  }
  return out ? `You lasted ${lasted} of ${config.max_steps} steps.` : `You escaped: ${lasted} steps.`;
}

const evaders = ({ n_evaders }: WorldConfig): string => `${n_evaders} evader${n_evaders === 1 ? "" : "s"}`;
