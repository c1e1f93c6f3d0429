/** Raises and lowers the ground, and builds walls, where the pointer goes. */
import { HALF_WIDTH } from "../game/moves.js";
import { endOfWall, wallsBetween } from "../game/walls.js";

/** The patches by which a brush raises the ground. */
const HEIGHTS = { raise: 1, lower: -1 };
const LINE = { color: 0xf5a524, isOnTop: true };
/** How high the line of a wall that is being built is, in patches. */
const ABOVE = 0.1;

let groups = 0;

/**
 * Listens to a stage, before others do.
 *
 * @param {import("../../shared/drawing/stage.js").Stage} stage
 * @param {() => string} brushNow "raise", "lower" or "wall"; anything else paints nothing
 * @param {() => object} buildingNow what changes the program
 */
export function paintGround(stage, brushNow, buildingNow) {
	const { host, canvas } = stage;
	if (!canvas) return;
	let stroke = null;
	const patchAt = (event) => {
		const at = stage.pointAt(event, 0);
		return at && Math.max(Math.abs(at.x), Math.abs(at.y)) < HALF_WIDTH + 0.5 ? { x: Math.round(at.x) + 0, y: Math.round(at.y) + 0 } : null;
	};
	const paint = (patch) => {
		const { brush, group, seen } = stroke;
		const place = `${patch.x} ${patch.y}`;
		if (seen.has(place)) return;
		seen.add(place);
		buildingNow().raise(patch.x, patch.y, HEIGHTS[brush], group);
	};
	host.addEventListener("pointerdown", (event) => {
		const brush = brushNow();
		const patch = event.button === 0 && event.isPrimary && event.target === canvas && (brush in HEIGHTS || brush === "wall") ? patchAt(event) : null;
		if (!patch) return;
		event.stopImmediatePropagation();
		canvas.setPointerCapture(event.pointerId);
		stroke = { brush, from: patch, to: patch, seen: new Set(), group: `ground ${++groups}` };
		if (brush !== "wall") paint(patch);
	}, true);
	host.addEventListener("pointermove", (event) => {
		const patch = stroke && patchAt(event);
		if (!stroke) return;
		event.stopImmediatePropagation();
		if (!patch) return;
		stroke.to = patch;
		if (stroke.brush !== "wall") {
			paint(patch);
			return;
		}
		const { from } = stroke;
		const to = endOfWall(from, patch);
		stage.wireframe("wall", LINE).showLines([from.x, from.y, ABOVE, to.x, to.y, ABOVE]);
	}, true);
	const end = (event) => {
		if (!stroke) return;
		event.stopImmediatePropagation();
		const { brush, from, to } = stroke;
		stroke = null;
		stage.clearLines("wall");
		const walls = brush === "wall" && event.type === "pointerup" ? wallsBetween(from, to) : [];
		if (walls.length > 0) buildingNow().wall(walls);
	};
	host.addEventListener("pointerup", end, true);
	host.addEventListener("pointercancel", end, true);
}
