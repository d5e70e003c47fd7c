// Numbers as text: the same form everywhere on the page.

/** A rate such as 0.43; a dash where it is not defined. */
export const rate = (value: number | null | undefined, digits = 2): string =>
  value === null || value === undefined ? "-" : value.toFixed(digits);

/** A value and its interval, where it has one. */
export function interval(value: number | null, low: number | null, high: number | null): string {
  return low === null || high === null ? rate(value) : `${rate(value)} (${rate(low)} to ${rate(high)})`;
}

/** A number of any size with its sign. */
export function signed(value: number): string {
  const size = Math.abs(value);
  const text = size >= 1e4 ? size.toExponential(0) : size.toFixed(size < 100 ? 2 : 0);
  return value < 0 && Number(text) ? `−${text}` : text;
}

export const thousands = (value: number): string => value.toLocaleString("en-GB");

export const capital = (text: string): string => text.charAt(0).toUpperCase() + text.slice(1);

/** Return round values inside a range, about as many as wanted. */
export function ticks(low: number, high: number, wanted: number, whole = false): number[] {
  const rough = (high - low) / Math.max(1, wanted);
  const power = 10 ** Math.floor(Math.log10(rough || 1));
  let step = [1, 2, 5, 10].map((factor) => factor * power).find((each) => each >= rough) ?? 10 * power;
  if (whole) step = Math.max(1, Math.round(step));
  const first = Math.ceil(low / step - 1e-9);
  const last = Math.floor(high / step + 1e-9);
  return Array.from({ length: Math.max(0, last - first + 1) }, (_, i) => (first + i) * step);
}
