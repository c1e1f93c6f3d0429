#!/usr/bin/env node
/**
 * Walks of spheres, capsules, boxes and hulls in one level that is made three times: as a ground, as one mesh whose triangles decide, and of cubes.
 *
 *   node test/fuzz/levels.mjs WALKS [SEED]
 *
 * After each walk the walker must not be in the solid of any triangle. Where no wall is, it must not be stuck. From the same place it must come to the same
 * place in all worlds.
 */
import { pathToFileURL } from "node:url";
import { gapToPrism, prismsOf } from "./geometry.mjs";
import { bodiesOf } from "./shapes.mjs";
import { engine, numbersOf, toolsOf } from "./tools.mjs";

const { Agent, AgentQueries, BuiltInModel, CombinationCollider, Footing, GreatLand, Model, Terrain, TerrainSurface, TightestFitCollider, WalkOptions } = engine;

const SIZE = 13;
const CELL = 0.5;
const FROM = -CELL * (SIZE - 1) / 2;

/** As deep in a triangle's solid, and as far from where the walker comes in another world: parts of its size. */
const DEEP = 1e-7;
const ALIKE = 1e-6;

const WALKERS = [["sphere", "sphere"], ["cylinder", "capsule"], ["cube", "box"], ["cube", "hull"]];

/** Heights by column and row; whether they are columns; whether there is nowhere a wall. */
const LEVELS = {
	hills: ({ between }) => {
		const [a, b, c] = [between(0.1, 0.5), between(0.3, 0.9), between(0, 6)];
		return { heightAt: (column, row) => a * (Math.sin(b * column + c) + Math.cos(b * row)), isBlocky: false, isOpen: true };
	},
	stairs: ({ pick }) => {
		const step = pick([0.1, 0.2, 0.24]);
		return { heightAt: (column, row) => step * Math.floor(Math.max(column, row) / 2), isBlocky: true, isOpen: true };
	},
	rough: ({ random }) => ({ heightAt: () => 0.24 * random(), isBlocky: true, isOpen: true }),
	walls: ({ random, between }) => ({ heightAt: () => (random() < 0.2 ? between(0.3, 2) : 0), isBlocky: true, isOpen: false }),
	ramps: ({ pick }) => {
		const steep = pick([0.3, 0.45, 0.8, 1]);
		return { heightAt: (column) => steep * Math.abs(column - 6), isBlocky: false, isOpen: false };
	},
};

/** A queries object for each world, with a walker. */
function worldsOf({ heightAt, isBlocky }, [shape, kind], size) {
	const terrain = new Terrain(SIZE, SIZE, CELL, FROM, FROM);
	terrain.isBlocky = isBlocky;
	const heights = Array.from({ length: SIZE * SIZE }, (_, i) => heightAt(i % SIZE, Math.floor(i / SIZE)));
	terrain.setHeights(0, 0, SIZE, SIZE, heights);
	const land = Object.assign(new GreatLand(), { loadAllBoundingStructures: true, loadHulls: true });
	for (const model of [BuiltInModel.sphere(), BuiltInModel.cube(), BuiltInModel.cylinder()]) land.addModel(model);
	const surface = new TerrainSurface(terrain);
	surface.update();
	land.addModel(new Model("mesh", surface.vertices, surface.triangles, Model.AS_GIVEN));
	const walkerOf = () => Object.assign(new Agent(shape, "walkers"), { size, collideAs: kind });
	const world = (system, level, ground) => {
		const queries = new AgentQueries(system);
		const walker = walkerOf();
		queries.terrain = ground;
		queries.update([...level, walker]);
		return { queries, walker };
	};
	const worlds = { ground: world(new TightestFitCollider(land), [], terrain) };
	worlds.mesh = world(Object.assign(new CombinationCollider(land), { exact: true }), [Object.assign(new Agent("mesh", "level"), { hierarchical: true })], null);
	if (isBlocky) {
		const cubes = heights.flatMap((height, i) => Array.from({ length: Math.ceil(height / CELL) + 2 }, (_, k) => {
			const cube = Object.assign(new Agent("cube", "level"), { size: CELL });
			cube.moveTo(FROM + CELL * (i % SIZE), FROM + CELL * Math.floor(i / SIZE), height - (k + 1) * CELL);
			return cube;
		}));
		worlds.cubes = world(new TightestFitCollider(land), cubes, null);
	}
	return { worlds, terrain, land, prisms: prismsOf(terrain, heights) };
}

function walk({ queries, walker }, from, dx, dy, options) {
	walker.jumpTo(...from);
	queries.moved(walker);
	const footing = queries.walk(walker, dx, dy, options, new Footing());
	return { footing, at: [walker.x, walker.y, walker.z] };
}

/** Walks, and what went wrong: a text for each. */
export function walkLevels(count, seed) {
	const found = { walks: 0, through: [], stuck: [], unlike: [] };
	for (let each = seed; found.walks < count; each++) {
		const tools = toolsOf(numbersOf(each));
		const name = tools.pick(Object.keys(LEVELS));
		const level = LEVELS[name](tools);
		const kind = tools.pick(WALKERS);
		const size = tools.between(0.3, 0.9);
		const { worlds, terrain, land, prisms } = worldsOf(level, kind, size);
		const setting = { land, setting: { system: 1 } };
		const options = Object.assign(new WalkOptions(), { carried: false });
		const within = -FROM - 1;
		let at = [tools.between(-within, within), tools.between(-within, within), 4];
		at = walk(worlds.ground, at, 0, 0, Object.assign(new WalkOptions(), { fall: Infinity })).at;
		let way = tools.between(0, 2 * Math.PI);
		for (let i = 0; i < 40 && Math.max(Math.abs(at[0]), Math.abs(at[1])) < within; i++) {
			way += tools.between(-0.5, 0.5);
			const step = tools.pick([0.02, 0.1, 0.3]);
			const ends = Object.entries(worlds).map(([world, made]) => {
				const end = walk(made, at, step * Math.cos(way), step * Math.sin(way), options);
				const text = `seed ${each}: ${name}, ${kind[1]} of size ${size} in ${world}, ${step} along ${way} from ${at} to ${end.at}`;
				const gap = Math.min(...bodiesOf(setting, made.walker).flatMap((body) => prisms.map((prism) => gapToPrism(body, prism))));
				if (gap < -DEEP * size) found.through.push(`${text}: ${-gap} deep`);
				if (level.isOpen && end.footing.part < 1e-3 && Array.from({ length: 8 }, (_, k) => k * Math.PI / 4).every((turn) => walk(made, at, step * Math.cos(way + turn), step * Math.sin(way + turn), options).footing.part < 1e-3)) found.stuck.push(text);
				found.walks++;
				return { ...end, text };
			});
			for (const end of ends.slice(1)) if (Math.hypot(...end.at.map((value, k) => value - ends[0].at[k])) > ALIKE * size) found.unlike.push(`${end.text}, not ${ends[0].at}`);
			[{ at }] = ends;
		}
	}
	return found;
}

if (import.meta.url === pathToFileURL(process.argv[1]).href) {
	const [count = "10000", seed = "1"] = process.argv.slice(2);
	const { walks, ...wrong } = walkLevels(Number(count), Number(seed));
	for (const [what, texts] of Object.entries(wrong)) console.log(`${what}: ${texts.length} of ${walks} walks${texts.slice(0, 5).map((text) => `\n  ${text}`).join("")}`);
	process.exitCode = wrong.through.length + wrong.stuck.length > 0 ? 1 : 0;
}
