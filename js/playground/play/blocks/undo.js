import * as Blockly from "blockly/core";

/**
 * Changes blocks in one step, which is undone at once.
 *
 * @param {string|boolean} group of earlier changes that the step has too; true for a new one
 */
export function inGroup(group, action) {
	const before = Blockly.Events.getGroup();
	Blockly.Events.setGroup(group);
	try {
		return action();
	} finally {
		Blockly.Events.setGroup(before);
	}
}
