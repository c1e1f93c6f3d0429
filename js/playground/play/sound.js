/** The sounds of a game: a tone for a touch, some tones for a success or a defeat. The user can mute it, and the browser remembers that. */
import { button } from "../shared/dom.js";
import { texts } from "../shared/language.js";

const words = texts.play;
const KEY = "starlogo-playground.muted";
/** The least number of frames between two tones of touches. */
const BETWEEN = 6;
/** Tones in hertz: for touches, for a success, for a lost game. */
const TOUCHES = [523, 587, 659, 784, 880];
const DONE = [523, 659, 784, 1047];
const LOST = [392, 330, 262];

export class Sound {
	#context = null;
	#isMuted = false;
	/** The last frame that was heard, the frame of the last tone, and the number of meetings then. */
	#frame = 0;
	#last = -BETWEEN;
	#met = 0;

	constructor() {
		try {
			this.#isMuted = localStorage.getItem(KEY) === "true";
		} catch {
			// the browser stores nothing
		}
		this.button = button("", () => this.#mute(!this.#isMuted), { class: "tool sound" });
		this.#show();
	}

	#show() {
		const text = this.#isMuted ? words.unmute : words.mute;
		this.button.classList.toggle("muted", this.#isMuted);
		this.button.setAttribute("aria-label", text);
		this.button.title = text;
	}

	#mute(isMuted) {
		this.#isMuted = isMuted;
		this.#show();
		try {
			localStorage.setItem(KEY, String(isMuted));
		} catch {
			// remembered until the page is closed
		}
		if (!isMuted) this.#play([TOUCHES[0]], 0.08);
	}

	/** Listens to a frame of a game. Plays a tone if a touch has begun in it. */
	hear({ frame, state: { meetings }, events: [event] }) {
		if (frame <= this.#frame) {
			// the game has begun again, or gone back
			this.#last = -BETWEEN;
			this.#met = 0;
		}
		const isNew = meetings > this.#met;
		this.#frame = frame;
		this.#met = meetings;
		if (!isNew || frame - this.#last < BETWEEN) return;
		this.#last = frame;
		this.#play([TOUCHES[(event.a.number + event.b.number) % TOUCHES.length]], 0.08);
	}

	done() {
		this.#play(DONE, 0.14);
	}

	lost() {
		this.#play(LOST, 0.2);
	}

	/** Plays tones one after the other. Each lasts this many seconds. */
	#play(tones, seconds) {
		if (this.#isMuted || !globalThis.AudioContext) return;
		// browsers allow sound only after the user has pressed something
		this.#context ??= new AudioContext();
		const { currentTime, destination } = this.#context;
		tones.forEach((tone, i) => {
			const [source, volume] = [this.#context.createOscillator(), this.#context.createGain()];
			const begin = currentTime + i * seconds;
			source.type = "triangle";
			source.frequency.value = tone;
			volume.gain.setValueAtTime(0.12, begin);
			volume.gain.exponentialRampToValueAtTime(0.001, begin + seconds);
			source.connect(volume).connect(destination);
			source.start(begin);
			source.stop(begin + seconds);
		});
	}

	close() {
		this.#context?.close();
	}
}
