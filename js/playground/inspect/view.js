/** Inspect: shows a model, the structures around it, and their costs. */
import { Agent, Model } from "starlogo-collision";
import { grid } from "../shared/drawing/backdrop.js";
import { AGENTS, LINES, OWN_COLOURS } from "../shared/drawing/colours.js";
import { button, checkBox, choice, field, fileButton, h, modes, short, slider, table } from "../shared/dom.js";
import { Lab, orbitByKeys } from "../shared/drawing/lab.js";
import { heightOf, loadModel } from "../shared/files/models.js";
import { openModel, ownModels } from "../shared/files/ownmodels.js";
import { MODELS } from "../shared/names.js";
import { texts } from "../shared/language.js";
import { Requests } from "../shared/requests.js";
import { depthOf, measure, nodesAt } from "./fits.js";

const words = texts.inspect;
const FIRST = "bear";

export async function createView(main) {
	const view = new InspectView(main);
	ownModels().then((models) => view.offer(models));
	await view.choose(FIRST);
	return view;
}

class InspectView {
	settings = { increment: 10, minVertices: 5, byMean: false };
	#loads = new Requests();
	#measurements = new Requests();
	/** Tells whether the shown model is still the last one that was asked for. */
	#isNewestLoad = () => true;
	#chosen = "";
	#files = new Map();
	#shown = null;
	#levelShown = false;
	#level = 3;
	/** The questions, which load when they are first wanted. */
	questions = null;

	constructor(main) {
		this.worldHost = h("div.world", { tabindex: "0", role: "application", "aria-label": words.world });
		this.models = choice(MODELS.map((name) => [name, texts.shapes[name]]), FIRST, (name) => this.choose(name));
		this.up = choice(Object.entries(words.ups), "z", () => this.loaded && this.#show());
		this.turned = 0;
		this.upHint = h("p.note.up-hint", { hidden: true }, words.upHint);
		this.status = h("p.status", { role: "status" });
		this.results = h("div.results");
		this.structures = h("div.sheets", {}, this.results, this.#settingsForm());
		main.replaceChildren(
			h("section.picture", { "aria-label": words.picture },
				h("div.tools", {}, field(words.model, this.models), field(words.up, this.up),
					button(words.turn, () => {
						this.turned = (this.turned + 1) % 4;
						if (this.loaded) this.#show();
					}),
					fileButton(words.choose, ".obj,.dae,.glb,.gltf,.stl,.bin", (...files) => this.openFile(...files)), h("small.hint.drop", {}, words.drop)),
				this.upHint,
				h("div.saying", {}, this.status), h("div.screen", {}, this.worldHost)),
			h("section.facts", { "aria-label": words.structures }, modes(words, "structures", (mode) => this.#turnTo(mode)), this.structures));
		this.stage = new Lab(this.worldHost, { label: words.world, eye: [1.7, -2.3, 1.5], target: [0, 0, 0.5], backdrop: grid(4) });
		orbitByKeys(this.stage, this.worldHost);
		this.facts = main.querySelector(".facts");
	}

	/** Shows either the structures around the model or the questions. */
	async #turnTo(mode) {
		this.structures.hidden = mode === "questions";
		if (this.structures.hidden && !this.questions) {
			const { Questions } = await import("./questions.js");
			this.questions ??= new Questions(this.stage);
			this.facts.append(this.questions.element);
		}
		if (this.questions) this.questions.element.hidden = !this.structures.hidden;
		this.#showModel();
	}

	#settingsForm() {
		const input = (name, properties) => h("input", { type: "number", value: this.settings[name], onchange: (event) => {
			this.settings[name] = Number(event.target.value);
		}, ...properties });
		return h("form.card", { onsubmit: (event) => {
			event.preventDefault();
			this.#measure();
		} }, h("h2", {}, words.settings),
		field(words.increment, input("increment", { min: 1, max: 90, step: "any" }), words.incrementNote),
		field(words.minVertices, input("minVertices", { min: 1, max: 10000, step: 1 })),
		checkBox(words.byMean, false, (on) => {
			this.settings.byMean = on;
		}),
		h("button.primary", { type: "submit" }, words.apply));
	}

	/** Adds models to the menu. */
	offer(models) {
		for (const [title, model] of models) {
			const name = `file ${title}`;
			if (!this.#files.has(name)) this.models.append(h("option", { value: name }, title));
			this.#files.set(name, model);
		}
	}

	/** Shows a model of the game, or of a file that was opened before. */
	async choose(name) {
		const file = this.#files.get(name);
		await this.#load(name, texts.shapes[name] ?? name.replace(/^file /, ""), () => file ?? loadModel(name));
	}

	async openFile(file, files = [file]) {
		if (/\.json$/i.test(file.name) && await this.#refusedAsProgram(file)) return;
		const name = `file ${file.name}`;
		await this.#load(name, file.name, async () => {
			const model = await openModel(file, files);
			this.offer([[file.name, model]]);
			return model;
		}, words.kinds);
	}

	/** If a file is a program or a pupil's work, says so, with the way to where it opens. Returns whether it was one. */
	async #refusedAsProgram(file) {
		const { isProgram, isWork, packed } = await import("../shared/files/packing.js");
		try {
			const { models, ...program } = JSON.parse(await file.text());
			if (isWork(program)) this.#say(texts.play.isWork(file.name), true);
			else if (isProgram(program)) {
				this.#say(words.isProgram(file.name), true);
				const link = await packed({ name: file.name.replace(/\.json$/i, ""), ...program });
				this.status.append(" ", h("a", { href: `#play/${link}` }, words.openInPlay));
			} else return false;
			return true;
		} catch {
			return false;
		}
	}

	async #load(name, title, read, hint = "") {
		const isNewest = this.#isNewestLoad = this.#loads.begin();
		this.#say(words.working(title));
		try {
			const loaded = await read();
			if (!isNewest()) return;
			Object.assign(this, { loaded, title });
			this.#chosen = name;
			this.up.value = "z";
			this.turned = 0;
			this.upHint.hidden = !this.#files.has(name);
			await this.#show();
		} catch (error) {
			if (isNewest()) this.#say(`${texts.brokenModel(title, error.message)} ${hint}`, true);
		}
		this.models.value = this.#chosen;
	}

	async #show() {
		this.model = withUp(this.loaded, this.up.value, this.turned);
		this.#shown = null;
		this.found = null;
		this.#showModel();
		await this.#measure();
	}

	/** Shows the model and the chosen structure, or all agents of the questions, once the model is measured. */
	#showModel() {
		const { model } = this;
		if (!model) return;
		this.questions?.close();
		const agent = new Agent(model.name);
		agent.color = this.#files.has(this.#chosen) && model.colours ? OWN_COLOURS : AGENTS.first;
		this.stage.showAgents([agent], new Map([[model.name, model]]));
		const height = heightOf(model);
		this.stage.frame([0, 0, height / 2], Math.hypot(0.6, height / 2));
		this.stage.clearLines("structure", "level");
		if (this.found && this.structures.hidden) this.questions?.open(model, this.found.greatLand);
		else if (this.found) this.#drawLines();
	}

	async #measure() {
		const { model, title } = this;
		if (!model) return;
		const isNewestLoad = this.#isNewestLoad;
		const isWanted = this.#measurements.begin();
		const say = (...what) => isNewestLoad() && this.#say(...what);
		say(words.working(title));
		this.results.setAttribute("aria-busy", "true");
		try {
			const found = await measure(model, this.settings, isWanted);
			if (!isWanted()) return;
			this.found = found;
			this.#shown ??= found.chosen;
			this.#tell();
			if (this.structures.hidden) this.#showModel();
			say(words.vertices(title, model.vertices.length / 3, (model.triangles?.length ?? 0) / 3));
		} catch (error) {
			if (isWanted()) say(words.wrongSetting + error.message, true);
		}
		if (isWanted()) this.results.removeAttribute("aria-busy");
	}

	#tell() {
		const { rows, chosen, root, hullMs, hierarchyMs, volume } = this.found;
		const levels = depthOf(root);
		const least = Math.min(...rows.map((row) => row.volume));
		const note = h("p.note");
		const tellLevel = (level) => {
			this.#level = level;
			note.textContent = words.levelNote(nodesAt(root, level), levels, short(hierarchyMs));
			this.#drawLines();
		};
		const start = Math.min(this.#level, levels);
		const level = slider(words.level, { min: 1, max: levels, step: 1, value: start }, tellLevel);
		this.results.replaceChildren(
			h("div.card", {}, h("h2", {}, words.structures),
				h("div.table", {}, table([words.show, words.volume, words.emptier, words.time], rows.map((row) => this.#row(row, least, volume)))),
				h("p.note", {}, Number.isNaN(volume) ? words.openNote : words.emptierNote(short(volume)), " ", words.timeNote(short(hullMs)), " ", words.chosen(words.fitters[chosen]))),
			h("div.card", {}, h("h2", {}, words.hierarchy),
				checkBox(words.showLevel, this.#levelShown, (on) => {
					this.#levelShown = on;
					this.#drawLines();
				}), level.element, note));
		tellLevel(start);
	}

	#row(row, least, volume) {
		const pick = h("input", { type: "radio", name: "structure", value: row.name, checked: row.name === this.#shown, onchange: () => {
			this.#shown = row.name;
			this.#drawLines();
		} });
		const isSmallest = row.volume === least;
		return h(isSmallest ? "tr.smallest" : "tr", {},
			h("th", { scope: "row" }, h("label.tick", {}, pick, h("span", {}, words.fitters[row.name], ...(isSmallest ? [" ", h("span.badge", {}, words.smallest)] : [])))),
			h("td", {}, short(row.volume)), h("td", {}, short(row.volume / volume)), h("td", {}, short(row.ms)));
	}

	#drawLines() {
		const { rows, root } = this.found;
		this.stage.wireframe("structure", { color: LINES.tested }).showStructure(rows.find(({ name }) => name === this.#shown).structure);
		const levels = this.stage.wireframe("level", { color: LINES.level });
		if (this.#levelShown) levels.showLevel(root, this.#level);
	}

	#say(text, isProblem = false) {
		this.status.textContent = text;
		this.status.classList.toggle("problem", isProblem);
	}

	close() {
		this.#loads.begin();
		this.#measurements.begin();
		this.stage.close();
	}
}

/**
 * The place of a model's point if another axis is up. The engine turns files in the same way. If the axis points down, the model is then
 * turned over.
 */
const UPS = { z: ([x, y, z]) => [x, y, z], y: ([x, y, z]) => [x, -z, y], x: ([x, y, z]) => [-y, -z, x] };

/** A model with another axis up, and turned about it by some quarters. */
function withUp(model, axis, quarters) {
	if (axis === "z" && quarters === 0) return model;
	const { name, vertices, triangles } = model;
	const turned = [];
	for (let i = 0; i < vertices.length; i += 3) {
		let [x, y, z] = UPS[axis.at(-1)](vertices.slice(i, i + 3));
		if (axis.startsWith("-")) [y, z] = [-y, -z];
		for (let k = 0; k < quarters; k++) [x, y] = [-y, x];
		turned.push(x, y, z);
	}
	return Object.assign(new Model(name, turned, triangles), { colours: model.colours });
}
