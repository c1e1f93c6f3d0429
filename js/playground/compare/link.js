/** A scene of Compare as text for an address. */
import { SHAPES } from "../shared/names.js";
import { SYSTEMS } from "./systems.js";

const TRAITS = ["x", "y", "z", "heading", "pitch", "roll", "size"];
/** The text of a scattered game begins with this. */
const GAME = "game";
const MOST_FRAMES = 2000;
/** The largest coordinate, turn or size. */
const MOST = 360;

const systemTo = (name) => name.replaceAll(" ", "-");
const systemFrom = (text) => SYSTEMS.find((name) => systemTo(name) === text) ?? null;

/** Two agents as a system sees them. */
export const pairTo = (agents, system) => [...agents.map((agent) => [agent.shape, ...TRAITS.map((trait) => Number(agent[trait].toFixed(3)))].join("_")), systemTo(system)].join("~");

/** A scattered game: the system whose pairs are drawn, the one beside it, and the frame. */
export const gameTo = (system, reference, frame) => [GAME, systemTo(system), systemTo(reference), frame].join("~");

/**
 * The scene in a text.
 *
 * @returns {{agents: object[], system: string}|{isGame: true, system: string, reference: string, frame: number}|null} null if there is none
 */
export function sceneFrom(text) {
	const parts = text.split("~");
	if (parts[0] === GAME) {
		const [system, reference] = parts.slice(1, 3).map(systemFrom);
		const frame = Number(parts[3]);
		return system && reference && system !== reference && Number.isInteger(frame) && frame >= 0 && frame <= MOST_FRAMES ? { isGame: true, system, reference, frame } : null;
	}
	const agents = parts.slice(0, 2).map(agentFrom);
	const system = systemFrom(parts[2]);
	return parts.length === 3 && agents.every(Boolean) && system ? { agents, system } : null;
}

function agentFrom(text) {
	const [shape, ...numbers] = text.split("_");
	const values = numbers.map(Number);
	const isRight = SHAPES.includes(shape) && values.length === TRAITS.length && values.every((value) => Math.abs(value) <= MOST) && values.at(-1) > 0;
	return isRight ? { shape, ...Object.fromEntries(TRAITS.map((trait, i) => [trait, values[i]])) } : null;
}
