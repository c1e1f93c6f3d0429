#!/usr/bin/env node
/**
 * Whether the engine makes garbage in every frame without anybody's seeing it: Adobe's VM keeps a Number in an object of its own where it
 * does not know that it is one. Reads the compiled engine as the SDK's swfdump prints it, lists what does that in the functions that run
 * every frame, and exits with 1 if there is more, or less, than is allowed.
 *
 *   swfdump -abc library.swf > file; node test/structure/boxes.mjs file
 *
 * coerce_a: both arms of a ternary that is not assigned to a typed local at once (or passed, or returned), what is assigned to an
 * untyped variable, and what a for each goes over. Math.max and Math.min of three: their arguments are put into an Array. A member of a cast
 * that is in no typed local, as in Sphere(structure).radius: the VM does not know the class of a cast, so it looks the member up by its name,
 * in some 30 ns, and keeps a Number that it finds there in an object.
 */
import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';

/** Packages and classes whose functions run every frame. */
const HOT = ['starlogo.agents', 'starlogo.bounding', 'starlogo.broadphase', 'starlogo.collision', 'starlogo.convex', 'starlogo.data.IntPairMap', 'starlogo.data.SortableIntList', 'starlogo.data.IntList', 'starlogo.geometry.Placement',
	'starlogo.geometry.Touching', 'starlogo.ground', 'starlogo.handlers', 'starlogo.hierarchy', 'starlogo.intersection', 'starlogo.queries', 'starlogo.search', 'starlogo.solid', 'starlogo.terrain'];

/** Classes of those packages that do not, and why. */
const COLD = {
	'starlogo.handlers.HandlerList': 'when handlers change',
	'starlogo.handlers.HandlerTable': 'made when handlers change',
	'starlogo.handlers.PairHandlers': 'made when handlers change',
	'starlogo.hierarchy.BoxTreeBuilder': 'when a model loads',
	'starlogo.hierarchy.TreePartition': 'when a model loads',
	'starlogo.solid.interior.CavityFinder': 'when a model loads',
	'starlogo.solid.interior.ClosedShell': 'when a model loads',
	'starlogo.solid.interior.DisjointSets': 'when a model loads',
	'starlogo.solid.interior.EdgeMatcher': 'when a model loads',
	'starlogo.solid.interior.ShellFinder': 'when a model loads',
	'starlogo.solid.interior.ComponentFinder': 'when a model loads',
	'starlogo.solid.interior.SurfaceTopology': 'when a model loads',
	'starlogo.solid.interior.VertexWelder': 'when a model loads',
	'starlogo.search.BaseShapeChoice': 'when agents get other models, and when models are replaced',
	'starlogo.search.BreedInterests': 'made when handlers change',
	'starlogo.terrain.TerrainSurface': 'when the ground is drawn anew',
};

/** How many there may be in a function: none of them is of a Number. */
export const ALLOWED = {
	'starlogo.agents.Agent.collideAs': { count: 2, why: 'the text of an error' },
	'starlogo.collision.FrameRunner.run': { count: 1, why: 'what a finally throws again' },
	'starlogo.handlers.requireParameters': { count: 2, why: 'the text of an error' },
	'starlogo.handlers.BreedHints.hintFor': { count: 1, why: 'runs when handlers change, or a block first names a breed or sets a trait of one' },
	'starlogo.handlers.warnOfMissingBreeds': { count: 1, why: 'runs when handlers change, or a block first names a breed or sets a trait of one' },
	'starlogo.queries.Footing.toString': { count: 4, why: 'the text of a trace' },
	'starlogo.search.table.ListedAgents.requireAgent': { count: 2, why: 'the text of an error' },
	'starlogo.queries.trees.Collector.admitTo': { count: 1, why: 'what a finally throws again' },
};

const FEWEST_FUNCTIONS = 150;

const BOXES = /^(?:coerce_a\b|callproperty\s+:(?:max|min) \((?!2\)))/;

// a class that is called with one argument, and a member that is read of what this returns
const CAST = /^callproperty\s+\S*:[A-Z][a-z]\w* \(1\)/;
const MEMBER = /^(?:getproperty|callproperty\s.*\(0\)$)/;

/** A function's qualified name from the line that swfdump heads it with; '' for initialisers, which run once. */
function nameIn(header) {
	const [owner, member] = header.replace(/^[gs]et /, '').split('(')[0].split(/::(.*)/);
	if (member === undefined || member.endsWith('init')) {
		return '';
	}
	return (owner.startsWith('script') ? member : `${owner}:${member.split(':').pop()}`).replaceAll(':', '.');
}

function isHot(name) {
	const isIn = (room) => name.startsWith(`${room}.`);
	return HOT.some(isIn) && !Object.keys(COLD).some(isIn);
}

/**
 * The functions that run every frame, and the source lines of what boxes Numbers in each, one for each such instruction.
 *
 * @param {string} dump what swfdump -abc prints
 * @returns {Map<string, number[]>}
 */
export function boxesIn(dump) {
	const boxes = new Map();
	let lines;
	let line = 0;
	let last = '';
	for (const text of dump.split('\n')) {
		const [, header] = /^ {4}function (.*)$/.exec(text) ?? [];
		if (header) {
			const name = nameIn(header);
			lines = isHot(name) ? boxes.get(name) ?? [] : undefined;
			if (lines) {
				boxes.set(name, lines);
			}
		}
		line = Number(/^\s+(?:L\d+:\s*)?debugline\s+(\d+)/.exec(text)?.[1] ?? line);
		const [, instruction] = /^\s+(?:L\d+:\s*)?(\S.*)$/.exec(text) ?? [];
		if (lines && (BOXES.test(instruction) || (CAST.test(last) && MEMBER.test(instruction)))) {
			lines.push(line);
		}
		last = /^debugline/.test(instruction) ? last : instruction;
	}
	return boxes;
}

/** What is wrong with them, in words; an empty list if nothing is. */
export function faultsOf(boxes, allowed = ALLOWED) {
	const faults = [];
	for (const [name, lines] of boxes) {
		if (lines.length > (allowed[name]?.count ?? 0)) {
			faults.push(`${name} may box Numbers in lines ${[...new Set(lines)].join(', ')}: ${lines.length} times`);
		}
	}
	for (const [name, { count }] of Object.entries(allowed)) {
		const found = boxes.get(name)?.length ?? 0;
		if (found < count) {
			faults.push(`${name} is allowed ${count}, and has ${found}: say so in test/structure/boxes.mjs`);
		}
	}
	return faults;
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
	const boxes = boxesIn(readFileSync(process.argv[2], 'utf8'));
	const faults = faultsOf(boxes);
	if (boxes.size < FEWEST_FUNCTIONS) {
		faults.push(`only ${boxes.size} functions run every frame: is ${process.argv[2]} a dump of the engine?`);
	}
	console.log(faults.join('\n') || `boxed Numbers: none in ${boxes.size} functions that run every frame`);
	process.exitCode = faults.length > 0 ? 1 : 0;
}
