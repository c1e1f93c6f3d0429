/**
 * The work of a class: what pupils have handed in, as the teacher has opened it. It is in the memory of this page alone; the browser's tab
 * remembers it when the page is loaded again, if there is room.
 */
import { WORK as KIND, isProgram, isWork, modelsOf, packed, unpacked } from "./packing.js";

const KEY = "starlogo-playground.class";
/** The beginning of the address's argument for a program that was handed in. */
const PREFIX = "handed-";
const CODE = /\bSL1\.[\w-]+/g;

/** What pupils have handed in, each {pupil, done, won, programs: [{name, lesson, program}], models}. */
let works = null;

function all() {
	if (works) return works;
	try {
		works = (JSON.parse(sessionStorage.getItem(KEY)) ?? []).map(workOf);
	} catch {
		works = [];
	}
	return works;
}

function keep() {
	try {
		sessionStorage.setItem(KEY, JSON.stringify(works));
	} catch {
		// remembered until the page is closed
	}
}

/** A text from outside, no longer than a name; or another one, if it is none. */
const nameOf = (value, other = "") => (typeof value === "string" && value.trim() !== "" ? value.trim().slice(0, 60) : other);
const namesOf = (value) => (Array.isArray(value) ? value.filter((each) => typeof each === "string").slice(0, 100) : []);

/** The parts of a pupil's work, whatever else a file has. */
function workOf({ pupil, done, won, programs, models }) {
	const listed = (Array.isArray(programs) ? programs : []).filter(({ program } = {}) => isProgram(program));
	return { kind: KIND, pupil: nameOf(pupil, "?"), done: namesOf(done), won: namesOf(won), programs: listed.map(({ name, lesson, program }) => ({ name: nameOf(name, "?"), lesson: nameOf(lesson), program })), models: modelsOf(models) };
}

/** A pupil's work as the content of a file. */
export const toFile = (work) => JSON.stringify({ ...work, kind: KIND }, null, 1);

/** A pupil's work as a code, a text to send. */
export const toCode = async (work) => `SL1.${await packed({ ...work, kind: KIND })}`;

/** Puts a work beside the others, unless it is there already. Returns whether it is new. */
function add(value) {
	const work = workOf(value);
	const text = JSON.stringify(work);
	if (all().some((each) => JSON.stringify(each) === text)) return false;
	works.push(work);
	works.sort((a, b) => a.pupil.localeCompare(b.pupil));
	keep();
	return true;
}

export const handed = {
	get all() {
		return all();
	},

	/**
	 * Takes the content of a pupil's file. A single program counts as the work of a pupil who has the file's name.
	 *
	 * @returns {boolean} whether it is new
	 * @throws {Error} if it is neither
	 */
	take(text, fileName) {
		const value = JSON.parse(text);
		if (isWork(value)) return add(value);
		if (!isProgram(value)) throw new Error("no work");
		const { name, lesson, models, ...program } = value;
		const title = fileName.replace(/\.json$/i, "");
		return add({ pupil: title, programs: [{ name: name ?? title, lesson, program }], models });
	},

	/** Takes all codes in a text. Returns the number of new works; null if there is no code, or a broken one. */
	async takeCodes(text) {
		// a letter may break a long code into lines
		for (const each of [text, text.replaceAll(/\s*\n\s*(?!SL1\.)/g, "")]) {
			try {
				const values = await Promise.all((each.match(CODE) ?? []).map((code) => unpacked(code.slice(4))));
				if (values.length > 0 && values.every(isWork)) return values.filter(add).length;
			} catch {
				// perhaps in one line
			}
		}
		return null;
	},

	/** The address's argument for a program. */
	addressOf: (work, number) => `${PREFIX}${all().indexOf(work)}-${number}`,

	/** The program at such an address, with its pupil and models; null if there is none. */
	at(argument) {
		const [, work, number] = /^handed-(\d+)-(\d+)$/.exec(argument) ?? [];
		const entry = all()[work]?.programs[number];
		return entry ? { ...entry, pupil: works[work].pupil, models: works[work].models } : null;
	},

	remove(work) {
		works = all().filter((each) => each !== work);
		keep();
	},
};
