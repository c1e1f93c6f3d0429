/** Moves agents with the pointer. Elsewhere the pointer turns the world. */

/** A pointer that has moved this many pixels drags. */
export const STILL = 6;

/**
 * Lets the pointer drag a stage's agents on the level on which they stand.
 *
 * @param {import("./stage.js").Stage} stage
 * @param {{onMove: (agent: object, x: number, y: number) => void, onTake?: (agent: object) => void, onDone?: (agent: object) => void,
 * mayDrag?: (agent: object) => boolean, isStill?: () => boolean}} game onMove moves the agent, onTake is called when the pointer takes one, and
 * onDone after an agent was moved; mayDrag says whether it may be moved now, and isStill whether the cursor shows which may be
 */
export function dragAgents(stage, { onMove, onTake = () => {}, onDone = () => {}, mayDrag = () => true, isStill = () => true }) {
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
		drag = { agent, x: agent.x - from.x, y: agent.y - from.y, startX: event.clientX, startY: event.clientY, isMoved: false };
		controls.enabled = false;
		canvas.setPointerCapture(event.pointerId);
		onTake(agent);
	}, true);
	host.addEventListener("pointermove", (event) => {
		if (!drag) {
			if (event.pointerType === "mouse" && event.buttons === 0 && isStill()) canvas.classList.toggle("grab", agentAt(event) !== null);
			return;
		}
		const { agent, x, y, startX, startY } = drag;
		drag.isMoved ||= Math.hypot(event.clientX - startX, event.clientY - startY) >= STILL;
		const to = drag.isMoved && mayDrag(agent) ? stage.pointAt(event, agent.z) : null;
		if (to) onMove(agent, x + to.x, y + to.y);
	});
	const end = () => {
		if (!drag) return;
		const { agent, isMoved } = drag;
		drag = null;
		controls.enabled = true;
		if (isMoved) onDone(agent);
	};
	host.addEventListener("pointerup", end);
	host.addEventListener("pointercancel", end);
	// a finger on an agent moves it, and does not scroll the page
	canvas.addEventListener("touchstart", (event) => {
		if (event.touches.length === 1 && agentAt(event.touches[0])) event.preventDefault();
	}, { passive: false });
}
