/** Writes a program for the npm package with two agents and a collision system. */
import { CollisionBlocks } from "starlogo-collision";
import { BUILT_IN, INSTALL, fileOf } from "../shared/names.js";
import { HULLS } from "./systems.js";

/** The traits of a new agent. The code sets only traits that differ. */
const USUAL = { x: 0, y: 0, z: 0, heading: 0, pitch: 0, roll: 0, size: 1, hierarchical: false, collideAs: "tightest" };

/**
 * A program that asks a collision system about two agents.
 *
 * @param {object[]} agents the two agents
 * @param {string} system the system's name
 * @param {boolean} areColliding the system's answer
 */
export function codeOf(agents, system, areColliding) {
	const shapes = [...new Set(agents.map(({ shape }) => shape))];
	const models = shapes.map((name) => (BUILT_IN.includes(name) ? `greatLand.addModel(BuiltInModel.${name}());`
		: fileOf(name) === null ? `greatLand.addModel(new Model(${JSON.stringify(name)}, vertices, triangles)); // of your own`
			: `await loader.loadAsync("${name}", "assets/${fileOf(name)}");`));
	const isUsed = (word) => models.some((line) => line.includes(word));
	const names = ["Agent", ...(isUsed("BuiltInModel") ? ["BuiltInModel"] : []), "CollisionBlocks", "GreatLand", ...(isUsed("new Model") ? ["Model"] : []), ...(isUsed("loader") ? ["ModelLoader"] : [])];
	return [
		INSTALL,
		`import { ${names.join(", ")} } from "starlogo-collision";`,
		"",
		"const greatLand = new GreatLand();",
		...(isUsed("loader") ? ["const loader = new ModelLoader(greatLand);"] : []),
		...models,
		...agents.map((agent, i) => `const ${"ab"[i]} = ${made(agent)};`),
		`const system = new CollisionBlocks(greatLand, [a, b]).systemNamed("${system === HULLS ? CollisionBlocks.TIGHTEST_FITS : system}");`,
		`console.log(system.areColliding(a, b)); // ${areColliding}`,
	].join("\n");
}

function made(agent) {
	const shape = JSON.stringify(agent.shape);
	const traits = Object.entries(USUAL).filter(([name, usual]) => agent[name] !== usual).map(([name]) => `${name}: ${JSON.stringify(agent[name])}`);
	return traits.length > 0 ? `Object.assign(new Agent(${shape}), { ${traits.join(", ")} })` : `new Agent(${shape})`;
}
