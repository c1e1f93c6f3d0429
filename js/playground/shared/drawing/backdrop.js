/** What is behind agents that stand on no land: a sky of one colour, and a grid as the ground. */
import { Color, GridHelper } from "three";
import { INK } from "./colours.js";

const LIGHTS = { light: { ambient: 1.5, sun: 2.2, ink: INK }, dark: { ambient: 1.1, sun: 2.2, ink: INK } };
const GRID = { light: { line: 0xc9d1de, middle: 0xaab5c6 }, dark: { line: 0x2c3440, middle: 0x46515f } };
const INDOORS = { light: 0xeef1f6, dark: 0x171b22 };
const OUTDOORS = { light: 0xa9d2f2, dark: 0x46618a };

class Backdrop {
	#grid = null;

	/**
	 * @param {object} scene contains the grid
	 * @param {{light: number, dark: number}} sky
	 * @param {number} width the width of the grid, 0 for none
	 * @param {number} cell the width of its cells
	 */
	constructor(scene, sky, width, cell) {
		Object.assign(this, { scene, sky, width, cell });
	}

	/** Builds it again for light or dark. Returns the brightness of the lights and the colour of the agents' outlines. */
	applyTheme(name) {
		this.dispose();
		this.scene.background = new Color(this.sky[name]);
		if (this.width > 0) {
			this.#grid = new GridHelper(this.width, this.width / this.cell, GRID[name].middle, GRID[name].line);
			this.#grid.rotation.x = Math.PI / 2;
			this.scene.add(this.#grid);
		}
		return LIGHTS[name];
	}

	dispose() {
		this.#grid?.removeFromParent();
		this.#grid?.dispose();
		this.#grid = null;
	}
}

/** The backdrop of a look at models: a grid. */
export const grid = (width, cell = 1) => (scene) => new Backdrop(scene, INDOORS, width, cell);

/** The backdrop of a level that brings its own ground. */
export const outdoors = (scene) => new Backdrop(scene, OUTDOORS, 0, 1);
