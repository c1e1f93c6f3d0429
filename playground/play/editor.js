/** The program as blocks: Blockly, dressed as the page and tamed for its policy. */
import * as Blockly from "blockly/core";
import "blockly/blocks";
import * as messages from "blockly/msg/en";
import { isDark, onThemeChange } from "../shared/dom.js";
import { BLOCK_STYLES, CATEGORY_STYLES, DEFINITIONS, TOOLBOX } from "./blocks.js";

Blockly.setLocale(messages);
Blockly.common.defineBlocksWithJsonArray(DEFINITIONS);

const PARTS = {
	light: { workspaceBackgroundColour: "#ffffff", toolboxBackgroundColour: "#f4f6fa", toolboxForegroundColour: "#1c2430", flyoutBackgroundColour: "#e9edf4", flyoutForegroundColour: "#1c2430", flyoutOpacity: 1, scrollbarColour: "#9aa6b6" },
	dark: { workspaceBackgroundColour: "#1a1f27", toolboxBackgroundColour: "#20262f", toolboxForegroundColour: "#e6eaf0", flyoutBackgroundColour: "#2a313c", flyoutForegroundColour: "#e6eaf0", flyoutOpacity: 1, scrollbarColour: "#5a6675" },
};
const themes = Object.fromEntries(Object.entries(PARTS).map(([name, componentStyles]) => [name, Blockly.Theme.defineTheme(`playground-${name}`, {
	name: `playground-${name}`, base: Blockly.Themes.Classic, blockStyles: BLOCK_STYLES, categoryStyles: CATEGORY_STYLES, componentStyles,
	fontStyle: { family: "system-ui, sans-serif", weight: "500", size: 11 }, startHats: true,
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

export class Editor {
	/**
	 * @param {HTMLElement} host what it fills
	 * @param {() => void} onChange called when the program has changed
	 */
	constructor(host, onChange) {
		const narrow = host.clientWidth < 520;
		this.workspace = adoptStyles(() => Blockly.inject(host, {
			toolbox: TOOLBOX, theme: theme(), renderer: "zelos", media: "media/", sounds: false, trashcan: false, horizontalLayout: narrow,
			zoom: { controls: !narrow, wheel: false, pinch: true, startScale: narrow ? 0.6 : 0.7, minScale: 0.3, maxScale: 1.5 }, move: { scrollbars: true, drag: true, wheel: true },
		}));
		this.forgetTheme = onThemeChange(() => adoptStyles(() => this.workspace.setTheme(theme())));
		this.observer = new ResizeObserver(() => Blockly.svgResize(this.workspace));
		this.observer.observe(host);
		this.workspace.addChangeListener((event) => {
			if (!event.isUiEvent && event.type !== Blockly.Events.FINISHED_LOADING && !this.loading) onChange();
		});
	}

	get program() {
		return Blockly.serialization.workspaces.save(this.workspace);
	}

	/** Shows a program, its scripts put in order if told; throws if Blockly finds none in it, and then shows what it did before. */
	show(program, inOrder) {
		const before = this.program;
		this.loading = true;
		try {
			Blockly.serialization.workspaces.load(program, this.workspace);
			if (inOrder) this.workspace.cleanUp();
		} catch (error) {
			Blockly.serialization.workspaces.load(before, this.workspace);
			throw error;
		} finally {
			this.workspace.scroll(12, 12);
			// the events come later
			setTimeout(() => {
				this.loading = false;
			}, 50);
		}
	}

	/** Marks the block that an error is about; none for null. */
	mark(id) {
		this.workspace.highlightBlock(id);
		if (id) this.workspace.centerOnBlock(id);
	}

	close() {
		this.observer.disconnect();
		this.forgetTheme();
		this.workspace.dispose();
	}
}
