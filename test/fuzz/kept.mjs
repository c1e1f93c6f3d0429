// Plays random games in which few agents change from frame to frame, with two Collisions: one goes on from the last frame's pairs, the other
// goes back to its own snapshot before each frame, so it searches among all agents. Now and then a new Collision goes on from that snapshot in its
// place. Both must make the same calls in the same order.
import { engine } from "./tools.mjs";

const { Agent, AgentFilter, BinCollider, BuiltInModel, Collision, CombinationCollider, GreatLand, HierarchicalCollider, Terrain,
	TightestFitCollider, WorldBounds } = engine;

const SHAPES = ["sphere", "cube", "cylinder"];
const BREEDS = ["wall", "coin", "mover", "ghost"];

function random(seed) {
	let state = seed * 7919 % 2147483647 + 1;
	const next = () => (state = state * 16807 % 2147483647) / 2147483647;
	for (let i = 0; i < 5; i++) next();
	next.of = list => list[Math.floor(next() * list.length)];
	next.isOne = among => next() * among < 1;
	return next;
}

/** How to play a game again. */
const again = seed => `Once more: node test/fuzz/kept.mjs ${seed} ${seed + 1}, after ./antw module`;

/** Plays a game. Returns what it was like; throws an Error with the first difference. */
export function play(seed, most = 300) {
	const chance = random(seed);
	const land = new GreatLand();
	land.loadAllBoundingStructures = chance.isOne(2);
	SHAPES.forEach(shape => land.addModel(BuiltInModel[shape]()));
	const kind = chance.of([BinCollider, TightestFitCollider, TightestFitCollider, HierarchicalCollider, CombinationCollider]);
	const side = chance.of([6, 12, 30, 1e3]);
	const isHigh = chance.isOne(2);
	const canSweep = chance.isOne(2);
	const hasGround = chance.isOne(2);
	const sizes = chance.of([[1], [1], [.5, 1, 3], [.01, 1, 40], [1e-4, .3, 1, 1000]]);
	const state = { terrain: null, bounds: null, filter: null };
	const place = () => (chance() - .5) * side;
	const height = () => isHigh ? chance() * 2 : 0;
	const created = () => {
		const agent = new Agent(chance.of(SHAPES), chance.of(BREEDS));
		agent.moveTo(place(), place(), height());
		agent.size = chance.of(sizes);
		agent.heading = chance() * 360;
		agent.hierarchical = chance.isOne(3);
		return agent;
	};
	const list = Array.from({ length: 2 + Math.floor(chance() * most) }, created);
	const [removes, throws] = [0, 1].map(() => chance.isOne(4) ? chance.of([3, 20, 200]) : 0);
	const sides = [[], []].map(calls => {
		const collision = new Collision(new kind(land));
		// what was added and removed since the last reset, for a new Collision
		const side = { calls, collision, list: [], changes: [] };
		const note = (what, a, b) => {
			calls.push(`${what} ${a.id} ${b.id}`);
			// its own list of the frame, which loses agents
			if (removes && (a.id * 31 + b.id) % removes == 0) side.list.splice(side.list.indexOf(b), 1);
			if (throws && (a.id + b.id * 31) % throws == 0) throw new Error("of a handler");
		};
		side.handlers = BREEDS.map(() => ["", "start", "end"].map(what => (a, b) => note(what, a, b)));
		side.handlers.forEach(of => of.push((a, b, contact) => note(`contact ${contact.time} ${contact.depth}`, a, b)));
		side.handlers.forEach(of => of.push((a, b, contact) => note(`start ${contact.time} ${contact.depth}`, a, b)));
		return side;
	});
	const names = [...BREEDS, Collision.ANY_BREED];
	const kinds = chance.of([[0, 1, 2, 3, 4], [1, 2], [1, 2, 4], [0, 1, 2]]);
	const change = () => {
		const [breed, other] = [chance.of(names), chance.of([...names, ...(hasGround ? [Collision.TERRAIN, Collision.EDGE] : [])])];
		const which = chance.of(kinds), by = Math.floor(chance() * BREEDS.length), removes = chance.isOne(3);
		for (const side of sides) {
			const method = removes ? "removeHandler" : ["onCollision", "onCollisionStart", "onCollisionEnd", "onCollision", "onCollisionStart"][which];
			add(side, method, breed, other, side.handlers[by][which]);
		}
	};
	const add = (side, method, ...values) => {
		side.collision[method](...values);
		side.changes.push([method, values]);
	};
	/** A new Collision goes on in place of a side's one. */
	const replace = side => {
		const { collision, changes } = side;
		side.collision = new Collision(new kind(land));
		for (const name of ["maxDepth", "exact"]) {
			if (name in collision.collisionSystem) side.collision.collisionSystem[name] = collision.collisionSystem[name];
		}
		for (const [method, values] of changes) side.collision[method](...values);
		return Object.assign(side.collision, state);
	};
	const handlerCount = chance.of([1, 2, 6]);
	for (let i = 0; i < handlerCount; i++) change();
	if (chance.isOne(3)) for (const side of sides) {
		const which = kinds.includes(0) ? 0 : 2;
		add(side, ["onCollision", "", "onCollisionEnd"][which], Collision.ANY_BREED, Collision.ANY_BREED, side.handlers[0][which]);
	}
	const ground = () => new Terrain(12, 12, side / 10, -side / 2, -side / 2);
	const rarely = chance.of([30, 100, 400]);
	const movers = chance.of([0, 0, .01, .02, .1]);
	const speed = chance.of([.01, .1, 1]);
	const frames = 50;
	let calls = 0, partial = 0;
	const touch = agent => {
		const what = chance();
		if (what < .8) agent.moveTo(agent.x + (chance() - .5) * speed * 2, agent.y + (chance() - .5) * speed * 2, isHigh ? agent.z + (chance() - .5) * speed : agent.z);
		else if (what < .86) agent.heading += chance() * 90;
		else if (what < .88) agent.jumpTo(place(), place(), height());
		else if (what < .9) agent.size = chance.of(sizes);
		else if (what < .92) agent.breed = chance.of(BREEDS);
		else if (what < .93) agent.shape = chance.of(SHAPES);
		else if (what < .94) agent.hierarchical = !agent.hierarchical;
		else if (what < .95) agent.pitch = chance() * 90;
		else if (what < .96) agent.traversalDepth = Math.floor(chance() * 4);
		else if (what < .97) agent.collideAs = chance.of(["tightest", "sphere", "box", "capsule", "hull"]);
		else if (what < .99) { if (canSweep) agent.sweeps = !agent.sweeps; }
		else agent.moveTo(chance.of([place(), 1e5, 1e7]), place(), height());
	};
	for (let frame = 0; frame < frames; frame++) {
		for (let i = 0; i < 1 + list.length * movers; i++) if (list.length > 0 && !chance.isOne(5)) touch(chance.of(list));
		const goesOn = chance.of([0, 1, 2]);
		if (goesOn == 0) for (const agent of list.slice(0, 3)) agent.moveTo(agent.x + speed / 3, agent.y, agent.z);
		if (chance.isOne(8)) list.push(created());
		if (chance.isOne(8) && list.length > 2) {
			const at = Math.floor(chance() * list.length);
			if (chance.isOne(2)) list.splice(at, 1);
			else list[at] = list.pop();
		}
		if (chance.isOne(rarely)) list.reverse();
		if (chance.isOne(rarely)) list.sort((a, b) => a.x - b.x);
		if (chance.isOne(rarely)) list.unshift(created());
		if (chance.isOne(rarely)) change();
		if (chance.isOne(rarely)) land.addModel(BuiltInModel[chance.of(SHAPES)]());
		if (chance.isOne(rarely)) state.filter = state.filter ? null : chance.of([new AgentFilter(), Object.assign(new AgentFilter(), { exceptBreeds: ["coin"] })]);
		if (state.filter && chance.isOne(4)) state.filter.except = [chance.of(list)];
		if (hasGround && chance.isOne(frame == 0 ? 1 : rarely)) state.terrain = chance.isOne(4) ? null : ground();
		if (state.terrain && chance.isOne(rarely / 4)) state.terrain.raiseMound(place(), place(), side / 3, chance() * 2);
		if (state.terrain && chance.isOne(rarely)) state.terrain.setHole(Math.floor(chance() * 12), Math.floor(chance() * 12), !chance.isOne(4));
		if (state.terrain && chance.isOne(rarely)) state.terrain.isBlocky = !state.terrain.isBlocky;
		if (hasGround && chance.isOne(frame == 0 ? 1 : rarely)) state.bounds = chance.isOne(4) ? null : new WorldBounds(-side / 3, -Infinity, -1, side / 3, Infinity, 1e9);
		if (state.bounds && chance.isOne(rarely)) state.bounds.setTo(-side / 4, -side, -1, side / 3, side, 1e9);
		const another = chance.isOne(rarely), depth = chance.isOne(rarely) ? 1 + Math.floor(chance() * 6) : 0, refuses = chance.isOne(rarely);
		const asks = chance.isOne(20), exact = chance.isOne(rarely) ? chance.isOne(2) : null, resets = chance.isOne(4 * rarely);
		for (const side of sides) {
			const { collision, calls: made } = side;
			made.length = 0;
			Object.assign(collision, state);
			const system = collision.collisionSystem;
			if (depth && system.maxDepth) system.maxDepth = depth;
			if (exact !== null && system.maxDepth && list.length < 40) system.exact = exact;
			if (another) collision.collisionSystem = new kind(land);
			if (resets) {
				collision.reset();
				side.changes.length = 0;
			}
			if (refuses) {
				const wrong = [...list, new Agent("cube"), list[0] ?? null];
				try { collision.update(wrong); made.push("not refused"); } catch (error) { made.push(String(error.constructor.name)); }
			}
			if (asks) collision.collisionSystem.findCollisions(list.slice(0, 20));
		}
		const [kept, full] = sides;
		for (const side of sides) {
			side.list = [...list];
			try { side.collision.update(side.list); } catch (error) { if (!error.message.startsWith("of a handler")) throw error; }
			side.calls.push(`${side.collision.handlerErrors.length} errors`);
		}
		if (chance.isOne(2 * rarely)) kept.collision.restore(kept.collision.snapshot(), [...list]);
		calls += kept.calls.length;
		if (kept.collision.statistics.candidatePairs < full.collision.statistics.candidatePairs) partial++;
		const differs = kept.calls.length != full.calls.length || kept.calls.findIndex((call, i) => call != full.calls[i]);
		if (differs !== -1 && differs !== false) {
			const at = differs === true ? kept.calls.findIndex((call, i) => call != full.calls[i]) : differs;
			const said = (side) => side.calls[at] === undefined ? "no call" : `"${side.calls[at]}"`;
			throw new Error(`${kind.name}: the Collision that goes on from the last frame makes other calls than one that searches anew: ${said(kept)} in place of ${said(full)}. `
				+ `They are the calls ${at + 1} of ${kept.calls.length} and of ${full.calls.length} in frame ${frame}, as "handler, id, id". ${again(seed)}`);
		}
		for (const count of ["agents", "agentsSkipped", "agentsLoading", "collisions", "handlerCalls"]) {
			if (kept.collision.statistics[count] !== full.collision.statistics[count]) throw new Error(`frame ${frame}: statistics.${count} is `
				+ `${kept.collision.statistics[count]}, and ${full.collision.statistics[count]} in a search of all. ${again(seed)}`);
		}
		// the second goes back to this frame, so it keeps no pairs for the next one
		const bytes = full.collision.snapshot();
		(frame % 8 == 7 ? replace(full) : full.collision).restore(bytes, [...list]);
	}
	return { calls, partial, frames };
}

if (process.argv[1].endsWith("kept.mjs")) {
	const [first, end] = [+process.argv[2] || 1, +process.argv[3] || 50];
	let calls = 0, partial = 0, frames = 0, found = 0;
	for (let seed = first; seed < end; seed++) {
		try {
			const game = play(seed);
			calls += game.calls; partial += game.partial; frames += game.frames;
		} catch (error) { found++; console.log(error.message.includes("Once more: ") ? error.message : error.stack); if (found > 8) break; }
	}
	console.log(`${end - first} games, ${frames} frames, ${partial} with fewer candidates, ${calls} calls: ${found} found`);
	process.exitCode = found ? 1 : 0;
}
