import { Agent } from "starlogo-collision";

/** The client has ten bins per side, each ten patches wide. */
const BIN_WIDTH = 10;
const LAST_BIN = 9;

/** The engine's Agent for an agent of the client. */
class EngineAgent extends Agent {
	constructor(record, shape) {
		super(shape);
		this.record = record;
	}
}

/** The data of an agent of the client while it can collide. The agent's jbins refers to it. */
export class AgentRecord {
	// set by Cells
	cell = -1;
	slot = -1;

	// where the client would look for it first: its lowest bin, and its turn in that bin
	binX = 0;
	binY = 0;
	turn = 0;

	// its place in the client's list; then the results of getCollisions for it
	index = -1;
	keys = [];
	others = [];

	// the breed whose traits the engine's Agent has; the Installation that contains the record
	breedOfTraits = null;
	owner = null;

	/** Creates a record of an agent. `shape` is a model that always exists. */
	constructor(clientAgent, shape) {
		this.clientAgent = clientAgent;
		this.engineAgent = new EngineAgent(this, shape);
	}

	/** Stores the bin and the turn that the client would give the agent. */
	setBin(half, turn) {
		const { x, y, size } = this.clientAgent.state;
		this.binX = lowestBin(x - size / 2 + half);
		this.binY = lowestBin(y - size / 2 + half);
		this.turn = turn;
	}

	/** Adds another record with which it was found, in the order of the keys. */
	insertSorted(other, key) {
		const { keys, others } = this;
		let place = keys.length;
		while (place > 0 && keys[place - 1] > key) place--;
		keys.splice(place, 0, key);
		others.splice(place, 0, other);
	}
}

function lowestBin(coordinate) {
	return Math.min(LAST_BIN, Math.max(0, Math.floor(coordinate / BIN_WIDTH)));
}

/** A number for the first bin that two records share. The client visits bins with smaller numbers first. */
export function firstSharedBin(a, b) {
	return Math.max(a.binX, b.binX) * (LAST_BIN + 1) + Math.max(a.binY, b.binY);
}
