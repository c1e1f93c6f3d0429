/** A game of up to 20,000 agents that runs: its world, the parts of its frames, and kdbush and Rapier beside the engine. */
import KDBush from "kdbush";
import { Collision, CollisionBlocks } from "starlogo-collision";
import { CAST, HALF_WIDTH, ScatteredGame } from "../shared/scattered.js";
import { VERDICTS } from "../shared/drawing/colours.js";
import { button, checkBox, choice, field, h, short, slider } from "../shared/dom.js";
import { Figures } from "../shared/figures.js";
import { failure, texts } from "../shared/language.js";
import { Loop } from "../shared/loop.js";
import { offerFile } from "../shared/files/ownmodels.js";
import { loadRapier } from "../shared/files/served.js";
import { Crowd, DRAWN } from "./crowd.js";
import { Parts } from "./parts.js";

const words = texts.measure.live;
const COUNTS = [100, 200, 500, 1000, 2000, 5000, 10000, 20000];
const FIRST = 1000;
/** The number of agents on a ground of the usual width. The ground grows with their number. */
const USUAL = 150;
/** The others are asked in each frame of so many, one after the other, so that the game goes on. */
const SELDOM = 6;
/** The figures are shown after so many frames. */
const SHOWN_AFTER = 12;
const PARTS = ["move", "engine", "draw"];
const OTHERS = ["kdbush", "rapier"];

const parts = (colour) => [(colour >> 16) / 255, ((colour >> 8) & 255) / 255, (colour & 255) / 255];
const COLOURS = [parts(VERDICTS.hit), parts(VERDICTS.none)];

export class Live {
	#loop = new Loop(() => {
		this.#step();
		if (this.#frame % SHOWN_AFTER === 0) this.#show();
	});
	#frame = 0;
	#system = CollisionBlocks.TIGHTEST_FITS;
	#count = FIRST;
	#cast = CAST;
	#isDrawn = true;
	#isBeside = false;
	/** For each agent, by its id, the number of the last frame in which it touched another one; and the first id. */
	#touched = new Uint32Array(0);
	#first = 0;
	#pairs = 0;
	/** The pairs that the engine and the others have found, in the last frame in which all were asked. Who has not been asked yet has no entry. */
	#found = {};
	/** Rapier, once it is loaded, and its world. */
	#library = null;
	rapier = null;

	constructor(greatLand) {
		this.greatLand = greatLand;
		this.runButton = button(words.run, () => (this.#loop.isRunning ? this.stop() : this.run()), { class: "primary" });
		this.host = h("div.world.unplayed", { onclick: () => this.host.classList.contains("unplayed") && this.run() });
		this.said = h("small.hint", { role: "status" });
		this.canvas = h("canvas.parts", { role: "img", "aria-label": words.graph });
		this.parts = new Parts(this.canvas, PARTS, OTHERS, words);
		this.figures = new Figures(words.figures, (name) => ({ class: `part-${name}` }));
		const count = slider(words.count, { min: 0, max: COUNTS.length - 1, step: 1, value: COUNTS.indexOf(FIRST), format: (i) => COUNTS[i].toLocaleString(texts.code) }, (i) => {
			this.#count = COUNTS[i];
			this.#begin();
		});
		count.element.classList.add("count");
		const systems = choice(CollisionBlocks.systemNames.map((name) => [name, texts.systems[name]]), this.#system, (name) => {
			this.#system = name;
			this.#begin();
		});
		this.models = choice([["", words.six]], "", (name) => {
			this.#cast = name === "" ? CAST : [name];
			this.#begin();
		});
		this.element = h("div.live", {},
			h("div.tools", {}, this.runButton, count.element, field(words.system, systems), field(words.models, this.models),
				checkBox(words.drawn, true, (isOn) => {
					this.#isDrawn = isOn;
					this.host.parentElement.hidden = !isOn;
					this.scene.classList.toggle("alone", !isOn);
					this.parts.draw();
				}), checkBox(words.beside, false, (isOn) => {
					this.#isBeside = isOn;
					delete this.#found.near;
					this.parts.clear();
					if (!this.#loop.isRunning) this.#show();
				}), loadRapier ? checkBox(words.besideRapier, false, (isOn) => this.#putRapier(isOn)) : null, this.said),
			this.scene = h("div.scene", {}, h("div.screen", {}, this.host),
				h("div.times", {}, this.figures.element,
					this.canvas, this.busy = h("p.busy", { role: "status", hidden: true }, texts.measure.busy),
					h("p.note", {}, words.note), h("details", {}, h("summary", {}, words.more), ...words.details.map((each) => h("p.note", {}, each))))));
	}

	/** Shows the world at its beginning. Called when the element is on the page. */
	open() {
		this.crowd ??= new Crowd(this.host, words.world);
		this.#begin();
	}

	/** Offers models instead of the six, in place of earlier ones with their names. */
	offer(models) {
		for (const [name, model] of models) {
			if (!this.greatLand.boundingStructures.has(name)) this.models.append(h("option", { value: name }, name));
			this.greatLand.addModel(model);
		}
	}

	/** Lets all agents have the model in a file. */
	async openFile(file, files) {
		if (!await offerFile(this, this.said, file, files)) return;
		this.models.value = file.name;
		this.#cast = [file.name];
		this.#begin();
	}

	/** Begins the game anew, with the present number of agents and system. */
	#begin() {
		const count = this.#count;
		this.halfWidth = HALF_WIDTH * Math.sqrt(count / USUAL);
		this.game = new ScatteredGame(count, this.halfWidth, this.#cast);
		this.#touched = new Uint32Array(count);
		this.#first = this.game.agents[0].id;
		const blocks = new CollisionBlocks(this.greatLand, this.game.agents);
		blocks.useCollisionSystem(this.#system);
		blocks.onCollision(Collision.ANY_BREED, Collision.ANY_BREED, (a, b) => {
			this.#touched[a.id - this.#first] = this.#frame;
			if (a.id < b.id) this.#pairs++;
		});
		this.collision = blocks.collision;
		this.parts.clear();
		this.crowd?.prepare(count);
		this.#found = {};
		this.#furnishRapier();
		this.#step();
		// the browser has not compiled anything yet
		this.parts.clear();
		if (!this.#loop.isRunning) this.#show();
	}

	/** Puts Rapier beside the engine, or takes it away. It loads with the first time. */
	async #putRapier(isOn) {
		this.isRapierWanted = isOn;
		if (isOn && !this.#library) {
			this.said.textContent = texts.loading;
			try {
				const library = await loadRapier();
				await library.ready();
				this.#library = library;
				this.said.textContent = "";
			} catch (error) {
				this.said.textContent = failure(error);
			}
		}
		this.parts.clear();
		this.#furnishRapier();
		if (!this.#loop.isRunning) this.#show();
	}

	#furnishRapier() {
		this.rapier?.close();
		delete this.#found.inRapier;
		this.rapier = this.isRapierWanted && this.#library ? new this.#library.RapierWorld(this.greatLand, this.game.agents) : null;
	}

	run() {
		this.host.classList.remove("unplayed");
		this.parts.clear();
		this.runButton.textContent = words.stop;
		this.#loop.run();
	}

	stop() {
		// the figures are those of the world that is in sight
		if (this.#loop.isRunning) this.#compare();
		this.#loop.stop();
		this.runButton.textContent = words.run;
		this.#show();
	}

	/** Does a frame, and measures its parts. */
	#step() {
		const { game: { agents }, parts: graph } = this;
		const times = [performance.now()];
		const part = () => times.push(performance.now()) && times.at(-1) - times.at(-2);
		const frame = {};
		this.game.step();
		frame.move = part();
		this.#frame++;
		this.#pairs = 0;
		this.collision.update(agents);
		frame.engine = part();
		if (this.#isDrawn) this.crowd?.draw(agents, DRAWN / (2 * this.halfWidth), COLOURS, (agent) => this.#touched[agent.id - this.#first] === this.#frame);
		frame.draw = part();
		if (this.#frame % SELDOM === 0) this.#compare(frame, part);
		graph.add(frame);
	}

	/**
	 * Asks the others too. All of the figures are then of this frame, so that they can be compared.
	 *
	 * @param {Object} frame receives the times of the others
	 * @param {() => number} part the time since its last call
	 */
	#compare(frame = {}, part = () => 0) {
		this.#found = { pairs: this.#pairs };
		if (this.#isBeside) {
			this.#found.near = nearIn(this.game.agents);
			frame.kdbush = part();
		}
		if (this.rapier) {
			this.rapier.pairs();
			frame.rapier = part();
			// not measured: it only makes the figure one of the same frame
			this.#found.inRapier = this.rapier.settled();
		}
	}

	#show() {
		const { leasts, isBusy } = this.parts;
		this.busy.hidden = !isBusy;
		this.parts.draw();
		const { pairs, near, inRapier } = this.#found;
		const counts = Object.entries({ pairs: pairs ?? this.#pairs, near, inRapier }).map(([name, value]) => [name, value?.toLocaleString(texts.code) ?? "–"]);
		const others = { ...!this.#isBeside && { kdbush: null, near: null }, ...!this.rapier && { rapier: null, inRapier: null } };
		this.figures.show({ ...Object.fromEntries([...Object.entries(leasts).map(([name, ms]) => [name, short(ms)]), ...counts]), ...others });
	}

	close() {
		this.#loop.stop();
		// it may still load
		this.isRapierWanted = false;
		this.rapier?.close();
		this.crowd?.close();
	}
}

/** The pairs whose places are near enough to touch, as kdbush finds them in an index that is built anew. */
function nearIn(agents) {
	const index = new KDBush(agents.length);
	for (const { x, y } of agents) index.add(x, y);
	index.finish();
	let pairs = 0;
	agents.forEach(({ x, y, size }, i) => {
		for (const other of index.within(x, y, size)) if (other > i) pairs++;
	});
	return pairs;
}
