/** A whole game of agents all over the ground: what each system finds in it, beside a system that is taken as right. */
import { CollisionBlocks } from "starlogo-collision";
import { grid } from "../shared/drawing/backdrop.js";
import { VERDICTS } from "../shared/drawing/colours.js";
import { button, choice, field, h, short, table } from "../shared/dom.js";
import { Lab } from "../shared/drawing/lab.js";
import { texts } from "../shared/language.js";
import { verdictsOf } from "../shared/pairs.js";
import { ScatteredGame } from "../shared/scattered.js";
import { gameTo } from "./link.js";
import { compare, timesOf } from "./results.js";
import { SYSTEMS, finderOf, titles } from "./systems.js";

const words = texts.compare;
const COUNT = 150;

export class GameSection {
	/** The system whose pairs are drawn, and the one that is taken as right. */
	system = CollisionBlocks.UNIT_SPHERES;
	reference = CollisionBlocks.EXACT;
	isShown = false;
	#frame = 0;

	/**
	 * @param {object} greatLand has the models
	 * @param {Map<string, object>} models
	 * @param {() => void} onChange called when the user has changed what is shown
	 */
	constructor(greatLand, models, onChange) {
		Object.assign(this, { greatLand, models, onChange });
		this.systemNamed = finderOf(new CollisionBlocks(greatLand, []));
		const host = h("div.world.wide");
		this.table = h("div.table");
		this.note = h("p.note", { role: "status" });
		this.colourNote = h("p.note");
		this.legend = h("ul.legend");
		this.references = choice(SYSTEMS.map((name) => [name, titles[name]]), this.reference, (name) => {
			this.reference = name;
			this.#judge();
			this.onChange();
		});
		this.element = h("section.scattered", { hidden: true, "aria-label": words.game },
			h("div.side", {}, h("div.tools", {}, h("h2", {}, words.game), field(words.reference, this.references)), this.note, this.table,
				h("div.tools", {}, button(words.next, () => this.#goOn()), button(words.another, () => {
					this.#restart();
					this.onChange();
				})),
				this.colourNote, this.legend),
			h("div.screen", {}, host));
		this.stage = new Lab(host, { label: words.gameWorld, eye: [0, -49, 154], backdrop: grid(100, 5) });
		// from this distance, outlines would hide the lines
		if (this.stage.renderer) this.stage.agents.materials.outline.visible = false;
		this.#restart();
	}

	/** Shows it, or hides it. */
	show(isShown) {
		this.element.hidden = !isShown;
		this.isShown = isShown;
		if (isShown) this.#time();
	}

	/** Shows a frame of the game. */
	open({ system, reference, frame }) {
		this.system = system;
		this.reference = this.references.value = reference;
		this.#restart(frame);
	}

	/** The address's argument for what is shown. */
	get link() {
		return gameTo(this.system, this.reference, this.#frame);
	}

	#restart(frame = 0) {
		this.game = new ScatteredGame(COUNT);
		for (this.#frame = 0; this.#frame < frame; this.#frame++) this.game.step();
		this.#judge();
	}

	#goOn() {
		this.game.step();
		this.#frame++;
		this.#judge();
		this.onChange();
	}

	#judge() {
		this.judged = compare(this.systemNamed, this.game.agents, this.reference);
		const { truth, systems } = this.judged;
		if (!(this.system in systems)) [this.system] = Object.keys(systems);
		const isExact = this.reference === CollisionBlocks.EXACT;
		const percent = (part, whole) => (whole === 0 ? "–" : `${Math.round((100 * part) / whole)} %`);
		const [right, wrong, missed, none] = (isExact ? words.outcomes : words.differences)(titles[this.reference]);
		this.legend.replaceChildren(...Object.entries({ hit: right, wrong, missed, none }).map(([name, text]) => h("li", { class: name }, text)));
		this.note.textContent = (isExact ? words.gameNote : words.differenceNote)(COUNT, truth.size, titles[this.reference]);
		const heads = [words.system, words.found, ...(isExact ? [words.falseCount, words.missedCount] : [words.onlyIt, words.onlyOther]), words.precision, words.recall, words.ms];
		this.table.replaceChildren(table(heads,
			Object.entries(systems).map(([name, pairs]) => {
				const found = pairs.hit.length + pairs.wrong.length;
				const pick = h("input", { type: "radio", name: "coloured", value: name, checked: name === this.system, onchange: () => {
					this.system = name;
					this.#colour();
					this.onChange();
				} });
				return h("tr", { "data-system": name }, h("th", { scope: "row" }, h("label.tick", {}, pick, titles[name])),
					...[found, pairs.wrong.length, pairs.missed.length, percent(pairs.hit.length, found), percent(pairs.hit.length, truth.size), "…"].map((text) => h("td", {}, String(text))));
			}),
			h("tfoot", {}, h("tr", { "data-reference": this.reference }, h("th", { scope: "row" }, titles[this.reference]), ...[truth.size, "", "", "", "", "…"].map((text) => h("td", {}, String(text)))))),
		h("p.note", {}, words.msNote));
		this.#colour();
		this.#time();
	}

	/** Shows each system's time. It is measured once, when the game is first shown. */
	async #time() {
		if (!this.isShown) return;
		this.timing ??= timesOf(this.greatLand, COUNT, () => this.element.isConnected);
		const times = await this.timing;
		for (const row of times ? this.table.querySelectorAll("[data-system], [data-reference]") : []) row.lastChild.textContent = short(times[row.dataset.system ?? row.dataset.reference]);
	}

	/** Draws each pair as a line between its agents. An agent has the colour of its worst pair. */
	#colour() {
		const judged = this.judged.systems[this.system];
		const verdicts = verdictsOf(judged);
		for (const agent of this.game.agents) agent.color = VERDICTS[verdicts.get(agent) ?? "none"];
		const signs = [];
		for (const [kind, pairs] of Object.entries(judged)) {
			const places = pairs.map((pair) => pair.map(({ x, y, z, size }) => [x, y, z + size / 2]));
			this.stage.wireframe(kind, { color: VERDICTS[kind], isOnTop: true }).showLines(places.flat(2));
			signs.push(...places.map(([a, b]) => ({ kind, x: (a[0] + b[0]) / 2, y: (a[1] + b[1]) / 2, z: (a[2] + b[2]) / 2 })));
		}
		this.stage.showSigns(signs);
		this.colourNote.textContent = words.colourBy(titles[this.system]);
		this.stage.showAgents(this.game.agents, this.models);
	}

	close() {
		this.stage.close();
	}
}
