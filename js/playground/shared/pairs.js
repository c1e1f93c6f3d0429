/** The pairs that collision systems find, and which of them are right. Nothing here draws. */

/** The pairs that a system finds, as a map from a key to the two agents. */
export function pairsOf(system, agents) {
	const found = system.findCollisions(agents);
	const pairs = new Map();
	for (let i = 0; i < found.length; i += 2) {
		const [a, b] = found[i].id < found[i + 1].id ? [found[i], found[i + 1]] : [found[i + 1], found[i]];
		pairs.set(`${a.id} ${b.id}`, [a, b]);
	}
	return pairs;
}

/** Judges found pairs by the true ones, both as such maps. The lists of pairs have the names of verdicts. */
export function judge(found, truth) {
	const pick = (pairs, isPicked) => [...pairs].filter(([key]) => isPicked(key)).map(([, pair]) => pair);
	return { hit: pick(found, (key) => truth.has(key)), wrong: pick(found, (key) => !truth.has(key)), missed: pick(truth, (key) => !found.has(key)) };
}

/** The verdict about each agent in judged pairs: that of its worst pair, which comes last. */
export const verdictsOf = (judged) => new Map(Object.entries(judged).flatMap(([verdict, pairs]) => pairs.flat().map((agent) => [agent, verdict])));
