// Elements of a page from their names, attributes and children. Text is never read as markup.

export type Child = Node | string | number | null | undefined | false;
type Value = string | number | boolean | null | undefined | ((event: never) => void);
export type Attributes = Readonly<Record<string, Value>>;

const SVG = "http://www.w3.org/2000/svg";

/** Return an HTML element; attributes that begin with "on" are listeners. */
export function html<Tag extends keyof HTMLElementTagNameMap>(
  tag: Tag,
  attributes: Attributes = {},
  ...children: Child[]
): HTMLElementTagNameMap[Tag] {
  return filled(document.createElement(tag), attributes, children);
}

/** Return an SVG element. */
export function svg<Tag extends keyof SVGElementTagNameMap>(
  tag: Tag,
  attributes: Attributes = {},
  ...children: Child[]
): SVGElementTagNameMap[Tag] {
  return filled(document.createElementNS(SVG, tag) as SVGElementTagNameMap[Tag], attributes, children);
}

function filled<Made extends Element>(
  element: Made,
  attributes: Attributes,
  children: readonly Child[],
): Made {
  for (const [name, value] of Object.entries(attributes)) {
    if (value === null || value === undefined || value === false) continue;
    if (typeof value === "function") element.addEventListener(name.slice(2), value as EventListener);
    else element.setAttribute(name, value === true ? "" : String(value));
  }
  const shown = children.filter((child) => child !== null && child !== undefined && child !== false);
  element.append(...shown.map((child) => (typeof child === "number" ? String(child) : child)));
  return element;
}

/** Return a list of choices; `change` gets the value of the one that is chosen. */
export function select(
  options: readonly (readonly [value: string | number, text: string])[],
  change: (value: string) => void,
): HTMLSelectElement {
  const made = html(
    "select",
    { onchange: () => change(made.value) },
    ...options.map(([value, text]) => html("option", { value }, text)),
  );
  return made;
}

/** Tell in a page why it could not start, and tell tests when it has. */
export async function started(start: Promise<unknown>): Promise<void> {
  try {
    await start;
  } catch (error) {
    const place = document.querySelector("#page, main") ?? document.body;
    place.querySelector(".absent")?.remove();
    place.prepend(
      html(
        "p",
        { class: "card problem", role: "alert" },
        error instanceof WebAssembly.CompileError || /WebAssembly/.test(String(error))
          ? "This page plays by WebAssembly, which is forbidden where it lies ('wasm-unsafe-eval' is missing in the content policy): save the file, and open it from your disk."
          : `The page could not start: ${String(error)}`,
      ),
    );
    throw error;
  } finally {
    document.body.dataset["ready"] = "true";
  }
}

/** Return whether the address of the page leads anywhere: that of a frame in a notebook does not. */
export const hasAddress = (): boolean => ["file:", "http:", "https:"].includes(location.protocol);
