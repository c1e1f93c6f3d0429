/** Draws pictures of games' beginnings, for pages that play no game. */
import { GreatLand } from "starlogo-collision";
import { h } from "../shared/dom.js";
import { loadModel } from "../shared/models.js";
import { SHAPES } from "../shared/names.js";
import { Stage } from "../shared/stage.js";
import { STAGE, Scene } from "./scene.js";
import { World } from "./world.js";

/** The size of the pictures in pixels. It is large enough for printing. */
export const PICTURE = [800, 500];

let loading = null;

async function load() {
	const models = new Map(await Promise.all(SHAPES.map(async (name) => [name, await loadModel(name)])));
	const greatLand = new GreatLand();
	for (const model of models.values()) greatLand.addModel(model);
	return { models, greatLand };
}

/**
 * Draws the beginning of a program's game.
 *
 * @param {object} program
 * @param {HTMLElement} parent contains the stage while it draws
 * @returns {Promise<string|null>} the picture's address; null if nothing can be drawn
 */
export async function pictureOf(program, parent) {
	loading ??= load();
	const { models, greatLand } = await loading;
	const world = new World(greatLand);
	world.begin(program);
	world.step();
	const host = h("div.studio", { "aria-hidden": "true" });
	parent.append(host);
	const stage = new Stage(host, { ...STAGE, label: "" });
	try {
		return new Scene(stage, world, models, host).pictureOfGame(program, world, ...PICTURE);
	} finally {
		stage.close();
		host.remove();
	}
}
