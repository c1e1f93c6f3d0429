/** Compare: shows which collisions each system finds, for two agents, and for a game of many. */
import { Agent, CollisionBlocks } from "starlogo-collision";
import { grid } from "../shared/backdrop.js";
import { AGENTS, TOUCHING, VERDICTS } from "../shared/colours.js";
import { copyLink, listing } from "../shared/copying.js";
import { button, choice, field, fileButton, h, modes, short } from "../shared/dom.js";
import { dragAgents } from "../shared/dragging.js";
import { MODEL_FILE } from "../shared/files.js";
import { Lab, orbitByKeys } from "../shared/lab.js";
import { loadLand } from "../shared/models.js";
import { SHAPES } from "../shared/names.js";
import { offerFile, ownModels } from "../shared/ownmodels.js";
import { Sight } from "../shared/sight.js";
import { ScatteredGame } from "../shared/scattered.js";
import { TraitSliders, moveWithin } from "../shared/traits.js";
import { texts } from "../shared/language.js";
import { codeOf } from "./code.js";
import { compare, timesOf } from "./results.js";
import { gameTo, pairTo, sceneFrom } from "./link.js";
import { HULLS, SYSTEMS, finderOf, useFor } from "./systems.js";

const words = texts.compare;
const titles = { ...texts.systems, [HULLS]: words.hulls };
const notes = { ...texts.systemNotes, [HULLS]: words.hullsNote };
const COLOURS = [AGENTS.first, AGENTS.other];
const COUNT = 150;
/** The kinds of pairs, with their colours' names. */
const KINDS = { right: "hit", wrong: "wrong", missed: "missed" };
/** A ball beneath the dragon's wing: it touches the dragon's box, but not the dragon. */
const BEGINNING = [{ shape: "dragon", size: 2 }, { shape: "sphere", x: 0.2, y: 0.6, z: 0.1, size: 0.2 }];

/** The address follows the scene this many milliseconds after its last change. */
const LATE = 300;

export async function createView(main, link) {
	const [{ models, greatLand }, own] = await Promise.all([loadLand(SHAPES), ownModels()]);
	const view = new CompareView(main, models, greatLand);
	view.offer(own);
	view.open(link);
	return view;
}

class CompareView {
	sliders = [];
	#frame = 0;
	#timer = 0;

	constructor(main, models, greatLand) {
		Object.assign(this, { main, models, greatLand });
		this.shapes = [];
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
		this.references = choice(SYSTEMS.map((name) => [name, titles[name]]), this.reference, (name) => {
			this.reference = name;
			this.#judge();
			this.#keep();
		});
		this.meeting = h("p.note", { role: "status" });
		this.code = h("code");
		this.shared = h("span", { role: "status" });
		this.modes = modes(words, "pair", (mode) => {
			this.#turnTo(mode);
			this.#keep();
		});
		main.replaceChildren(
			h("div.tools", {}, this.modes, button(texts.play.share, () => this.#share()), fileButton(texts.inspect.choose, ".obj,.dae,.glb,.gltf,.stl,.bin", (...files) => this.openFile(...files)), this.shared),
			h("section.pair", { "aria-label": words.pair },
				h("div.seen", {}, h("div.screen", {}, this.pairHost), this.verdicts),
				h("div.side", { tabindex: "-1" }, h("h2", {}, words.pair), h("p.note", {}, words.pairNote), this.meeting, ...this.agents.map((agent, i) => this.#controls(agent, i)),
					listing(words.code, this.code))),
			h("section.scattered", { hidden: true, "aria-label": words.game },
				h("div.side", {}, h("div.tools", {}, h("h2", {}, words.game), field(words.reference, this.references)), this.gameNote, this.table,
					h("div.tools", {}, button(words.next, () => this.#step()), button(words.another, () => {
						this.#restart();
						this.#keep();
					})),
					this.colourNote, this.legend),
				h("div.screen", {}, this.gameHost)));
		this.stage = new Lab(this.pairHost, { label: words.world, eye: [1.6, 2.35, 1.2], target: [0, 0, 0.35], backdrop: grid(6) });
		this.gameStage = new Lab(this.gameHost, { label: words.gameWorld, eye: [0, -49, 154], target: [0, 0, 0], backdrop: grid(100, 5) });
		// from this distance, outlines would hide the lines
		if (this.gameStage.renderer) this.gameStage.agents.materials.outline.visible = false;
		orbitByKeys(this.stage, this.pairHost);
		this.sight = new Sight(this.stage, greatLand, models, this.agents, CollisionBlocks.TIGHTEST_FITS);
		this.system = this.sight.system;
		this.systemNamed = finderOf(this.sight.blocks);
		this.#buildVerdicts();
		dragAgents(this.stage, {
			onMove: (agent, x, y) => {
				moveWithin(agent, x, y);
				this.sliders[this.agents.indexOf(agent)].update();
				this.#change();
			},
		});
		this.#update();
		this.#restart();
	}

	/** Offers further models to the two agents. */
	offer(models) {
		for (const [name, model] of models) {
			if (this.models.has(name)) continue;
			this.models.set(name, model);
			this.greatLand.addModel(model);
			for (const shape of this.shapes) shape.append(h("option", { value: name }, name));
		}
	}

	/** Whether a dropped file is for this view. */
	takes({ name }) {
		return MODEL_FILE.test(name);
	}

	/** Gives agent A the model in a file. */
	async openFile(file, files) {
		if (!await offerFile(this, this.shared, file, files)) return;
		this.shapes[0].value = this.agents[0].shape = file.name;
		this.#turnTo("pair");
		this.#change();
	}

	/** Shows either two agents or a whole game. Each has the window to itself. */
	#turnTo(mode) {
		this.main.querySelector(".pair").hidden = mode !== "pair";
		this.main.querySelector(".scattered").hidden = mode === "pair";
		for (const pick of this.modes.querySelectorAll("input")) pick.checked = pick.value === mode;
		this.isGame = mode !== "pair";
		if (this.isGame) this.#time();
	}

	/** Shows the scene in an address. Without one it stays as it is. */
	open(link) {
		const scene = sceneFrom(link, (shape) => this.models.has(shape));
		if (!scene) return;
		this.#turnTo(scene.isGame ? "game" : "pair");
		if (scene.isGame) {
			this.gameSystem = scene.system;
			this.reference = this.references.value = scene.reference;
			this.game = new ScatteredGame(COUNT);
			for (this.#frame = 0; this.#frame < scene.frame; this.#frame++) this.game.step();
			this.#judge();
			return;
		}
		this.agents.forEach((agent, i) => {
			Object.assign(agent, scene.agents[i]);
			this.shapes[i].value = agent.shape;
			this.sliders[i].update();
		});
		this.#use(scene.system);
		for (const { row, name } of this.rows) row.firstChild.checked = name === scene.system;
		this.#update();
	}

	get #link() {
		return this.isGame ? gameTo(this.gameSystem, this.reference, this.#frame) : pairTo(this.agents, this.system);
	}

	/** Puts the scene into the address, so that it is there when the page is loaded again. */
	#keep() {
		clearTimeout(this.#timer);
		// browsers refuse many changes of the address in a short time
		this.#timer = setTimeout(() => history.replaceState(null, "", `#compare/${this.#link}`), LATE);
	}

	async #share() {
		const place = await copyLink(`compare/${this.#link}`);
		this.shared.replaceChildren(place ?? texts.play.shared);
		place?.select();
	}

	#controls(agent, i) {
		const letter = "AB"[i];
		const shape = choice(SHAPES.map((name) => [name, texts.shapes[name]]), agent.shape, (name) => {
			agent.shape = name;
			this.#change();
		});
		this.shapes.push(shape);
		const sliders = new TraitSliders(agent, () => this.#change());
		this.sliders.push(sliders);
		return h("details", { open: i === 1, name: "agent" }, h("summary", {}, words.agent(letter)), field(words.shape, shape), ...sliders.elements);
	}

	#buildVerdicts() {
		this.rows = SYSTEMS.map((name) => {
			const verdict = h("strong");
			const pick = h("input", { type: "radio", name: "shown", value: name, checked: name === this.system, onchange: () => {
				this.#use(name);
				this.#change();
			} });
			const row = h("label.verdict", {}, pick, h("span", {}, titles[name], h("small", {}, notes[name]), verdict));
			return { name, row, verdict };
		});
		this.verdicts.replaceChildren(...this.rows.map(({ row }) => row));
	}

	/** Called when the user has changed the scene of two agents. */
	#change() {
		this.#update();
		this.#keep();
	}

	/** Updates the answers and the picture. */
	#update() {
		const [a, b] = this.agents;
		const truth = this.systemNamed(CollisionBlocks.EXACT).areColliding(a, b);
		for (const { name, row, verdict } of this.rows) {
			const answer = this.systemNamed(name).areColliding(a, b);
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
		const { system } = this;
		const meeting = this.sight.showMeeting(a, b);
		if (meeting === null) this.sight.load().then(() => this.#update());
		this.meeting.textContent = `${titles[system]}: ${meeting ?? "…"}`;
		this.code.textContent = codeOf(this.agents, system, this.systemNamed(system).areColliding(a, b));
	}

	/** Chooses the system whose tests are shown for two agents. */
	#use(name) {
		this.system = name;
		this.sight.use(useFor(this.agents, name));
	}

	#restart() {
		this.game = new ScatteredGame(COUNT);
		this.#frame = 0;
		this.#judge();
	}

	#step() {
		this.game.step();
		this.#frame++;
		this.#judge();
		this.#keep();
	}

	#judge() {
		this.judged = compare(this.systemNamed, this.game.agents, this.reference);
		const { truth, systems } = this.judged;
		if (!(this.gameSystem in systems)) [this.gameSystem] = Object.keys(systems);
		const isExact = this.reference === CollisionBlocks.EXACT;
		const percent = (part, whole) => (whole === 0 ? "–" : `${Math.round((100 * part) / whole)} %`);
		const [right, wrong, missed, none] = (isExact ? words.outcomes : words.differences)(titles[this.reference]);
		this.legend.replaceChildren(...Object.entries({ hit: right, wrong, missed, none }).map(([name, text]) => h("li", { class: name }, text)));
		this.gameNote.textContent = (isExact ? words.gameNote : words.differenceNote)(COUNT, truth.size, titles[this.reference]);
		const heads = [words.system, words.found, ...(isExact ? [words.falseCount, words.missedCount] : [words.onlyIt, words.onlyOther]), words.precision, words.recall, words.ms];
		this.table.replaceChildren(h("table", {}, h("thead", {}, h("tr", {}, ...heads.map((text) => h("th", { scope: "col" }, text)))),
			h("tbody", {}, ...Object.entries(systems).map(([name, pairs]) => {
				const found = pairs.right.length + pairs.wrong.length;
				const pick = h("input", { type: "radio", name: "coloured", value: name, checked: name === this.gameSystem, onchange: () => {
					this.gameSystem = name;
					this.#colour();
					this.#keep();
				} });
				return h("tr", { "data-system": name }, h("th", { scope: "row" }, h("label.tick", {}, pick, titles[name])),
					...[found, pairs.wrong.length, pairs.missed.length, percent(pairs.right.length, found), percent(pairs.right.length, truth.size), "…"].map((text) => h("td", {}, String(text))));
			})),
			h("tfoot", {}, h("tr", { "data-reference": this.reference }, h("th", { scope: "row" }, titles[this.reference]), ...[truth.size, "", "", "", "", "…"].map((text) => h("td", {}, String(text)))))),
		h("p.note", {}, words.msNote));
		this.#colour();
		this.#time();
	}

	/** Shows each system's time. It is measured once, when the game is first shown. */
	async #time() {
		if (!this.isGame) return;
		this.timing ??= timesOf(this.greatLand, COUNT, () => this.main.isConnected);
		const times = await this.timing;
		for (const row of times ? this.table.querySelectorAll("[data-system], [data-reference]") : []) row.lastChild.textContent = short(times[row.dataset.system ?? row.dataset.reference]);
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
		this.colourNote.textContent = words.colourBy(titles[this.gameSystem]);
		this.gameStage.showAgents(this.game.agents, this.models);
	}

	close() {
		clearTimeout(this.#timer);
		this.stage.close();
		this.gameStage.close();
	}
}
