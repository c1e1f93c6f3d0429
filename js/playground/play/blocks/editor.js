/** Shows and edits the program as blocks, with Blockly. */
import * as Blockly from "blockly/core";
import "../game/lateengine.js";
import { KeyboardNavigation } from "@blockly/keyboard-navigation";
import { button, h, onThemeChange } from "../../shared/dom.js";
import { texts } from "../../shared/language.js";
import { MEDIA } from "../../shared/files/served.js";
import { TOOLBOX, drawerFor, addToMenus, variableDrawer } from "./blocks.js";
import { Building } from "./building.js";
import { Placing } from "./placing.js";
import { readAloud } from "./reading.js";
import { MARGIN, SCALE, adoptStyles, pictures, theme } from "./setup.js";

/** The largest and the smallest scale of the drawer's blocks, and the pixels that it leaves for the scripts if it can. */
const [IN_DRAWER, LEAST_IN_DRAWER, LEFT_FOR_SCRIPTS] = [0.84, 0.75, 220];
const [SMALLEST, LARGEST, ZOOM] = [0.3, 1.5, 1.2];
const words = texts.play.editor;

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
			workspace.registerToolboxCategoryCallback("VARIABLE", (each) => variableDrawer(Blockly.Variables.flyoutCategory(each, false)));
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
		this.undoButton.setAttribute("aria-disabled", String(this.workspace.getUndoStack().length === 0));
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
		addToMenus(program);
		Blockly.Events.disable();
		try {
			Blockly.serialization.workspaces.load(program, this.workspace);
			if (inOrder) this.workspace.cleanUp();
		} finally {
			Blockly.Events.enable();
		}
		Blockly.Events.fire(new (Blockly.Events.get(Blockly.Events.FINISHED_LOADING))(this.workspace));
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
