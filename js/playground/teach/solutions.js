/** A solved program of each lesson, for the sheets. The words of the same solutions are in languages/. */
import { LESSONS } from "../play/builtin/library.js";
import { aim, bounce, collision, count, each, fall, jump, move, nearest, solid, sweep } from "../play/builtin/notation.js";

const say = (what) => ({ type: "starlogo_say", inputs: { TEXT: what } });

/** Puts a block, with those below it, behind the last one of the first script of a type. */
export function append(scripts, type, block) {
	let last = scripts.find((script) => script.type === type).inputs.DO.block;
	while (last.next) last = last.next.block;
	last.next = { block };
}

/** What a pupil changes in the blocks; or the collision system that solves the lesson. */
const CHANGES = {
	blocks: (scripts) => append(scripts, "starlogo_each", move(0.05)),
	helmet: "tightest fits",
	wing: "hierarchies",
	main: (scripts) => append(scripts, "starlogo_start", { type: "starlogo_hierarchical", fields: { WHO: "dragons", ON: "on" } }),
	fast: (scripts) => append(scripts, "starlogo_start", sweep("paintballs")),
	starts: (scripts) => {
		scripts.find(({ type }) => type === "starlogo_collision").type = "starlogo_touch_start";
	},
	room: (scripts) => scripts.push(collision("bears", "walls", bounce)),
	near: (scripts) => scripts.push(each("bears", say(count("turtles", 5)))),
	see: (scripts) => scripts.push(each("bears", say({ block: { type: "starlogo_can_see", inputs: { AGENT: nearest("turtles", 20) } } }))),
	hunt: (scripts) => {
		const { inputs } = scripts.find(({ type, fields }) => type === "starlogo_each" && fields.BREED === "bears");
		inputs.DO = { block: { ...aim(nearest("turtles", 50)), next: { block: move(0.15) } } };
	},
	jump: (scripts) => {
		append(scripts, "starlogo_start", solid("platforms"));
		append(scripts, "starlogo_each", jump(2));
		append(scripts, "starlogo_each", fall);
	},
};

/** The solved program of a lesson. */
export function solved(name) {
	const program = structuredClone(LESSONS[name].program);
	const change = CHANGES[name];
	if (typeof change === "string") return { ...program, system: change };
	change(program.blocks.blocks);
	return program;
}

/** Whether a lesson is solved by the choice of a collision system alone. */
export const isSolvedBySystem = (name) => typeof CHANGES[name] === "string";
