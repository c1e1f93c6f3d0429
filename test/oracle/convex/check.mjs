/** Compares an engine's answers about pairs of bodies with the exact ones. */
import { body, extentsOf, sizeOf } from "./bodies.mjs";
import { Pair, placeAt, scaled } from "./truth.mjs";

/** Of the sizes: how much distances, points and places may be off. */
const DISTANCE = 1e-12;

/** Of the coordinates: their rounding. */
const PLACES = 1e-15;

/** The documented gap across which shapes still touch: of the radii, half-extents and hulls' sizes; of the coordinates. */
const TOUCHING = 5e-14;
const TOUCHING_PLACES = 2 * 6e-16;

/** Of the larger extent: how much farther than its depth a contact's displacement may have to be. */
const CONTACT = 1e-9;

/** Of the larger extent: how much farther than its depth a contact's point may be outside of one of the two. Of the sizes: how far a common point may be. */
const COMMON_POINT = 2e-8;

/** Of the sizes: how deep a motion may go into what it touches. */
const THROUGH = 1e-15;

/** The same where a motion that grazes is not stopped. */
const GRAZING = 1e-9;

/** Of a way: how far apart moving shapes may be that touch. */
const MOTION = 2e-14;

/** What an engine answered wrongly, and how far it was off at most. */
export class Tally {
	counts = new Map();
	wrong = new Map();
	worst = { distance: 0, point: 0, "common point": 0, early: 0, through: 0, contact: 0, "contact point": 0 };

	count(what) {
		this.counts.set(what, (this.counts.get(what) ?? 0) + 1);
	}

	/** Notes a case as wrong, with what was wrong about it. */
	add(what, { family, a, b, seed }, details) {
		const all = this.wrong.get(what) ?? [];
		this.wrong.set(what, all);
		all.push({ family, kinds: `${a.kind}-${b.kind}`, seed, details });
	}

	/** Notes an error as a part of what is allowed; more than 1 is wrong. */
	note(what, error, allowed, each, details) {
		const part = error === 0 ? 0 : error / allowed;
		if (part > this.worst[what]) this.worst[what] = part;
		if (!(part <= 1)) this.add(what, each, details);
	}

	get wrongCount() {
		return [...this.wrong.values()].reduce((sum, all) => sum + all.length, 0);
	}
}

/** A point as a body. */
const pointBody = (at) => body("sphere", [...at, 0]);

/** The radius of a body around its middle, or around the origin of a hull's corners. */
const reachOf = (each) => (each.kind === "hull" ? Math.max(0, ...each.numbers.slice(3).map(Math.abs)) * Math.SQRT2 : sizeOf(each));

function slackOf({ a, b }) {
	const size = sizeOf(a) + sizeOf(b);
	const places = [a, b].flatMap((each) => extentsOf(each).middle).reduce((sum, each) => sum + Math.abs(each), 0);
	return { size, places, length: DISTANCE * size + PLACES * places, touching: TOUCHING * (reachOf(a) + reachOf(b)) + TOUCHING_PLACES * places };
}

/** Checks all answers about a pair: { family, a, b, seed, motion }. */
export function checkPair(engine, each, tally) {
	const [a, b] = [engine.shapeOf(each.a), engine.shapeOf(each.b)];
	const truth = new Pair(each.a, each.b);
	const slack = slackOf(each);
	const distance = truth.signedDistance;
	tally.count("pairs");
	if (distance <= 0) tally.count("touching");
	if (distance === 0) tally.count("just touching");
	checkVerdict(engine, each, [a, b], distance, slack, tally);
	checkClosest(engine, each, [a, b], distance, slack, tally);
	if (distance <= 0) checkContact(engine, each, [a, b], truth, distance, slack, tally);
	checkSweep(engine, each, [a, b], slack, tally);
}

function checkVerdict(engine, each, [a, b], distance, slack, tally) {
	const areTouching = engine.areTouching(a, b);
	if (areTouching !== engine.areTouching(b, a)) tally.add("swapped verdict", each, distance);
	if (distance <= 0 && !areTouching) tally.add("missed", each, `${distance} of ${slack.size}`);
	if (distance > slack.touching && areTouching) tally.add("false hit", each, `${distance} of ${slack.size}`);
}

function checkClosest(engine, each, [a, b], distance, slack, tally) {
	const found = engine.closest(a, b);
	const back = engine.closest(b, a);
	if (found.distance !== back.distance || String([found.a, found.b]) !== String([back.b, back.a])) tally.add("swapped distance", each, `${found.distance} ${found.a} ${found.b}, ${back.distance} ${back.b} ${back.a}`);
	if (![found.distance, ...found.a, ...found.b].every(Number.isFinite)) {
		tally.add("not finite", each, `distance ${found.distance}, ${found.a}, ${found.b}`);
		return;
	}
	const right = Math.max(0, distance);
	tally.note("distance", Math.abs(found.distance - right), slack.length, each, `${found.distance}, not ${right}`);
	const off = [[found.a, each.a], [found.b, each.b]].map(([point, of]) => Math.max(0, new Pair(pointBody(point), of).separation));
	off.push(Math.abs(Math.hypot(...found.a.map((at, k) => at - found.b[k])) - right));
	if (found.distance > 0) tally.note("point", Math.max(...off), slack.length, each, `off by ${off}`);
	else tally.note("common point", Math.max(...off), COMMON_POINT * slack.size + slack.length, each, `off by ${off}`);
}

function checkContact(engine, each, [a, b], truth, distance, slack, tally) {
	const { normal, depth, point } = engine.contact(a, b);
	const back = engine.contact(b, a);
	if (![depth, ...normal, ...point].every(Number.isFinite)) {
		tally.add("not finite", each, `${normal} by ${depth} at ${point}`);
		return;
	}
	// bodies in one place have no side from which they come
	const [middleA, middleB] = [each.a, each.b].map((of) => extentsOf(of).middle);
	const isSamePlace = Math.hypot(...middleA.map((at, k) => at - middleB[k])) <= CONTACT * slack.size;
	if (!isSamePlace && (depth !== back.depth || normal.some((at, k) => at !== -back.normal[k]))) tally.add("swapped contact", each, `${normal} by ${depth}, ${back.normal} by ${back.depth}`);
	tally.count("contacts");
	const extent = Math.max(...extentsOf(each.a).half, ...extentsOf(each.b).half);
	const more = CONTACT * extent + PLACES * slack.places;
	if (!(Math.abs(Math.hypot(...normal) - 1) <= 1e-12)) tally.add("normal's length", each, normal);
	// how much longer than the shortest way
	tally.note("contact", Math.abs(depth + distance), more, each, `depth ${depth}, not ${-distance}, extent ${extent}`);
	if (extent > 0) {
		const after = new Pair(each.a, each.b, scaled(normal, depth + more));
		if (after.areTouching()) tally.add("still touching", each, `after ${depth} along ${normal}`);
		if (depth > more && !new Pair(each.a, each.b, scaled(normal, depth - more)).areTouching()) tally.add("too long", each, `${depth} along ${normal}`);
	}
	const off = Math.max(0, ...[each.a, each.b].map((of) => new Pair(pointBody(point), of).separation));
	tally.note("contact point", off, depth + COMMON_POINT * extent + slack.length, each, `off by ${off}`);
}

function checkSweep(engine, each, [a, b], slack, tally) {
	const { start, way } = each.motion;
	const swept = (part) => new Pair(each.a, each.b, start, scaled(way, part));
	// what is in another body may leave it
	if (engine.mayGraze && swept(0).areTouching()) return;
	const time = engine.timeOf(a, b, start, way);
	if (!engine.mayGraze) {
		const back = engine.timeOf(b, a, start.map((at) => -at), way.map((at) => -at));
		if (time !== back) tally.add("swapped time", each, `${time}, ${back}`);
	}
	tally.count("sweeps");
	if (!(time <= 1) && time !== Infinity) {
		tally.add("no time", each, time);
		return;
	}
	const text = `time ${time}, ${JSON.stringify(each.motion)}`;
	const ways = Math.hypot(...start) + Math.hypot(...way);
	if (time <= 1) {
		tally.count("hits");
		const there = new Pair(each.a, each.b, placeAt(start, way, time));
		tally.note("early", Math.max(0, there.separation), slack.length + slack.touching + MOTION * ways, each, text);
	}
	// what it goes through before the time, or to the end
	const most = (engine.mayGraze ? GRAZING : THROUGH) * (slack.size + ways + slack.places);
	const before = time <= 1 ? Math.max(0, time - most / Math.hypot(...way)) : 1;
	if (time > 0 && swept(before).areTouching()) tally.note("through", Math.max(0, -swept(Math.min(time, 1)).signedDistance), most, each, text);
}
