/** Near misses, for which collision systems give different answers. */
import { nearMiss } from "./notation.js";

export const EXAMPLES = {
	// the helmet is completely above the unit sphere
	helmet: nearMiss("firemen", "fireman", 3, 0, 0, 6.6, 0.6),
	// in the box around the dragon, but far from its body
	wing: nearMiss("dragons", "dragon", 8, 0.8, -2.6, 0.4, 0.8),
	// in the unit sphere of the wall, but far from it
	wall: nearMiss("walls", "wall", 6, 1.5, 0, 1.5, 0.6),
};
