// Makes elements: `h("p.note", { title: "…" }, "text", child)`. Text is always text, never markup.

export type Child = Node | string | null | undefined | false;

type Attributes = { [name: string]: string | number | boolean | null | undefined | ((event: never) => void) };

/** An element from `tag.class.class`, its attributes (functions become event listeners, `true` an empty attribute) and its children. */
export function h<K extends keyof HTMLElementTagNameMap>(tag: K | `${K}.${string}`, attributes?: Attributes, ...children: Child[]): HTMLElementTagNameMap[K];
export function h(tag: string, attributes: Attributes = {}, ...children: Child[]): HTMLElement {
  const [name, ...classes] = tag.split(".");
  const element = document.createElement(name);
  if (classes.length > 0) element.className = classes.join(" ");
  decorate(element, attributes);
  append(element, children);
  return element;
}

/** As `h`, for SVG. */
export function svg(tag: string, attributes: Attributes = {}, ...children: Child[]): SVGElement {
  const element = document.createElementNS("http://www.w3.org/2000/svg", tag);
  decorate(element, attributes);
  append(element, children);
  return element;
}

/** A sentence of the command: `code` between backticks becomes a code element. */
export function sentence(text: string): DocumentFragment {
  const fragment = document.createDocumentFragment();
  text.split("`").forEach((piece, i) => {
    if (piece !== "") fragment.append(i % 2 === 1 ? h("code", {}, piece) : piece);
  });
  return fragment;
}

function decorate(element: Element, attributes: Attributes): void {
  for (const [name, value] of Object.entries(attributes)) {
    if (value === null || value === undefined || value === false) continue;
    if (typeof value === "function") element.addEventListener(name, value as EventListener);
    else element.setAttribute(name, value === true ? "" : String(value));
  }
}

function append(element: Element, children: Child[]): void {
  for (const child of children) {
    if (child !== null && child !== undefined && child !== false) element.append(child);
  }
}
