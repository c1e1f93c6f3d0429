/** The program as blocks: Blockly, dressed as the page and tamed for its policy. */
import * as Blockly from "blockly/core";
import "./locale.js";
import { KeyboardNavigation } from "@blockly/keyboard-navigation";
import { button, h, isDark, onThemeChange } from "../shared/dom.js";
import { texts } from "../shared/language.js";
import { BLOCK_STYLES, CATEGORY_STYLES, DEFINITIONS, MENUS, NEW_BREED, SHAPE_OF, TOOLBOX, meet } from "./blocks.js";

const PARTS = {
	light: { workspaceBackgroundColour: "#ffffff", toolboxBackgroundColour: "#f4f6fa", toolboxForegroundColour: "#1c2430", flyoutBackgroundColour: "#e9edf4", flyoutForegroundColour: "#1c2430", flyoutOpacity: 1, scrollbarColour: "#9aa6b6" },
	dark: { workspaceBackgroundColour: "#1a1f27", toolboxBackgroundColour: "#20262f", toolboxForegroundColour: "#e6eaf0", flyoutBackgroundColour: "#2a313c", flyoutForegroundColour: "#e6eaf0", flyoutOpacity: 1, scrollbarColour: "#5a6675" },
};
/** Blocks' words in points, and how large they are drawn: together 14 pixels and more. */
const [WORDS, SCALE] = [12, 0.9];
const [SMALLEST, LARGEST, ZOOM] = [0.3, 1.5, 1.2];
/** How long the name of a breed or a variable may be. */
const LONGEST = 30;
/** How far the first script is from the corner, in pixels. */
const MARGIN = 12;
const words = texts.play.editor;

/** The picture of a shape, as an address; the page that has an editor sets it. */
const pictures = { of: () => null };

/** The menu of shapes: each with its picture. */
const picturedShapes = () => MENUS.SHAPE().map(([text, value]) => [h("span.shape", { title: text }, h("img", { "data-shape": value, alt: "", width: 80, height: 60 }), text), value]);

Blockly.dialog.setPrompt(async (message, value, callback) => {
	const { ask } = await import("./ask.js");
	callback(await ask(message, value, LONGEST));
});
Blockly.common.defineBlocksWithJsonArray(DEFINITIONS.map((definition) => ({
	...definition,
	args0: definition.args0.map((part) => (part.menu ? { ...part, ...(part.menu === "SHAPE" ? { type: "field_shape", options: picturedShapes } : { options: MENUS[part.menu] }) } : part)),
	...(definition.args0.some(({ menu }) => menu === "BREED" || menu === "OTHER") && { extensions: ["new_breed"] }),
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
				// else those of before count
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
		for (const picture of Blockly.DropDownDiv.getContentDiv().querySelectorAll("img")) picture.src = pictures.of(picture.dataset.shape) ?? "icon.svg";
	}
}
Blockly.fieldRegistry.register("field_shape", FieldShape);

/** Branches beyond the first, which programs may bring: each condition with its place, and one for what is done otherwise. */
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

/**
 * Blockly writes style elements, which the page's policy forbids: the sheets that they would make are adopted by the document.
 */
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

/** The toolbox hears no keys by itself: the plugin does. */
class Toolbox extends Blockly.Toolbox {
	onKeyDown_() {}
}
Blockly.registry.register(Blockly.registry.Type.TOOLBOX, Blockly.registry.DEFAULT, Toolbox, true);

/** A bin that takes blocks which are dropped on it. */
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

/** Tells menus of what a program names. */
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
 * @param {number} highest how high the picture may be, in pixels
 */
export function showBlocks(host, program, highest) {
	meetAll(program);
	const workspace = adoptStyles(() => Blockly.inject(host, { theme: themes.light, renderer: "zelos", media: "media/", sounds: false, readOnly: true, trashcan: false, zoom: { minScale: 0.1 }, move: { scrollbars: false, drag: false, wheel: false } }));
	Blockly.serialization.workspaces.load(program, workspace);
	const blocks = workspace.getTopBlocks(true);
	for (const block of blocks) block.setCollapsed(false);
	// else blocks have no sizes yet
	Blockly.renderManagement.triggerQueuedRenders();
	const heights = blocks.map((block) => block.getHeightWidth().height + MARGIN);
	const half = heights.reduce((sum, height) => sum + height, 0) / 2;
	const ends = [0, 0];
	const widths = [0, 0];
	blocks.forEach((block, i) => {
		const column = ends[0] > 0 && ends[0] + heights[i] / 2 > half ? 1 : 0;
		block.moveTo(new Blockly.utils.Coordinate(column === 0 ? 0 : widths[0] + 2 * MARGIN, ends[column]));
		const { height, width } = block.getHeightWidth();
		ends[column] += height + 2 * MARGIN;
		widths[column] = Math.max(widths[column], width);
	});
	const scale = Math.min(SCALE, host.clientWidth / (widths[0] + widths[1] + 3 * MARGIN), highest / Math.max(...ends));
	workspace.setScale(scale);
	host.style.height = `${Math.ceil(Math.max(...ends) * scale)}px`;
	Blockly.svgResize(workspace);
	workspace.translate(0, 0);
	// the picture has a name of its own, and what Blockly measures words with is in no part of the page
	for (const part of host.querySelectorAll("[aria-label]")) part.removeAttribute("aria-label");
	document.querySelector(".blocklyComputeCanvas")?.setAttribute("aria-hidden", "true");
}

let isKeyboardReady = false;

export class Editor {
	#isLoading = false;
	#failed = null;
	/** Blocks that the last change has deleted, with those that it has deleted before. */
	#deleted = { group: "", count: 0 };

	/**
	 * @param {HTMLElement} host what it fills
	 * @param {HTMLElement} bar takes the buttons that change the program and its size
	 * @param {{onChange: (deleted: number) => void, pictureOf: (shape: string) => string|null, say: (text: string) => void}} page onChange is called when the
	 *     user has changed the program, with the number of blocks that this has deleted
	 */
	constructor(host, bar, { onChange, pictureOf, say }) {
		pictures.of = pictureOf;
		const narrow = innerWidth < 520;
		this.workspace = adoptStyles(() => {
			if (!isKeyboardReady) {
				KeyboardNavigation.registerKeyboardNavigationStyles();
				KeyboardNavigation.registerFlyoutCursor();
				isKeyboardReady = true;
			}
			const workspace = Blockly.inject(host, {
				toolbox: TOOLBOX, theme: theme(), renderer: "zelos", media: "media/", sounds: false, trashcan: false, horizontalLayout: narrow,
				zoom: { controls: false, wheel: false, pinch: true, startScale: SCALE, scaleSpeed: ZOOM, minScale: SMALLEST, maxScale: LARGEST }, move: { scrollbars: true, drag: true, wheel: true },
			});
			this.keyboard = new KeyboardNavigation(workspace);
			// Blockly leaves them out where the drawer is above
			if (narrow) workspace.getToolbox().getToolboxItems().forEach((item, i) => item.getDiv().querySelector("[role=presentation]").classList.add(...TOOLBOX.contents[i].cssconfig.icon.split(" ")));
			return workspace;
		});
		// a block comes out of the drawer whichever way it is pulled; the drawer is scrolled beside its blocks, and by the wheel
		this.workspace.getFlyout().isDragTowardWorkspace = () => true;
		this.#addTools(host, bar, say);
		this.forgetTheme = onThemeChange(() => adoptStyles(() => this.workspace.setTheme(theme())));
		this.observer = new ResizeObserver(() => Blockly.svgResize(this.workspace));
		this.observer.observe(host);
		this.workspace.addChangeListener((event) => {
			// events come later than what they tell of: those of loading end with this one
			if (event.type === Blockly.Events.FINISHED_LOADING) {
				this.#isLoading = false;
				// what is undone belongs to the program that is there
				this.workspace.clearUndo();
			} else if (!event.isUiEvent && !this.#isLoading) {
				onChange(this.#countDeleted(event));
			}
			this.#showTools();
		});
	}

	#addTools(host, bar, say) {
		const tool = (name, onclick) => button("", onclick, { class: `tool tool-${name}`, "aria-label": words[name], title: words[name] });
		const { workspace } = this;
		this.undoButton = tool("undo", () => this.undo());
		this.redoButton = tool("redo", () => workspace.undo(true));
		bar.replaceChildren(this.undoButton, this.redoButton, tool("smaller", () => workspace.zoomCenter(-1)), tool("larger", () => workspace.zoomCenter(1)));
		const bin = tool("bin", () => {
			const block = Blockly.common.getSelected();
			if (block?.isDeletable?.()) block.checkAndDelete();
			else say(words.howToDelete);
		});
		// the block stays chosen
		bin.addEventListener("pointerdown", (event) => event.preventDefault());
		host.append(bin);
		workspace.getComponentManager().addComponent({ component: new Bin(bin), weight: 2, capabilities: [Blockly.ComponentManager.Capability.DELETE_AREA, Blockly.ComponentManager.Capability.DRAG_TARGET] });
		this.#showTools();
	}

	#showTools() {
		// a button that is disabled would lose the focus
		this.undoButton.setAttribute("aria-disabled", String(!this.canUndo));
		this.redoButton.setAttribute("aria-disabled", String(this.workspace.getRedoStack().length === 0));
	}

	/** How many blocks the user has deleted at once, by the events until this one. */
	#countDeleted({ type, group, ids, recordUndo }) {
		if (type !== Blockly.Events.BLOCK_DELETE || !recordUndo) return 0;
		this.#deleted = { group, count: ids.length + (this.#deleted.group === group ? this.#deleted.count : 0) };
		return this.#deleted.count;
	}

	get program() {
		return Blockly.serialization.workspaces.save(this.workspace);
	}

	/**
	 * Shows a program; throws if Blockly finds none in it, and then shows what it did before.
	 *
	 * @param {object} program in Blockly's notation
	 * @param {boolean} inOrder whether its scripts are put in order
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

	/** Whether the user has changed anything since this program is shown. */
	get canUndo() {
		return this.workspace.getUndoStack().length > 0;
	}

	/** Takes back the user's last change. */
	undo() {
		this.workspace.undo(false);
	}

	/** The system that the program begins with, if its start has a block for that; null if not. */
	get system() {
		return this.#systemBlock?.getFieldValue("SYSTEM") ?? null;
	}

	set system(name) {
		this.#systemBlock?.setFieldValue(name, "SYSTEM");
	}

	/** The block that decides which collision system a program begins with: the last one in a start, or null. */
	get #systemBlock() {
		return this.workspace.getBlocksByType("starlogo_system", true).filter((block) => block.getRootBlock().type === "starlogo_start" && block.isEnabled()).at(-1) ?? null;
	}

	/** Marks the block that an error is about, and goes there if told; none for null. */
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
