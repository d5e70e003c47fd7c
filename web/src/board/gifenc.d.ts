// What `gif.ts` uses of gifenc, which has no types of its own.
declare module "gifenc" {
  export function GIFEncoder(): {
    writeFrame(index: Uint8Array, width: number, height: number, options: { palette: number[][]; delay: number }): void;
    finish(): void;
    bytes(): Uint8Array;
  };
  export function applyPalette(rgba: Uint8ClampedArray, palette: number[][]): Uint8Array;
}
