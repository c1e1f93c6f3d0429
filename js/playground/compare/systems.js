/** The collision systems that Compare shows: those of the blocks, and the tightest fits with hulls in their place. */
import { Collider, CollisionBlocks, ShapeChoice } from "starlogo-collision";
import { texts } from "../shared/language.js";

/** The name of the system of hulls. */
export const HULLS = "hulls";

/** All names, in the order in which they are shown. */
export const SYSTEMS = CollisionBlocks.systemNames.flatMap((name) => (name === CollisionBlocks.TIGHTEST_FITS ? [name, HULLS] : [name]));

/** What users read about each, by its name. */
export const titles = { ...texts.systems, [HULLS]: texts.compare.hulls };
export const notes = { ...texts.systemNotes, [HULLS]: texts.compare.hullsNote };

/** Every agent is the hull of its model. */
class Hulls extends ShapeChoice {
	bind(shape) {
		shape.setStructure(this.greatLand.boundingStructures.hull(shape.modelName));
	}
}

/**
 * Finds a system by its name.
 *
 * @param {CollisionBlocks} blocks have all systems but that of hulls
 */
export function finderOf(blocks) {
	const hulls = new Collider(new Hulls(blocks.greatLand));
	return (name) => (name === HULLS ? hulls : blocks.systemNamed(name));
}

/** Lets agents collide as a system of the blocks sees them. Gives the name of that system. */
export function useFor(agents, name) {
	for (const agent of agents) agent.collideAs = name === HULLS ? "hull" : "tightest";
	return name === HULLS ? CollisionBlocks.TIGHTEST_FITS : name;
}
