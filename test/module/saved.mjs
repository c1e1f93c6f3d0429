/**
 * Goes on with a game that another process has saved: walkers on platforms that move, trees that sweep, ground. Each agent is created in an order
 * of its own. It prints what happens.
 *
 *   node test/module/saved.mjs FILE FRAMES
 */
import { readFileSync } from "node:fs";
import path from "node:path";
import { fileURLToPath, pathToFileURL } from "node:url";

const folder = fileURLToPath(new URL("../../bin/module", import.meta.url));
const manifest = JSON.parse(readFileSync(path.join(folder, "package.json"), "utf8"));
const { Agent, AgentQueries, BuiltInModel, Collision, CombinationCollider, GreatLand, Terrain, WorldBounds } = await import(pathToFileURL(path.join(folder, manifest.exports["."].default)));

/** The breeds of the agents, in the order of the list. */
const BREEDS = ["platforms", "walkers", "walkers", "rocks", "rocks", "rocks", "rocks", "walkers", "platforms"];
const SHAPES = { platforms: "cube", walkers: "sphere", rocks: "cylinder" };

export class SavedGame {
	frame = 0;
	#log = [];

	/** @param {number[]} [ages] in what order agents are created: indices in the list */
	constructor(ages = BREEDS.map((_, i) => i)) {
		const land = new GreatLand();
		for (const model of [BuiltInModel.cube(), BuiltInModel.sphere(), BuiltInModel.cylinder()]) land.addModel(model);
		this.collision = new Collision(Object.assign(new CombinationCollider(land), { exact: true }));
		this.collision.terrain = new Terrain(30, 30, 1, -15, -15);
		this.collision.bounds = new WorldBounds(-14, -14, -50, 14, 14, 50);
		this.queries = new AgentQueries(this.collision);
		this.agents = [];
		for (const i of ages) this.agents[i] = new Agent(SHAPES[BREEDS[i]], BREEDS[i]);
		for (const other of [Collision.ANY_BREED, Collision.TERRAIN, Collision.EDGE]) {
			for (const breed of ["rocks", "walkers"]) {
				this.collision.onCollision(breed, other, (a, b, { time, depth, normal }) => this.#tell("hit", a, b, time, depth, normal.x, normal.y));
				this.collision.onCollisionStart(breed, other, (a, b) => this.#tell("start", a, b));
				this.collision.onCollisionEnd(breed, other, (a, b) => this.#tell("end", a, b));
			}
		}
	}

	/** Puts the agents to where a new game begins. */
	begin() {
		const { agents, collision } = this;
		collision.terrain.raiseMound(3, 3, 8, 2);
		agents.forEach((agent, i) => {
			agent.moveTo(1.2 * (i % 3), 1.3 * Math.floor(i / 3), 1);
			if (agent.breed === "rocks") Object.assign(agent, { hierarchical: true, sweeps: true, color: i });
			if (agent.breed === "rocks") agent.setQuaternion(0.1 * i, 0.3, 0.2, 0.5);
			if (agent.breed === "platforms") Object.assign(agent, { size: 1.6, z: 0, collideAs: "box" });
		});
		agents[1].moveTo(agents[0].x, agents[0].y + 0.1, 2);
		agents[7].moveTo(agents[8].x + 0.2, agents[8].y, 2);
	}

	#tell(what, a, b, ...numbers) {
		this.#log.push([what, this.agents.indexOf(a), b.breed, this.agents.indexOf(b), ...numbers].join(" "));
	}

	/** Plays some frames. Returns all that happened. */
	run(frames) {
		const { agents, queries, collision } = this;
		this.#log = [];
		for (let i = 0; i < frames; i++) {
			this.frame++;
			agents.forEach((agent, k) => {
				if (agent.breed === "platforms") {
					agent.x += 0.05 * Math.sign(Math.sin(this.frame / 9));
					agent.heading += 2;
				} else if (agent.breed === "rocks") {
					agent.moveTo(2 + 2 * Math.sin(this.frame * (1 + 0.3 * k)), 2 + 2 * Math.cos(this.frame * 0.7 * k), agent.z);
					const [x, y, z, w] = agent.getQuaternion();
					agent.setQuaternion(x + 0.05, y, z - 0.02, w);
				}
			});
			queries.update(agents);
			for (const walker of agents.filter(({ breed }) => breed === "walkers")) {
				const { stands, on, part, pushed } = queries.walk(walker, 0.02, 0.01 * Math.sin(this.frame));
				this.#log.push(["walk", stands, agents.indexOf(on), part, pushed, queries.canSee(walker, agents[4]), walker.x, walker.y, walker.z, walker.heading].join(" "));
			}
			collision.update(agents);
		}
		return this.#log;
	}
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
	const [file, frames] = process.argv.slice(2);
	new Agent("cube", "others"); // ids and breeds differ too
	const game = new SavedGame([6, 2, 8, 0, 3, 7, 5, 1, 4]);
	const { frame, bytes } = JSON.parse(readFileSync(file, "utf8"));
	game.collision.restore(Buffer.from(bytes, "base64"), game.agents);
	game.frame = frame;
	console.log(game.run(Number(frames)).join("\n"));
}
