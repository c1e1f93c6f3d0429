import { Agent } from "starlogo-collision";

/** The names of the traits. */
const TRAITS = ["hierarchical", "depth", "sweeps", "structure"];

/** The traits that the client itself does not know. An agent's own count more than those of its breed. */
export class Traits {
	/** The traits of breeds, by their names. */
	ofBreeds = new Map();

	/** The own traits of agents. */
	ofAgents = new WeakMap();

	/** All traits of an agent that are set. */
	of(agent) {
		return { ...this.ofBreeds.get(agent.breed.name), ...this.ofAgents.get(agent) };
	}

	/** Whether an agent has own traits, and among them these. */
	hasAll(agent, traits) {
		const own = this.ofAgents.get(agent);
		return Boolean(own) && Object.keys(traits).every((name) => own[name] === traits[name]);
	}

	/** Gives an agent that one of its own breed has made the traits of that one. The client does so with the traits that it knows. */
	inherit(agent) {
		const inherited = agent.parent?.breed === agent.breed && this.ofAgents.get(agent.parent);
		if (inherited && !this.ofAgents.has(agent)) this.ofAgents.set(agent, inherited);
	}
}

/** A copy of traits. Throws a RangeError if one of them is wrong. */
export function checkTraits(traits) {
	for (const name of Object.keys(traits)) if (!TRAITS.includes(name)) throw new RangeError(`the traits are ${TRAITS.join(", ")}, not ${name}`);
	const { depth = 0, structure = Agent.TIGHTEST } = traits;
	if (!(Number.isInteger(depth) && depth >= 0)) throw new RangeError(`depth must be a whole number, 0 or more, not ${depth}`);
	if (![Agent.TIGHTEST, Agent.SPHERE, Agent.BOX, Agent.CAPSULE, Agent.HULL].includes(structure)) throw new RangeError(`structure must be tightest, sphere, box, capsule or hull, not ${structure}`);
	return { ...traits };
}
