/** Where an agent is, how it is turned and how large: by sliders, and by the pointer. */
import { fixed, texts } from "./language.js";
import { slider } from "./dom.js";

const RANGES = { x: [-2, 2, 0.01], y: [-2, 2, 0.01], z: [-1, 3, 0.01], heading: [-180, 180, 1], pitch: [-180, 180, 1], roll: [-180, 180, 1], size: [0.2, 3, 0.01] };

/** As many as sliders have. */
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

	/** Shows how the agent is now. */
	update() {
		for (const { trait, set } of this.sliders) set(this.agent[trait]);
	}
}

/** The pointer takes an agent of a stage along the level that it stands on, as far as sliders do; onTake and onMove are told which. */
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
