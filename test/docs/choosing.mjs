/** For docs/choosing.md: what it names and does not show. */
import assert from 'node:assert/strict';
import * as game from './game.mjs';

export const greatLand = game.greatLand;
export const collision = game.collision;
export const bear = game.bear;
export const ball = game.ball;
export const agents = game.agents;

/** Whether the samples have done what the page says. */
export const check = ({ collider }) => assert.equal(collision.collisionSystem, collider);
