/** The switch “Build”, its brushes, and buttons that change the agent that was clicked. With all of them the program changes. */
import { button, checkBox, h } from "../../shared/dom.js";
import { paintGround } from "./painting.js";
import { texts } from "../../shared/language.js";

const words = texts.play.building;
/** Places are whole and half patches. */
const GRID = 2;
const snapped = (coordinate) => Math.round(coordinate * GRID) / GRID;
/** The angle of a turn, in degrees; the patches of a step up, and of a copy to the side. */
const [TURN, STEP, ASIDE] = [45, 0.5, 2];

export class BuildBar {
	isOn = false;
	brush = "agents";
	/** The block whose agent is chosen again when the game has begun anew. */
	#kept = null;

	/**
	 * @param {{world: object, scene: object, stage: object, layout: object, editor: object, isRunning: boolean, reset: () => void, showGround: () => void,
	 * draw: () => void, say: (text: string) => void}} view
	 */
	constructor(view) {
		this.view = view;
		this.checkBox = checkBox(words.build, false, (on) => {
			this.isOn = on;
			if (on && (view.isRunning || view.world.frame > 0)) view.reset();
			this.element.hidden = !on;
			this.#useBrush("agents");
		});
		/** What the pointer does in the world: it moves agents, raises or lowers the ground, or builds walls. */
		this.brushes = h("div.brushes", { role: "group", "aria-label": words.brush },
			...Object.entries(words.brushes).map(([name, text]) => button(text, () => this.#useBrush(name), { "data-brush": name })));
		const tool = (name, action) => button(words[name], () => this.#with(action), { "data-tool": name });
		/** What changes the agent that was clicked. Its place is kept free, so that the world stays as high when one is clicked. */
		this.changes = h("div.build-bar", { role: "group", "aria-label": words.build },
			tool("copy", (building, id, { x, y, z }) => building.copy(id, snapped(x + (x > 0 ? -ASIDE : ASIDE)), snapped(y), z)),
			tool("turn", (building, id, { heading }) => building.turn(id, (heading + TURN) % 360)),
			tool("up", (building, id, { x, y, z }) => building.move(id, x, y, z + STEP)),
			tool("down", (building, id, { x, y, z }) => building.move(id, x, y, Math.max(0, z - STEP))),
			tool("remove", (building, id) => building.remove(id)));
		this.element = h("div.builders", { hidden: true }, this.brushes, this.changes);
	}

	/** Listens to the world's stage, before all others do. */
	listen(stage) {
		paintGround(stage, () => (this.isOn ? this.brush : "agents"), () => this.view.editor.building);
	}

	/** Takes a brush. All but the one for agents need the whole ground in sight, and a camera that stays. */
	#useBrush(brush) {
		const { view } = this;
		this.brush = brush;
		for (const each of this.brushes.children) each.setAttribute("aria-pressed", String(each.dataset.brush === brush));
		const isPainting = this.isOn && brush !== "agents";
		view.scene.isStill = isPainting;
		view.scene.chosen = isPainting ? null : view.scene.chosen;
		if (view.stage.canvas) view.stage.canvas.style.touchAction = isPainting ? "none" : "pan-y";
		if (isPainting) view.showGround();
		if (this.isOn) {
			view.layout.dragNote.hidden = true;
			view.say(words.how[brush]);
		}
		view.draw();
	}

	/** Whether an agent is at its beginning, and a block of its own says where that is. */
	has(agent) {
		return this.isOn && this.view.world.frame === 0 && Boolean(this.view.editor?.building.has(agent.maker));
	}

	/** Called when the user has moved an agent. Returns whether its block has been changed. */
	moved(agent) {
		if (!this.has(agent)) return false;
		this.#kept = agent.maker;
		this.view.editor.building.move(agent.maker, snapped(agent.x), snapped(agent.y), agent.z);
		return true;
	}

	#with(action) {
		const { editor, scene: { chosen } } = this.view;
		if (!chosen || !this.has(chosen)) return;
		this.#kept = chosen.maker;
		const copy = action(editor.building, chosen.maker, chosen);
		if (typeof copy === "string") this.#kept = copy;
	}

	/** Called when the game has begun anew: the same agent is chosen. */
	begin() {
		if (this.isOn && this.#kept) this.view.scene.chosen = this.view.world.agents.find(({ maker }) => maker === this.#kept) ?? null;
	}

	/** Shows the buttons while an agent is chosen that they can change. */
	show() {
		const { chosen } = this.view.scene;
		this.changes.classList.toggle("away", !(chosen && this.has(chosen)));
	}
}
