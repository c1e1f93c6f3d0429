/** Controls for an agent's place, turns and size: sliders, and the pointer. */
import { fixed, texts } from "./language.js";
import { slider } from "./dom.js";

const RANGES = { x: [-2, 2, 0.01], y: [-2, 2, 0.01], z: [-1, 3, 0.01], heading: [-180, 180, 1], pitch: [-180, 180, 1], roll: [-180, 180, 1], size: [0.2, 3, 0.01] };

/** The number of decimals of the sliders. */
const DECIMALS = 2;

/** Sliders for an agent's traits, each with its element. */
export class TraitSliders {
	constructor(agent, onChange) {
		this.agent = agent;
		this.sliders = Object.entries(RANGES).map(([trait, [min, max, step]]) => {
			const made = slider(texts.traits[trait], { min, max, step, value: agent[trait], format: (value) => fixed(value, step < 1 ? 2 : 0) }, (value) => {
				agent[trait] = value;
				onChange();
			});
			return { trait, ...made };
		});
	}

	get elements() {
		return this.sliders.map(({ element }) => element);
	}

	/** Shows the agent's present traits. */
	update() {
		for (const { trait, set } of this.sliders) set(this.agent[trait]);
	}
}

/**
 * Lets the pointer drag a stage's agents on the level on which they stand, within the sliders' limits. onTake and onMove are called with
 * the agent.
 */
export function dragAgents(stage, onMove, onTake = () => {}) {
	if (!stage.renderer) return;
	const { canvas, controls } = stage;
	let held = null;
	canvas.addEventListener("pointerdown", (event) => {
		const agent = stage.agentAt(event);
		const from = agent && stage.pointAt(event, agent.z);
		if (!from) return;
		held = { agent, x: agent.x - from.x, y: agent.y - from.y };
		controls.enabled = false;
		canvas.setPointerCapture(event.pointerId);
		onTake(agent);
	}, { capture: true });
	canvas.addEventListener("pointermove", (event) => {
		canvas.classList.toggle("grab", held !== null || stage.agentAt(event) !== null);
		const to = held && stage.pointAt(event, held.agent.z);
		if (!to) return;
		for (const axis of ["x", "y"]) {
			const [min, max] = RANGES[axis];
			held.agent[axis] = Number(Math.min(max, Math.max(min, to[axis] + held[axis])).toFixed(DECIMALS));
		}
		onMove(held.agent);
	});
	const drop = () => {
		held = null;
		controls.enabled = true;
	};
	canvas.addEventListener("pointerup", drop);
	canvas.addEventListener("pointercancel", drop);
}
