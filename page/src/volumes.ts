// The volumes of a run, by kind and species.

import { messageOf } from "./controls.ts";
import type { Run, VolumeInfo, VolumeKind } from "./data.ts";
import type { Context } from "./section.ts";
import type { Volume } from "./volume.ts";

/** Volumes of the chosen species. */
export interface Volumes {
  response: Volume | null;
  target: Volume | null;
  labels: Volume | null;
  bodies: Volume | null;
  /** Times of cure and properties. */
  others: Volume[];
}

/** The volume of a kind, of a species ("" for the first). */
export function infoOf(run: Run, kind: VolumeKind, species: string): VolumeInfo | undefined {
  const ofKind = run.volumes.filter((info) => info.kind === kind);
  return ofKind.find((info) => species !== "" && info.species === species) ?? ofKind[0];
}

/** Species that have a dose of their own. */
export function speciesOf(run: Run): string[] {
  return run.volumes.filter(({ kind, species }) => kind === "response" && species !== null).map(({ species }) => species ?? "");
}

/** The species that the address names; "" for the first. */
export function chosenSpecies({ run, state }: Context): string {
  const species = state.get("species");
  return speciesOf(run).includes(species) ? species : "";
}

/** The volumes of a species, and what could not be read. */
export async function volumesOf(context: Context, species: string): Promise<{ volumes: Volumes; problems: string[] }> {
  const { run, store } = context;
  const problems: string[] = [];
  const load = async (info: VolumeInfo | undefined): Promise<Volume | null> => {
    if (!info) return null;
    try {
      return await store.volume(info);
    } catch (error) {
      problems.push(messageOf(error));
      return null;
    }
  };
  const one = (kind: VolumeKind) => load(infoOf(run, kind, species));
  const others = run.volumes.filter(({ kind }) => kind === "cure_time" || kind === "property");
  const [response, target, labels, bodies, ...rest] = await Promise.all([one("response"), one("target"), one("labels"), one("bodies"), ...others.map(load)]);
  return { volumes: { response, target, labels, bodies, others: rest.filter((volume) => volume !== null) }, problems };
}

