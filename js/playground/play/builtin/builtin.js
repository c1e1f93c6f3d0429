/** The programs that the page brings along, by their names: games, examples, and those of lessons. They load when one is first wanted. */
import { loadWords, texts } from "../../shared/language.js";
import { LESSON_NAMES } from "./names.js";

/** The name of a lesson's program begins with this. */
const LESSON = "lesson-";

/** The name of a lesson's program. */
export const programOfLesson = (lesson) => LESSON + lesson;

/** The lesson that a program's name is of, or null. */
export const lessonOf = (name) => (name.startsWith(LESSON) ? name.slice(LESSON.length) : null);

/** Whether the page has a program with this name. */
export const isBuiltIn = (name) => Object.hasOwn(texts.play.games, name) || Object.hasOwn(texts.play.examples, name) || LESSON_NAMES.includes(lessonOf(name));

/** A program of the page. */
export async function builtInProgram(name) {
	await loadWords("game");
	const { BUILT_IN_PROGRAMS } = await import("./library.js");
	return BUILT_IN_PROGRAMS[name];
}
