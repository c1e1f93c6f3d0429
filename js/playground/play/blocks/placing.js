/**
 * Keeps scripts where the user has put them, and in sight.
 *
 * Blockly pushes blocks apart that are close together without being connected. A block that comes out of the drawer lies over scripts, so
 * Blockly would push these away. Here no block is pushed.
 */
import * as Blockly from "blockly/core";
import { inGroup } from "./undo.js";

/** The distance between scripts, and between the drawer and a script. */
const GAP = 24;
/** The distance within which a block joins another one, in the blocks' units. */
const SNAP = 36;

Blockly.BlockSvg.prototype.bumpNeighbours = () => {};
Blockly.config.snapRadius = Blockly.config.connectingSnapRadius = SNAP;

export class Placing {
	/** The pixels by which the scripts have given way to the drawer, to the right or downwards, and where they are since then. */
	#given = { x: 0, y: 0 };
	#at = { x: 0, y: 0 };
	/** Whether the user has scrolled since then. */
	#isScrolled = false;
	#wanted = null;

	/** @param {Blockly.WorkspaceSvg} workspace */
	constructor(workspace) {
		this.workspace = workspace;
		workspace.getInjectionDiv().addEventListener("wheel", () => {
			this.#isScrolled = true;
		}, { passive: true });
		// further to the right and downwards than Blockly lets scripts go
		const metrics = workspace.getMetricsManager();
		const padded = metrics.getPaddedContent_;
		metrics.getPaddedContent_ = (view, content) => {
			const bounds = padded.call(metrics, view, content);
			return { ...bounds, left: Math.min(bounds.left, content.left - view.width), top: Math.min(bounds.top, content.top - view.height) };
		};
	}

	/** Hears every event of the workspace. */
	hear(event) {
		const { workspace } = this;
		if (event.type === Blockly.Events.TOOLBOX_ITEM_SELECT) this.#makeRoom();
		if (event.type === Blockly.Events.BLOCK_DRAG && !event.isStart) {
			this.#join(event);
			this.#stepAside(event);
		}
		if (event.type === Blockly.Events.BLOCK_MOVE && event.reason?.includes("bump")) this.#clear(event);
		const isOpen = workspace.getFlyout().isVisible();
		this.widen(isOpen || workspace.isDragging());
		if (!isOpen && !workspace.isDragging()) this.#takeRoom();
		if (!event.isUiEvent && event.recordUndo) this.#spreadLater(event);
	}

	/** While a drawer is open, the blocks lie over a part of the world, so that there is room for scripts beside it. */
	widen(isOpen) {
		const { workspace } = this;
		const { classList } = workspace.getInjectionDiv();
		if (classList.contains("drawer-open") === isOpen) return;
		classList.toggle("drawer-open", isOpen);
		Blockly.svgResize(workspace);
	}

	/** Moves the scripts to the right of an open drawer. In a narrow window the drawer is above them, and they move downwards. */
	#makeRoom() {
		const { workspace } = this;
		const flyout = workspace.getFlyout();
		if (!flyout.isVisible()) return;
		const toolbox = workspace.getToolbox();
		const pane = workspace.getInjectionDiv().getBoundingClientRect();
		const shown = workspace.getTopBlocks(false).map((block) => block.getSvgRoot().getBoundingClientRect()).filter(({ top, bottom, right }) => bottom > pane.top && top < pane.bottom && right > pane.left);
		const isBelow = workspace.horizontalLayout;
		const end = isBelow ? pane.top + toolbox.getHeight() + flyout.getHeight() : pane.left + toolbox.getWidth() + flyout.getWidth();
		const by = end + GAP / 2 - Math.min(...shown.map(({ left, top }) => (isBelow ? top : left)));
		if (!(by > 0 && by < (isBelow ? pane.height : pane.width))) return;
		const given = isBelow ? { x: 0, y: by } : { x: by, y: 0 };
		workspace.scroll(workspace.scrollX + given.x, workspace.scrollY + given.y);
		this.#given = { x: this.#given.x + given.x, y: this.#given.y + given.y };
		this.#at = { x: workspace.scrollX, y: workspace.scrollY };
		this.#isScrolled = false;
	}

	/** Moves them back to where they were, unless the user has moved them meanwhile. Keys that leave the drawer scroll to the block that they reach. */
	#takeRoom() {
		const { workspace } = this;
		const { x, y } = this.#given;
		this.#given = { x: 0, y: 0 };
		if (this.#isScrolled) return;
		if (x > 0) workspace.scroll(this.#at.x - x, workspace.scrollY);
		if (y > 0) workspace.scroll(workspace.scrollX, this.#at.y - y);
	}

	/** Joins a dropped block to the connection that it lies on, if a fast pointer has left it loose there. */
	#join({ blockId, group }) {
		const { previousConnection } = this.workspace.getBlockById(blockId) ?? {};
		if (!previousConnection || previousConnection.isConnected()) return;
		const { connection } = previousConnection.closest(SNAP, new Blockly.utils.Coordinate(0, 0));
		if (connection) inGroup(group, () => connection.connect(previousConnection));
	}

	/** Moves a block that another one has replaced to the right of all scripts that it would lie on. */
	#clear({ blockId, group }) {
		const { workspace } = this;
		const block = workspace.getBlockById(blockId);
		if (!block || block.getParent()) return;
		const place = block.getBoundingRectangle();
		const by = moveBeyond(place, workspace.getTopBlocks(false).filter((each) => each !== block).map((each) => each.getBoundingRectangle()), "left", "right");
		if (by === 0) return;
		inGroup(group, () => block.moveBy(by, 0));
		workspace.scrollBoundsIntoView(place);
	}

	/** Moves a dropped value away from an input that it does not fit, so that it does not seem to be in it. */
	#stepAside({ blockId, group }) {
		const block = this.workspace.getBlockById(blockId);
		const { outputConnection: output } = block ?? {};
		if (!output || output.isConnected() || output.neighbours(GAP).length === 0) return;
		inGroup(group, () => block.moveBy(GAP, GAP));
	}

	/**
	 * Gives each script its own place, when the blocks have their sizes. The lower one gives way. The one that was moved goes to the right
	 * if that is nearer.
	 */
	#spreadLater({ type, blockId, group }) {
		const isMove = type === Blockly.Events.BLOCK_MOVE || type === Blockly.Events.BLOCK_CREATE;
		const isFirst = this.#wanted === null;
		this.#wanted = { group, moved: isMove ? blockId : this.#wanted?.moved };
		if (isFirst) Blockly.renderManagement.finishQueuedRenders().then(() => {
			const { moved, group: last } = this.#wanted;
			this.#wanted = null;
			if (!this.workspace.isDragging() && this.workspace.rendered) inGroup(last, () => this.#spread(moved));
		});
	}

	#spread(moved) {
		const { workspace } = this;
		const scripts = workspace.getTopBlocks(false).filter(({ outputConnection, previousConnection }) => !outputConnection && !previousConnection);
		const placed = scripts.map((block) => ({ block, place: block.getBoundingRectangle() })).sort((a, b) => a.place.top - b.place.top);
		const taken = [];
		for (const { block, place } of placed) {
			const isMoved = block.id === moved;
			const aside = isMoved ? place.clone() : null;
			let [x, y] = [0, moveBeyond(place, taken, "top", "bottom")];
			if (isMoved && y > 0) {
				const right = moveBeyond(aside, placed.filter((each) => each.block !== block).map((each) => each.place), "left", "right");
				if (right < y) [x, y] = [right, 0];
			}
			taken.push(y === 0 && x > 0 ? aside : place);
			if (x === 0 && y === 0) continue;
			block.moveBy(x, y);
			if (isMoved) workspace.scrollBoundsIntoView(taken.at(-1));
		}
	}
}

/** Moves a place beyond all others that it would lie on, to the right or downwards. Returns how far. */
function moveBeyond(place, others, begin, end) {
	const before = place[begin];
	for (let other = null; (other = others.find((each) => each.intersects(place))); ) {
		const by = other[end] + GAP - place[begin];
		place[begin] += by;
		place[end] += by;
	}
	return place[begin] - before;
}
