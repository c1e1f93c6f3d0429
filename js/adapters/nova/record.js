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

	// where the client would look for it first: its lowest bin, and the number of its last update, because a bin has its agents in that order
	binX = 0;
	binY = 0;
	sequence = 0;

	// its place in the client's list
	index = -1;

	/** Creates a record of an agent. `shape` is a model that always exists. */
	constructor(clientAgent, shape) {
		this.clientAgent = clientAgent;
		this.engineAgent = new EngineAgent(this, shape);
	}

	/** Stores the bin that the client would give the agent, and the number of this update. */
	setBin(half, sequence) {
		const { x, y, size } = this.clientAgent.state;
		this.binX = lowestBin(x - size / 2 + half);
		this.binY = lowestBin(y - size / 2 + half);
		this.sequence = sequence;
	}
}

function lowestBin(coordinate) {
	return Math.min(LAST_BIN, Math.max(0, Math.floor(coordinate / BIN_WIDTH)));
}

/** A pair of records that collide, at the first place where the client would find it. */
export class FoundPair {
	/** Creates one. The client would find `other` in the bins of `finder`, for the breed of this rank in the finder's block. */
	constructor(finder, other, rank) {
		this.finder = finder;
		this.other = other;
		this.rank = rank;
		// the client visits bins with smaller numbers first
		this.bin = Math.max(finder.binX, other.binX) * (LAST_BIN + 1) + Math.max(finder.binY, other.binY);
	}

	/** The pair as the client has it. */
	get pair() {
		const [a, b] = [this.finder.clientAgent, this.other.clientAgent];
		return a.id < b.id ? { a, b } : { a: b, b: a };
	}

	/** Compares two by the client's order: by its list of agents, then by bins, by breeds of blocks, and by updates. */
	static compare(a, b) {
		return a.finder.index - b.finder.index || a.bin - b.bin || a.rank - b.rank || a.other.sequence - b.other.sequence;
	}
}
