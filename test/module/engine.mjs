/**
 * The engine that tests outside of a player import: the npm package, or what the environment's ENGINE names. The quick command names the module of the engine
 * and the tests, which it has just made of what changed.
 */
import path from "node:path";
import { fileURLToPath, pathToFileURL } from "node:url";

export const engine = await import(pathToFileURL(path.resolve(process.env.ENGINE || fileURLToPath(new URL("../../bin/module/starlogo-collision.min.js", import.meta.url)))));
