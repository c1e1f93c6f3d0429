/**
 * Builds a level in the world: changes the blocks “create … of …” of agents that the user moves, turns, copies or deletes there, and adds blocks
 * for walls and for the ground.
 */
import * as Blockly from "blockly/core";

/** Blocks that move or turn an agent. What an agent does last decides its place and its heading. */
const MOVING = new Set(["starlogo_go", "starlogo_forward", "starlogo_up", "starlogo_scatter", "starlogo_walk", "starlogo_until", "starlogo_stand", "starlogo_edge", "starlogo_back"]);
const TURNING = new Set(["starlogo_heading", "starlogo_turn", "starlogo_scatter", "starlogo_face"]);

const isNumber = (input) => input.connection.targetBlock()?.type === "math_number";
const numberOf = (block, name) => block.getInputTargetBlock(name).getFieldValue("NUM");
const shadow = (NUM) => ({ shadow: { type: "math_number", fields: { NUM } } });

/** The blocks of a chain. */
function* chain(first) {
	for (let block = first; block; block = block.getNextBlock()) yield block;
}

export class Building {
	/** @param {Blockly.WorkspaceSvg} workspace */
	constructor(workspace) {
		this.workspace = workspace;
	}

	/** The block that makes one agent, once, when the game starts; null if the block with this id is no such block. */
	#blockOf(id) {
		const block = id ? this.workspace.getBlockById(id) : null;
		if (block?.type !== "starlogo_create" || block.getSurroundParent()?.type !== "starlogo_start") return null;
		const count = block.getInputTargetBlock("COUNT");
		return count?.type === "math_number" && Math.floor(count.getFieldValue("NUM")) === 1 ? block : null;
	}

	/** Whether an agent that a block has made can be built with. */
	has(id) {
		return this.#blockOf(id) !== null;
	}

	/** Has the agent of a block begin at a place. */
	move(id, x, y, z) {
		this.#change(id, (block) => this.#set(block, "starlogo_go", MOVING, { X: x, Y: y, Z: z }));
	}

	/** Has the agent of a block begin with a heading, in degrees. */
	turn(id, HEADING) {
		this.#change(id, (block) => this.#set(block, "starlogo_heading", TURNING, { HEADING }));
	}

	/** Puts a copy of a block below it, whose agent begins at another place. Returns its id, or null. */
	copy(id, x, y, z) {
		return this.#change(id, (block) => {
			const copy = Blockly.serialization.blocks.append(Blockly.serialization.blocks.save(block, { addNextBlocks: false, doFullSerialization: false }), this.workspace, { recordUndo: true });
			const next = block.getNextBlock();
			block.nextConnection.connect(copy.previousConnection);
			if (next && !next.getPreviousBlock()) copy.nextConnection.connect(next.previousConnection);
			this.#set(copy, "starlogo_go", MOVING, { X: x, Y: y, Z: z });
			return copy.id;
		});
	}

	/** Deletes a block, with what is in it. */
	remove(id) {
		this.#change(id, (block) => block.dispose(true));
	}

	/**
	 * Raises the ground at a place. What is built there has its own script, of which only the first line is shown.
	 *
	 * @param {string|boolean} group of changes that are undone together; true for a new one
	 */
	raise(x, y, by, group) {
		this.#grouped(group, () => {
			const raising = this.workspace.getBlocksByType("starlogo_raise", true).filter((block) => block.getRootBlock().type === "starlogo_start" && ["X", "Y", "HEIGHT"].every((name) => isNumber(block.getInput(name))));
			const here = raising.find((block) => numberOf(block, "X") === x && numberOf(block, "Y") === y);
			if (!here) {
				const block = { type: "starlogo_raise", inputs: { HEIGHT: shadow(by), X: shadow(x), Y: shadow(y) } };
				if (raising.length > 0) this.#append(raising[0].getRootBlock(), block);
				// its first line names the block in it: a later change of that would be a step of its own for Undo
				else this.#add({ type: "starlogo_start", collapsed: true, inputs: { DO: { block } } });
				return;
			}
			const height = numberOf(here, "HEIGHT") + by;
			if (height !== 0) here.getInputTargetBlock("HEIGHT").setFieldValue(height, "NUM");
			else if (raising.length === 1 && here.getParent()?.type === "starlogo_start" && !here.getNextBlock()) here.getRootBlock().dispose();
			else here.dispose(true);
		});
	}

	/** Builds walls, each from a place to another one: [x, y, heading, size]. Nobody goes through them. */
	wall(pieces) {
		this.#grouped(true, () => {
			const start = this.workspace.getBlocksByType("starlogo_create", true).map((block) => block.getRootBlock()).find(({ type }) => type === "starlogo_start") ?? this.workspace.getTopBlocks(true).find(({ type }) => type === "starlogo_start") ?? this.#add({ type: "starlogo_start" });
			const isSolid = this.workspace.getBlocksByType("starlogo_solid").some((block) => block.getFieldValue("BREED") === "walls");
			if (!isSolid) this.#append(start, { type: "starlogo_solid", fields: { BREED: "walls", ON: "on" } });
			for (const [x, y, heading, size] of pieces) {
				const set = { type: "starlogo_size", inputs: { SIZE: shadow(size) }, next: { block: { type: "starlogo_heading", inputs: { HEADING: shadow(heading) }, next: { block: { type: "starlogo_go", inputs: { X: shadow(x), Y: shadow(y), Z: shadow(0) } } } } } };
				this.#append(start, { type: "starlogo_create", fields: { BREED: "walls", SHAPE: "wall" }, inputs: { COUNT: shadow(1), DO: { block: set } } });
			}
		});
	}

	/** Adds a block to the program. */
	#add(state) {
		return Blockly.serialization.blocks.append(state, this.workspace, { recordUndo: true });
	}

	/** Puts a block at the end of a script. */
	#append(start, state) {
		const added = this.#add(state);
		let last = null;
		for (const each of chain(start.getInputTargetBlock("DO"))) last = each;
		(last ? last.nextConnection : start.getInput("DO").connection).connect(added.previousConnection);
	}

	/** Does something with a block, as one step that is undone at once. */
	#change(id, action) {
		const block = this.#blockOf(id);
		return block ? this.#grouped(true, () => action(block)) : null;
	}

	#grouped(group, action) {
		Blockly.Events.setGroup(group);
		try {
			return action() ?? null;
		} finally {
			Blockly.Events.setGroup(false);
		}
	}

	/** Sets the numbers of the last block of a kind in a block's content. If it is of another type, or has other blocks in it, a new one follows. */
	#set(block, type, kind, numbers) {
		let last = null;
		let end = null;
		for (const each of chain(block.getInputTargetBlock("DO"))) {
			end = each;
			if (kind.has(each.type)) last = each;
		}
		if (last?.type === type && Object.keys(numbers).every((name) => isNumber(last.getInput(name)))) {
			for (const [name, number] of Object.entries(numbers)) last.getInputTargetBlock(name).setFieldValue(number, "NUM");
			return;
		}
		const inputs = Object.fromEntries(Object.entries(numbers).map(([name, number]) => [name, shadow(number)]));
		const added = Blockly.serialization.blocks.append({ type, inputs }, this.workspace, { recordUndo: true });
		(end ? end.nextConnection : block.getInput("DO").connection).connect(added.previousConnection);
	}
}
