/** Builds a level in the world: changes the blocks “create … of …” of agents that the user moves, turns, copies or deletes there. */
import * as Blockly from "blockly/core";

/** Blocks that move or turn an agent. What an agent does last decides its place and its heading. */
const MOVING = new Set(["starlogo_go", "starlogo_forward", "starlogo_up", "starlogo_scatter", "starlogo_walk", "starlogo_until", "starlogo_stand", "starlogo_edge", "starlogo_back"]);
const TURNING = new Set(["starlogo_heading", "starlogo_turn", "starlogo_scatter", "starlogo_face"]);

const isNumber = (input) => input.connection.targetBlock()?.type === "math_number";
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

	/** Does something with a block, as one step that is undone at once. */
	#change(id, action) {
		const block = this.#blockOf(id);
		if (!block) return null;
		Blockly.Events.setGroup(true);
		try {
			return action(block) ?? null;
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
