/** For docs/poses.md: the vertices of a model that a game moves, and a file with an animation. */
import assert from 'node:assert/strict';
import { engine } from './engine.mjs';

const { Agent, BuiltInModel, Collision, GreatLand, TightestFitCollider } = engine;
const cube = BuiltInModel.cube();
export const vertices = [...cube.vertices];
export const triangles = cube.triangles;
export const greatLand = new GreatLand();
export const collision = new Collision(new TightestFitCollider(greatLand));
export const agents = [new Agent('walker')];

// a triangle that goes from 0 to 4 along x within 2 seconds
const floats = Float32Array.of(0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 2, 0, 0, 0, 4, 0, 0);
const accessor = (first, count, type) => [{ buffer: 0, byteOffset: 4 * first, byteLength: 4 * count * (type === 'VEC3' ? 3 : 1) }, { componentType: 5126, count, type }];
const [views, accessors] = [0, 1].map((part) => [accessor(0, 3, 'VEC3'), accessor(9, 2, 'SCALAR'), accessor(11, 2, 'VEC3')].map((each) => each[part]));
export const bytes = new TextEncoder().encode(JSON.stringify({
	asset: { version: '2.0' },
	scenes: [{ nodes: [0] }],
	nodes: [{ mesh: 0 }],
	meshes: [{ primitives: [{ attributes: { POSITION: 0 } }] }],
	accessors: accessors.map((each, bufferView) => ({ ...each, bufferView })),
	bufferViews: views,
	buffers: [{ byteLength: floats.byteLength, uri: `data:application/octet-stream;base64,${Buffer.from(floats.buffer).toString('base64')}` }],
	animations: [{ name: 'Run', samplers: [{ input: 1, output: 2 }], channels: [{ sampler: 0, target: { node: 0, path: 'translation' } }] }],
}));
export const seconds = 2.5;

/** Whether the samples have done what the page says. */
export function check({ walking, runner }) {
	walking.vertices.forEach((number, i) => assert.ok(Math.abs(number - vertices[i]) < 1e-12));
	assert.deepEqual(runner.vertices.slice(0, 3), [1, 0, 0]);
}
