/** Finds the program that an address names: one of the page's, one of the user's, one that a pupil has handed in, or one in a link. */
import { texts } from "../../shared/language.js";
import { isProgram } from "../../shared/files/packing.js";
import { isHanded } from "../../shared/names.js";
import { builtInProgram, isBuiltIn, lessonOf } from "../builtin/builtin.js";
import { fromLink, meaning } from "./programtext.js";

const words = texts.play;
/** The program that is opened if the browser remembers none. */
export const FIRST = "paintball";
/** The id of one of the user's programs. */
const OWN = /^own-[a-z\d]+-[a-z\d]+$/;
/** A link with a program is longer. */
const LONGEST_NAME = 60;

/** No program is at an address. The message says why. */
export class AddressError extends Error {}

export class Finder {
	/** @param {import("./shelf.js").Shelf} shelf */
	constructor(shelf) {
		this.shelf = shelf;
	}

	/**
	 * The program at an address. Its name is "link" if it is neither the page's nor the user's. Models are those that came with it, as their
	 * files' text.
	 *
	 * @returns {Promise<{name: string, program: object, title: string, lesson: string|null, pupil?: string, models?: Record<string, string>}>}
	 * @throws {AddressError} if there is none
	 */
	async find(address) {
		const entry = this.shelf.find(address);
		if (entry) return { name: address, program: entry.program, title: entry.name, lesson: entry.lesson };
		if (isBuiltIn(address)) return { name: address, program: await builtInProgram(address), title: titleOf(address), lesson: lessonOf(address) };
		return isHanded(address) ? this.#findHanded(address) : this.#findInLink(address);
	}

	async #findHanded(address) {
		const { handed } = await import("../../shared/files/submissions.js");
		await handed.open();
		const found = handed.at(address);
		if (!found) throw new AddressError(words.handedElsewhere);
		return { ...found, name: "link", title: found.name };
	}

	async #findInLink(address) {
		const { name, lesson, ...program } = await fromLink(address).catch(() => {
			throw new AddressError(OWN.test(address) ? words.keptElsewhere : address.length > LONGEST_NAME ? words.brokenLink : words.noAddress(address));
		});
		const title = name ?? words.fromLink;
		const mine = this.shelf.all.find((each) => each.name === title && meaning(each.program) === meaning(program));
		return mine ? this.find(mine.id) : { name: "link", program, title, lesson };
	}

	/** The program that was open last, otherwise the paintball game. */
	async last() {
		const { last, all } = this.shelf;
		const entry = this.shelf.find(last) ?? (last === null ? all.at(-1) : null);
		if (entry && isProgram(entry.program)) return this.find(entry.id);
		return this.find(last !== null && isBuiltIn(last) ? last : FIRST);
	}

	/** Whether the browser remembers a program. */
	get hasLast() {
		return this.shelf.last !== null || this.shelf.all.length > 0;
	}

	/** Whether an address is the first screen's. */
	isHome(address) {
		return address === "all" || (address === "" && !this.hasLast);
	}

	/** The program whose beginning Play shows first for an address. */
	first(address) {
		return (address === "" || address === "all" ? this.last() : this.find(this.ownOf(address))).catch(() => this.find(FIRST));
	}

	/** The id of what the user has made of a lesson's program last; otherwise the same name. */
	ownOf(name) {
		const lesson = lessonOf(name);
		const own = lesson === null ? [] : this.shelf.all.filter((each) => each.lesson === lesson && isProgram(each.program));
		return own.sort((a, b) => b.changed - a.changed)[0]?.id ?? name;
	}
}

/** The title of one of the page's programs. */
const titleOf = (name) => words.games[name] ?? words.examples[name] ?? texts.lessons.list[lessonOf(name)].title;
