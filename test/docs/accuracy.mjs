#!/usr/bin/env node
/**
 * What each collision system makes of a scattered game, over many frames: how often it is right, and what a frame takes in Node. The timing
 * report counts the same way in the same game (PrecisionTask.as). Then the same of a ball in many places beside a dragon, against a loop over all
 * triangles. Prints the tables of docs/choosing.md.
 *
 *   ./antw module-test -Dtest=AccuracyTest && node test/docs/accuracy.mjs
 */
import { readFileSync } from 'node:fs';
import path from 'node:path';
import { pathToFileURL } from 'node:url';
import { toTriangle, windingOf } from '../fuzz/geometry.mjs';
import { root } from '../structure/sources.mjs';

const AGENTS = 150;
const FRAMES = 400;
const FILES = { bear: 'bear.obj', dragon: 'dragon.dae', fireman: 'fireman.dae', seagull: 'seagull.dae', fortress: 'fortress.obj', person: 'person.dae' };

const { Accuracy, Agent, BinCollider, BuiltInModel, Collider, ColladaModel, CombinationCollider, GreatLand, HierarchicalCollider, ObjModel, Scenes, ShapeChoice, TightestFitCollider } =
	await import(pathToFileURL(path.join(root, 'bin/generated/module/tests.mjs')).href);

const greatLand = Object.assign(new GreatLand(), { loadHulls: true });
for (const [name, file] of Object.entries(FILES)) {
	const bytes = new Uint8Array(readFileSync(path.join(root, 'assets', file)));
	greatLand.addModel(file.endsWith('.obj') ? ObjModel.fromBytes(name, bytes) : ColladaModel.fromBytes(name, bytes));
}

/** What the TightestFitCollider has if all agents collide as hulls. */
class Hulls extends ShapeChoice {
	bind(shape) {
		shape.setStructure(this.greatLand.boundingStructures.hull(shape.modelName));
	}
}

const atDepth = (maxDepth) => Object.assign(new HierarchicalCollider(greatLand), { maxDepth });
const systems = {
	'BinCollider': new BinCollider(greatLand),
	'TightestFitCollider': new TightestFitCollider(greatLand),
	'TightestFitCollider, hulls': new Collider(new Hulls(greatLand)),
	'CombinationCollider, every other agent hierarchical': new CombinationCollider(greatLand),
	'HierarchicalCollider, depth 1': atDepth(1),
	'HierarchicalCollider, depth 3': atDepth(3),
	'HierarchicalCollider, depth 5': atDepth(5),
	'HierarchicalCollider, depth 10': atDepth(10),
	'HierarchicalCollider, exact': Object.assign(new HierarchicalCollider(greatLand), { exact: true }),
};

const sums = Object.fromEntries(Object.keys(systems).map((name) => [name, { accuracy: new Accuracy(), times: [] }]));
const game = Scenes.crowded(AGENTS);
game.agents.forEach((agent, i) => (agent.hierarchical = i % 2 === 0));
for (let frame = 0; frame < FRAMES; frame++) {
	game.step();
	const truth = Accuracy.truthOf(systems['HierarchicalCollider, exact'], game.agents);
	for (const [name, system] of Object.entries(systems)) {
		// what the one before moved is looked at anew
		game.agents.forEach((agent) => agent.jumpTo(agent.x, agent.y, agent.z));
		const start = performance.now();
		const found = system.findCollisions(game.agents);
		sums[name].times.push(performance.now() - start);
		sums[name].accuracy.add(found, truth);
	}
}

console.log(`${AGENTS} agents, ${FRAMES} frames, ${sums.BinCollider.accuracy.touching} pairs that touch; Node ${process.versions.node}`);
console.log('| system | found | false | missed | precision | recall | ms a frame |');
for (const [name, { accuracy: { found, right, touching, precision, recall }, times }] of Object.entries(sums)) {
	const median = times.sort((a, b) => a - b)[FRAMES / 2];
	const percent = (part) => `${Math.round(100 * part)} %`;
	console.log(`| ${name} | ${found} | ${found - right} | ${touching - right} | ${percent(precision)} | ${percent(recall)} | ${median.toFixed(3)} |`);
}

// A ball is met by the dragon as it is: a sphere.
const PLACES = 4000;
const dragon = ColladaModel.fromBytes('dragon', new Uint8Array(readFileSync(path.join(root, 'assets/dragon.dae'))));
const corners = Array.from(dragon.triangles, (vertex) => [0, 1, 2].map((axis) => dragon.vertices[3 * vertex + axis]));
const triangles = Array.from({ length: corners.length / 3 }, (_, i) => corners.slice(3 * i, 3 * i + 3));

const ballSystems = {
	'TightestFitCollider': new TightestFitCollider(greatLand),
	'CombinationCollider': new CombinationCollider(greatLand),
	'CombinationCollider, exact': Object.assign(new CombinationCollider(greatLand), { exact: true }),
};
const ofBalls = Object.fromEntries(Object.keys(ballSystems).map((name) => [name, { found: 0, right: 0 }]));
let seed = 51;
const random = (from, to) => from + (to - from) * ((seed = (seed * 1103515245 + 12345) % 2147483648) / 2147483648);
const [ball, beast] = [new Agent('sphere'), new Agent('dragon')];
greatLand.addModel(BuiltInModel.sphere());
beast.hierarchical = true;
const fit = greatLand.boundingStructures.tightestFit('sphere');
let touching = 0;
for (let i = 0; i < PLACES; i++) {
	ball.size = random(0.05, 0.3);
	ball.moveTo(random(-0.6, 0.6), random(-0.6, 0.6), random(-0.2, 0.8));
	const middle = [ball.x + ball.size * fit.center.x, ball.y + ball.size * fit.center.y, ball.z + ball.size * fit.center.z];
	const truth = triangles.some((triangle) => toTriangle(middle, triangle) <= ball.size * fit.radius) || Math.abs(windingOf(triangles, middle)) > 0.5;
	touching += truth ? 1 : 0;
	for (const [name, system] of Object.entries(ballSystems)) {
		const answer = system.areColliding(ball, beast);
		ofBalls[name].found += answer ? 1 : 0;
		ofBalls[name].right += answer && truth ? 1 : 0;
	}
}
console.log(`a ball in ${PLACES} places beside a dragon, ${touching} of them touching`);
console.log('| system | found | precision | recall |');
for (const [name, { found, right }] of Object.entries(ofBalls)) {
	console.log(`| ${name} | ${found} | ${(right / found).toFixed(3)} | ${(right / touching).toFixed(3)} |`);
}
