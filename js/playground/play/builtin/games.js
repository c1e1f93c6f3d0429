/** The page's games, in Blockly's notation. */
import { Collision } from "starlogo-collision";
import { texts } from "../../shared/language.js";
import {
	aim, along, alongside, bounce, change, collision, colour, compare, count, create, each, either, end, fall, field, folded, get, go, goal, ground, hatch, heading, jump, key, limit, many, math, mound, move, nearest, number, numbers, paint,
	program, remove, repeat, say, scatter, score, set, side, size, solid, sound, stand, standing, start, step, sweep, timer, touch, trait, turn, up, walk, wall, when,
} from "./notation.js";
import { wallsBetween } from "../game/walls.js";

const words = texts.programs;

const splash = [paint("collidee", { block: { type: "starlogo_colour_of", fields: { WHO: "me" } } }), remove("me")];
const TURTLES = 10;
const unpainted = { block: { type: "starlogo_number_of", fields: { BREED: "turtles" }, inputs: { COLOUR: colour("own") } } };

const paintball = program(
	key("space", "pressed", "bears", hatch("paintballs", "sphere", paint("me", { block: { type: "starlogo_any_colour" } }), size(0.4), up(0.3), move(1))),
	touch("paintballs", "turtles", ...splash),
	each("bears",
		score({ block: { type: "math_arithmetic", fields: { OP: "MINUS" }, inputs: { A: number(TURTLES), B: unpainted } } }),
		when(compare("EQ", unpainted, number(0)), end("won", words.paintball.won))),
	each("turtles", move(0.02), turn("left", numbers(-4, 4))),
	folded(start(
		goal(words.paintball.goal),
		create(1, "bears", "bear", size(1.4), heading(0)),
		create(TURTLES, "turtles", "turtle", scatter, size(1.6)),
		create(6, "seagulls", "seagull", scatter, up(1.6), size(1.8)),
		create(5, "walls", "wall", scatter, size(4)),
	)),
	folded(key("up", "held", "bears", along(0.12, "walls"))),
	folded(key("down", "held", "bears", along(-0.08, "walls"))),
	folded(key("left", "held", "bears", turn("left", number(3)))),
	folded(key("right", "held", "bears", turn("right", number(3)))),
	folded(each("paintballs", move(0.25), when(compare("GT", trait("age"), number(1.5)), remove("me")))),
	folded(each("seagulls", move(0.05), turn("right", number(1)))),
	folded(touch("paintballs", "seagulls", ...splash)),
	folded(touch("paintballs", "walls", ...splash)),
	folded(collision("turtles", "walls", bounce)),
);

/** Arrow keys make the agents of a breed walk and turn, and slide along those of another breed. */
const walks = (breed, steps, others) => [
	folded(key("up", "held", breed, along(steps, others))),
	folded(key("down", "held", breed, along(-steps / 2, others))),
	folded(key("left", "held", breed, turn("left", number(3)))),
	folded(key("right", "held", breed, turn("right", number(3)))),
];

const GEMS = 6;
const chase = program(
	each("dragons", aim(nearest("people", 50)), move(0.04)),
	touch("dragons", "people", end("lost", words.chase.lost)),
	touch("people", "gems", remove("collidee"), change(1), when(compare("EQ", field("starlogo_score"), number(GEMS)), say(words.chase.home))),
	touch("people", "fortresses", when(compare("GTE", field("starlogo_score"), number(GEMS)), end("won", words.chase.won))),
	folded(start(
		goal(words.chase.goal), score(number(0)),
		create(1, "people", "person", size(1.2), go(-9, -9, 0), heading(45)),
		create(1, "dragons", "dragon", size(3), go(9, -9, 0), heading(180)),
		create(1, "fortresses", "fortress", size(4), go(8, 8, 0)),
		// around the trees, so that no tree stands in their way
		create(GEMS, "gems", "sphere", heading(numbers(0, 359)), move(9), size(0.6), up(0.3), paint("me", colour("yellow"))),
		create(7, "trees", "tree", heading(numbers(0, 359)), move(5), size(1.6)),
	)),
	...walks("people", 0.1, "trees"),
);

const EDGE = 11.5;
const maze = many(["place"],
	touch("people", "fortresses", end("won", words.maze.won)),
	touch("turtles", "people", say(words.maze.caught), { type: "starlogo_ask", inputs: { AGENT: field("starlogo_agent", { WHO: "collidee" }), DO: { block: go(-9, -9, 0) } } }),
	each("turtles", move(0.05)),
	collision("turtles", "walls", bounce),
	folded(start(
		goal(words.maze.goal), limit(90, words.maze.lost),
		create(1, "people", "person", size(1.2), go(-9, -9, 0), heading(90)),
		create(1, "fortresses", "fortress", size(3), go(9, -9, 0)),
		set("place", -8),
		repeat(3, wall(get("place"), EDGE, 8, 90), wall(get("place"), -EDGE, 8, 90), wall(EDGE, get("place"), 8), wall(-EDGE, get("place"), 8), step("place", 8)),
		wall(-6, -8, 8), wall(-6, 0, 8), wall(0, 0, 8), wall(0, 8, 8), wall(6, -8, 8), wall(6, 0, 8),
		wall(-4.5, -1, 3, 90), wall(1.5, -3, 3, 90), wall(7.5, 1, 3, 90),
		create(1, "turtles", "turtle", size(1.3), go(-3, -8, 0), heading(70)),
		create(1, "turtles", "turtle", size(1.3), go(3, 7, 0), heading(110)),
		create(1, "turtles", "turtle", size(1.3), go(9, -3, 0), heading(200)),
	)),
	...walks("people", 0.1, "walls"),
);

const SHIELDS = 3;
const space = many(["shields"],
	key("space", "pressed", "spaceships", hatch("shots", "sphere", size(0.4), paint("me", colour("yellow")), up(0.4), move(1.2))),
	touch("shots", "rocks", change(1),
		{ type: "starlogo_ask", inputs: { AGENT: field("starlogo_agent", { WHO: "collidee" }), DO: { block: when(compare("GT", trait("size"), number(1.5)),
			repeat(2, hatch("rocks", "sphere", size(1.1), paint("me", colour("brown")), turn("left", numbers(0, 359))))) } } },
		remove("collidee"), remove("me")),
	touch("spaceships", "rocks", step("shields", -1), remove("collidee"), say(words.space.hit), when(compare("LTE", get("shields"), number(0)), end("lost", words.space.lost))),
	each("spaceships", alongside(number(0.04), "rocks"), when(compare("EQ", count("rocks", 50), number(0)), end("won", words.space.won))),
	each("rocks", move(0.05)),
	folded(start(
		ground("space"), goal(words.space.goal), score(number(0)), set("shields", SHIELDS),
		create(1, "spaceships", "spaceship", size(1.8), heading(90)),
		create(5, "rocks", "sphere", scatter, when(compare("LT", { block: { type: "starlogo_distance", inputs: { AGENT: nearest("spaceships", 50) } } }, number(4)), move(8)), size(2.2), paint("me", colour("grey"))),
	)),
	folded(key("up", "held", "spaceships", move(0.1))),
	folded(key("left", "held", "spaceships", turn("left", number(3)))),
	folded(key("right", "held", "spaceships", turn("right", number(3)))),
	folded(each("shots", move(0.3), when(compare("GT", trait("age"), number(0.8)), remove("me")))),
);

const [PEARLS, MISSES] = [12, 3];
const catching = many(["missed"],
	timer(1.2, "turtles", hatch("pearls", "sphere", size(0.8), paint("me", colour("white")), go(numbers(-7, 7), 0, 6.5))),
	each("pearls", up(-0.05), when(compare("LT", trait("z"), number(0)), step("missed", 1), when(compare("GTE", get("missed"), number(MISSES)), end("lost", words.catch.lost)), remove("me"))),
	touch("turtles", "pearls", remove("collidee"), change(1), when(compare("GTE", field("starlogo_score"), number(PEARLS)), end("won", words.catch.won))),
	folded(start(
		ground("sea"), goal(words.catch.goal), score(number(0)), set("missed", 0),
		create(1, "turtles", "turtle", size(2.4), heading(0)),
		create(12, "kelp", "kelp", scatter, go(numbers(-7, 7), numbers(2, 5), 0), size(2.6)),
		// the view reaches as high as the highest agent
		create(1, "seagulls", "seagull", go(0, 4, 6.5), size(2)),
	)),
	folded(key("left", "held", "turtles", heading(180), move(0.16))),
	folded(key("right", "held", "turtles", heading(0), move(0.16))),
);

const RUNNERS = 8;
const tagged = [{ type: "starlogo_become", fields: { WHO: "collidee", BREED: "taggers" } }, paint("collidee", colour("red")), change(1)];
const tag = program(
	touch("players", "people", ...tagged),
	touch("taggers", "people", ...tagged),
	each("taggers", aim(nearest("people", 50)), alongside(number(0.05), "trees")),
	each("people",
		when(compare("GT", count("players", 4), number(0)), aim(nearest("players", 50)), turn("left", number(180))),
		turn("left", numbers(-6, 6)), alongside(number(0.06), "trees")),
	each("players", when(compare("EQ", count("people", 50), number(0)), end("won", words.tag.won))),
	folded(start(
		goal(words.tag.goal), limit(45, words.tag.lost), score(number(0)),
		create(1, "players", "person", size(1.4), paint("me", colour("red"))),
		create(RUNNERS, "people", "person", scatter, size(1.2), paint("me", colour("blue"))),
		create(6, "trees", "tree", scatter, size(1.6)),
	)),
	...walks("players", 0.12, "trees"),
);

const [BALLS, GOAL] = [3, 20];
const x = (by) => math("ADD", trait("x"), number(by));
const pinball = many(["balls", "place"],
	collision("balls", "bumpers", bounce),
	touch("balls", "bumpers", change(1), paint("collidee", { block: { type: "starlogo_any_colour" } }), when(compare("GTE", field("starlogo_score"), number(GOAL)), end("won", words.pinball.won))),
	collision("balls", "paddles", heading(numbers(50, 130))),
	collision("balls", "walls", bounce),
	each("balls", move(0.2), when(compare("LT", trait("y"), number(-10.5)),
		step("balls", -1), go(0, 6, 0.3), heading(numbers(230, 310)), when(compare("LTE", get("balls"), number(0)), end("lost", words.pinball.lost)))),
	folded(start(
		goal(words.pinball.goal), score(number(0)), set("balls", BALLS),
		create(1, "paddles", "wall", size(5), heading(90), go(0, -9, 0), paint("me", colour("blue"))),
		create(1, "balls", "sphere", size(0.9), go(0, 6, 0.3), heading(250), paint("me", colour("orange"))),
		sweep("balls"),
		create(1, "bumpers", "cylinder", size(2), go(-5, 4, 0), paint("me", colour("purple"))),
		create(1, "bumpers", "cylinder", size(2), go(5, 4, 0), paint("me", colour("purple"))),
		create(1, "bumpers", "fortress", size(3), go(0, 0.5, 0)),
		create(1, "bumpers", "cylinder", size(1.4), go(-3, -3, 0), paint("me", colour("green"))),
		create(1, "bumpers", "cylinder", size(1.4), go(3, -3, 0), paint("me", colour("green"))),
		set("place", -8),
		repeat(3, wall(get("place"), EDGE, 8, 90), wall(EDGE, get("place"), 8), wall(-EDGE, get("place"), 8), step("place", 8)),
	)),
	folded(key("left", "held", "paddles", when(compare("GT", trait("x"), number(-8)), go(x(-0.25), -9, 0)))),
	folded(key("right", "held", "paddles", when(compare("LT", trait("x"), number(8)), go(x(0.25), -9, 0)))),
);

const PEAKS = 5;
const hills = program(
	touch("people", "gems", remove("collidee"), change(1), when(compare("EQ", field("starlogo_score"), number(PEAKS)), end("won", words.hills.won))),
	each("people", stand),
	folded(each("gems", stand)),
	folded(each("trees", stand)),
	folded(start(
		goal(words.hills.goal), limit(40, words.hills.lost), score(number(0)),
		create(1, "people", "person", size(1.2), heading(90)),
		create(PEAKS, "gems", "sphere", heading(numbers(0, 359)), move(8), mound(numbers(1, 3), numbers(5, 8)), size(0.6), paint("me", colour("yellow"))),
		create(6, "trees", "tree", heading(numbers(0, 359)), move(numbers(4, 6)), mound(1, 5), size(1.6)),
	)),
	...walks("people", 0.1, "trees"),
);

const COINS = 5;
const slab = (x, z, wide) => create(1, "platforms", "platform", size(wide), go(x, 0, z));
const gold = (x, z) => create(1, "coins", "coin", size(0.8), go(x, 0, z));
const beginning = go(-7.5, 0, 2);
const jumping = program(
	each("people", fall,
		when(standing(Collision.TERRAIN), say(words.jump.again), beginning)),
	key("space", "pressed", "people", jump(2.5), sound("jump")),
	touch("people", "coins", remove("collidee"), change(1), sound("ding")),
	touch("people", "turtles", either(side("me", "bottom"), [remove("collidee"), sound("pop")], [end("lost", words.jump.lost)])),
	touch("people", "houses", either(compare("GTE", field("starlogo_score"), number(COINS)), [end("won", words.jump.won)], [say(words.jump.more)])),
	each("lifts", move(0.03), when(compare("GT", trait("x"), number(1.4)), heading(180)), when(compare("LT", trait("x"), number(-1)), heading(0))),
	each("turtles", walk(0.02), fall, when(compare("GT", trait("x"), number(6)), heading(180)), when(compare("LT", trait("x"), number(4)), heading(0))),
	folded(start(
		goal(words.jump.goal), score(number(0)), solid("platforms"), solid("lifts"),
		slab(-7, 0.5, 3), slab(-3.5, 1, 2), slab(5, 1.2, 3.5), slab(8, 3, 2),
		create(1, "lifts", "platform", size(2), go(0, 0, 1.2), paint("me", colour("blue"))),
		create(1, "people", "person", size(1), beginning),
		create(1, "turtles", "turtle", size(1), go(5, 0, 2.1)),
		create(1, "houses", "house", size(1.2), go(8.3, 0, 3.5)),
		gold(-6, 2.2), gold(-3.5, 2.4), gold(0.2, 2.8), gold(4, 2.9), gold(6.2, 3.4),
	)),
	folded(key("left", "held", "people", heading(180), walk(0.1))),
	folded(key("right", "held", "people", heading(0), walk(0.1))),
);

/** The maze of the next game. It was built in the world by mouse: each line is a stroke of “Walls”, from one place to another. */
export const STROKES = [[[-10, -10], [10, -10]], [[10, -10], [10, 10]], [[10, 10], [-10, 10]], [[-10, 10], [-10, -10]], [[-6, -10], [-6, 6]], [[-2, 10], [-2, -6]], [[2, -10], [2, 2]], [[6, -10], [6, 2]]];
const places = STROKES.flatMap((stroke) => wallsBetween(...stroke.map(([x, y]) => ({ x, y }))));
const drive = program(
	touch("cars", "keys", remove("collidee"), sound("ding"), say(words.drive.found)),
	touch("cars", "houses", either(compare("EQ", count("keys", 50), number(0)), [end("won", words.drive.won)], [say(words.drive.more)])),
	folded(start(
		goal(words.drive.goal), limit(60, words.drive.lost), solid("walls"),
		create(1, "cars", "car", size(1.6), go(-8, -8, 0), heading(90)),
		create(1, "keys", "key", size(1.6), go(4, -8, 0.2)),
		create(1, "houses", "house", size(2), go(8, -8, 0)),
		...places.map(([x, y, turned, long]) => wall(x, y, long, turned)),
	)),
	folded(key("up", "held", "cars", walk(0.15))),
	folded(key("down", "held", "cars", walk(-0.08))),
	folded(key("left", "held", "cars", turn("left", number(4)))),
	folded(key("right", "held", "cars", turn("right", number(4)))),
);

export const GAMES = { paintball, chase, maze, space, catch: catching, tag, pinball, hills, jump: jumping, drive };
