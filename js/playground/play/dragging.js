/** Moves agents in the world with the pointer. Elsewhere the pointer turns the world. */
import { HALF_WIDTH } from "./moves.js";

/** A pointer that has moved this many pixels drags. */
const STILL = 6;

const inside = (coordinate) => Math.min(HALF_WIDTH, Math.max(-HALF_WIDTH, coordinate));

/**
 * Listens to a stage.
 *
 * @param {import("../shared/stage.js").Stage} stage
 * @param {{mayDrag: (agent: object) => boolean, isStill: () => boolean, onDrag: (agent: object, isDone: boolean) => void}} game onDrag is called
 * whenever an agent was moved, and at the end
 */
export function dragAgents(stage, { mayDrag, isStill, onDrag }) {
	const { host, canvas, controls } = stage;
	if (!canvas) return;
	let drag = null;
	const agentAt = (event) => {
		const agent = stage.agentAt(event);
		return agent && mayDrag(agent) ? agent : null;
	};
	// before the controls of the camera hear of it
	host.addEventListener("pointerdown", (event) => {
		if (event.button !== 0 || !event.isPrimary || event.target !== canvas) return;
		const agent = agentAt(event);
		const from = agent && stage.pointAt(event, agent.z);
		if (!from) return;
		drag = { agent, from, x: agent.x, y: agent.y, startX: event.clientX, startY: event.clientY, isMoved: false };
		controls.enabled = false;
		canvas.setPointerCapture(event.pointerId);
	}, true);
	host.addEventListener("pointermove", (event) => {
		if (!drag) {
			if (event.pointerType === "mouse" && event.buttons === 0 && isStill()) canvas.classList.toggle("grab", agentAt(event) !== null);
			return;
		}
		const { agent, from, x, y, startX, startY } = drag;
		drag.isMoved ||= Math.hypot(event.clientX - startX, event.clientY - startY) >= STILL;
		const to = drag.isMoved && agent.isAlive ? stage.pointAt(event, agent.z) : null;
		if (!to) return;
		agent.jumpTo(inside(x + to.x - from.x), inside(y + to.y - from.y), agent.z);
		onDrag(agent, false);
	});
	const end = () => {
		if (!drag) return;
		const { agent, isMoved } = drag;
		drag = null;
		controls.enabled = true;
		if (isMoved) onDrag(agent, true);
	};
	host.addEventListener("pointerup", end);
	host.addEventListener("pointercancel", end);
	// a finger on an agent moves it, and does not scroll the page
	canvas.addEventListener("touchstart", (event) => {
		if (event.touches.length === 1 && agentAt(event.touches[0])) event.preventDefault();
	}, { passive: false });
}
