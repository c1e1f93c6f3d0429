/** The page's own programs, by name. The names of lessons' programs have a prefix, as in addresses. */
import { EXAMPLES } from "./examples.js";
import { GAMES } from "./games.js";
import { LESSONS } from "./lessons.js";

export { LESSONS };
export const BUILT_IN_PROGRAMS = { ...GAMES, ...EXAMPLES, ...Object.fromEntries(Object.entries(LESSONS).map(([name, { program }]) => [`lesson-${name}`, program])) };
