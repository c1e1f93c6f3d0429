/** A game on nothing but the engine and a canvas. */
import { Agent, BuiltInModel, Collision, CombinationCollider, GreatLand, ModelLoader } from "../../module/starlogo-collision.min.js";
import { Pictures } from "../shared/pictures.js";

const ASSETS = new URL("../../assets/", import.meta.url);
const PIXELS_A_PATCH = 10;
const HALF_WIDTH = 48;
const HALF_HEIGHT = 32;
const RELOAD = 25;
const PAINTS = ["#d94f3d", "#3d7bd9", "#e0a526", "#8a4fc9"];

const context = document.querySelector("canvas").getContext("2d");
const score = document.querySelector("output");
const pictures = new Pictures();
const greatLand = new GreatLand();
const collision = new Collision(new CombinationCollider(greatLand));
const agents = [];
const colours = new Map();
const counts = { frames: 0, turns: 0, hits: 0 };

loadModels();

function loadModels() {
	const loader = new ModelLoader(greatLand);
	loader.addEventListener("modelLoaded", ({ model }) => pictures.addModel(model));
	loader.addEventListener("error", ({ text }) => console.error(text));
	loader.addEventListener("complete", start);
	for (const file of ["fortress.obj", "tree.obj", "seagull.dae", "spaceship.obj"]) loader.load(file.split(".")[0], new URL(file, ASSETS).href);
}

function start() {
	const ball = BuiltInModel.sphere();
	greatLand.addModel(ball);
	pictures.addModel(ball);
	const fort = add("fortress", "land", -18, 4, 26, 0, "#b9a78c");
	fort.hierarchical = true; // its parts collide; everybody else is the tightest structure around them
	for (const [x, y] of [[34, 22], [40, 12], [30, -24], [-40, -24], [-42, 26]]) add("tree", "land", x, y, 8, 0, "#5f8f4e");
	for (let i = 0; i < 14; i++) add("seagull", "gulls", -40 + 13 * (i % 7), i < 7 ? 25 : -14, 6, 77 * i, "#ffffff");
	const ship = add("spaceship", "ships", 24, 0, 10, 90, "#8fa3b5");

	collision.onCollision("gulls", Collision.ANY_BREED, turnAway);
	collision.onCollisionStart("gulls", Collision.ANY_BREED, () => counts.turns++);
	collision.onCollision("shots", "gulls", paint);
	collision.onCollision("shots", "land", remove);
	requestAnimationFrame(function frame() {
		step(ship);
		draw();
		requestAnimationFrame(frame);
	});
}

function add(shape, breed, x, y, size, heading, colour) {
	const agent = new Agent(shape, breed);
	agent.size = size;
	agent.heading = heading;
	agent.jumpTo(x, y, 0);
	agents.push(agent);
	colours.set(agent, colour);
	return agent;
}

function remove(agent) {
	agents.splice(agents.indexOf(agent), 1);
	colours.delete(agent);
}

function step(ship) {
	counts.frames++;
	ship.heading += 1.5;
	if (counts.frames % RELOAD === 0) shoot(ship);
	for (const agent of [...agents]) {
		if (agent.breed === "gulls") walk(agent, 0.22);
		if (agent.breed === "shots") {
			walk(agent, 1.8);
			if (isOutside(agent, 0)) remove(agent);
		}
	}
	collision.update(agents);
}

function shoot(ship) {
	const shot = add("sphere", "shots", ship.x, ship.y, 1.4, ship.heading, PAINTS[(counts.frames / RELOAD) % PAINTS.length]);
	shot.sweeps = true; // it is fast: it meets whatever is on its way
}

function walk(agent, distance) {
	const angle = (agent.heading * Math.PI) / 180;
	agent.moveTo(agent.x + distance * Math.cos(angle), agent.y + distance * Math.sin(angle), agent.z);
	if (agent.breed === "gulls" && isOutside(agent, 4)) agent.heading = (Math.atan2(-agent.y, -agent.x) * 180) / Math.PI;
}

function isOutside({ x, y }, margin) {
	return Math.abs(x) > HALF_WIDTH - margin || Math.abs(y) > HALF_HEIGHT - margin;
}

/** Out of what was met, and on as a ball from a cushion. */
function turnAway(gull, other, { normal, depth }) {
	if (other.breed === "shots") return;
	const angle = (gull.heading * Math.PI) / 180;
	const towards = normal.x * Math.cos(angle) + normal.y * Math.sin(angle);
	gull.moveTo(gull.x + normal.x * depth, gull.y + normal.y * depth, 0);
	if (towards < 0) gull.heading = (Math.atan2(Math.sin(angle) - 2 * towards * normal.y, Math.cos(angle) - 2 * towards * normal.x) * 180) / Math.PI;
}

function paint(shot, gull) {
	counts.hits++;
	colours.set(gull, colours.get(shot));
	remove(shot);
}

function draw() {
	context.setTransform(1, 0, 0, 1, 0, 0);
	context.fillStyle = "#bcd8e0";
	context.fillRect(0, 0, context.canvas.width, context.canvas.height);
	for (const agent of agents) {
		const picture = pictures.of(agent.shape, colours.get(agent), Math.ceil(agent.size * PIXELS_A_PATCH));
		context.setTransform(1, 0, 0, 1, context.canvas.width / 2 + agent.x * PIXELS_A_PATCH, context.canvas.height / 2 - agent.y * PIXELS_A_PATCH);
		context.rotate((-agent.heading * Math.PI) / 180);
		context.drawImage(picture, -picture.width / 2, -picture.height / 2);
	}
	score.textContent = `frame ${counts.frames}: ${counts.turns} turns, ${counts.hits} hits, ${collision.statistics.candidatePairs} pairs looked at`;
}
