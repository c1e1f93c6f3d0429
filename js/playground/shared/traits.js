/** Sliders for an agent's place, turns and size. */
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
			const made = slider(texts.traits[trait], { min, max, step, value: agent[trait], format: (value) => fixed(value, step < 1 ? DECIMALS : 0) }, (value) => {
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

/** Moves an agent to a place, within the sliders' limits. */
export function moveWithin(agent, x, y) {
	for (const [axis, wanted] of [["x", x], ["y", y]]) {
		const [min, max] = RANGES[axis];
		agent[axis] = Number(Math.min(max, Math.max(min, wanted)).toFixed(DECIMALS));
	}
}
