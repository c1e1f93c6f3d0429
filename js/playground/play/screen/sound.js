/** The sounds of a game: a tone for a touch, some tones for a success or a defeat. The user can mute it, and the browser remembers that. */
import { button } from "../../shared/dom.js";
import { texts } from "../../shared/language.js";
import { recall, remember } from "../../shared/files/memory.js";

const words = texts.play;
const KEY = "starlogo-playground.muted";
/** The least number of frames between two tones of touches. */
const BETWEEN = 6;
/** Tones in hertz: for touches, for a success, for a lost game. */
const TOUCHES = [523, 587, 659, 784, 880];
const DONE = [523, 659, 784, 1047];
const LOST = [392, 330, 262];
/** The sounds of blocks: their waves, their tones in hertz, and the seconds of each tone. */
const SOUNDS = {
	pop: ["sine", [420, 700], 0.04], ding: ["triangle", [1319, 1319], 0.18], jump: ["square", [262, 330, 440, 587], 0.04], fall: ["square", [587, 440, 330, 262, 196], 0.06],
	zap: ["sawtooth", [1400, 900, 500, 250], 0.03], drum: ["sine", [140, 90, 60], 0.05],
};
/** The most sounds that blocks play in one frame. */
const MOST_SOUNDS = 4;
/** The number and the frequency of the note a', and the seconds of a block's note. */
const [A, A_HERTZ, NOTE] = [69, 440, 0.25];

export class Sound {
	#context = null;
	#isMuted = recall(KEY) === "true";
	/** The frame of the last tone for a touch. */
	#last = -BETWEEN;

	constructor() {
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
		remember(KEY, String(isMuted));
		if (!isMuted) this.#play([TOUCHES[0]], 0.08);
	}

	/** Listens to a frame of a game. Plays a tone if a touch has begun in it. */
	hear({ frame, meetings: [meeting], sounds }) {
		for (const each of sounds.slice(0, MOST_SOUNDS)) {
			if (typeof each === "number") this.#play([A_HERTZ * 2 ** ((Math.min(127, Math.max(0, each)) - A) / 12)], NOTE);
			else if (each in SOUNDS) this.#play(SOUNDS[each][1], SOUNDS[each][2], SOUNDS[each][0]);
		}
		// before the last tone, if the game has begun again or gone back
		const since = frame - this.#last;
		if (meeting?.frame !== frame || (since >= 0 && since < BETWEEN)) return;
		this.#last = frame;
		this.#play([TOUCHES[(meeting.a.number + meeting.b.number) % TOUCHES.length]], 0.08);
	}

	done() {
		this.#play(DONE, 0.14);
	}

	lost() {
		this.#play(LOST, 0.2);
	}

	/** Plays tones one after the other. Each lasts this many seconds. */
	#play(tones, seconds, wave = "triangle") {
		if (this.#isMuted || !globalThis.AudioContext) return;
		// browsers allow sound only after the user has pressed something
		this.#context ??= new AudioContext();
		const { currentTime, destination } = this.#context;
		tones.forEach((tone, i) => {
			const [source, volume] = [this.#context.createOscillator(), this.#context.createGain()];
			const begin = currentTime + i * seconds;
			source.type = wave;
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
