/** What the user does with keys and the pointer in a game. */
export class Input {
	mouse = { x: 0, y: 0, isDown: false };
	/** The agent that was clicked before this frame, or null. */
	clicked = null;
	#held = new Set();
	#pressed = new Set();

	press(key) {
		if (!this.#held.has(key)) this.#pressed.add(key);
		this.#held.add(key);
	}

	release(key) {
		this.#held.delete(key);
	}

	releaseAll() {
		this.#held.clear();
	}

	isDown(key) {
		return this.#held.has(key);
	}

	/** Whether a key was pressed before this frame. A key that was pressed for less than a frame counts for the whole frame. */
	wasPressed(key) {
		return this.#pressed.has(key);
	}

	/** Forgets what has happened once. Keys that are held still are. */
	endFrame() {
		this.#pressed.clear();
		this.clicked = null;
	}

	/** Takes the input of another game, which has not done its next step yet. The same agent is clicked in this game. */
	copyFrom(other, agents) {
		this.mouse = other.mouse;
		this.#held = other.#held;
		this.#pressed = new Set(other.#pressed);
		this.clicked = agents.find(({ number }) => number === other.clicked?.number) ?? null;
	}
}
