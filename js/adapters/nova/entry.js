/** An agent of the client, and the engine's agent that stands for it. */
import { Agent } from "starlogo-collision";

/** The client's bins are ten patches wide, ten to a side. */
const BIN_WIDTH = 10;
const LAST_BIN = 9;

/** The engine's agent of an entry. */
class Body extends Agent {
	constructor(entry, shape) {
		super(shape);
		this.entry = entry;
	}
}

/** What is kept of an agent while it can collide; the agent's jbins has it. */
export class Entry {
	// of Cells
	cell = -1;
	slot = -1;

	// where the client would look for it first: its lowest bin, and its turn in it
	binX = 0;
	binY = 0;
	turn = 0;

	// of the agent's place in the client's list; of what getCollisions has found for it
	index = -1;
	keys = [];
	others = [];

	// the breed whose traits the body has; the Collisions that it is in
	traitsOf = null;
	owner = null;

	/** An entry of an agent; `shape` is a model that is always there. */
	constructor(agent, shape) {
		this.agent = agent;
		this.body = new Body(this, shape);
	}

	/** Remembers where and in which turn the client would bin the agent. */
	bin(half, turn) {
		const { x, y, size } = this.agent.state;
		this.binX = lowestBin(x - size / 2 + half);
		this.binY = lowestBin(y - size / 2 + half);
		this.turn = turn;
	}

	/** Keeps another agent that it has been found with, in the order of the keys. */
	keep(other, key) {
		const { keys, others } = this;
		let place = keys.length;
		while (place > 0 && keys[place - 1] > key) place--;
		if (place === keys.length) {
			keys.push(key);
			others.push(other);
		} else {
			keys.splice(place, 0, key);
			others.splice(place, 0, other);
		}
	}
}

function lowestBin(coordinate) {
	return Math.min(LAST_BIN, Math.max(0, Math.floor(coordinate / BIN_WIDTH)));
}

/** The first bin that two entries share is the earlier the smaller this is. */
export function firstSharedBin(a, b) {
	return Math.max(a.binX, b.binX) * (LAST_BIN + 1) + Math.max(a.binY, b.binY);
}
