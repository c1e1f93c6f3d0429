/**
 * Builds a level in the world: changes the blocks “create … of …” of agents that the user moves, turns, copies or deletes there, and adds blocks
 * for walls and for the ground.
 */
import * as Blockly from "blockly/core";
import { folded, number, solid, start, wall } from "../builtin/notation.js";
import { inGroup } from "./undo.js";

/** Blocks that move or turn an agent. What an agent does last decides its place and its heading. */
const MOVING = new Set(["starlogo_go", "starlogo_forward", "starlogo_up", "starlogo_scatter", "starlogo_walk", "starlogo_until", "starlogo_stand", "starlogo_edge", "starlogo_back"]);
const TURNING = new Set(["starlogo_heading", "starlogo_turn", "starlogo_scatter", "starlogo_face"]);

const isNumber = (input) => input.connection.targetBlock()?.type === "math_number";
const numberOf = (block, name) => block.getInputTargetBlock(name).getFieldValue("NUM");

/** A block and those below it. */
function* blocksFrom(first) {
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
			const copy = this.#add(Blockly.serialization.blocks.save(block, { addNextBlocks: false, doFullSerialization: false }));
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
		inGroup(group, () => {
			const raising = this.workspace.getBlocksByType("starlogo_raise", true).filter((block) => block.getRootBlock().type === "starlogo_start" && ["X", "Y", "HEIGHT"].every((name) => isNumber(block.getInput(name))));
			const here = raising.find((block) => numberOf(block, "X") === x && numberOf(block, "Y") === y);
			if (!here) {
				const block = { type: "starlogo_raise", inputs: { HEIGHT: number(by), X: number(x), Y: number(y) } };
				if (raising.length > 0) this.#append(raising[0].getRootBlock(), block);
				// its first line names the block in it: a later change of that would be a step of its own for Undo
				else this.#add(folded(start(block)));
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
		inGroup(true, () => {
			const makers = this.workspace.getBlocksByType("starlogo_create", true).map((block) => block.getRootBlock());
			const script = [...makers, ...this.workspace.getTopBlocks(true)].find(({ type }) => type === "starlogo_start") ?? this.#add({ type: "starlogo_start" });
			const isSolid = this.workspace.getBlocksByType("starlogo_solid").some((block) => block.getFieldValue("BREED") === "walls");
			if (!isSolid) this.#append(script, solid("walls"));
			for (const [x, y, angle, length] of pieces) this.#append(script, wall(x, y, length, angle));
		});
	}

	/** Adds a block to the program. */
	#add(state) {
		return Blockly.serialization.blocks.append(state, this.workspace, { recordUndo: true });
	}

	/** Puts a block at the end of a script, or of the blocks in another one. */
	#append(parent, state) {
		const added = this.#add(state);
		const last = [...blocksFrom(parent.getInputTargetBlock("DO"))].at(-1);
		(last ? last.nextConnection : parent.getInput("DO").connection).connect(added.previousConnection);
	}

	/** Does something with a block, as one step that is undone at once. */
	#change(id, action) {
		const block = this.#blockOf(id);
		return block ? inGroup(true, () => action(block)) : null;
	}

	/** Sets the numbers of the last block of a kind in a block's content. If it is of another type, or has other blocks in it, a new one follows. */
	#set(block, type, kind, numbers) {
		const last = [...blocksFrom(block.getInputTargetBlock("DO"))].findLast((each) => kind.has(each.type));
		if (last?.type === type && Object.keys(numbers).every((name) => isNumber(last.getInput(name)))) {
			for (const [name, value] of Object.entries(numbers)) last.getInputTargetBlock(name).setFieldValue(value, "NUM");
			return;
		}
		this.#append(block, { type, inputs: Object.fromEntries(Object.entries(numbers).map(([name, value]) => [name, number(value)])) });
	}
}
