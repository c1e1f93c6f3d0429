/** Inspect: a model, what can be put around it, and what that costs. */
import { Agent, Wireframes } from "starlogo-collision";
import { button, choice, field, fileButton, h, short, slider, tick } from "../shared/dom.js";
import { loadModel, parseModel } from "../shared/models.js";
import { MODELS } from "../shared/names.js";
import { Stage, orbitByKeys } from "../shared/stage.js";
import { texts } from "../texts.js";
import { depthOf, measure, nodesAt } from "./measure.js";

const words = texts.inspect;
const FIRST = "bear";
const LINES = 0xff8a00;
const LEVEL_LINES = 0x12a594;
const MODEL_COLOUR = 0x8fa6c8;

export async function createView(main) {
	const view = new InspectView(main);
	await view.choose(FIRST);
	return view;
}

class InspectView {
	settings = { increment: 10, tolerance: 1, minVertices: 5, byMean: false };
	#turn = 0;
	#drop = new AbortController();
	#shown = null;
	#levelShown = false;
	#level = 3;

	constructor(main) {
		this.worldHost = h("div.world", { tabindex: "0", role: "application", "aria-label": words.world });
		this.models = choice(MODELS.map((name) => [name, texts.shapes[name]]), FIRST, (name) => this.choose(name));
		this.status = h("p.status", { role: "status" });
		this.results = h("div.results");
		main.replaceChildren(
			h("section.picture", { "aria-label": words.picture },
				h("div.tools", {}, field(words.model, this.models), fileButton(words.choose, ".obj,.dae,.zae,.glb,.gltf,.stl", (file) => this.openFile(file)), h("small.hint", {}, words.drop)),
				this.status, h("div.screen", {}, this.worldHost)),
			h("section.facts", { "aria-label": words.structures }, this.results, this.#settingsForm()));
		this.stage = new Stage(this.worldHost, { label: words.world, eye: [1.7, -2.3, 1.5], target: [0, 0, 0.5], ground: 4 });
		orbitByKeys(this.stage, this.worldHost);
		this.#listenForFiles(main);
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
		field(words.tolerance, input("tolerance", { min: 1, max: 100, step: "any" }), words.toleranceNote),
		field(words.minVertices, input("minVertices", { min: 1, max: 10000, step: 1 })),
		tick(words.byMean, false, (on) => {
			this.settings.byMean = on;
		}),
		h("button.primary", { type: "submit" }, words.apply));
	}

	#listenForFiles(main) {
		const { signal } = this.#drop;
		addEventListener("dragover", (event) => {
			event.preventDefault();
			main.classList.add("dropping");
		}, { signal });
		addEventListener("dragleave", (event) => {
			if (!event.relatedTarget) main.classList.remove("dropping");
		}, { signal });
		addEventListener("drop", (event) => {
			event.preventDefault();
			main.classList.remove("dropping");
			const [file] = event.dataTransfer.files;
			if (file) this.openFile(file);
		}, { signal });
	}

	async choose(name) {
		const turn = ++this.#turn;
		this.#say(words.working(texts.shapes[name]));
		const model = await loadModel(name);
		if (turn === this.#turn) await this.#show(model);
	}

	async openFile(file) {
		const turn = ++this.#turn;
		if (!/\.(obj|dae|zae|glb|gltf|stl)$/i.test(file.name)) {
			this.#say(words.wrongKind(file.name), true);
			return;
		}
		this.#say(words.working(file.name));
		try {
			const model = parseModel(file.name, file.name, new Uint8Array(await file.arrayBuffer()));
			if (turn === this.#turn) await this.#show(model);
		} catch (error) {
			this.#say(`${words.broken} ${error.message}`, true);
		}
	}

	async #show(model) {
		this.model = model;
		this.#shown = null;
		const agent = new Agent(model.name);
		agent.color = MODEL_COLOUR;
		this.stage.showAgents([agent], new Map([[model.name, model]]));
		const height = model.vertices.reduce((most, value, i) => (i % 3 === 2 ? Math.max(most, value) : most), 0);
		this.stage.frame([0, 0, height / 2], Math.hypot(0.6, height / 2));
		await this.#measure();
	}

	async #measure() {
		const turn = ++this.#turn;
		const { model } = this;
		this.#say(words.working(texts.shapes[model.name] ?? model.name));
		this.results.setAttribute("aria-busy", "true");
		try {
			const found = await measure(model, this.settings);
			if (turn !== this.#turn) return;
			this.found = found;
			this.#shown ??= found.chosen;
			this.#tell();
			this.#say(words.vertices(model.vertices.length / 3, (model.triangles?.length ?? 0) / 3));
		} catch (error) {
			if (turn === this.#turn) this.#say(words.wrongSetting + error.message, true);
		}
		this.results.removeAttribute("aria-busy");
	}

	#tell() {
		const { rows, chosen, root, hierarchyMs, volume } = this.found;
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
				h("div.table", {}, h("table", {},
					h("thead", {}, h("tr", {}, ...[words.show, words.volume, words.emptier, words.time].map((text) => h("th", { scope: "col" }, text)))),
					h("tbody", {}, ...rows.map((row) => this.#row(row, least, volume))))),
				h("p.note", {}, Number.isNaN(volume) ? words.openNote : words.emptierNote(short(volume)), " ", words.chosen(words.fitters[chosen].toLowerCase()))),
			h("div.card", {}, h("h2", {}, words.hierarchy),
				tick(words.showLevel, this.#levelShown, (on) => {
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
		const isTightest = row.volume === least;
		return h(isTightest ? "tr.tightest" : "tr", {},
			h("th", { scope: "row" }, h("label.tick", {}, pick, words.fitters[row.name], isTightest ? h("span.badge", {}, words.tightest) : null)),
			h("td", {}, short(row.volume)), h("td", {}, short(row.volume / volume)), h("td", {}, short(row.ms)));
	}

	#drawLines() {
		const { rows, root } = this.found;
		this.stage.showLines("structure", Wireframes.ofStructure(rows.find(({ name }) => name === this.#shown).structure), LINES);
		this.stage.showLines("level", this.#levelShown ? Wireframes.ofLevel(root, this.#level) : [], LEVEL_LINES);
	}

	#say(text, isProblem = false) {
		this.status.textContent = text;
		this.status.classList.toggle("problem", isProblem);
	}

	close() {
		this.#turn++;
		this.#drop.abort();
		this.stage.close();
	}
}
