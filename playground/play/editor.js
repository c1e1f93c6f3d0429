/** The program as blocks: Blockly, dressed as the page and tamed for its policy. */
import * as Blockly from "blockly/core";
import "./locale.js";
import { KeyboardNavigation } from "@blockly/keyboard-navigation";
import { isDark, onThemeChange } from "../shared/dom.js";
import { texts } from "../shared/language.js";
import { BLOCK_STYLES, CATEGORY_STYLES, DEFINITIONS, MENUS, NEW_BREED, TOOLBOX, meet } from "./blocks.js";

const PARTS = {
	light: { workspaceBackgroundColour: "#ffffff", toolboxBackgroundColour: "#f4f6fa", toolboxForegroundColour: "#1c2430", flyoutBackgroundColour: "#e9edf4", flyoutForegroundColour: "#1c2430", flyoutOpacity: 1, scrollbarColour: "#9aa6b6" },
	dark: { workspaceBackgroundColour: "#1a1f27", toolboxBackgroundColour: "#20262f", toolboxForegroundColour: "#e6eaf0", flyoutBackgroundColour: "#2a313c", flyoutForegroundColour: "#e6eaf0", flyoutOpacity: 1, scrollbarColour: "#5a6675" },
};
/** Blocks' words in points, and how large they are drawn: together 14 pixels and more. */
const [WORDS, SCALE] = [12, 0.9];

Blockly.common.defineBlocksWithJsonArray(DEFINITIONS.map((definition) => ({
	...definition,
	args0: definition.args0.map((part) => (part.menu ? { ...part, options: MENUS[part.menu] } : part)),
	...(definition.args0.some(({ menu }) => menu === "BREED" || menu === "OTHER") && { extensions: ["new_breed"] }),
})));
Blockly.Extensions.register("new_breed", function askForBreeds() {
	for (const name of ["BREED", "OTHER"]) {
		const field = this.getField(name);
		field?.setValidator((value) => {
			if (value !== NEW_BREED) return value;
			Blockly.dialog.prompt(texts.blocks.askBreed, "", (answer) => {
				const breed = answer?.trim().slice(0, 30);
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

let isKeyboardReady = false;

export class Editor {
	#isLoading = false;
	#failed = null;

	/**
	 * @param {HTMLElement} host what it fills
	 * @param {(isDeletion: boolean) => void} onChange called when the user has changed the program
	 */
	constructor(host, onChange) {
		const narrow = innerWidth < 520;
		this.workspace = adoptStyles(() => {
			if (!isKeyboardReady) {
				KeyboardNavigation.registerKeyboardNavigationStyles();
				KeyboardNavigation.registerFlyoutCursor();
				isKeyboardReady = true;
			}
			const workspace = Blockly.inject(host, {
				toolbox: TOOLBOX, theme: theme(), renderer: "zelos", media: "media/", sounds: false, trashcan: false, horizontalLayout: narrow,
				zoom: { controls: !narrow, wheel: false, pinch: true, startScale: SCALE, minScale: 0.3, maxScale: 1.5 }, move: { scrollbars: true, drag: true, wheel: true },
			});
			this.keyboard = new KeyboardNavigation(workspace);
			return workspace;
		});
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
				onChange(event.type === Blockly.Events.BLOCK_DELETE);
			}
		});
	}

	get program() {
		return Blockly.serialization.workspaces.save(this.workspace);
	}

	/** Shows a program, its scripts put in order if told; throws if Blockly finds none in it, and then shows what it did before. */
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
			this.workspace.scroll(12, 12);
		}
	}

	#load(program, inOrder) {
		// menus take what they know
		JSON.stringify(program, (key, value) => {
			meet(key, value);
			return value;
		});
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

	/** Marks the block that an error is about; none for null. */
	mark(id) {
		this.#failed?.getSvgRoot()?.classList.remove("failed");
		this.#failed = id ? this.workspace.getBlockById(id) : null;
		if (!this.#failed) return;
		for (let block = this.#failed; block; block = block.getParent()) block.setCollapsed(false);
		this.#failed.getSvgRoot().classList.add("failed");
		this.workspace.centerOnBlock(id);
	}

	close() {
		this.observer.disconnect();
		this.forgetTheme();
		this.keyboard.dispose();
		this.workspace.dispose();
	}
}
