/** How the agents of a game move and turn: by blocks, on a ground that ends where it begins. Each method is one block. */
import { Collision, CollisionBlocks } from "starlogo-collision";

/** Half the width of the ground. An agent that leaves it comes in on the other side. */
export const HALF_WIDTH = 12;

/** The nearest coordinate on the ground. */
export const onGround = (coordinate) => Math.min(HALF_WIDTH, Math.max(-HALF_WIDTH, coordinate));

export class Moves {
	#world;
	/** Separate systems, because a system that has searched gives the contacts of its last search. */
	#now;

	/** @param {import("./world.js").World} world the game */
	constructor(world) {
		this.#world = world;
		this.#now = new CollisionBlocks(world.greatLand, []);
	}

	/** Walks by its heading: up low steps, along walls, carried by what it stands on. */
	walk(agent, steps) {
		this.#world.walking.walk(agent, steps);
		this.#moveInside(agent, agent.x, agent.y);
	}

	/** Goes by its heading, at its height, and along solid agents. */
	forward(agent, steps) {
		if (this.#world.solid.length > 0) {
			this.#world.walking.forward(agent, steps);
			this.#moveInside(agent, agent.x, agent.y);
			return;
		}
		const [x, y] = ahead(agent);
		this.#moveInside(agent, agent.x + steps * x, agent.y + steps * y);
	}

	/** Moves an agent forward, until it touches an agent of a breed, or sliding along it. The agent keeps its height, even on a slope. */
	advance(agent, steps, breed, how) {
		const { z } = agent;
		const [x, y] = ahead(agent);
		const filter = breed === Collision.ANY_BREED ? { exceptBreeds: [Collision.TERRAIN] } : { breeds: [breed] };
		this.#world.senses.queries[how](agent, steps * x, steps * y, 0, filter);
		agent.z = z;
		this.#moveInside(agent, agent.x, agent.y);
	}

	/** Puts an agent anywhere on the ground, with any heading. */
	scatter(agent) {
		agent.jumpTo((this.#world.random() * 2 - 1) * (HALF_WIDTH - 2), (this.#world.random() * 2 - 1) * (HALF_WIDTH - 2), agent.z);
		agent.heading = this.#world.random() * 360;
	}

	/** Turns an agent to another one. */
	face(agent, other) {
		if (other && (other.x !== agent.x || other.y !== agent.y)) agent.heading = degrees(other.x - agent.x, other.y - agent.y);
	}

	/** Turns an agent that moves into another one, as a mirror reflects light. */
	bounce(agent, other) {
		const { normal } = this.#system.contactOf(agent, other);
		const [x, y] = ahead(agent);
		const into = x * normal.x + y * normal.y;
		if (into < 0) agent.heading = degrees(x - 2 * into * normal.x, y - 2 * into * normal.y);
	}

	/**
	 * Undoes the agent's steps and turns of this frame. If it touched the other agent before, for example after a change of the collision
	 * system, it must not get stuck. Then it may turn, and move to where the overlap is not deeper.
	 */
	goBack(agent, other) {
		const { x, y, z, heading } = agent;
		const deep = other ? this.#depth(agent, other) : 0;
		agent.jumpTo(agent.before[0], agent.before[1], agent.before[2]);
		agent.heading = agent.before[3];
		if (!other || this.#depth(agent, other) === 0) return;
		agent.heading = heading;
		if (deep <= this.#depth(agent, other)) agent.jumpTo(x, y, z);
	}

	/** The steps of a frame that bring two agents together, along the normal of their contact. */
	speedOf(agent, other) {
		const { normal } = this.#system.contactOf(agent, other);
		return Math.max(0, ["x", "y", "z"].reduce((sum, axis, i) => sum - normal[axis] * (agent[axis] - agent.before[i] - other[axis] + other.before[i]), 0));
	}

	/** The height of the ground below an agent; 0 outside of the field. */
	groundBelow({ x, y }) {
		return this.#world.terrain.heightAt(x, y) || 0;
	}

	// Moves an agent to a place. On a ground without edges it comes in on the other side.
	#moveInside(agent, x, y) {
		if (this.#world.collisions.collision.bounds) {
			agent.moveTo(x, y, agent.z);
			return;
		}
		const wrappedX = wrapped(x);
		const wrappedY = wrapped(y);
		if (wrappedX === x && wrappedY === y) agent.moveTo(x, y, agent.z);
		else agent.jumpTo(wrappedX, wrappedY, agent.z);
	}

	get #system() {
		return this.#world.collisions.collision.collisionSystem;
	}

	/** The depth of the overlap of two agents now; 0 if they do not touch. */
	#depth(agent, other) {
		if (!this.#system.areColliding(agent, other)) return 0;
		return Math.max(Number.MIN_VALUE, this.#now.systemNamed(this.#world.collisions.systemName).contactOf(agent, other).depth);
	}
}

/** The direction in which an agent looks: x and y, of length 1. */
function ahead({ heading }) {
	const angle = (heading * Math.PI) / 180;
	return [Math.cos(angle), Math.sin(angle)];
}

const degrees = (x, y) => (Math.atan2(y, x) * 180) / Math.PI;

/** The coordinate on the ground for one beyond its border. */
function wrapped(coordinate) {
	if (Math.abs(coordinate) <= HALF_WIDTH) return coordinate;
	const width = 2 * HALF_WIDTH;
	return ((((coordinate + HALF_WIDTH) % width) + width) % width) - HALF_WIDTH;
}
