/**
 * The blocks for screen readers: a tree in reading order, in which each block has its words, and what can
 * be changed in a block comes below it.
 *
 * Blockly draws a block's words after the blocks in it, and the next block as a part of the one above. Read as they are drawn, the words
 * come in reverse.
 */
import * as Blockly from "blockly/core";
import { texts } from "../../shared/language.js";

const words = texts.play.reading;
const { VALUE } = Blockly.inputs.inputTypes;

const label = (element, role, name) => {
	element.setAttribute("role", role);
	element.setAttribute("aria-label", name);
};
/** The inputs that a block has when it is unfolded. */
const inputsOf = (block) => block.inputList.filter(({ name }) => name !== Blockly.constants.COLLAPSED_INPUT_NAME);

/** The words of a block and of the values in it. */
export function wordsOf(block) {
	const parts = inputsOf(block).flatMap(({ fieldRow, connection, type }) => [
		...fieldRow.map((field) => field.getText()),
		...(type === VALUE ? [connection.targetBlock() ? wordsOf(connection.targetBlock()) : words.gap] : []),
	]);
	return parts.filter(Boolean).join(" ").replaceAll(/ (?=[,:])/g, "");
}

/** Labels a block, the blocks in it and those below it. Adds their elements' ids in reading order. */
function labelScript(first, level, ids) {
	for (let block = first; block; block = block.getNextBlock()) {
		const path = block.getFocusableElement();
		label(path, "treeitem", wordsOf(block));
		path.setAttribute("aria-level", level);
		ids.push(path.id);
		if (block.isCollapsed()) path.setAttribute("aria-expanded", "false");
		else path.removeAttribute("aria-expanded");
		for (const { fieldRow, connection } of block.isCollapsed() ? [] : inputsOf(block)) {
			for (const field of fieldRow) {
				const element = field.getSvgRoot();
				// what cannot be changed is in the block's words
				if (!field.isClickable() || field.isFullBlockField()) element?.setAttribute("aria-hidden", "true");
				else {
					label(element, "treeitem", field.getText());
					element.setAttribute("aria-roledescription", words.field);
					element.setAttribute("aria-level", level + 1);
					ids.push(element.id);
				}
			}
			labelScript(connection?.targetBlock(), level + 1, ids);
		}
	}
}

function labelTree(workspace, name, blocks) {
	const ids = [];
	for (const block of blocks) labelScript(block, 1, ids);
	const canvas = workspace.getCanvas();
	label(canvas, "tree", name);
	canvas.setAttribute("aria-owns", ids.join(" "));
	workspace.getFocusableElement().setAttribute("aria-label", name);
}

/** Keeps a workspace and its drawer labelled. */
export function readAloud(workspace) {
	const host = workspace.getInjectionDiv();
	const flyout = workspace.getFlyout();
	let isDue = false;
	const refresh = () => {
		isDue = false;
		if (!host.isConnected) return;
		for (const svg of host.querySelectorAll("svg")) svg.setAttribute(...(svg.matches(".blocklySvg, .blocklyFlyout") ? ["role", "presentation"] : ["aria-hidden", "true"]));
		labelTree(workspace, words.program, workspace.getTopBlocks(true));
		const items = flyout.isVisible() ? flyout.getContents().map((item) => item.getElement()) : [];
		labelTree(flyout.getWorkspace(), words.drawer, items.filter((item) => item instanceof Blockly.BlockSvg));
		for (const item of items) if (item instanceof Blockly.FlyoutButton) label(item.getFocusableElement(), "button", item.getButtonText());
	};
	workspace.addChangeListener(({ isUiEvent, type }) => {
		if (isDue || (isUiEvent && ![Blockly.Events.TOOLBOX_ITEM_SELECT, Blockly.Events.FINISHED_LOADING].includes(type))) return;
		isDue = true;
		requestAnimationFrame(refresh);
	});
	host.addEventListener("focusin", ({ target }) => {
		const node = Blockly.getFocusManager().getFocusedNode();
		if (node instanceof Blockly.RenderedConnection) label(target, "treeitem", `${words.gap}: ${wordsOf(node.getSourceBlock())}`);
	});
}
