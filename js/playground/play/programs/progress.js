/** The lessons that the user has done and the games that were won, now or earlier. The browser remembers them. */
import { recallList, rememberValue } from "../../shared/files/memory.js";
import { texts } from "../../shared/language.js";
import { LESSON_NAMES } from "../builtin/names.js";

const KEY = "starlogo-playground.lessons";
const ofGame = (name) => `game ${name}`;

export class Progress {
	#names = new Set(recallList(KEY));

	isDone(lesson) {
		return this.#names.has(lesson);
	}

	isWon(game) {
		return this.#names.has(ofGame(game));
	}

	tickLesson(lesson) {
		this.#names.add(lesson);
		this.#keep();
	}

	tickGame(game) {
		this.#names.add(ofGame(game));
		this.#keep();
	}

	/** The names of all lessons that were done and of all games that were won. */
	get results() {
		return { done: LESSON_NAMES.filter((name) => this.isDone(name)), won: Object.keys(texts.play.games).filter((name) => this.isWon(name)) };
	}

	/** Forgets everything, for the browser's next user. */
	forget() {
		this.#names.clear();
		this.#keep();
	}

	#keep() {
		rememberValue(KEY, [...this.#names]);
	}
}
