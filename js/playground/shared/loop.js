/** Calls a function before each picture that the browser draws, and tells how many frames of a game are due then. */
export class Loop {
	#request = 0;
	#last = 0;
	#owed = 0;

	/** @param {(now: number) => void} onPicture called with the time, in milliseconds */
	constructor(onPicture) {
		this.onPicture = onPicture;
	}

	get isRunning() {
		return this.#request !== 0;
	}

	run() {
		this.stop();
		this.#last = performance.now();
		this.#owed = 0;
		const next = (now) => {
			this.#request = requestAnimationFrame(next);
			this.onPicture(now);
		};
		this.#request = requestAnimationFrame(next);
	}

	stop() {
		cancelAnimationFrame(this.#request);
		this.#request = 0;
	}

	/**
	 * The number of frames since the last call.
	 *
	 * @param {number} now the picture's time
	 * @param {number} rate the frames of a second
	 * @param {number} most at most so many make up for lost time
	 */
	due(now, rate, most) {
		this.#owed = Math.min(most, this.#owed + ((now - this.#last) * rate) / 1000);
		this.#last = now;
		// a picture's time may be before the call of run
		const due = Math.max(0, Math.floor(this.#owed));
		this.#owed -= due;
		return due;
	}
}
