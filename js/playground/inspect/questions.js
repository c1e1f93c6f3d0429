/** Questions about the space around a model, asked with the pointer and answered in the picture. */
import { Agent, AgentQueries, CollisionBlocks, RayHit, Vector3D } from "starlogo-collision";
import { AGENTS, LINES, VERDICTS } from "../shared/drawing/colours.js";
import { checkBox, choice, field, h, short, slider } from "../shared/dom.js";
import { STILL, dragAgents } from "../shared/drawing/dragging.js";
import { loadModel } from "../shared/files/models.js";
import { SHAPES } from "../shared/names.js";
import { Requests } from "../shared/requests.js";
import { Sight, placeText } from "../shared/drawing/sight.js";
import { TraitSliders, moveWithin } from "../shared/traits.js";
import { texts } from "../shared/language.js";

const words = texts.questions;
const RAY = { color: LINES.ray, isOnTop: true };
const NEAREST = { color: LINES.distance, isOnTop: true };
const MOST = 8;
const FIRST_SHAPE = "sphere";
/** The reach of the pointer's ray. Nothing is farther away. */
const REACH = 8;
const SIZE = 0.6;
/** The first of the others stands to the left of the model, so that the gap between the two is in sight. */
const FIRST_ANGLE = (7 * Math.PI) / 6;

export class Questions {
	sight = null;
	#hit = new RayHit();
	#isKept = false;
	/** The ray of the last question. If an agent moves, a kept answer is computed again. */
	#ray = null;
	#shape = FIRST_SHAPE;
	#count = 3;
	#system = CollisionBlocks.EXACT;
	#isTestedShown = false;
	#requests = new Requests();

	/** @param {object} stage its pointer asks */
	constructor(stage) {
		this.stage = stage;
		this.answers = Object.fromEntries(Object.keys(words.answers).map((name) => [name, h("dd", {}, words.ask)]));
		this.who = h("select", { onchange: () => this.isOpen && this.#choose(this.sight.agents[Number(this.who.value)]) });
		this.traits = h("div", {});
		this.element = h("div.sheets", { hidden: true },
			h("div.card", {}, h("h2", {}, words.title), h("p.note", {}, words.how),
				h("div", { role: "status" }, h("dl.answers", {}, ...Object.entries(words.answers).map(([name, text]) => h("div", { class: name }, h("dt", {}, text), this.answers[name]))))),
			h("div.card", {}, h("h2", {}, words.scene),
				field(words.system, choice(CollisionBlocks.systemNames.map((name) => [name, texts.systems[name]]), this.#system, (name) => {
					this.#system = name;
					this.sight?.use(name);
					this.#update();
				})),
				checkBox(words.tested, false, (isOn) => {
					this.#isTestedShown = isOn;
					this.#update();
				}),
				field(words.others, choice(SHAPES.map((name) => [name, texts.shapes[name]]), FIRST_SHAPE, (name) => {
					this.#shape = name;
					this.#populate();
				})),
				slider(words.count, { min: 1, max: MOST, step: 1, value: this.#count }, (count) => {
					this.#count = count;
					this.#populate();
				}).element,
				field(words.who, this.who), this.traits));
		dragAgents(stage, {
			mayDrag: () => this.isOpen,
			onTake: (agent) => this.#choose(agent),
			onMove: (agent, x, y) => {
				moveWithin(agent, x, y);
				this.#update();
			},
		});
		if (stage.renderer) this.#listen(stage.canvas);
	}

	/** Whether there is a model to ask about. */
	get isOpen() {
		return this.sight !== null;
	}

	/** Puts a model of the land in the middle, and others around it. */
	async open(model, greatLand) {
		Object.assign(this, { model, greatLand });
		this.stage.frame([0, 0, 0.5], 1.8);
		await this.#populate();
	}

	/** Removes everything that it drew. */
	close() {
		this.#requests.begin();
		this.sight = null;
		this.stage.showDepth(null);
		this.stage.tell("");
		this.stage.clearLines("ray", "nearest", "meeting", "tested");
	}

	async #populate() {
		if (!this.model) return;
		const isNewest = this.#requests.begin();
		const { model, greatLand } = this;
		const other = await loadModel(this.#shape);
		if (!isNewest()) return;
		// a user's file may have the name of a model of the game
		if (!greatLand.hasModel(other.name)) greatLand.addModel(other);
		const agents = [new Agent(model.name)];
		for (let i = 0; i < this.#count; i++) {
			const agent = new Agent(other.name);
			const angle = FIRST_ANGLE + (2 * Math.PI * i) / this.#count;
			agent.moveTo(1.2 * Math.cos(angle), 1.2 * Math.sin(angle), 0);
			agent.size = SIZE;
			agents.push(agent);
		}
		this.sight = new Sight(this.stage, greatLand, new Map([[other.name, other], [model.name, model]]), agents, this.#system, AgentQueries);
		this.who.replaceChildren(...agents.map((agent, i) => h("option", { value: i }, this.#nameOf(agent))));
		this.#isKept = false;
		this.#choose(agents[1]);
	}

	/** The name of an agent: the model's name, or the other models' names with a number. */
	#nameOf(agent) {
		const i = this.sight.agents.indexOf(agent);
		return i === 0 ? texts.shapes[agent.shape] ?? agent.shape : words.other(texts.shapes[agent.shape], i);
	}

	#choose(agent) {
		this.chosen = agent;
		this.who.value = this.sight.agents.indexOf(agent);
		this.sliders = new TraitSliders(agent, () => this.#update());
		this.traits.replaceChildren(...this.sliders.elements);
		this.#update();
	}

	/** Takes all agents' present places, and says how far the chosen one and its neighbour are apart. */
	#update() {
		const { sight, chosen } = this;
		if (!sight) return;
		const { queries, agents: [middle] } = sight;
		queries.update(sight.agents);
		for (const agent of sight.agents) agent.color = queries.touching(agent).length > 0 ? VERDICTS.hit : agent === middle ? AGENTS.first : AGENTS.other;
		sight.update();
		sight.showTested(this.#isTestedShown);
		this.sliders.update();
		const other = chosen === middle ? queries.nearest(middle) : middle;
		this.answers.meeting.textContent = `${this.#nameOf(chosen)}, ${this.#nameOf(other)}: ${sight.showMeeting(chosen, other)}`;
		if (this.#isKept) this.#ask(this.#ray);
		else this.#forgetRay();
	}

	#forgetRay() {
		this.stage.clearLines("ray", "nearest");
		for (const name of ["ray", "nearest"]) this.answers[name].textContent = words.ask;
	}

	#listen(canvas) {
		let down = null;
		canvas.addEventListener("pointerdown", (event) => {
			down = event;
		});
		canvas.addEventListener("pointermove", (event) => {
			if (this.isOpen && event.buttons === 0 && !this.#isKept) this.#ask(this.stage.rayAt(event));
		});
		canvas.addEventListener("pointerup", (event) => {
			if (!this.isOpen || !down || Math.hypot(event.clientX - down.clientX, event.clientY - down.clientY) >= STILL) return;
			this.#isKept = !this.#isKept;
			this.#ask(this.stage.rayAt(event));
		});
		// without a pointer, the ray goes through the middle of the picture
		this.stage.host.addEventListener("keydown", (event) => {
			if (!this.isOpen || event.key !== "Enter") return;
			const box = canvas.getBoundingClientRect();
			this.#isKept = true;
			this.#ask(this.stage.rayAt({ clientX: box.left + box.width / 2, clientY: box.top + box.height / 2 }));
		});
	}

	/** Finds the first agent on a ray, and the agent whose place is nearest to the ray's end. */
	#ask({ origin, direction }) {
		this.#ray = { origin: origin.clone(), direction: direction.clone() };
		const { queries } = this.sight;
		const [from, along] = [origin, direction].map(({ x, y, z }) => new Vector3D(x, y, z));
		const hit = queries.cast(from, along, Infinity, null, this.#hit);
		const ray = this.stage.wireframe("ray", RAY);
		if (hit) ray.showRay(from, along, 1, hit);
		const isKept = this.#isKept ? words.kept : "";
		this.answers.ray.textContent = (hit ? words.hit(this.#nameOf(hit.agent), short(hit.distance), placeText(hit.point), placeText(hit.normal)) : words.noHit) + isKept;
		const ground = -origin.z / direction.z;
		const point = hit ? hit.point : ground > 0 ? new Vector3D(origin.x + ground * direction.x, origin.y + ground * direction.y, 0) : null;
		const agent = point && Math.hypot(point.x, point.y) < REACH ? queries.nearestToPoint(point) : null;
		const nearest = this.stage.wireframe("nearest", NEAREST);
		if (agent) nearest.showLines([point.x, point.y, point.z, agent.x, agent.y, agent.z]);
		this.answers.nearest.textContent = agent
			? words.nearest(this.#nameOf(agent), short(Math.hypot(agent.x - point.x, agent.y - point.y, agent.z - point.z)), placeText(point)) : words.noNearest;
	}
}
