/** The work of a class: what pupils have handed in, as the teacher has opened it. This browser keeps it until she removes it. */
import { Cabinet } from "./cabinet.js";
import { HANDED } from "../names.js";
import { WORK as KIND, isProgram, isWork, modelsOf, packed, unpacked } from "./packing.js";

const cabinet = new Cabinet("starlogo-playground.class", "works", "id");
const CODE = /\bSL1\.[\w-]+/g;

/** What pupils have handed in, by their names, the newest of each first: each {id, when, pupil, done, won, programs: [{name, lesson, program}], solutions: {lesson: program}, models}. */
let works = null;
let isKept = true;

/** A text from outside, no longer than a name; or another one, if it is none. */
const nameOf = (value, other = "") => (typeof value === "string" && value.trim() !== "" ? value.trim().slice(0, 60) : other);
const namesOf = (value) => (Array.isArray(value) ? value.filter((each) => typeof each === "string").slice(0, 100) : []);

/** The programs that did a pupil's lessons, by the lessons' names: whole, or a collision system alone if the lesson's own program is meant. */
const solutionsOf = (value) => Object.fromEntries(Object.entries(value && typeof value === "object" ? value : {}).filter(([, each]) => isProgram(each) || typeof each?.system === "string"));

/** The time at which a work was handed in, in milliseconds; the present time if its file does not say, or says a later one. */
const timeOf = (value) => (value > 0 && value < Date.now() ? value : Date.now());

/** The parts of a pupil's work, whatever else a file has. */
function workOf({ when, pupil, done, won, programs, solutions, models }) {
	const listed = (Array.isArray(programs) ? programs : []).filter(({ program } = {}) => isProgram(program));
	return {
		kind: KIND, when: timeOf(when), pupil: nameOf(pupil, "?"), done: namesOf(done), won: namesOf(won),
		programs: listed.map(({ name, lesson, program }) => ({ name: nameOf(name, "?"), lesson: nameOf(lesson), program })), solutions: solutionsOf(solutions), models: modelsOf(models),
	};
}

/** A pupil's work as the content of a file. */
export const toFile = (work) => JSON.stringify({ ...work, kind: KIND, when: Date.now() }, null, 1);

/** A pupil's work as a code, a text to send. */
export const toCode = async (work) => `SL1.${await packed({ ...work, kind: KIND, when: Date.now() })}`;

/** The content of each work as text, by which equal ones are known, whenever they were handed in. */
const contents = new WeakMap();

function contentOf(work) {
	if (!contents.has(work)) contents.set(work, JSON.stringify({ ...work, id: undefined, when: undefined }));
	return contents.get(work);
}

const sort = () => works.sort((a, b) => a.pupil.localeCompare(b.pupil) || b.when - a.when);
let opening = null;

/** Puts a work beside the others, unless it is there already. Returns whether it is new. */
async function add(value) {
	const work = workOf(value);
	if (works.some((each) => contentOf(each) === contentOf(work))) return false;
	work.id = crypto.getRandomValues(new Uint32Array(2)).join("-");
	works.push(work);
	sort();
	await change((store) => store.put(work));
	return true;
}

/** Changes what the browser keeps. If it refuses, the works are there until the page is closed. */
async function change(action) {
	try {
		await cabinet.within(action);
	} catch {
		isKept = false;
	}
}

export const handed = {
	/** Waits for what the browser keeps. Comes before everything else. */
	open() {
		opening ??= cabinet.all().then((all) => {
			works = all.map((kept) => ({ ...workOf(kept), id: kept.id }));
			sort();
		});
		return opening;
	},

	get all() {
		return works;
	},

	/** The works of each pupil, the newest first. */
	get pupils() {
		return [...Map.groupBy(works, ({ pupil }) => pupil).values()];
	},

	/** Whether the browser keeps the works. */
	get isKept() {
		return isKept;
	},

	/**
	 * Takes the content of a pupil's file. A single program counts as the work of a pupil who has the file's name.
	 *
	 * @returns {Promise<boolean>} whether it is new
	 * @throws {Error} if it is neither
	 */
	async take(text, fileName) {
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
				if (values.length === 0 || !values.every(isWork)) continue;
				let count = 0;
				for (const value of values) if (await add(value)) count++;
				return count;
			} catch {
				// perhaps in one line
			}
		}
		return null;
	},

	/** The address's argument for a program, which stays when other works come. */
	addressOf: (work, number) => `${HANDED}${work.id}-${number}`,

	/** The program at such an address, with its pupil and models; null if there is none. */
	at(argument) {
		const [, id, number] = new RegExp(`^${HANDED}(.+)-(\\d+)$`).exec(argument) ?? [];
		const work = works.find((each) => each.id === id);
		const entry = work?.programs[number];
		return entry ? { ...entry, pupil: work.pupil, models: work.models } : null;
	},

	/** Removes all works of a pupil. */
	async remove(pupil) {
		const removed = works.filter((each) => each.pupil === pupil);
		works = works.filter((each) => each.pupil !== pupil);
		for (const { id } of removed) await change((store) => store.delete(id));
	},

	/** Forgets the whole class. */
	forget() {
		works = [];
		return change((store) => store.clear());
	},
};
