/** Draws a game: its agents, their words, their meetings, the shapes that the engine tests, goal, score and end. */
import { CollisionBlocks, Sphere, Vector3D } from "starlogo-collision";
import { LINES, VERDICTS } from "../../shared/drawing/colours.js";
import { button, h, short } from "../../shared/dom.js";
import { fixed, plain, texts } from "../../shared/language.js";
import { heightOf } from "../../shared/files/models.js";
import { judge, pairsOf, verdictsOf } from "../../shared/pairs.js";
import { textOf } from "../game/actions.js";
import { Being } from "../game/being.js";
import { Occluders, isMoving } from "./occluders.js";
import { lateEngine } from "../game/late.js";
import { nameOf } from "./panel.js";
import { breedsThatKeysTurn } from "../game/program.js";
import { HALF_WIDTH } from "../game/moves.js";
import { World } from "../game/world.js";

const words = texts.play;
const STRUCTURES = { color: LINES.tested };
const CHOSEN = { color: LINES.chosen };
/** The length of a flash and of a mark, in frames, and the share of white in a flash. Agents keep their colour in it. */
const [FLASH, MARK, BRIGHT] = [9, 45, 0.2];
const MOST_SAID = 40;
/** The last seconds of a game with a limit of time. */
const LAST_SECONDS = 10;
/** The frames for which all moving agents may be out of sight, and those of their way ahead that the camera shows then. */
const [LOST, AHEAD] = [20, 120];
/** The height of signs above heads. */
const ABOVE = 0.35;
/** The size of the shapes' pictures in menus. */
const SMALL = [80, 60];
/** If agents are all over the ground, small pictures show this part of it in the middle. */
const NEAR = 0.6 * HALF_WIDTH;
const MIDDLE = [-NEAR, -NEAR, 0, NEAR, NEAR, 2];

export class Scene {
	camera = "all";
	/** Whether what the engine tests is shown. */
	isEngineShown = false;
	/** Whether the camera stays where it is when a game begins. */
	isStill = false;
	chosen = null;
	/** Agents that touch in this game only ("wrong"), or in the game beside it only ("missed"). */
	differing = new Map();
	/** Whether the same game is played beside this one. */
	isBeside = false;
	/** What the end says about the best time; and the best time itself in seconds, or null. */
	bestNote = "";
	record = null;
	#bestNote = "";
	#mainBreed = null;
	#explained = null;
	#bubbles = new Map();
	#levels = new Map();
	#pictures = new Map();
	#isPictured = false;
	#framed = "";
	/** The last frame in which the camera has seen an agent that moves, or in which none moved. */
	#seen = 0;

	/**
	 * @param {import("./landstage.js").LandStage} stage
	 * @param {import("../game/world.js").World} world
	 * @param {Map} models by their names
	 * @param {HTMLElement} screen lies over the stage
	 * @param {(() => void)|null} onAgain begins another game after the end; null if this scene cannot
	 */
	constructor(stage, world, models, screen, onAgain = null) {
		Object.assign(this, { stage, world, models, onAgain });
		this.goal = h("p.goal", { hidden: true });
		this.clock = h("p.score.clock", { hidden: true });
		this.score = h("p.score", { hidden: true, "aria-live": "polite" });
		this.caption = h("p.caption", { hidden: true });
		this.end = h("div.end", { role: "alert", hidden: true });
		this.legend = h("ul.legend.sees", { hidden: true });
		this.bubbles = h("div.bubbles");
		this.facts = h("div.inspector", { hidden: true, role: "region", "aria-label": words.inspector });
		screen.append(this.bubbles, h("div.overlay", {}, h("div.banner", {}, this.goal, this.caption, h("div.counts", {}, this.score, this.clock)), this.facts), this.end);
		stage.onDrawn = () => this.#placeBubbles();
	}

	/** Called when a game begins. */
	begin() {
		this.chosen = null;
		this.#seen = 0;
	}

	/**
	 * Points the camera at a new program's game: over the shoulder of its main character, otherwise at all of its agents. If they are all over
	 * the ground, or if there are hills, at the whole ground.
	 *
	 * @param {object} program in Blockly's notation
	 * @param {string|null} camera the one that the user has chosen
	 * @returns {string} the name of the camera
	 */
	lookAt(program, camera) {
		this.#mainBreed = mainBreedOf(program, this.world.agents);
		this.camera = camera ?? (this.#mainBreed === null ? "all" : "follow");
		this.#showAll(this.#part);
		return this.camera;
	}

	/**
	 * Shows all of the agents, if that is what the camera shows. If others are there than it has shown, or if the user asks for it: else the user
	 * may have turned it.
	 */
	frameAgents(isAsked = false) {
		const part = this.#part;
		if (this.isStill) this.#framed = String(part);
		else if (this.camera === "all" && (isAsked || String(part) !== this.#framed)) this.#showAll(part);
	}

	/** Shows all agents and the way ahead of those that move, if the camera has lost sight of all of these. */
	#findAgain() {
		const { agents, frame } = this.world;
		const moving = agents.filter((agent) => isMoving(agent, frame));
		if (moving.length === 0 || moving.some(({ x, y, z }) => this.stage.pixelOf(x, y, z).isSeen)) this.#seen = frame;
		if (frame - this.#seen < LOST) return;
		this.#seen = frame;
		const ahead = moving.map(({ shape, size, x, y, z, before }) => ({ shape, size, x: x + AHEAD * (x - before[0]), y: y + AHEAD * (y - before[1]), z }));
		this.#showAll(this.#partOf([...agents, ...ahead]));
	}

	/** Shows the whole ground. */
	showGround() {
		this.camera = "all";
		this.stage.showAll(null);
	}

	#showAll(part) {
		this.#framed = String(part);
		this.stage.showAll(part);
	}

	/** What the camera has to show of the ground; null for all of it. */
	get #part() {
		const { agents, hills } = this.world;
		return hills ? null : this.#partOf(agents);
	}

	/** The agent that the camera follows if none was clicked. */
	get main() {
		return this.world.agents.find(({ breed }) => breed === this.#mainBreed) ?? this.world.agents[0];
	}

	/** The bounds of agents in x, y and z; null if they are all over the ground. */
	#partOf(agents) {
		const low = [Infinity, Infinity, 0];
		const high = [-Infinity, -Infinity, 0];
		for (const agent of agents) {
			[agent.x, agent.y].forEach((at, i) => {
				low[i] = Math.min(low[i], at - agent.size / 2);
				high[i] = Math.max(high[i], at + agent.size / 2);
			});
			high[2] = Math.max(high[2], agent.z + this.#height(agent));
		}
		const width = Math.max(high[0] - low[0], high[1] - low[1]);
		return width > 0 && width < 1.5 * HALF_WIDTH ? [...low, ...high] : null;
	}

	/** Draws the present game. */
	draw() {
		const { stage, world } = this;
		const { frame } = world;
		if (this.chosen && !this.chosen.isAlive) this.chosen = null;
		const main = this.camera === "all" ? null : this.chosen ?? this.main;
		if (main) stage.follow(main, this.#height(main), this.camera === "eyes");
		else if (stage.renderer && !stage.isTouched && !this.isStill) this.#findAgain();
		stage.setGround(world.ground);
		stage.showTerrain(world.hills);
		stage.showAgents(this.camera === "follow" ? this.#notHiding(main, world) : world.agents, this.models, ({ hit }) => Math.max(0, BRIGHT * (1 - (frame - hit) / FLASH)));
		const lines = [];
		world.structures.lines(lines);
		stage.wireframe("structures", STRUCTURES).showLines(lines);
		stage.wireframe("chosen", CHOSEN).showLines(this.chosen ? world.structures.linesOf(this.chosen) : []);
		const verdicts = this.isEngineShown ? this.#verdicts() : this.differing;
		const solids = (this.isEngineShown ? world.agents : [...verdicts.keys()]).map((agent) => ({ ...this.#structuresOf(agent), color: VERDICTS[verdicts.get(agent) ?? "none"] }));
		stage.showMarks(world.meetings.filter((each) => frame - each.frame < MARK).map((each) => ({ point: each.point, age: (frame - each.frame) / MARK, color: VERDICTS.hit })), solids);
		stage.showSigns([...verdicts].map(([agent, kind]) => ({ kind, x: agent.x, y: agent.y, z: agent.z + this.#height(agent) + ABOVE })));
		this.#show();
		this.#inspect();
		stage.draw();
	}

	/** A picture of the beginning of a program's game. It stays on the stage until the game is drawn again. Null if the game cannot begin. */
	pictureOfGame(program, width, height) {
		const world = new World(this.world.greatLand);
		try {
			world.begin(program);
			world.step();
		} catch {
			return null;
		}
		const breed = mainBreedOf(program, world.agents);
		return this.#picture(world, width, height, world.agents.find((agent) => agent.breed === breed));
	}

	/** A picture of agents, from behind one of them, or of all. */
	#picture(world, width, height, main) {
		this.stage.setGround(world.ground);
		this.stage.showTerrain(world.hills ?? null);
		this.stage.showMarks([], []);
		this.stage.showSigns([]);
		this.stage.clearLines("structures", "chosen");
		return this.stage.picture(width, height, () => {
			if (main) this.stage.follow(main, this.#height(main), false);
			else this.stage.showAll(this.#partOf(world.agents) ?? MIDDLE);
			this.stage.showAgents(this.#notHiding(main, world), this.models);
		});
	}

	/** The agents without those that hide the followed agent. */
	#notHiding(main, world) {
		const { agents } = world;
		if (!main || !this.stage.renderer || !lateEngine) return agents;
		this.occluders ??= new Occluders(this.world.greatLand);
		const hiding = this.occluders.of(world, main, this.#height(main), this.stage.camera.position);
		return hiding.size > 0 ? agents.filter((agent) => !hiding.has(agent)) : agents;
	}

	/** The address of a picture of one agent of a shape. It is made once. */
	pictureOf(shape) {
		const model = this.models.get(shape);
		if (model && !this.#pictures.has(model)) {
			this.#pictures.set(model, this.#picture({ agents: [new Being(shape, shape)], frame: 0, ground: "meadow" }, ...SMALL, null));
			// after the last picture, the game is shown again
			if (!this.#isPictured) queueMicrotask(() => {
				this.#isPictured = false;
				this.draw();
			});
			this.#isPictured = true;
		}
		return this.#pictures.get(model) ?? null;
	}

	#height(agent) {
		return agent.size * heightOf(this.models.get(agent.shape));
	}

	#show() {
		const { goal, score, ended, seconds, secondsLeft } = this.world;
		this.clock.hidden = secondsLeft === null;
		if (secondsLeft !== null) {
			this.clock.classList.toggle("late", secondsLeft <= LAST_SECONDS);
			this.clock.textContent = `${words.clock(Math.ceil(secondsLeft))}${this.record === null ? "" : ` · ${words.bestShort(fixed(this.record, 1))}`}`;
		}
		this.goal.hidden = !goal;
		this.goal.textContent = goal;
		this.score.hidden = score === null;
		if (score !== null && this.score.textContent !== words.score(score)) this.score.textContent = words.score(score);
		this.#explain(this.isEngineShown ? words.seesNote : this.isBeside ? words.differs : {});
		if (this.end.hidden === Boolean(ended) || (ended && this.bestNote !== this.#bestNote)) {
			this.#bestNote = this.bestNote;
			this.end.hidden = !ended;
			this.end.replaceChildren(...(ended ? [h("strong", {}, words[ended.how]), h("p", {}, `${ended.text} ${words.took(fixed(seconds, 1))}`), this.bestNote && h("p.best", {}, this.bestNote), this.onAgain && button(words.again, this.onAgain, { class: "primary" })].filter(Boolean) : []));
			if (ended) this.end.querySelector("button")?.focus({ preventScroll: true });
		}
	}

	/** Explains, once, the colours and signs in the pictures. */
	#explain(notes) {
		if (this.#explained === notes) return;
		this.#explained = notes;
		this.legend.hidden = Object.keys(notes).length === 0;
		this.legend.replaceChildren(...Object.entries(notes).map(([name, text]) => h(`li.${name}`, {}, text)));
	}

	/** The verdict about each agent that touches or should: "hit" if the models touch too, "wrong" if they do not, or "missed". */
	#verdicts() {
		const { world } = this;
		const { agents, collisions } = world;
		const truth = pairsOf(collisions.systemNamed(CollisionBlocks.EXACT), agents);
		const found = pairsOf(this.#blocks.systemNamed(collisions.systemName), agents);
		return verdictsOf(judge(found, truth));
	}

	/** Separate systems, because motions begin where the game's own systems have last seen the agents. */
	get #blocks() {
		this.blocks ??= new CollisionBlocks(this.world.greatLand, this.world.agents);
		return this.blocks;
	}

	/** Says whether an agent touches the ground in the game's collision system, and whether its model does. */
	#groundOf(agent) {
		const { collisions, terrain } = this.world;
		const distanceIn = (name) => {
			const queries = new lateEngine.AgentQueries(this.#blocks.systemNamed(name));
			queries.terrain = terrain;
			return queries.distance(agent, terrain.agent);
		};
		const distance = distanceIn(collisions.systemName);
		const isTrue = distanceIn(CollisionBlocks.EXACT) === 0;
		const says = words.inspected.ground;
		if (distance > 0) return isTrue ? says.missed : says.none(short(distance));
		return isTrue ? says.hit : says.wrong;
	}

	/**
	 * The solids that the collision system tests for an agent, in the model's space. Without an agent in the result, they are in the world.
	 */
	#structuresOf(agent) {
		const { collisions, greatLand } = this.world;
		const { systemName } = collisions;
		if (systemName === CollisionBlocks.UNIT_SPHERES) {
			return { agent: null, structures: [new Sphere(new Vector3D(agent.x, agent.y, agent.z + agent.size / 2), agent.size / 2)] };
		}
		const isTree = systemName === CollisionBlocks.COMBINATION ? agent.hierarchical : systemName !== CollisionBlocks.TIGHTEST_FITS;
		if (isTree) {
			const level = systemName === CollisionBlocks.EXACT ? Infinity : agent.traversalDepth || collisions.collision.collisionSystem.maxDepth;
			const key = `${agent.shape} ${level}`;
			if (!this.#levels.has(key)) this.#levels.set(key, boundsAt(greatLand.hierarchies.root(agent.shape), level));
			return { agent, structures: this.#levels.get(key) };
		}
		const library = greatLand.boundingStructures;
		return { agent, structures: [agent.collideAs === "tightest" ? library.tightestFit(agent.shape) : library[agent.collideAs](agent.shape)] };
	}

	/** Shows the agents' words over their heads. */
	#placeBubbles() {
		const { agents, frame, shownVariables } = this.world;
		const wordsOf = ({ said, own }) => [...(said.text !== "" && said.until > frame ? [said.text] : []), ...shownVariables.filter((name) => name in own).map((name) => `${name} ${textOf(own[name])}`)].join("\n");
		const talking = agents.filter((agent) => wordsOf(agent) !== "").slice(0, MOST_SAID);
		for (const [agent, bubble] of this.#bubbles) {
			if (talking.includes(agent)) continue;
			bubble.remove();
			this.#bubbles.delete(agent);
		}
		for (const agent of talking) {
			if (!this.#bubbles.has(agent)) this.#bubbles.set(agent, this.bubbles.appendChild(h("p.bubble")));
			const bubble = this.#bubbles.get(agent);
			const height = this.#height(agent);
			const { x, y } = this.stage.pixelOf(agent.x, agent.y, agent.z + height + 0.2);
			bubble.hidden = !this.stage.pixelOf(agent.x, agent.y, agent.z + height / 2).isSeen;
			bubble.textContent = wordsOf(agent);
			// no higher than the picture
			bubble.style.transform = `translate(${x.toFixed(1)}px, max(${y.toFixed(1)}px, 100%)) translate(-50%, -100%)`;
		}
	}

	/** Shows the data of the agent that was clicked. */
	#inspect() {
		const { chosen, world } = this;
		this.facts.hidden = !chosen;
		if (!chosen) return;
		const touched = world.senses.queries.touching(chosen).filter((agent) => agent !== world.terrain?.agent).map(nameOf);
		const values = { x: chosen.x, y: chosen.y, z: chosen.z, heading: chosen.heading, size: chosen.size };
		this.facts.replaceChildren(
			h("strong", {}, nameOf(chosen)),
			h("span", {}, `${words.inspected.shape(texts.shapes[chosen.shape] ?? chosen.shape)}, ${words.inspected.as(texts.systems[world.collisions.systemName])}`),
			h("span", {}, Object.entries(values).map(([name, value]) => `${texts.blocks.traits[name]} ${plain(value)}`).join("  ")),
			h("span", {}, touched.length > 0 ? words.inspected.touching(touched.join(", ")) : words.inspected.alone),
			...(world.terrain ? [h("span", {}, this.#groundOf(chosen))] : []),
			button(words.inspected.close, () => {
				this.chosen = null;
				this.facts.hidden = true;
				this.stage.clearLines("chosen");
			}));
	}
}

/** The breed of a game's main character: keys turn it, and it has only one agent. Null if there is none. */
const mainBreedOf = (program, agents) => breedsThatKeysTurn(program).find((breed) => agents.filter((agent) => agent.breed === breed).length === 1) ?? null;

/** The structures of a tree at which a test ends. */
function boundsAt(node, level, out = []) {
	if (level <= 1 || node.isLeaf) return [...out, node.bounds];
	return boundsAt(node.right, level - 1, boundsAt(node.left, level - 1, out));
}
