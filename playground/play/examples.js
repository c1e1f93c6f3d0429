/** The programs that the playground brings, in Blockly's notation. */
import { texts } from "../shared/language.js";
import { number, colour, numbers, inside, move, turn, paint, size, up, heading, scatter, create, key, each, touch, start, remove, program, folded, field, along, compare, when, score, end, goal, nearMiss } from "./notation.js";

const splash = [paint("collidee", { block: { type: "starlogo_colour_of", fields: { WHO: "me" } } }), remove("me")];
const TURTLES = 10;
const unpainted = { block: { type: "starlogo_number_of", fields: { BREED: "turtles" }, inputs: { COLOUR: colour("own") } } };
const words = texts.programs;

const paintball = program(
	key("space", "pressed", "bears", { type: "starlogo_hatch", fields: { BREED: "paintballs", SHAPE: "sphere" }, inputs: { DO: inside(paint("me", { block: { type: "starlogo_any_colour" } }), size(0.4), up(0.8), move(1)) } }),
	touch("paintballs", "turtles", ...splash),
	each("bears",
		score({ block: { type: "math_arithmetic", fields: { OP: "MINUS" }, inputs: { A: number(TURTLES), B: unpainted } } }),
		when(compare("EQ", unpainted, number(0)), end("won", words.allPainted))),
	each("turtles", move(0.02), turn("left", numbers(-4, 4))),
	folded(start(
		goal(words.paintball),
		create(1, "bears", "bear", size(1.4), heading(0)),
		create(TURTLES, "turtles", "turtle", scatter, size(1.6)),
		create(6, "seagulls", "seagull", scatter, up(1.6), size(1.8)),
		create(5, "walls", "wall", scatter, size(4)),
	)),
	folded(key("up", "held", "bears", along(0.12, "walls"))),
	folded(key("down", "held", "bears", along(-0.08, "walls"))),
	folded(key("left", "held", "bears", turn("left", number(3)))),
	folded(key("right", "held", "bears", turn("right", number(3)))),
	folded(each("paintballs", move(0.25), when(compare("GT", field("starlogo_trait", { TRAIT: "age" }), number(1.5)), remove("me")))),
	folded(each("seagulls", move(0.05), turn("right", number(1)))),
	folded(touch("paintballs", "seagulls", ...splash)),
	folded(touch("paintballs", "walls", ...splash)),
	folded({ type: "starlogo_collision", fields: { BREED: "turtles", OTHER: "walls" }, inputs: { DO: inside({ type: "starlogo_bounce" }) } }),
);

export const EXAMPLES = {
	paintball,
	// all of the helmet is above the unit sphere
	helmet: nearMiss("fireman", 3, 0, 0, 6.6, 0.6),
	// in the box around the dragon, and nowhere near its body
	wing: nearMiss("dragon", 8, 0.8, -2.6, 0.4, 0.8),
	// in the unit sphere of the wall, and a good way from it
	wall: nearMiss("wall", 6, 1.5, 0, 1.5, 0.6),
};
