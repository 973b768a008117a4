// The movies of the run folder, and what a decoder makes of them.

import { h } from "../dom.ts";
import type { Context } from "../section.ts";
import { significant } from "./number.ts";
import { list, report } from "./schema.ts";
import { dataTable } from "./table.ts";

export function movies({ run }: Context): HTMLElement | null {
  const own = list(report(run).movies);
  if (own.length === 0) return null;
  const rows = own.map((movie) => [
    h("code", {}, movie.file ?? ""),
    significant(movie.frames, 6),
    significant(movie.frame_rate, 4),
    `${significant(movie.width, 6)} × ${significant(movie.height, 6)}`,
    significant(movie.largest_error_of_255, 3),
    significant(movie.rms_error_of_255, 2),
  ]);
  return h(
    "div",
    {},
    h("p.quiet", {}, "Written, then decoded again and compared with the frames; errors are gray levels of 255. H.264 is lossy: the PNG frames are exact."),
    dataTable({ caption: "Movies", heads: ["file", "frames", "rate, 1/s", "pixels", "largest error", "rms error"], rows }),
  );
}
