// Colours of a board: CSS variables of board.css, so that light and dark themes are one place.

const NAMES = {
  paper: "--board-paper",
  line: "--board-line",
  frame: "--board-frame",
  ink: "--board-ink",
  muted: "--board-muted",
  obstacle: "--board-obstacle",
  pursuer: "--pursuer",
  evader: "--evader",
  capture: "--capture",
  collision: "--collision",
  focus: "--focus",
} as const;

export type Palette = Readonly<Record<keyof typeof NAMES, string>>;

/** Return the colours that apply to an element. */
export function paletteOf(element: Element): Palette {
  const style = getComputedStyle(element);
  const entries = Object.entries(NAMES).map(([name, variable]) => [name, style.getPropertyValue(variable).trim()]);
  return Object.fromEntries(entries) as Palette;
}
