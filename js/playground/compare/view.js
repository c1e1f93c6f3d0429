/** Compare: shows which collisions each system finds, for two agents, and for a game of many. */
import { Agent, CollisionBlocks, GreatLand } from "starlogo-collision";
import { AGENTS, TOUCHING, VERDICTS } from "../shared/colours.js";
import { button, choice, field, h } from "../shared/dom.js";
import { Lab } from "../shared/lab.js";
import { loadModel } from "../shared/models.js";
import { SHAPES } from "../shared/names.js";
import { Sight } from "../shared/sight.js";
import { orbitByKeys } from "../shared/stage.js";
import { TraitSliders, dragAgents } from "../shared/traits.js";
import { texts } from "../shared/language.js";
import { codeOf } from "./code.js";
import { ScatteredGame, compare } from "./game.js";

const words = texts.compare;
const COLOURS = [AGENTS.first, AGENTS.other];
const COUNT = 150;
/** The kinds of pairs, with their colours' names. */
const KINDS = { right: "hit", wrong: "wrong", missed: "missed" };
/** A ball beneath the dragon's wing: it touches the dragon's box, but not the dragon. */
const BEGINNING = [{ shape: "dragon", size: 2 }, { shape: "sphere", x: 0.2, y: 0.6, z: 0.1, size: 0.2 }];

export async function createView(main) {
	const models = new Map(await Promise.all(SHAPES.map(async (name) => [name, await loadModel(name)])));
	const greatLand = new GreatLand();
	for (const model of models.values()) greatLand.addModel(model);
	return new CompareView(main, models, greatLand);
}

class CompareView {
	sliders = [];

	constructor(main, models, greatLand) {
		this.models = models;
		this.agents = BEGINNING.map(({ shape, ...traits }) => Object.assign(new Agent(shape), traits));
		this.agents[0].hierarchical = true;
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
		this.code = h("code");
		const copied = h("span", { role: "status" });
		const copy = button(words.copy, async () => {
			try {
				await navigator.clipboard.writeText(this.code.textContent);
				copied.textContent = words.copied;
			} catch {
				getSelection().selectAllChildren(this.code);
				copied.textContent = words.notCopied;
			}
		});
		const listing = h("details.code", {}, h("summary", {}, words.code), h("div.tools", {}, copy, copied), h("pre", { tabindex: "0", "aria-label": words.code }, this.code));
		main.replaceChildren(
			this.#modes(main),
			h("section.pair", { "aria-label": words.pair },
				h("div.seen", {}, h("div.screen", {}, this.pairHost), this.verdicts),
				h("div.side", { tabindex: "-1" }, h("h2", {}, words.pair), h("p.note", {}, words.pairNote), this.meeting, ...this.agents.map((agent, i) => this.#controls(agent, i)),
					listing)),
			h("section.scattered", { hidden: true, "aria-label": words.game },
				h("div.side", {}, h("div.tools", {}, h("h2", {}, words.game), field(words.reference, references)), this.gameNote, this.table,
					h("div.tools", {}, button(words.next, () => this.#step()), button(words.another, () => this.#restart())),
					this.colourNote, this.legend),
				h("div.screen", {}, this.gameHost)));
		this.stage = new Lab(this.pairHost, { label: words.world, eye: [1.6, 2.35, 1.2], target: [0, 0, 0.35], ground: 6 });
		this.gameStage = new Lab(this.gameHost, { label: words.gameWorld, eye: [0, -45, 142], target: [0, 0, 0], ground: 100, cell: 5 });
		// from this distance, outlines would hide the lines
		if (this.gameStage.renderer) this.gameStage.agents.materials.outline.visible = false;
		orbitByKeys(this.stage, this.pairHost);
		this.sight = new Sight(this.stage, greatLand, models, this.agents, CollisionBlocks.TIGHTEST_FITS);
		this.blocks = this.sight.blocks;
		this.#buildVerdicts();
		dragAgents(this.stage, (agent) => {
			this.sliders[this.agents.indexOf(agent)].update();
			this.#update();
		});
		this.#update();
		this.#restart();
	}

	/** Shows either two agents or a whole game. Each has the window to itself. */
	#modes(main) {
		return h("div.modes", { role: "radiogroup", "aria-label": words.mode }, ...Object.entries(words.modes).map(([name, text]) => h("label.tick", {},
			h("input", { type: "radio", name: "mode", value: name, checked: name === "pair", onchange: () => {
				main.querySelector(".pair").hidden = name !== "pair";
				main.querySelector(".scattered").hidden = name === "pair";
			} }), text)));
	}

	#controls(agent, i) {
		const letter = "AB"[i];
		const shape = choice(SHAPES.map((name) => [name, texts.shapes[name]]), agent.shape, (name) => {
			agent.shape = name;
			this.#update();
		});
		const sliders = new TraitSliders(agent, () => this.#update());
		this.sliders.push(sliders);
		return h("details", { open: i === 1, name: "agent" }, h("summary", {}, words.agent(letter)), field(words.shape, shape), ...sliders.elements);
	}

	#buildVerdicts() {
		this.rows = CollisionBlocks.systemNames.map((name) => {
			const verdict = h("strong");
			const pick = h("input", { type: "radio", name: "shown", value: name, checked: name === this.sight.system, onchange: () => {
				this.sight.use(name);
				this.#update();
			} });
			const row = h("label.verdict", {}, pick, h("span", {}, texts.systems[name], h("small", {}, texts.systemNotes[name]), verdict));
			return { name, row, verdict };
		});
		this.verdicts.replaceChildren(...this.rows.map(({ row }) => row));
	}

	/** Updates the answers and the picture. */
	#update() {
		const [a, b] = this.agents;
		const truth = this.blocks.systemNamed(CollisionBlocks.EXACT).areColliding(a, b);
		for (const { name, row, verdict } of this.rows) {
			const answer = this.blocks.systemNamed(name).areColliding(a, b);
			const isRight = answer === truth;
			row.dataset.verdict = isRight ? (answer ? "hit" : "none") : answer ? "wrong" : "missed";
			verdict.textContent = { hit: words.hit, none: words.miss, wrong: words.falseHit, missed: words.missed }[row.dataset.verdict];
			row.classList.toggle("differs", !isRight);
		}
		this.agents.forEach((agent, i) => {
			agent.color = (truth ? TOUCHING : COLOURS)[i];
		});
		this.sight.update();
		this.sight.showTested();
		const { system } = this.sight;
		this.meeting.textContent = `${texts.systems[system]}: ${this.sight.showMeeting(a, b)}`;
		this.code.textContent = codeOf(this.agents, system, this.blocks.systemNamed(system).areColliding(a, b));
	}

	#restart() {
		this.game = new ScatteredGame(COUNT);
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
		const [right, wrong, missed, none] = (isExact ? words.outcomes : words.differences)(texts.systems[this.reference]);
		this.legend.replaceChildren(...Object.entries({ hit: right, wrong, missed, none }).map(([name, text]) => h("li", { class: name }, text)));
		this.gameNote.textContent = (isExact ? words.gameNote : words.differenceNote)(COUNT, truth.size, texts.systems[this.reference]);
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

	/** Draws each pair as a line between its agents. An agent has the colour of its worst pair. */
	#colour() {
		const pairs = this.judged.systems[this.gameSystem];
		for (const agent of this.game.agents) agent.color = VERDICTS.none;
		const signs = [];
		for (const [outcome, kind] of Object.entries(KINDS)) {
			for (const agent of pairs[outcome].flat()) agent.color = VERDICTS[kind];
			const places = pairs[outcome].map((pair) => pair.map(({ x, y, z, size }) => [x, y, z + size / 2]));
			this.gameStage.wireframe(outcome, { color: VERDICTS[kind], isOnTop: true }).showLines(places.flat(2));
			signs.push(...places.map(([a, b]) => ({ kind, x: (a[0] + b[0]) / 2, y: (a[1] + b[1]) / 2, z: (a[2] + b[2]) / 2 })));
		}
		this.gameStage.showSigns(signs);
		this.colourNote.textContent = words.colourBy(texts.systems[this.gameSystem]);
		this.gameStage.showAgents(this.game.agents, this.models);
	}

	close() {
		this.stage.close();
		this.gameStage.close();
	}
}
