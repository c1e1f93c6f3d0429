/** A scene of Compare as text for an address. */
import { SYSTEMS } from "./systems.js";

const TRAITS = ["x", "y", "z", "heading", "pitch", "roll", "size"];
/** The text of a scattered game begins with this. */
const GAME = "game";
const MOST_FRAMES = 2000;
/** The largest coordinate, turn or size. */
const MOST = 360;

const systemTo = (name) => name.replaceAll(" ", "-");
const systemFrom = (text) => SYSTEMS.find((name) => systemTo(name) === text) ?? null;

/** A model's name without the signs that part the text. */
const nameTo = (name) => encodeURIComponent(name).replaceAll("_", "%5F").replaceAll("~", "%7E");
function nameFrom(text) {
	try {
		return decodeURIComponent(text);
	} catch {
		return text;
	}
}

/** Two agents as a system sees them. */
export const pairTo = (agents, system) => [...agents.map((agent) => [nameTo(agent.shape), ...TRAITS.map((trait) => Number(agent[trait].toFixed(3)))].join("_")), systemTo(system)].join("~");

/** A scattered game: the system whose pairs are drawn, the one beside it, and the frame. */
export const gameTo = (system, reference, frame) => [GAME, systemTo(system), systemTo(reference), frame].join("~");

/**
 * The scene in a text.
 *
 * @param {string} text
 * @param {(shape: string) => boolean} isModel whether there is a model with a name
 * @returns {{agents: object[], system: string}|{isGame: true, system: string, reference: string, frame: number}|null} null if there is none
 */
export function sceneFrom(text, isModel) {
	const parts = text.split("~");
	if (parts[0] === GAME) {
		const [system, reference] = parts.slice(1, 3).map(systemFrom);
		const frame = Number(parts[3]);
		return system && reference && system !== reference && Number.isInteger(frame) && frame >= 0 && frame <= MOST_FRAMES ? { isGame: true, system, reference, frame } : null;
	}
	const agents = parts.slice(0, 2).map((each) => agentFrom(each, isModel));
	const system = systemFrom(parts[2]);
	return parts.length === 3 && agents.every(Boolean) && system ? { agents, system } : null;
}

function agentFrom(text, isModel) {
	const [name, ...numbers] = text.split("_");
	const shape = nameFrom(name);
	const values = numbers.map(Number);
	const isRight = isModel(shape) && values.length === TRAITS.length && values.every((value) => Math.abs(value) <= MOST) && values.at(-1) > 0;
	return isRight ? { shape, ...Object.fromEntries(TRAITS.map((trait, i) => [trait, values[i]])) } : null;
}
