// The sections that are text, tables and curves.

import type { Section } from "../section.ts";

export const sections: Section[] = [];
