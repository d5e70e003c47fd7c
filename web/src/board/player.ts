// A clock over the moments of a recording: play, pause, step, scrub. It knows neither pages nor boards.

/** Steps a second that can be chosen. */
export const SPEEDS: readonly number[] = [0.5, 1, 2, 4, 8, 16, 32, 64];
/** The speed that shows a whole recording, however long, in `WHOLE` seconds; short ones are faster. */
export const FITTING = 0;
export const WHOLE = 12;
const SLOWEST_FITTING = 2;

/** A step that stands out by so much: a bar of this share of the height, with a text. */
export interface Tick {
  readonly step: number;
  readonly kind: "pursuer" | "evader";
  readonly size: number;
  readonly text: string;
}

/**
 * A moment of a recording that moves with time.
 *
 * It dispatches `frame` when a picture has to be drawn, `step` when another step is shown, and `state`
 * when it starts, stops, or has another speed or length.
 *
 *     const player = new Player(recording.moments.length - 1);
 *     player.addEventListener("frame", () => boards.forEach((board) => board.show(recording, player.time)));
 *     player.addEventListener("step", () => say(player.step));
 *     player.play();
 */
export class Player extends EventTarget {
  #length: number;
  #speed: number;
  #still: boolean;
  #step = 0;
  #time = 0;
  #playing = false;
  #frame: number | null = null;
  #last = 0;
  #marks: readonly number[] = [];
  #ticks: readonly Tick[] = [];

  /** Seconds of a single step forward or back. */
  glide = 0.28;

  /** `still`: whether pictures jump from moment to moment, for readers who want no motion. */
  constructor(length: number, { speed = 4, still = false }: { speed?: number; still?: boolean } = {}) {
    super();
    this.#length = length;
    this.#speed = speed;
    this.#still = still;
  }

  /** The number of the step that is shown, 0 to `length`; while it is drawn, the step being made. */
  get step(): number {
    return this.#step;
  }

  /** What to draw: 3 is moment 3, and 3.5 half of step 4. */
  get time(): number {
    return this.#still ? this.#step : this.#time;
  }

  /** Whether the step that is shown has been drawn to its end. */
  get arrived(): boolean {
    return this.#time === this.#step;
  }

  get playing(): boolean {
    return this.#playing;
  }

  /** The number of steps of the recording. */
  get length(): number {
    return this.#length;
  }

  set length(length: number) {
    this.#length = length;
    if (this.#step > length) this.jump(length);
    this.#emit("state");
  }

  /** Steps that stand out, such as captures. */
  get marks(): readonly number[] {
    return this.#marks;
  }

  set marks(steps: readonly number[]) {
    this.#marks = steps;
    this.#emit("state");
  }

  /** Steps that stand out by a number, such as what a team lost. */
  get ticks(): readonly Tick[] {
    return this.#ticks;
  }

  set ticks(ticks: readonly Tick[]) {
    this.#ticks = ticks;
    this.#emit("state");
  }

  /** Steps a second that are played now. */
  get pace(): number {
    return this.#speed || Math.max(SLOWEST_FITTING, this.#length / WHOLE);
  }

  /** Steps a second, or `FITTING`. */
  get speed(): number {
    return this.#speed;
  }

  set speed(speed: number) {
    this.#speed = speed;
    this.#emit("state");
  }

  /** Change the speed to the next one of `SPEEDS`: +1 is faster, -1 slower. */
  changeSpeed(by: number): void {
    const now = SPEEDS.findIndex((speed) => speed >= this.pace);
    this.speed = SPEEDS[Math.min(SPEEDS.length - 1, Math.max(0, now + by))]!;
  }

  /** Play to the end; from the start if the end is shown. */
  play(): void {
    if (this.#playing || !this.#length) return;
    if (this.#step === this.#length) this.jump(0);
    this.#playing = true;
    this.#emit("state");
    this.#start();
  }

  /** Stop at the end of the step that is being drawn. */
  pause(): void {
    if (!this.#playing) return;
    this.#playing = false;
    this.#emit("state");
  }

  toggle(): void {
    if (this.#playing) this.pause();
    else this.play();
  }

  /** Show another step, with motion if it is the next or the last one. */
  move(by: number): void {
    this.pause();
    const step = Math.min(this.#length, Math.max(0, this.#step + by));
    if (Math.abs(step - this.#time) > 1) this.jump(step);
    else this.#aim(step);
    this.#start();
  }

  /** Show a step at once. */
  jump(step: number): void {
    this.#time = Math.min(this.#length, Math.max(0, Math.round(step)));
    this.#aim(this.#time);
    this.#emit("frame");
  }

  #aim(step: number): void {
    if (step === this.#step) return;
    this.#step = step;
    this.#emit("step");
    if (this.#still) this.#emit("frame");
  }

  #start(): void {
    if (this.#frame !== null) return;
    this.#last = performance.now();
    this.#frame = requestAnimationFrame(() => this.#tick());
  }

  #tick(): void {
    this.#frame = null;
    const now = performance.now();
    // A page that was hidden continues where it was.
    this.#advance(Math.min(0.25, (now - this.#last) / 1000));
    this.#last = now;
    // Without motion nothing changes until the step has had its time.
    if (!this.#still || this.arrived) this.#emit("frame");
    if (this.#playing || this.#time !== this.#step) {
      this.#frame = requestAnimationFrame(() => this.#tick());
    }
  }

  /** Let time follow the step that is shown; while playing, that step is the next one. */
  #advance(seconds: number): void {
    let left = seconds;
    while (left > 0) {
      if (this.#time === this.#step) {
        if (!this.#playing) return;
        if (this.#step === this.#length) return this.pause();
        this.#aim(this.#step + 1);
      }
      const rate = this.#playing ? this.pace : 1 / this.glide;
      const distance = this.#step - this.#time;
      const reach = Math.min(Math.abs(distance), left * rate);
      left -= reach / rate;
      // Sums of small parts miss whole numbers, so the last part ends exactly there.
      this.#time = reach === Math.abs(distance) ? this.#step : this.#time + Math.sign(distance) * reach;
    }
    if (this.#playing && this.#time === this.#length) this.pause();
  }

  #emit(type: "frame" | "step" | "state"): void {
    this.dispatchEvent(new Event(type));
  }
}

/** Return whether a key was one of the player's; it is then done. */
export function playerKey(player: Player, event: KeyboardEvent): boolean {
  if (event.ctrlKey || event.metaKey || event.altKey) return false;
  const many = event.shiftKey ? 10 : 1;
  const actions: Record<string, () => void> = {
    " ": () => player.toggle(),
    ArrowRight: () => player.move(many),
    ArrowLeft: () => player.move(-many),
    Home: () => player.move(-player.length),
    End: () => player.move(player.length),
    "+": () => player.changeSpeed(1),
    "-": () => player.changeSpeed(-1),
  };
  const action = actions[event.key];
  action?.();
  return action !== undefined;
}
