/** Bad input; the message has the form "<name>: expected X, got Y". */
export class EngineError extends Error {
  override name = "EngineError";
}

/** Return the error for a value that is not as expected. */
export function expected(name: string, what: string, got: unknown): EngineError {
  const text =
    typeof got === "string" ? `'${got}'` : typeof got === "object" ? JSON.stringify(got) : String(got);
  return new EngineError(`${name}: expected ${what}, got ${text}`);
}
