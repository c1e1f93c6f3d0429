/** How often the frames are counted, and the limits are looked at, in milliseconds. */
const CHECK_MS = 500;

const secondsSince = (time) => (Date.now() - time) / 1000;

/**
 * Whether a SWF is alive: what it traces and the files that it hands over are signs of life. Frames are none, but say why there are no
 * signs.
 */
export class Pulse {
	#lastSign = Date.now();
	#started = Date.now();
	#lastFrame = Date.now();
	#frames = 0;
	#framesAtSign = 0;
	#isCounting = false;
	#player;
	#timer;

	/** Notes a sign of life. */
	sign() {
		this.#lastSign = Date.now();
		this.#framesAtSign = this.#frames;
	}

	/**
	 * Begins to watch. Before, the player has prepared itself.
	 *
	 * @param {{ frames?: () => Promise<number> }} player counts frames, if it can
	 * @param {{ stall: number, seconds: number }} limits how many seconds may pass without a sign, and in all
	 * @param {object} on what to call
	 * @param {(said: string) => void} on.stall when there was no sign for too long, with the reason
	 * @param {(said: string) => void} on.time when the time is over
	 */
	watch(player, { stall, seconds }, on) {
		this.#player = player;
		this.#started = this.#lastFrame = Date.now();
		this.sign();
		this.#timer = setInterval(() => {
			this.#countFrames();
			if (secondsSince(this.#started) > seconds) on.time(`ended after ${seconds} s${this.#whereItIs()}`);
			else if (secondsSince(this.#lastSign) > stall) on.stall(`the SWF stalled: ${stall} s without a sign of life${this.#whyItStalls(stall)}`);
		}, CHECK_MS);
	}

	/** Ends the watch. */
	end() {
		clearInterval(this.#timer);
	}

	async #countFrames() {
		if (this.#isCounting || !this.#player.frames) return;
		this.#isCounting = true;
		const counted = await this.#player.frames().catch(() => this.#frames);
		if (counted > this.#frames) this.#lastFrame = Date.now();
		this.#frames = counted;
		this.#isCounting = false;
	}

	/** Says so if a SWF is in the middle of a call. */
	#whereItIs() {
		const since = Math.round(secondsSince(this.#lastFrame));
		return this.#player.frames && since >= 2 ? `, in the middle of one call: no frame in the last ${since} s` : '';
	}

	/** Why a SWF gave no sign of life for some seconds: by its frames in this time, and the seconds since the last one. */
	#whyItStalls(seconds) {
		if (!this.#player.frames) return '';
		const since = Math.round(secondsSince(this.#lastFrame));
		if (since > seconds / 2) return `, and no frame in the last ${since} s: one call takes longer, or has no end`;
		const frames = this.#frames - this.#framesAtSign;
		return frames < seconds ? `, but ${frames} frames: it is slow; give it more by --stall`
			: `, but ${frames} frames: it waits for an event that does not come, or has ended without Host.exit`;
	}
}
