/** The programs that the page brings, by their names; those of lessons begin as addresses do. */
import { EXAMPLES } from "./examples.js";
import { GAMES } from "./games.js";
import { LESSONS } from "./lessons.js";

export { LESSONS };
export const BROUGHT = { ...GAMES, ...EXAMPLES, ...Object.fromEntries(Object.entries(LESSONS).map(([name, { program }]) => [`lesson-${name}`, program])) };
