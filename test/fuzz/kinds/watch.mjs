/**
 * A second Collision with a collider of its own, for the agents that do not sweep. Its handlers do nothing, so a loop over all pairs says which calls a
 * frame makes: starts and ends beside the ground and the edges, for any breed and for one, after an exchange of the ground, a reset, a snapshot.
 */
import assert from "node:assert/strict";
import { engine, HAIR } from "../tools.mjs";

const { AgentFilter, Collision } = engine;
const { ANY_BREED, TERRAIN, EDGE } = Collision;

const FIXTURES = [TERRAIN, EDGE];
const HANDLERS = ["onCollision", "onCollisionStart", "onCollisionEnd"];

const randomPair = ({ pick, random }) => {
	const breed = () => pick(["bears", "balls", "walls", ANY_BREED]);
	return random() < 0.5 ? [breed(), breed()] : random() < 0.7 ? [breed(), pick(FIXTURES)] : [pick(FIXTURES), breed()];
};

const fits = (asked, breed) => asked === breed || asked === ANY_BREED && !FIXTURES.includes(breed);
const fitsPair = (handler, a, b) => fits(handler.breed, a) && fits(handler.other, b);

class Watch {
	collision;
	handlers = [];
	touches = new Map();
	calls = [];

	constructor(game) {
		this.game = game;
		this.collision = new Collision(game.makeSystem());
	}

	add(kind, breed, other, takes) {
		const handler = { kind, breed, other };
		const call = (a, b, contact) => this.calls.push({ handler, a, b, contact: contact ? { time: contact.time, depth: contact.depth, normal: [contact.normal.x, contact.normal.y, contact.normal.z] } : null });
		handler.call = takes === "rest" ? (...all) => call(...all) : takes === "contact" ? (a, b, contact) => call(a, b, contact) : (a, b) => call(a, b, null);
		handler.takes = takes !== "";
		this.collision[kind](breed, other, handler.call);
		this.handlers.push(handler);
	}

	remove(place) {
		if (this.handlers.length === 0) return;
		const [{ breed, other, call }] = this.handlers.splice(place % this.handlers.length, 1);
		assert.ok(this.collision.removeHandler(breed, other, call), "a watcher was not there");
	}

	/** The calls for a pair of agents with these breeds: in both directions. */
	callsOf(kind, first, second, firstBreed, secondBreed) {
		const calls = [];
		for (const handler of this.handlers.filter((each) => each.kind === kind)) {
			if (fitsPair(handler, firstBreed, secondBreed)) calls.push([handler, first, second]);
			if (fitsPair(handler, secondBreed, firstBreed)) calls.push([handler, second, first]);
		}
		return calls;
	}

	touchingPairs(list, fresh) {
		const { terrain, bounds, filter } = this.collision;
		const some = filter === null ? list : list.filter(({ breed }) => !filter.exceptBreeds.includes(breed));
		const pairs = [];
		some.forEach((a, i) => some.slice(i + 1).forEach((b) => fresh.areColliding(a, b) && pairs.push([a, b])));
		for (const a of some) {
			for (const fixture of [terrain, bounds]) if (fixture && fresh.areColliding(a, fixture.agent)) pairs.push([a, fixture.agent]);
		}
		return pairs;
	}

	/** What the next frame has to call, and the touches after it. */
	foresee(list) {
		const fresh = this.game.makeSystem(this.setting);
		const touches = new Map();
		const calls = [];
		for (const [first, second] of this.touchingPairs(list, fresh)) {
			const key = [this.game.numberOf(first), this.game.numberOf(second)].sort().join();
			const [firstBreed, secondBreed] = [first.breed, second.breed];
			const old = this.touches.get(key);
			const isKnown = old && (old.first === first ? old.firstBreed === firstBreed && old.secondBreed === secondBreed : old.firstBreed === secondBreed && old.secondBreed === firstBreed);
			const isTracked = ["onCollisionStart", "onCollisionEnd"].some((kind) => this.callsOf(kind, first, second, firstBreed, secondBreed).length > 0);
			if (isTracked) touches.set(key, isKnown ? old : { first, second, firstBreed, secondBreed });
			if (isTracked && !isKnown) calls.push(...this.callsOf("onCollisionStart", first, second, firstBreed, secondBreed));
			calls.push(...this.callsOf("onCollision", first, second, firstBreed, secondBreed));
		}
		for (const [key, old] of this.touches) {
			if (touches.get(key) !== old) calls.push(...this.callsOf("onCollisionEnd", old.first, old.second, old.firstBreed, old.secondBreed));
		}
		return { calls, touches };
	}

	/** @param check the name of the check of its calls */
	frame(isReversed, check = "watch calls") {
		const { game } = this;
		if (this.isRunning) return;
		const list = game.agents.filter((agent) => !agent.sweeps);
		if (isReversed) list.reverse();
		if (!list.every(({ shape }) => game.land.hasModel(shape))) {
			assert.throws(() => this.collision.update(list), /no model/);
			this.isRefused = true;
			return;
		}
		const { calls, touches } = this.foresee(list);
		const fresh = game.makeSystem(this.setting);
		const contacts = new Map();
		for (const [handler, a, b] of calls) if (handler.takes && handler.kind !== "onCollisionEnd") contacts.set(`${game.numberOf(a)} ${game.numberOf(b)}`, fresh.contactOf(a, b).depth);
		this.calls = [];
		this.isRefused = false;
		this.isRunning = true;
		try {
			this.collision.update(list);
		} finally {
			this.isRunning = false;
		}
		this.touches = touches;
		const text = (kind, breed, other, a, b) => `${kind} ${breed}-${other} ${game.numberOf(a)} ${game.numberOf(b)}`;
		const made = this.calls.map(({ handler, a, b }) => text(handler.kind, handler.breed, handler.other, a, b));
		const meant = calls.map(([handler, a, b]) => text(handler.kind, handler.breed, handler.other, a, b));
		const less = (some, others) => others.filter((each) => others.filter((one) => one === each).length > some.filter((one) => one === each).length).slice(0, 4);
		game.expect(check, made.length === meant.length && [...made].sort().join() === [...meant].sort().join(), `missing ${less(made, meant)}, too many ${less(meant, made)}, in ${JSON.stringify(this.setting)}`);
		const first = this.calls.findIndex(({ handler }) => handler.kind !== "onCollisionEnd");
		game.expect("watch order", first < 0 || this.calls.slice(first).every(({ handler }) => handler.kind !== "onCollisionEnd"), "ends come first");
		for (const { handler, a, b, contact } of this.calls) {
			if (!handler.takes) continue;
			const depth = contacts.get(`${game.numberOf(a)} ${game.numberOf(b)}`);
			if (handler.kind === "onCollisionEnd") game.expect("watch contact", contact === null, "an end has a contact");
			else game.expect("watch contact", contact !== null && contact.time === 1 && Math.abs(contact.depth - depth) <= HAIR * Math.max(1, depth), `${JSON.stringify(contact)}, not ${depth} deep: ${a} and ${b}`);
		}
	}

	get setting() {
		return this.asked ?? this.game.setting;
	}

	set setting(value) {
		this.asked = value;
	}
}

const watchOf = (game) => {
	if (!game.watch) {
		game.watch = new Watch(game);
		game.watch.setting = { ...game.setting };
	}
	return game.watch;
};

export const playWatchedFrame = (game) => watchOf(game).frame(false);

export const watch = {
	watch: {
		random: (tools) => [tools.pick(HANDLERS), ...randomPair(tools), tools.pick(["", "", "contact", "rest"])],
		play: (game, ...values) => watchOf(game).add(...values),
	},
	unwatch: { random: ({ integer }) => [integer(99)], play: (game, place) => watchOf(game).remove(place) },
	/** For a frame, and the frame after it. */
	watchOnce: {
		random: (tools) => [tools.pick(HANDLERS), ...randomPair(tools)],
		play(game, kind, breed, other) {
			const watched = watchOf(game);
			watched.add(kind, breed, other, "");
			watched.frame(false);
			watched.remove(watched.handlers.length - 1);
			watched.frame(false);
		},
	},
	watchFrame: { random: ({ random }) => [random() < 0.2], play: (game, isReversed) => watchOf(game).frame(isReversed) },
	watchGround: {
		random: ({ random }) => [random() < 0.7, random() < 0.7],
		play(game, hasGround, hasEdges) {
			Object.assign(watchOf(game).collision, { terrain: hasGround ? game.collision.terrain : null, bounds: hasEdges ? game.collision.bounds : null });
		},
	},
	watchSystem: {
		random: ({ integer, random }) => [integer(4), random() < 0.4, 1 + integer(8)],
		play(game, system, exact, depth) {
			const watched = watchOf(game);
			watched.setting = { system, exact, depth };
			watched.collision.collisionSystem = game.makeSystem(watched.setting);
		},
	},
	watchFilter: {
		random: ({ pick }) => [pick([null, "bears", "balls"])],
		play(game, breed) {
			watchOf(game).collision.filter = breed === null ? null : Object.assign(new AgentFilter(), { exceptBreeds: [breed] });
		},
	},
	watchReset: {
		random: () => [],
		play(game) {
			const watched = watchOf(game);
			watched.collision.reset();
			watched.handlers = [];
			watched.touches = new Map();
		},
	},
	watchRewind: {
		random: ({ between, integer }) => [between(0, 0.5), 1 + integer(3)],
		play(game, step, frames) {
			const watched = watchOf(game);
			if (watched.isRefused || !game.known()) return;
			const { collision } = watched;
			const bytes = collision.snapshot();
			const listed = [...collision.lastAgents];
			if (!listed.every(({ shape }) => game.land.hasModel(shape))) return;
			const touches = new Map(watched.touches);
			const before = game.traits(game.agents);
			for (let i = 0; i < frames; i++) {
				game.agents.forEach((agent, k) => agent.moveTo(agent.x + step * ((k + i) % 3 - 1), agent.y, agent.z));
				watched.frame(false);
			}
			game.putBack(game.agents, before);
			let problem = null;
			try {
				collision.restore(bytes, listed);
			} catch (error) {
				problem = error;
			}
			game.expect("watch restores", problem === null, `${problem}`);
			if (problem !== null) return;
			watched.touches = touches;
			watched.frame(false, "watch calls after a restore");
		},
	},
	/** A collider belongs to one Collision. */
	share: {
		random: ({ random }) => [random() < 0.5],
		play(game, isNew) {
			const { collisionSystem } = game.collision;
			const watched = watchOf(game).collision;
			const own = watched.collisionSystem;
			let problem = null;
			try {
				if (isNew) new Collision(collisionSystem);
				else watched.collisionSystem = collisionSystem;
			} catch (error) {
				problem = error;
			}
			const isKept = watched.collisionSystem === own;
			watched.collisionSystem = own;
			game.expect("share is refused", problem?.name === "ArgumentError" && isKept, `${problem}`);
		},
	},
};
