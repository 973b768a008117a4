// What the bundler makes modules of.

/** Style sheets come along and export nothing. */
declare module "*.css";

/** A bundled program as text, for a worker. */
declare module "worker:*" {
  const source: string;
  export default source;
}
