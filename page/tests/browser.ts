// The browser of the tests: one for a file of tests. What a page throws or logs as an error fails the test that opened it.

import { existsSync } from "node:fs";
import type { PageData } from "../src/data.ts";
import { written } from "./fixture.ts";
import puppeteer, { type Browser, type Page } from "puppeteer-core";

const executablePath = process.env.CHROMIUM ?? "/usr/bin/chromium";

/** Why browser tests are skipped; false where there is a browser. */
export const skip: string | false = existsSync(executablePath) ? false : `there is no Chromium at ${executablePath}; set CHROMIUM`;

let browser: Browser | null = null;
let opened = 0;

/** Ends the browser; for `after` of each file of tests. */
export async function close(): Promise<void> {
  await browser?.close();
}

/** A page and what it has thrown. */
export type Shown = Page & { problems: string[] };

export interface Options {
  width?: number;
  dark?: boolean;
  /** What follows "#". */
  hash?: string;
  /** A browser without WebGL. */
  noWebGl?: boolean;
}

/** Opens an address, or data without arrays as a page, and waits until volumes are unpacked. */
export async function open(what: string | PageData, { width = 1400, dark = false, hash = "", noWebGl = false }: Options = {}): Promise<Shown> {
  const address = typeof what === "string" ? what : written(`${process.pid}-${opened++}`, { data: what, blobs: new Map() });
  browser ??= await puppeteer.launch({
    executablePath,
    args: ["--no-sandbox", "--disable-gpu", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--disable-background-networking"],
    protocolTimeout: 120_000,
  });
  const page = await browser.newPage();
  // A machine that does other work takes its time
  page.setDefaultTimeout(120_000);
  const problems: string[] = [];
  page.on("pageerror", (error) => problems.push(String(error)));
  await page.setViewport({ width, height: 900 });
  await page.emulateMediaFeatures([
    { name: "prefers-color-scheme", value: dark ? "dark" : "light" },
    { name: "prefers-reduced-motion", value: "reduce" },
  ]);
  if (noWebGl) {
    await page.evaluateOnNewDocument(() => {
      const real = HTMLCanvasElement.prototype.getContext;
      HTMLCanvasElement.prototype.getContext = function (this: HTMLCanvasElement, kind: string, ...rest: unknown[]) {
        return kind.startsWith("webgl") ? null : Reflect.apply(real, this, [kind, ...rest]);
      } as typeof real;
    });
  }
  await page.goto(hash === "" ? address : `${address}#${hash}`, { waitUntil: "load" });
  await page.waitForFunction(() => document.querySelector("[aria-busy=true]") === null);
  await settled(page);
  return Object.assign(page, { problems });
}

/** Waits until what was asked for is drawn. */
export async function settled(page: Page): Promise<void> {
  await page.evaluate(() => new Promise<void>((resolve) => requestAnimationFrame(() => requestAnimationFrame(() => resolve()))));
}

/** Text of the first element, without extra spaces. */
export function text(page: Page, selector: string): Promise<string> {
  return page.$eval(selector, (element) => (element.textContent ?? "").replace(/\s+/g, " ").trim());
}

/** A number that stands for the pixels of a canvas. */
export function pixels(page: Page, selector: string): Promise<number> {
  return page.$eval(selector, (element) => {
    const canvas = element as HTMLCanvasElement;
    const data = canvas.getContext("2d")!.getImageData(0, 0, canvas.width, canvas.height).data;
    let hash = 0;
    for (let i = 0; i < data.length; i++) hash = (hash * 31 + data[i]) | 0;
    return hash;
  });
}

/** Moves a range input as a reader does. */
export async function slide(page: Page, selector: string, value: number): Promise<void> {
  await page.$eval(
    selector,
    (element, to) => {
      (element as HTMLInputElement).value = String(to);
      element.dispatchEvent(new Event("input", { bubbles: true }));
    },
    value,
  );
  await settled(page);
}
