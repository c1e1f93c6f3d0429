/** Sets up Blockly for the page: its blocks and menus, its style, which keeps to the page's policy, and its words. */
import * as Blockly from "blockly/core";
import "./locale.js";
import { KeyboardNavigation } from "@blockly/keyboard-navigation";
import { h, isDark } from "../../shared/dom.js";
import { texts } from "../../shared/language.js";
import { ICON } from "../../shared/files/served.js";
import { BLOCK_STYLES, CATEGORY_STYLES, DEFINITIONS, MENUS, NEW_BREED, SHAPE_OF, addToMenu } from "./blocks.js";

const PARTS = {
	light: { workspaceBackgroundColour: "#ffffff", toolboxBackgroundColour: "#f4f6fa", toolboxForegroundColour: "#1c2430", flyoutBackgroundColour: "#e9edf4", flyoutForegroundColour: "#1c2430", flyoutOpacity: 1, scrollbarColour: "#9aa6b6" },
	dark: { workspaceBackgroundColour: "#1a1f27", toolboxBackgroundColour: "#20262f", toolboxForegroundColour: "#e6eaf0", flyoutBackgroundColour: "#2a313c", flyoutForegroundColour: "#e6eaf0", flyoutOpacity: 1, scrollbarColour: "#5a6675" },
};
/** The blocks' scale, and the size of their words in points. Together the words are at least 14 pixels high. */
export const SCALE = 0.9;
const WORDS = 12;
/** The distance of the first script from the corner, in pixels. */
export const MARGIN = 12;
/** The most letters in the name of a breed or a variable. */
const LONGEST = 30;

/** Gives the address of a shape's picture. The page that has an editor sets it. */
export const pictures = { of: () => null };

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
				addToMenu(name, breed);
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

export const themes = Object.fromEntries(Object.entries(PARTS).map(([name, componentStyles]) => [name, Blockly.Theme.defineTheme(`playground-${name}`, {
	name: `playground-${name}`, base: Blockly.Themes.Classic, blockStyles: BLOCK_STYLES, categoryStyles: CATEGORY_STYLES, componentStyles,
	fontStyle: { family: "system-ui, sans-serif", weight: "500", size: WORDS }, startHats: true,
})]));
export const theme = () => themes[isDark() ? "dark" : "light"];

/** Blockly writes style elements, which the page's policy forbids. The document adopts their style sheets instead. */
export function adoptStyles(action) {
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

// Blockly takes no more styles after it has shown blocks, as a sheet for printing does
KeyboardNavigation.registerKeyboardNavigationStyles();
KeyboardNavigation.registerFlyoutCursor();
