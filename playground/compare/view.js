/** Compare: what each collision system says of two agents, and of a game of many. */
import { Agent, CollisionBlocks, GreatLand } from "starlogo-collision";
import { button, choice, field, h, isDark, onThemeChange } from "../shared/dom.js";
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
const COLOURS = [0x5b8def, 0xe0a030];
const HIT_COLOURS = [0x3a63c9, 0xb97a10];
const GAME_COLOURS = { none: 0xaeb8c6, right: 0x3d9a5f, wrong: 0xf0a020, missed: 0xd8435a };
/** Of lines, which stand out from the ground and the agents: by day and by night. */
const PAIR_COLOURS = { right: [0x0b5c2c, 0xa6f0c0], wrong: [0x8a5300, 0xffe7b0], missed: [0x9c0f26, 0xffc2ca] };
const AGENTS = 150;
/** A ball beneath the dragon's wing: the box says yes, and the dragon no. */
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
			await navigator.clipboard?.writeText(this.code.textContent).then(() => {
				copied.textContent = words.copied;
			}, () => {});
		});
		main.replaceChildren(
			h("section.pair", { "aria-label": words.pair },
				h("div.seen", {}, h("div.screen", {}, this.pairHost), this.verdicts),
				h("div.side", { tabindex: "-1" }, h("h2", {}, words.pair), h("p.note", {}, words.pairNote), this.meeting, ...this.agents.map((agent, i) => this.#controls(agent, i)),
					h("details.code", {}, h("summary", {}, words.code), h("pre", { tabindex: "0", "aria-label": words.code }, this.code), h("div.tools", {}, copy, copied)))),
			h("section.scattered", { "aria-label": words.game },
				h("div.side", {}, h("div.tools", {}, h("h2", {}, words.game), field(words.reference, references)), this.gameNote, this.table,
					h("div.tools", {}, button(words.next, () => this.#step()), button(words.another, () => this.#restart())),
					this.colourNote, this.legend),
				h("div.screen", {}, this.gameHost)));
		this.stage = new Lab(this.pairHost, { label: words.world, eye: [1.6, 2.35, 1.2], target: [0, 0, 0.35], ground: 6 });
		this.gameStage = new Lab(this.gameHost, { label: words.gameWorld, eye: [0, -45, 142], target: [0, 0, 0], ground: 100, cell: 5 });
		// seen from so far, outlines would hide the lines
		if (this.gameStage.renderer) this.gameStage.agents.materials.outline.visible = false;
		orbitByKeys(this.stage, this.pairHost);
		this.sight = new Sight(this.stage, greatLand, models, this.agents, CollisionBlocks.TIGHTEST_FITS);
		this.blocks = this.sight.blocks;
		this.#buildVerdicts();
		dragAgents(this.stage, (agent) => {
			this.sliders[this.agents.indexOf(agent)].update();
			this.#update();
		});
		this.forgetTheme = onThemeChange(() => this.#colour());
		this.#update();
		this.#restart();
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
		this.sight.update();
		this.sight.showTested();
		const { system } = this.sight;
		this.meeting.textContent = `${texts.systems[system]}: ${this.sight.showMeeting(a, b)}`;
		this.code.textContent = codeOf(this.agents, system, this.blocks.systemNamed(system).areColliding(a, b));
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
		const [right, wrong, missed, none] = (isExact ? words.outcomes : words.differences)(texts.systems[this.reference]);
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
			this.gameStage.wireframe(outcome, { color: PAIR_COLOURS[outcome][isDark() ? 1 : 0], isOnTop: true }).showLines(pairs[outcome].flatMap((pair) => pair.flatMap(({ x, y, z, size }) => [x, y, z + size / 2])));
		}
		this.colourNote.textContent = words.colourBy(texts.systems[this.gameSystem]);
		this.gameStage.showAgents(this.game.agents, this.models);
	}

	close() {
		this.forgetTheme();
		this.stage.close();
		this.gameStage.close();
	}
}
