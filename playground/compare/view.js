/** Compare: what each collision system says of two agents, and of a game of many. */
import { Agent, CollisionBlocks, GreatLand, StructureBlocks } from "starlogo-collision";
import { button, choice, field, h, slider } from "../shared/dom.js";
import { Lab, edgesOf } from "../shared/lab.js";
import { showMeeting } from "../shared/meeting.js";
import { loadModel } from "../shared/models.js";
import { SHAPES } from "../shared/names.js";
import { orbitByKeys } from "../shared/stage.js";
import { texts } from "../texts.js";
import { ScatteredGame, compare } from "./game.js";

const words = texts.compare;
const COLOURS = [0x5b8def, 0xe0a030];
const HIT_COLOURS = [0x3a63c9, 0xb97a10];
const LINES = 0xff8a00;
const GAME_COLOURS = { none: 0xaeb8c6, right: 0x3d9a5f, wrong: 0xf0a020, missed: 0xd8435a };
const PAIR_COLOURS = { right: 0x0b5c2c, wrong: 0x8a5300, missed: 0x9c0f26 };
const AGENTS = 150;
const RANGES = { x: [-2, 2, 0.01], y: [-2, 2, 0.01], z: [-1, 3, 0.01], heading: [-180, 180, 1], pitch: [-180, 180, 1], roll: [-180, 180, 1], size: [0.2, 3, 0.01] };
/** A ball beneath the dragon's wing: the box says yes, and the dragon no. */
const BEGINNING = [{ shape: "dragon", size: 2 }, { shape: "sphere", x: 0.2, y: 0.6, z: 0.1, size: 0.2 }];

export async function createView(main) {
	const models = new Map(await Promise.all(SHAPES.map(async (name) => [name, await loadModel(name)])));
	const greatLand = new GreatLand();
	for (const model of models.values()) greatLand.addModel(model);
	return new CompareView(main, models, greatLand);
}

class CompareView {
	constructor(main, models, greatLand) {
		this.models = models;
		this.agents = BEGINNING.map(({ shape, ...traits }) => Object.assign(new Agent(shape), traits));
		this.agents[0].hierarchical = true;
		this.blocks = new CollisionBlocks(greatLand, this.agents);
		this.structures = new StructureBlocks(this.blocks);
		this.shown = CollisionBlocks.TIGHTEST_FITS;
		this.blocks.useCollisionSystem(this.shown);
		this.sliders = [];
		this.pairHost = h("div.world", { tabindex: "0", role: "application", "aria-label": words.world });
		this.verdicts = h("div.verdicts", { role: "radiogroup", "aria-label": words.shown });
		this.gameHost = h("div.world.wide", {});
		this.table = h("div.table");
		this.gameNote = h("p.note", { role: "status" });
		this.colourNote = h("p.note");
		this.legend = h("ul.legend");
		this.gameSystem = CollisionBlocks.UNIT_SPHERES;
		this.reference = CollisionBlocks.EXACT;
		const references = choice(CollisionBlocks.systemNames.map((name) => [name, texts.systems[name]]), this.reference, (name) => {
			this.reference = name;
			this.#judge();
		});
		this.meeting = h("p.note", { role: "status" });
		main.replaceChildren(
			h("section.pair", { "aria-label": words.pair },
				h("div.seen", {}, h("div.screen", {}, this.pairHost), this.verdicts),
				h("div.side", { tabindex: "-1" }, h("h2", {}, words.pair), h("p.note", {}, words.pairNote), this.meeting, ...this.agents.map((agent, i) => this.#controls(agent, i)))),
			h("section.scattered", { "aria-label": words.game },
				h("div.side", {}, h("h2", {}, words.game), field(words.reference, references), this.gameNote, this.table,
					h("div.tools", {}, button(words.next, () => this.#step()), button(words.another, () => this.#restart())),
					this.colourNote, this.legend),
				h("div.screen", {}, this.gameHost)));
		this.stage = new Lab(this.pairHost, { label: words.world, eye: [2, 2.9, 1.5], target: [0, 0, 0.4], ground: 6 });
		this.gameStage = new Lab(this.gameHost, { label: words.gameWorld, eye: [0, -45, 142], target: [0, 0, 0], ground: 100, cell: 5 });
		orbitByKeys(this.stage, this.pairHost);
		this.#buildVerdicts();
		this.#drag();
		this.#update();
		this.#restart();
	}

	#controls(agent, i) {
		const letter = "AB"[i];
		const shape = choice(SHAPES.map((name) => [name, texts.shapes[name]]), agent.shape, (name) => {
			agent.shape = name;
			this.#update();
		});
		const sliders = Object.entries(RANGES).map(([trait, [min, max, step]]) => [trait, slider(words.traits[trait], { min, max, step, value: agent[trait], format: (value) => value.toFixed(step < 1 ? 2 : 0) }, (value) => {
			agent[trait] = value;
			this.#update();
		})]);
		this.sliders[i] = Object.fromEntries(sliders);
		return h("details", { open: i === 1, name: "agent" }, h("summary", {}, words.agent(letter)), field(words.shape, shape), ...sliders.map(([, { element }]) => element));
	}

	#buildVerdicts() {
		this.rows = CollisionBlocks.systemNames.map((name) => {
			const verdict = h("strong");
			const pick = h("input", { type: "radio", name: "shown", value: name, checked: name === this.shown, onchange: () => {
				this.shown = name;
				this.blocks.useCollisionSystem(name);
				this.#update();
			} });
			const row = h("label.verdict", {}, pick, h("span", {}, texts.systems[name], h("small", {}, texts.systemNotes[name]), verdict));
			return { name, row, verdict };
		});
		this.verdicts.replaceChildren(...this.rows.map(({ row }) => row));
	}

	/** Says anew what is so, and draws it. */
	#update() {
		const [a, b] = this.agents;
		const truth = this.blocks.systemNamed(CollisionBlocks.EXACT).areColliding(a, b);
		for (const { name, row, verdict } of this.rows) {
			const answer = this.blocks.systemNamed(name).areColliding(a, b);
			const isRight = answer === truth;
			verdict.textContent = isRight ? (answer ? words.hit : words.miss) : answer ? words.falseHit : words.missed;
			row.classList.toggle("hit", answer);
			row.classList.toggle("wrong", !isRight);
		}
		this.agents.forEach((agent, i) => {
			agent.color = (truth ? HIT_COLOURS : COLOURS)[i];
		});
		this.stage.showAgents(this.agents, this.models);
		const lines = this.stage.wireframe("tested", LINES);
		for (const agent of this.agents) {
			const model = this.models.get(agent.shape);
			if (this.shown === CollisionBlocks.EXACT && model.triangles) lines.showLines(edgesOf(model), agent);
			else lines.showLines(this.structures.linesOf(agent));
		}
		this.meeting.textContent = showMeeting(this.stage, this.blocks.systemNamed(this.shown), a, b);
	}

	/** The pointer takes an agent along the level that it stands on. */
	#drag() {
		if (!this.stage.renderer) return;
		const { canvas, controls } = this.stage;
		let held = null;
		canvas.addEventListener("pointerdown", (event) => {
			const agent = this.stage.agentAt(event);
			const from = agent && this.stage.pointAt(event, agent.z);
			if (!from) return;
			held = { agent, x: agent.x - from.x, y: agent.y - from.y };
			controls.enabled = false;
			canvas.setPointerCapture(event.pointerId);
		}, { capture: true });
		canvas.addEventListener("pointermove", (event) => {
			canvas.classList.toggle("grab", held !== null || this.stage.agentAt(event) !== null);
			const to = held && this.stage.pointAt(event, held.agent.z);
			if (!to) return;
			const sliders = this.sliders[this.agents.indexOf(held.agent)];
			for (const axis of ["x", "y"]) {
				const [min, max] = RANGES[axis];
				held.agent[axis] = Math.min(max, Math.max(min, to[axis] + held[axis]));
				sliders[axis].set(held.agent[axis]);
			}
			this.#update();
		});
		const drop = () => {
			held = null;
			controls.enabled = true;
		};
		canvas.addEventListener("pointerup", drop);
		canvas.addEventListener("pointercancel", drop);
	}

	#restart() {
		this.game = new ScatteredGame(AGENTS);
		this.#judge();
	}

	#step() {
		this.game.step();
		this.#judge();
	}

	#judge() {
		this.judged = compare(this.blocks, this.game.agents, this.reference);
		const { truth, systems } = this.judged;
		if (!(this.gameSystem in systems)) [this.gameSystem] = Object.keys(systems);
		const isExact = this.reference === CollisionBlocks.EXACT;
		const percent = (part, whole) => (whole === 0 ? "–" : `${Math.round((100 * part) / whole)} %`);
		const [right, wrong, missed, none] = (isExact ? words.outcomes : words.differences)(texts.systems[this.reference].toLowerCase());
		this.legend.replaceChildren(...Object.entries({ right, wrong, missed, none }).map(([name, text]) => h("li", { class: name }, text)));
		this.gameNote.textContent = (isExact ? words.gameNote : words.differenceNote)(AGENTS, truth.size, texts.systems[this.reference]);
		const heads = [words.system, words.found, ...(isExact ? [words.falseCount, words.missedCount] : [words.onlyIt, words.onlyOther]), words.precision, words.recall];
		this.table.replaceChildren(h("table", {}, h("thead", {}, h("tr", {}, ...heads.map((text) => h("th", { scope: "col" }, text)))),
			h("tbody", {}, ...Object.entries(systems).map(([name, pairs]) => {
				const found = pairs.right.length + pairs.wrong.length;
				const pick = h("input", { type: "radio", name: "coloured", value: name, checked: name === this.gameSystem, onchange: () => {
					this.gameSystem = name;
					this.#colour();
				} });
				return h("tr", { "data-system": name }, h("th", { scope: "row" }, h("label.tick", {}, pick, texts.systems[name])),
					...[found, pairs.wrong.length, pairs.missed.length, percent(pairs.right.length, found), percent(pairs.right.length, truth.size)].map((text) => h("td", {}, String(text))));
			}))));
		this.#colour();
	}

	/** Each pair is a line between its two, who have the colour of the worst that is said of them. */
	#colour() {
		const pairs = this.judged.systems[this.gameSystem];
		for (const agent of this.game.agents) agent.color = GAME_COLOURS.none;
		for (const outcome of ["right", "wrong", "missed"]) {
			for (const agent of pairs[outcome].flat()) agent.color = GAME_COLOURS[outcome];
			this.gameStage.wireframe(outcome, PAIR_COLOURS[outcome], true).showLines(pairs[outcome].flatMap((pair) => pair.flatMap(({ x, y, z, size }) => [x, y, z + size / 2])));
		}
		this.colourNote.textContent = words.colourBy(texts.systems[this.gameSystem]);
		this.gameStage.showAgents(this.game.agents, this.models);
	}

	close() {
		this.stage.close();
		this.gameStage.close();
	}
}
