/** What a collision system tests of an agent, as plain bodies in the world: the numbers are the engine's fits and models, the placing is the fuzzer's own. */
import { boxBody, hullBody, placed, pointOf, triangleBody, turned, withExtents } from "./geometry.mjs";
import { engine } from "./tools.mjs";

/** By what an agent may set collideAs to. */
const KINDS = { sphere: engine.Sphere, box: engine.Box, capsule: engine.Capsule, hull: engine.Hull };

/** Of a Sphere, Capsule, Box or Hull of the model. */
function ofStructure(structure, agent) {
	if (structure.center && structure.radius !== undefined) return { corners: [placed(pointOf(structure.center), agent)], radius: structure.radius * agent.size };
	if (structure.start) return { corners: [placed(pointOf(structure.start), agent), placed(pointOf(structure.end), agent)], radius: structure.radius * agent.size };
	if (structure.corners) {
		const corners = Array.from({ length: structure.corners.length / 3 }, (_, i) => placed(structure.corners.slice(3 * i, 3 * i + 3), agent));
		return hullBody(corners, structure.faces);
	}
	return boxBody(placed(pointOf(structure.center), agent), [structure.axisX, structure.axisY, structure.axisZ].map((axis) => turned(pointOf(axis), agent)),
		[structure.halfX, structure.halfY, structure.halfZ].map((half) => half * agent.size));
}

function nodesOf(node, depth, found) {
	if (depth <= 1 || node.isLeaf) found.push(node.bounds);
	else for (const child of [node.left, node.right]) nodesOf(child, depth - 1, found);
	return found;
}

/** The triangles of an agent with this model, three placed corners each. */
export function trianglesOf({ vertices, triangles }, agent) {
	const corner = (i) => placed([vertices[3 * i], vertices[3 * i + 1], vertices[3 * i + 2]], agent);
	return Array.from({ length: triangles.length / 3 }, (_, i) => [corner(triangles[3 * i]), corner(triangles[3 * i + 1]), corner(triangles[3 * i + 2])]);
}

/** The bodies of an agent; null if this setting has other ones. */
export function bodiesOf(game, agent) {
	const { system, exact, depth } = game.setting;
	const { land } = game;
	if (system === 0) return [withExtents({ corners: [[agent.x, agent.y, agent.z + agent.size / 2]], radius: agent.size / 2 })];
	if (system === 1 || system === 3 && !agent.hierarchical) {
		const library = land.boundingStructures;
		const tightest = library.tightestFit(agent.shape);
		const isTightest = agent.collideAs === "tightest" || tightest instanceof KINDS[agent.collideAs];
		const isKept = agent.collideAs === "hull" ? library.hasHull(agent.shape) : library.hasAll(agent.shape);
		const structure = isTightest ? tightest : isKept ? library[agent.collideAs](agent.shape) : null;
		return structure && [withExtents(ofStructure(structure, agent))];
	}
	const model = game.models.get(agent.shape);
	if (exact) return model.triangles === null ? null : trianglesOf(model, agent).map((corners) => withExtents(triangleBody(corners)));
	const nodes = nodesOf(land.hierarchies.root(agent.shape), agent.traversalDepth || depth, []);
	// of nodes that are no boxes, a child reaches beyond its parent
	return nodes.every(({ halfX }) => halfX >= 0) ? nodes.map((bounds) => withExtents(ofStructure(bounds, agent))) : null;
}
