/** Shows blocks as pictures, for sheets of paper. */
import * as Blockly from "blockly/core";
import { MEDIA } from "../../shared/files/served.js";
import { addToMenus } from "./blocks.js";
import { MARGIN, SCALE, adoptStyles, themes } from "./setup.js";

/**
 * Shows a program's blocks as a picture, in two columns.
 *
 * @param {HTMLElement} host as wide as the picture
 * @param {object} program in Blockly's notation
 * @param {number} highest the largest height of the picture, in pixels
 * @param {number} smallest the smallest scale; with it the picture may be higher
 */
export function showBlocks(host, program, highest, smallest = 0) {
	addToMenus(program);
	const workspace = adoptStyles(() => Blockly.inject(host, { theme: themes.light, renderer: "zelos", media: MEDIA, sounds: false, readOnly: true, trashcan: false, zoom: { minScale: 0.1 }, move: { scrollbars: false, drag: false, wheel: false } }));
	Blockly.serialization.workspaces.load(program, workspace);
	const blocks = workspace.getTopBlocks(true);
	for (const block of blocks) block.setCollapsed(false);
	// otherwise blocks have no sizes yet
	Blockly.renderManagement.triggerQueuedRenders();
	const heights = blocks.map((block) => block.getHeightWidth().height + MARGIN);
	const half = heights.reduce((sum, height) => sum + height, 0) / 2;
	const columns = [[], []];
	const ends = [0, 0];
	blocks.forEach((block, i) => {
		const column = ends[0] > 0 && ends[0] + heights[i] / 2 > half ? 1 : 0;
		columns[column].push({ block, top: ends[column] });
		ends[column] += heights[i] + MARGIN;
	});
	const widths = columns.map((column) => Math.max(0, ...column.map(({ block }) => block.getHeightWidth().width)));
	// not before all of the first column are known: the second one is beside the widest
	columns.forEach((column, i) => {
		for (const { block, top } of column) block.moveTo(new Blockly.utils.Coordinate(i === 0 ? 0 : widths[0] + 2 * MARGIN, top));
	});
	const widest = Math.min(SCALE, host.clientWidth / (widths[0] + widths[1] + 3 * MARGIN));
	const scale = Math.min(widest, Math.max(smallest, highest / Math.max(...ends)));
	workspace.setScale(scale);
	host.style.height = `${Math.ceil(Math.max(...ends) * scale)}px`;
	Blockly.svgResize(workspace);
	workspace.translate(0, 0);
	// The picture has its own name. Blockly measures words in an element outside of the page's parts.
	for (const part of host.querySelectorAll("[aria-label]")) part.removeAttribute("aria-label");
	document.querySelector(".blocklyComputeCanvas")?.setAttribute("aria-hidden", "true");
}
