/** Compare: shows which collisions each system finds, for two agents, and for a game of many. */
import { Agent, CollisionBlocks } from "starlogo-collision";
import { grid } from "../shared/drawing/backdrop.js";
import { AGENTS, TOUCHING } from "../shared/drawing/colours.js";
import { copyLink, listing } from "../shared/copying.js";
import { button, choice, field, fileButton, h, modes } from "../shared/dom.js";
import { dragAgents } from "../shared/drawing/dragging.js";
import { MODEL_FILE } from "../shared/files/files.js";
import { Lab, orbitByKeys } from "../shared/drawing/lab.js";
import { loadLand } from "../shared/files/models.js";
import { SHAPES } from "../shared/names.js";
import { offerFile, ownModels } from "../shared/files/ownmodels.js";
import { Sight } from "../shared/drawing/sight.js";
import { TraitSliders, moveWithin } from "../shared/traits.js";
import { texts } from "../shared/language.js";
import { codeOf } from "./code.js";
import { pairTo, sceneFrom } from "./link.js";
import { GameSection } from "./gamesection.js";
import { SYSTEMS, finderOf, notes, titles, useFor } from "./systems.js";

const words = texts.compare;
const COLOURS = [AGENTS.first, AGENTS.other];
/** A ball beneath the dragon's wing: it touches the dragon's box, but not the dragon. */
const BEGINNING = [{ shape: "dragon", size: 2 }, { shape: "sphere", x: 0.2, y: 0.6, z: 0.1, size: 0.2 }];

/** The address follows the scene this many milliseconds after its last change. */
const ADDRESS_DELAY = 300;

export async function createView(main, link) {
	const [{ models, greatLand }, own] = await Promise.all([loadLand(SHAPES), ownModels()]);
	const view = new CompareView(main, models, greatLand);
	view.offer(own);
	view.open(link);
	return view;
}

/** Two agents, as each system sees them, beside a whole game. */
class CompareView {
	sliders = [];
	#timer = 0;

	constructor(main, models, greatLand) {
		Object.assign(this, { main, models, greatLand });
		this.shapes = [];
		this.agents = BEGINNING.map(({ shape, ...traits }) => Object.assign(new Agent(shape), traits));
		this.agents[0].hierarchical = true;
		this.pairHost = h("div.world", { tabindex: "0", role: "application", "aria-label": words.world });
		this.verdicts = h("div.verdicts", { role: "radiogroup", "aria-label": words.shown });
		this.gameSection = new GameSection(greatLand, models, () => this.#keep());
		this.meeting = h("p.note", { role: "status" });
		this.code = h("code");
		this.shared = h("span", { role: "status" });
		this.modes = modes(words, "pair", (mode) => {
			this.#turnTo(mode);
			this.#keep();
		});
		main.replaceChildren(
			h("div.tools", {}, this.modes, button(texts.play.share, () => this.#share()), fileButton(texts.inspect.choose, ".obj,.dae,.glb,.gltf,.stl,.bin", (...files) => this.openFile(...files)), this.shared),
			this.pair = h("section.pair", { "aria-label": words.pair },
				h("div.seen", {}, h("div.screen", {}, this.pairHost), this.verdicts),
				h("div.side", { tabindex: "-1" }, h("h2", {}, words.pair), h("p.note", {}, words.pairNote), this.meeting, ...this.agents.map((agent, i) => this.#controls(agent, i)),
					listing(words.code, this.code))),
			this.gameSection.element);
		this.stage = new Lab(this.pairHost, { label: words.world, eye: [1.6, 2.35, 1.2], target: [0, 0, 0.35], backdrop: grid(6) });
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
	}

	/** Offers models to the two agents, in place of earlier ones with their names. */
	offer(models) {
		for (const [name, model] of models) {
			if (!this.models.has(name)) for (const shape of this.shapes) shape.append(h("option", { value: name }, name));
			this.models.set(name, model);
			this.greatLand.addModel(model);
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
		this.pair.hidden = mode !== "pair";
		for (const pick of this.modes.querySelectorAll("input")) pick.checked = pick.value === mode;
		this.gameSection.show(mode !== "pair");
	}

	/** Shows the scene in an address. Without one it stays as it is. */
	open(link) {
		const scene = sceneFrom(link, (shape) => this.models.has(shape));
		if (!scene) return;
		this.#turnTo(scene.isGame ? "game" : "pair");
		if (scene.isGame) {
			this.gameSection.open(scene);
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
		return this.gameSection.isShown ? this.gameSection.link : pairTo(this.agents, this.system);
	}

	/** Puts the scene into the address, so that it is there when the page is loaded again. */
	#keep() {
		clearTimeout(this.#timer);
		// browsers refuse many changes of the address in a short time
		this.#timer = setTimeout(() => history.replaceState(null, "", `#compare/${this.#link}`), ADDRESS_DELAY);
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

	close() {
		clearTimeout(this.#timer);
		this.stage.close();
		this.gameSection.close();
	}
}
