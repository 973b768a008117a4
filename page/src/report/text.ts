// Pieces of text that several sections share.

import { h, sentence, type Child } from "../dom.ts";

/** Sentences of the command as paragraphs; those that are missing are left out. */
export function paragraphs(texts: readonly (string | null | undefined)[], className = ""): HTMLElement[] {
  return texts.filter(isText).map((text) => h("p", { class: className || null }, sentence(asSentence(text))));
}

/** A list of sentences, or null where there are none. */
export function bullets(texts: readonly (string | null | undefined)[]): HTMLElement | null {
  const given = texts.filter(isText);
  if (given.length === 0) return null;
  return h("ul", {}, ...given.map((text) => h("li", {}, sentence(asSentence(text)))));
}

function isText(text: string | null | undefined): text is string {
  return typeof text === "string" && text !== "";
}

/** With a capital and a full stop. A key or a file at the beginning stays as it is. */
function asSentence(text: string): string {
  const begun = /^[a-z]+[ ,]/.test(text) ? text.charAt(0).toUpperCase() + text.slice(1) : text;
  return /[.!?:]$/.test(begun) ? begun : `${begun}.`;
}

/** A part of a section with its own heading. */
export function part(title: string, ...children: Child[]): HTMLElement {
  return h("div.part", {}, h("h3", {}, title), ...children);
}

/** A button that copies a text and says so. */
export function copyButton(label: string, text: () => string): HTMLButtonElement {
  const button = h("button.copy", { type: "button" }, label);
  button.addEventListener("click", () => {
    const say = (words: string) => {
      button.textContent = words;
      window.setTimeout(() => (button.textContent = label), 1600);
    };
    // Frames of other pages may not copy, and pages of other machines have no clipboard
    const copied = navigator.clipboard?.writeText(text()) ?? Promise.reject(new Error("no clipboard"));
    copied.then(
      () => say("Copied"),
      () => say("The browser refused to copy"),
    );
  });
  return button;
}

/** Cells as a line of CSV. */
export function csvLine(cells: readonly (string | number | null | undefined)[]): string {
  const quoted = (cell: string) => (/[",\n]/.test(cell) ? `"${cell.replaceAll('"', '""')}"` : cell);
  return cells.map((cell) => quoted(cell === null || cell === undefined ? "" : String(cell))).join(",");
}
