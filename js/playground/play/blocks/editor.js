/** Shows and edits the program as blocks, with Blockly. Blockly gets the page's style, and keeps to the page's policy. */
import * as Blockly from "blockly/core";
import "../game/lateengine.js";
import "./locale.js";
import { KeyboardNavigation } from "@blockly/keyboard-navigation";
import { button, h, isDark, onThemeChange } from "../../shared/dom.js";
import { texts } from "../../shared/language.js";
import { ICON, MEDIA } from "../../shared/files/served.js";
import { BLOCK_STYLES, CATEGORY_STYLES, DEFINITIONS, MENUS, NEW_BREED, SHAPE_OF, TOOLBOX, drawerFor, meet, withNumbers } from "./blocks.js";
import { Building } from "./building.js";
import { Placing } from "./placing.js";
import { readAloud } from "./reading.js";

const PARTS = {
	light: { workspaceBackgroundColour: "#ffffff", toolboxBackgroundColour: "#f4f6fa", toolboxForegroundColour: "#1c2430", flyoutBackgroundColour: "#e9edf4", flyoutForegroundColour: "#1c2430", flyoutOpacity: 1, scrollbarColour: "#9aa6b6" },
	dark: { workspaceBackgroundColour: "#1a1f27", toolboxBackgroundColour: "#20262f", toolboxForegroundColour: "#e6eaf0", flyoutBackgroundColour: "#2a313c", flyoutForegroundColour: "#e6eaf0", flyoutOpacity: 1, scrollbarColour: "#5a6675" },
};
/** The size of blocks' words in points, and the blocks' scale. Together the words are at least 14 pixels high. */
const [WORDS, SCALE] = [12, 0.9];
/** The largest and the smallest scale of the drawer's blocks, and the pixels that it leaves for the scripts if it can. */
const [IN_DRAWER, LEAST_IN_DRAWER, LEFT_FOR_SCRIPTS] = [0.84, 0.75, 220];
const [SMALLEST, LARGEST, ZOOM] = [0.3, 1.5, 1.2];
/** The most letters in the name of a breed or a variable. */
const LONGEST = 30;
/** The distance of the first script from the corner, in pixels. */
const MARGIN = 12;
const words = texts.play.editor;

/** Gives the address of a shape's picture. The page that has an editor sets it. */
const pictures = { of: () => null };

/** The menu of shapes, with a picture of each. */
const picturedShapes = () => MENUS.SHAPE().map(([text, value]) => [h("span.shape", { title: text }, h("img", { "data-shape": value, alt: "", width: 80, height: 60 }), text), value]);

Blockly.Scrollbar.scrollbarThickness = 9;
Blockly.dialog.setPrompt(async (message, value, callback) => {
	const { ask } = await import("./askname.js");
	const toolbox = Blockly.getMainWorkspace().getToolbox();
	const drawer = toolbox.getSelectedItem();
	callback(await ask(message, value, LONGEST));
	// the dialog closes it
	if (drawer) {
		toolbox.clearSelection();
		toolbox.setSelectedItem(drawer);
	}
});
Blockly.common.defineBlocksWithJsonArray(DEFINITIONS.map((definition) => ({
	...definition,
	args0: definition.args0.map((part) => (part.menu ? { ...part, ...(part.menu === "SHAPE" ? { type: "field_shape", options: picturedShapes } : { options: MENUS[part.menu] }) } : part)),
	...(definition.args0.some(({ menu }) => ["BREED", "OTHER", "ANYONE"].includes(menu)) && { extensions: ["new_breed"] }),
})));
Blockly.Extensions.register("new_breed", function askForBreeds() {
	for (const name of ["BREED", "OTHER"]) {
		const field = this.getField(name);
		field?.setValidator((value) => {
			if (value !== NEW_BREED) {
				if (Blockly.Events.isEnabled()) followBreed(this, field.getValue(), value);
				return value;
			}
			Blockly.dialog.prompt(texts.blocks.askBreed, "", (answer) => {
				const breed = answer?.trim();
				if (!breed) return;
				meet(name, breed);
				// otherwise the old options would count
				field.getOptions(false);
				field.setValue(breed);
			});
			return null;
		});
	}
});

/** Gives a block of a new breed the shape of that breed, if it had the shape of the old one. */
function followBreed(block, before, after) {
	const shape = block.getField("SHAPE");
	if (shape && shape.getValue() === SHAPE_OF[before] && after in SHAPE_OF) shape.setValue(SHAPE_OF[after]);
}

/** A menu of shapes. Their pictures are made when it opens. */
class FieldShape extends Blockly.FieldDropdown {
	static fromJson(options) {
		return new this(options.options, undefined, options);
	}

	showEditor_(event) {
		super.showEditor_(event);
		for (const picture of Blockly.DropDownDiv.getContentDiv().querySelectorAll("img")) picture.src = pictures.of(picture.dataset.shape) ?? ICON;
	}
}
Blockly.fieldRegistry.register("field_shape", FieldShape);

/** Further branches of a condition, which programs may have: a condition and an input for each, and an input for the other case. */
Blockly.Extensions.registerMutator("branches", {
	saveExtraState() {
		return this.branches ?? null;
	},
	loadExtraState(state) {
		this.branches = state;
		for (let i = 1; i <= (state.elseIfCount ?? 0); i++) {
			this.appendValueInput(`IF${i}`).setCheck("Boolean").appendField(texts.blocks.elseIf);
			this.appendStatementInput(`DO${i}`);
		}
		if (state.hasElse) this.appendStatementInput("ELSE").appendField(texts.blocks.otherwise.replace(" %1", ""));
	},
});

const themes = Object.fromEntries(Object.entries(PARTS).map(([name, componentStyles]) => [name, Blockly.Theme.defineTheme(`playground-${name}`, {
	name: `playground-${name}`, base: Blockly.Themes.Classic, blockStyles: BLOCK_STYLES, categoryStyles: CATEGORY_STYLES, componentStyles,
	fontStyle: { family: "system-ui, sans-serif", weight: "500", size: WORDS }, startHats: true,
})]));
const theme = () => themes[isDark() ? "dark" : "light"];

/** Blockly writes style elements, which the page's policy forbids. The document adopts their style sheets instead. */
function adoptStyles(action) {
	const { head } = document;
	const adopt = (node) => {
		const sheet = new CSSStyleSheet();
		sheet.replaceSync(node.textContent);
		document.adoptedStyleSheets.push(sheet);
		return node;
	};
	head.appendChild = adopt;
	head.insertBefore = adopt;
	try {
		return action();
	} finally {
		delete head.appendChild;
		delete head.insertBefore;
	}
}

/** The toolbox does not listen to keys, because the plugin does. */
class Toolbox extends Blockly.Toolbox {
	onKeyDown_() {}
}
Blockly.registry.register(Blockly.registry.Type.TOOLBOX, Blockly.registry.DEFAULT, Toolbox, true);

/** A trash can for blocks that are dropped on it. */
class Bin extends Blockly.DeleteArea {
	id = "bin";

	constructor(element) {
		super();
		this.element = element;
	}

	getClientRect() {
		const { top, bottom, left, right } = this.element.getBoundingClientRect();
		return new Blockly.utils.Rect(top, bottom, left, right);
	}

	onDragOver() {
		this.element.classList.add("open");
	}

	onDragExit() {
		this.element.classList.remove("open");
	}

	onDrop() {
		this.onDragExit();
	}
}

/** Adds everything that a program names to the menus. */
function meetAll(program) {
	JSON.stringify(program, (key, value) => {
		meet(key, value);
		return value;
	});
}

/**
 * Shows a program's blocks as a picture, in two columns.
 *
 * @param {HTMLElement} host as wide as the picture
 * @param {object} program in Blockly's notation
 * @param {number} highest the largest height of the picture, in pixels
 * @param {number} smallest the smallest scale; with it the picture may be higher
 */
export function showBlocks(host, program, highest, smallest = 0) {
	meetAll(program);
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

// Blockly takes no more styles after it has shown blocks, as a sheet for printing does
KeyboardNavigation.registerKeyboardNavigationStyles();
KeyboardNavigation.registerFlyoutCursor();

export class Editor {
	#isLoading = false;
	#failed = null;
	/** The blocks that the last change deleted, in all of its events. */
	#deleted = { group: "", count: 0 };

	/**
	 * @param {HTMLElement} host contains the editor
	 * @param {HTMLElement} bar takes the buttons that change the program and its size
	 * @param {{onChange: (deleted: number) => void, pictureOf: (shape: string) => string|null, say: (text: string) => void}} page onChange is
	 * called when the user has changed the program, with the number of deleted blocks
	 */
	constructor(host, bar, { onChange, pictureOf, say }) {
		pictures.of = pictureOf;
		const narrow = innerWidth < 520;
		this.workspace = adoptStyles(() => {
			const workspace = Blockly.inject(host, {
				toolbox: TOOLBOX, theme: theme(), renderer: "zelos", media: MEDIA, sounds: false, trashcan: false, horizontalLayout: narrow,
				zoom: { controls: false, wheel: false, pinch: true, startScale: SCALE, scaleSpeed: ZOOM, minScale: SMALLEST, maxScale: LARGEST }, move: { scrollbars: true, drag: true, wheel: true },
			});
			workspace.registerToolboxCategoryCallback("VARIABLE", (each) => withNumbers(Blockly.Variables.flyoutCategory(each, false)));
			this.keyboard = new KeyboardNavigation(workspace);
			// Blockly leaves them out if the drawer is above
			if (narrow) workspace.getToolbox().getToolboxItems().forEach((item, i) => item.getDiv().querySelector("[role=presentation]").classList.add(...TOOLBOX.contents[i].cssconfig.icon.split(" ")));
			return workspace;
		});
		// A block leaves the drawer in whatever direction it is pulled. The drawer scrolls beside its blocks, and by the wheel.
		const flyout = this.workspace.getFlyout();
		flyout.isDragTowardWorkspace = () => true;
		const showItems = flyout.show.bind(flyout);
		flyout.show = (items) => {
			// its blocks are as large as the room for them allows, which is more as soon as it is open
			this.placing.widen(true);
			showItems(Array.isArray(items) ? drawerFor(items, this.program) : items);
		};
		flyout.getFlyoutScale = () => this.#drawerScale;
		this.placing = new Placing(this.workspace);
		this.building = new Building(this.workspace);
		readAloud(this.workspace);
		this.#addTools(host, bar, say);
		this.forgetTheme = onThemeChange(() => adoptStyles(() => this.workspace.setTheme(theme())));
		this.observer = new ResizeObserver(() => Blockly.svgResize(this.workspace));
		this.observer.observe(host);
		this.workspace.addChangeListener((event) => {
			// Events come later than their cause. The events of loading end with this one.
			if (event.type === Blockly.Events.FINISHED_LOADING) {
				this.#isLoading = false;
				// undo must not go back to an earlier program
				this.workspace.clearUndo();
			} else if (!event.isUiEvent && !this.#isLoading) {
				onChange(this.#countDeleted(event));
			}
			if (!this.#isLoading) this.placing.hear(event);
			this.#showTools();
		});
	}

	#addTools(host, bar, say) {
		const tool = (name, onclick) => button("", onclick, { class: `tool tool-${name}`, "aria-label": words[name], title: words[name] });
		const { workspace } = this;
		this.undoButton = tool("undo", () => this.undo());
		this.redoButton = tool("redo", () => workspace.undo(true));
		bar.replaceChildren(this.undoButton, this.redoButton);
		const bin = tool("bin", () => {
			const block = Blockly.common.getSelected();
			if (block?.isDeletable?.()) block.checkAndDelete();
			else say(words.howToDelete);
		});
		// the block stays selected
		bin.addEventListener("pointerdown", (event) => event.preventDefault());
		host.append(h("div.corner-tools", {}, tool("larger", () => workspace.zoomCenter(1)), tool("smaller", () => workspace.zoomCenter(-1)), bin));
		workspace.getComponentManager().addComponent({ component: new Bin(bin), weight: 2, capabilities: [Blockly.ComponentManager.Capability.DELETE_AREA, Blockly.ComponentManager.Capability.DRAG_TARGET] });
		this.#showTools();
	}

	#showTools() {
		// a disabled button would lose the focus
		this.undoButton.setAttribute("aria-disabled", String(!this.canUndo));
		this.redoButton.setAttribute("aria-disabled", String(this.workspace.getRedoStack().length === 0));
	}

	/** The number of blocks that the user has deleted at once, in the events up to this one. */
	#countDeleted({ type, group, ids, recordUndo }) {
		if (group === "" || group !== this.#deleted.group) this.#deleted = { group, count: 0 };
		if (type === Blockly.Events.BLOCK_DELETE && recordUndo) this.#deleted.count += ids.length;
		return this.#deleted.count;
	}

	/** The scale of the drawer's blocks. If the widest one needs it, they are smaller. */
	get #drawerScale() {
		const { workspace } = this;
		const flyout = workspace.getFlyout();
		const most = Math.min(IN_DRAWER, workspace.scale);
		if (workspace.horizontalLayout) return most;
		const widest = Math.max(1, ...flyout.getContents().map((item) => item.getElement().getBoundingRectangle().getWidth()));
		const room = workspace.getInjectionDiv().clientWidth - workspace.getToolbox().getWidth() - LEFT_FOR_SCRIPTS;
		return Math.min(most, Math.max(LEAST_IN_DRAWER, room / (widest + 3 * MARGIN)));
	}

	get program() {
		return Blockly.serialization.workspaces.save(this.workspace);
	}

	/**
	 * Shows a program. If Blockly finds none in it, it throws, and shows the old one again.
	 *
	 * @param {object} program in Blockly's notation
	 * @param {boolean} inOrder whether to arrange its scripts
	 */
	show(program, inOrder) {
		const before = this.program;
		Blockly.Events.fireNow?.();
		Blockly.hideChaff();
		this.#isLoading = true;
		try {
			this.#load(program, inOrder);
		} catch (error) {
			this.#load(before, false);
			throw error;
		} finally {
			this.workspace.clearUndo();
			this.workspace.scroll(MARGIN, MARGIN);
		}
	}

	#load(program, inOrder) {
		meetAll(program);
		Blockly.Events.disable();
		try {
			Blockly.serialization.workspaces.load(program, this.workspace);
			if (inOrder) this.workspace.cleanUp();
		} finally {
			Blockly.Events.enable();
		}
		Blockly.Events.fire(new (Blockly.Events.get(Blockly.Events.FINISHED_LOADING))(this.workspace));
	}

	/** Whether the user has changed anything since this program was shown. */
	get canUndo() {
		return this.workspace.getUndoStack().length > 0;
	}

	/** Undoes the user's last change. */
	undo() {
		this.workspace.undo(false);
	}

	/** The collision system in the program's start block, or null. */
	get system() {
		return this.#systemBlock?.getFieldValue("SYSTEM") ?? null;
	}

	set system(name) {
		this.#systemBlock?.setFieldValue(name, "SYSTEM");
	}

	/** The block that sets the collision system at a program's start: the last one in a start, or null. */
	get #systemBlock() {
		return this.workspace.getBlocksByType("starlogo_system", true).filter((block) => block.getRootBlock().type === "starlogo_start" && block.isEnabled()).at(-1) ?? null;
	}

	/** Closes the drawer, and menus that lie over the page. */
	closeMenus() {
		Blockly.hideChaff();
	}

	/** Marks the block of an error, and scrolls to it if isSought; null removes the mark. */
	mark(id, isSought = true) {
		this.#failed?.getSvgRoot()?.classList.remove("failed");
		this.#failed = id ? this.workspace.getBlockById(id) : null;
		if (!this.#failed) return;
		this.#failed.getSvgRoot().classList.add("failed");
		if (!isSought) return;
		for (let block = this.#failed; block; block = block.getParent()) block.setCollapsed(false);
		this.workspace.centerOnBlock(id);
	}

	close() {
		this.observer.disconnect();
		this.forgetTheme();
		this.keyboard.dispose();
		this.workspace.dispose();
	}
}
