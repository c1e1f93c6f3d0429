/** Draws pictures of games' beginnings, for pages that play no game. */
import { h } from "../../shared/dom.js";
import { toBytes } from "../../shared/files/files.js";
import { landOf, loadLand, parseModel } from "../../shared/files/models.js";
import { SHAPES } from "../../shared/names.js";
import { LandStage } from "./landstage.js";
import { Scene } from "./scene.js";
import { World } from "../game/world.js";

/** The size of the pictures in pixels. It is large enough for printing. */
export const PICTURE = [800, 500];

/** The loading of the page's models. After a failure the next call tries again. */
let loading = null;
/** The lands of pupils with models of their own. */
const lands = new WeakMap();

/** The page's land with further models, given as their files' text. */
async function withOwn(shapes, own) {
	if (Object.keys(own).length === 0) return shapes;
	if (!lands.has(own)) {
		const models = new Map(shapes.models);
		for (const [name, text] of Object.entries(own)) if (!models.has(name)) models.set(name, await parseModel(name, toBytes(text)));
		lands.set(own, landOf(models));
	}
	return lands.get(own);
}

/** The page's models, with the own models of a program: all by their names, and the engine's land of them. */
export async function landFor(own = {}) {
	if (!loading) {
		loading = loadLand(SHAPES);
		loading.catch(() => {
			loading = null;
		});
	}
	return withOwn(await loading, own);
}

/** A stage that is not seen, for pictures. */
export class Studio {
	/** @param {HTMLElement} parent contains the stage while it draws */
	constructor(parent) {
		this.host = h("div.studio", { "aria-hidden": "true" });
		parent.append(this.host);
		this.stage = new LandStage(this.host, "");
	}

	/**
	 * Draws the beginning of a program's game.
	 *
	 * @param {object} program
	 * @param {Record<string, string>} own the program's own models: their files as text
	 * @param {number} width
	 * @param {number} height
	 * @returns {Promise<string|null>} the picture's address; null if nothing can be drawn
	 */
	async pictureOf(program, own = {}, width = PICTURE[0], height = PICTURE[1]) {
		try {
			await import("../game/lateengine.js");
			const { models, greatLand } = await landFor(own);
			return new Scene(this.stage, new World(greatLand), models, this.host).pictureOfGame(program, width, height);
		} catch {
			return null;
		}
	}

	close() {
		this.stage.close();
		this.host.remove();
	}
}

/**
 * Draws the beginning of one program's game into an image element, which is removed if nothing can be drawn.
 *
 * @param {HTMLElement} parent contains the stage while it draws
 */
export async function drawInto(picture, parent, program, own = {}) {
	const studio = new Studio(parent);
	const address = await studio.pictureOf(program, own);
	studio.close();
	if (address) picture.src = address;
	else picture.remove();
}
