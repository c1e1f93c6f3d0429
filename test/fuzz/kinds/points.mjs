/** Agents of all sizes, and points, among spheres: the right pairs, in a time that is in proportion to their number. */
import { engine, HAIR, numbersOf, toolsOf } from "../tools.mjs";

const { Agent } = engine;

/** Processor milliseconds of a call: the least of some. */
function timeOf(call) {
	let least = Infinity;
	for (let i = 0; i < 4; i++) {
		const before = process.cpuUsage();
		call();
		const { user, system } = process.cpuUsage(before);
		least = Math.min(least, (user + system) / 1000);
	}
	return least;
}

export const points = {
	dots: {
		random: ({ integer, random }) => [1 + integer(60), 1 + integer(1e6), integer(4), random() < 0.5],
		play(game, count, seed, which, areSizes) {
			const { between, pick } = toolsOf(numbersOf(seed));
			const place = (agent, size) => {
				agent.moveTo(between(-5, 5), between(-5, 5), pick([0, 0, between(-1, 1)]));
				agent.size = size;
				return agent;
			};
			const spheres = Array.from({ length: 60 }, () => place(new Agent("sphere"), 1));
			const others = Array.from({ length: count }, () => place(new Agent(areSizes ? "sphere" : pick(["point", "one place"])), areSizes ? 10 ** between(-6, 2) : pick([1, 1e-6, 0.3])));
			const system = game.makeSystem({ system: which, exact: false, depth: 5 });
			const alone = timeOf(() => system.findCollisions(spheres));
			const all = [...others, ...spheres];
			const together = timeOf(() => system.findCollisions(all));
			game.expect("points cost", together < 20 * alone + 6 + 0.004 * count * count, `${count} ${areSizes ? "agents of all sizes" : "points"} take ${together} ms beside ${alone}, in system ${which}`);
			const found = system.findCollisions(all);
			const pairs = new Set();
			for (let i = 0; i < found.length; i += 2) pairs.add(all.indexOf(found[i]) * all.length + all.indexOf(found[i + 1]));
			const fresh = game.makeSystem({ system: which, exact: false, depth: 5 });
			all.forEach((a, i) => all.slice(i + 1).forEach((b, k) => {
				const isFound = pairs.has(i * all.length + i + 1 + k);
				game.expect("points touch", fresh.areColliding(a, b) === isFound, `${a} and ${b} in system ${which}`);
				if (which !== 1 || a.shape !== "sphere" && b.shape !== "sphere") return;
				// a point is where it is, a sphere stands on its place
				const [p, q] = [a, b].map((each) => (each.shape === "sphere" ? [each.x, each.y, each.z + each.size / 2, each.size / 2] : [each.x, each.y, each.z, 0]));
				const gap = Math.hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]) - p[3] - q[3];
				if (Math.abs(gap) > 100 * HAIR) game.expect("points touch", isFound === gap < 0, `${a} and ${b} are ${gap} apart`);
			}));
		},
	},
};
