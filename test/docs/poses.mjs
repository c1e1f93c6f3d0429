/** For docs/poses.md: the vertices of a model that a game moves. */
import assert from 'node:assert/strict';
import { engine } from './engine.mjs';

const { Agent, BuiltInModel, Collision, GreatLand, TightestFitCollider } = engine;
const cube = BuiltInModel.cube();
export const vertices = [...cube.vertices];
export const triangles = cube.triangles;
export const greatLand = new GreatLand();
export const collision = new Collision(new TightestFitCollider(greatLand));
export const agents = [new Agent('walker')];

/** Whether the samples have done what the page says. */
export function check({ walking }) {
	walking.vertices.forEach((number, i) => assert.ok(Math.abs(number - vertices[i]) < 1e-12));
}
