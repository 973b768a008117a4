// Which rows a reader wants: conditions on columns ("upper >= 0.7") and words, separated by commas; all must hold.

import { isNumber } from "../number.ts";
import type { Column, Model } from "./model.ts";

type Test = (row: number) => boolean;

const COMPARISONS: Record<string, (a: number, b: number) => boolean> = {
  "<=": (a, b) => a <= b,
  ">=": (a, b) => a >= b,
  "!=": (a, b) => a !== b,
  "==": (a, b) => a === b,
  "=": (a, b) => a === b,
  "<": (a, b) => a < b,
  ">": (a, b) => a > b,
};

/** The rows that a filter leaves, in their order. */
export function filtered(model: Model, filter: string): number[] {
  const tests = filter.split(",").map((term) => term.trim()).filter((term) => term !== "").map((term) => testOf(model, term));
  return model.rows.map((_, row) => row).filter((row) => tests.every((test) => test(row)));
}

function testOf(model: Model, term: string): Test {
  const [, name, operator, text] = term.match(/^(.*?)\s*(<=|>=|!=|==|=|<|>)\s*(.*)$/) ?? [];
  const column = name === undefined ? undefined : find(model, name);
  const bound = Number(text);
  if (column && text !== "" && isNumber(bound)) {
    const compare = COMPARISONS[operator];
    return (row) => {
      const value = model.number(row, column);
      return value !== null && compare(value, bound);
    };
  }
  if (column && (operator === "=" || operator === "==")) return (row) => model.text(row, column).toLowerCase() === text.toLowerCase();
  const word = term.toLowerCase();
  return (row) => [...model.columns.map((one) => model.text(row, one)), model.state(row), model.rows[row].why ?? ""].some((cell) => cell.toLowerCase().includes(word));
}

/** By the whole name, or the last part of the key path of one metric. */
function find({ columns }: Model, name: string): Column | undefined {
  const ends = columns.filter((column) => column.name.split(".").at(-1) === name);
  return columns.find((column) => column.name === name) ?? (ends.length === 1 ? ends[0] : undefined);
}
