import { Agent } from "starlogo-collision";

/** The structures that a trait names. */
export const STRUCTURES = [Agent.TIGHTEST, Agent.SPHERE, Agent.BOX, Agent.CAPSULE, Agent.HULL];
const BOOLEAN = { isValid: (value) => typeof value === "boolean", kind: "true or false" };

/** The traits: what each of them may be. */
const TRAITS = {
	hierarchical: BOOLEAN,
	depth: { isValid: (value) => Number.isInteger(value) && value >= 0 && value < 2 ** 31, kind: "a whole number, 0 or more" },
	sweeps: BOOLEAN,
	structure: { isValid: (value) => STRUCTURES.includes(value), kind: "tightest, sphere, box, capsule or hull" },
};

/** The traits that the client itself does not know. An agent's own count more than those of its breed. */
export class Traits {
	/** The traits of breeds, by their names. */
	ofBreeds = {};

	/** The own traits of agents. */
	ofAgents = new WeakMap();

	/** All traits of an agent that are set. */
	of(agent) {
		const { name } = agent.breed;
		return { ...Object.hasOwn(this.ofBreeds, name) && this.ofBreeds[name], ...this.ofAgents.get(agent) };
	}

	/** Gives an agent that one of its own breed has made the traits of that one. The client does so with the traits that it knows. */
	inherit(agent) {
		const inherited = agent.parent?.breed === agent.breed && this.ofAgents.get(agent.parent);
		if (inherited && !this.ofAgents.has(agent)) this.ofAgents.set(agent, inherited);
	}
}

/** A copy of the traits of breeds, by their names, that does not change. Throws a RangeError if one of them is wrong. */
export function checkedBreeds(breeds) {
	return Object.freeze(Object.fromEntries(entriesOf(breeds, "breeds").map(([name, traits]) => [name, checkedTraits(traits)])));
}

/** A copy of traits that does not change. Undefined ones count as left out. Throws a RangeError if one of them is wrong. */
export function checkedTraits(traits) {
	const given = entriesOf(traits, "traits").filter(([name, value]) => {
		if (!Object.hasOwn(TRAITS, name)) throw new RangeError(`the traits are ${Object.keys(TRAITS).join(", ")}, not ${name}`);
		if (value !== undefined && !TRAITS[name].isValid(value)) throw new RangeError(`${name} must be ${TRAITS[name].kind}, not ${String(value)}`);
		return value !== undefined;
	});
	return Object.freeze(Object.fromEntries(given));
}

function entriesOf(given, name) {
	given ??= {};
	if (typeof given !== "object" || Array.isArray(given)) throw new RangeError(`${name} must be an object, not ${String(given)}`);
	return Object.entries(given);
}
