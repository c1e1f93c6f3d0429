/** Handlers, and what they do to the game while a frame calls them: to agents, models, the ground, the edges, the Collision itself. */
import assert from "node:assert/strict";
import { engine, HAIR } from "../tools.mjs";
import { solid } from "./models.mjs";
import { playWatchedFrame } from "./watch.mjs";

const { Collision, Terrain } = engine;

/** The message of errors that handlers throw on purpose. */
export const MEANT = "meant";

export const BREEDS = ["bears", "balls", "walls"];
const FIXTURES = [Collision.TERRAIN, Collision.EDGE];
const HANDLERS = ["onCollision", "onCollisionStart", "onCollisionEnd"];

/** What handlers do. */
const ACTIONS = ["throw", "leave", "move", "system", "model", "update", "raise", "edges", "no ground", "new ground", "second", "reset"];

/** The contact is the one that the frame found, whatever handlers have changed since. */
function checkContact(game, collider, collidee, contact) {
	const { time, depth, normal } = contact;
	assert.ok(time >= 0 && time <= 1 && Math.abs(normal.length - 1) < HAIR, `contact ${time} ${normal}`);
	if (!collider.sweeps && !collidee.sweeps) game.expect("contact time", time === 1, `time ${time} of ${collider} and ${collidee}`);
	const meant = game.contacts.get(`${game.numberOf(collider)} ${game.numberOf(collidee)}`) ?? game.contacts.get(`${game.numberOf(collidee)} ${game.numberOf(collider)}`);
	if (meant !== undefined) game.expect("contact is of the frame", Math.abs(depth - meant) <= HAIR * Math.max(1, meant), `depth ${depth} of ${collider} and ${collidee}, not ${meant}`);
	if (meant === undefined || game.frameSystem !== game.collision.collisionSystem) return;
	const asked = game.frameSystem.contactOf(collider, collidee);
	game.expect("contactOf in a frame", Math.abs(asked.depth - meant) <= HAIR * Math.max(1, meant), `depth ${asked.depth} of ${collider} and ${collidee}, not ${meant}`);
}

/** What a handler does to the game. */
function act(game, action, collidee) {
	const { terrain, bounds } = game.collision;
	const isListed = game.agents.includes(collidee);
	if (action === "throw") {
		game.thrown++;
		throw new Error(MEANT);
	}
	if (action === "leave" && game.agents.length > 3 && isListed) game.leave(game.agents.indexOf(collidee) + game.agents.length);
	if (action === "move" && isListed) collidee.moveTo(collidee.x + 0.01, collidee.y, collidee.z);
	if (action === "system") game.system((game.setting.system + 1) % 4, false, 4);
	if (action === "model") {
		game.modelChanges++;
		game.take(solid("blob 1", game.calls.length + 1));
	}
	if (action === "update") assert.throws(() => game.collision.update(game.agents), /must not be called from a handler/);
	if (action === "raise" && terrain) terrain.setHeight(1, 1, terrain.getHeight(1, 1) + 0.3);
	if (action === "edges" && bounds) bounds.setTo(-3, -3, -2, 1 + game.calls.length % 3, 3, 3);
	if (action === "no ground") game.setGround(null);
	if (action === "new ground") game.setGround(new Terrain(4, 4, 1, -2, -1));
	if (["raise", "edges", "reset"].includes(action)) game.groundChanges++;
	if (action === "second") playWatchedFrame(game);
	if (action === "reset") reset(game);
}

function reset(game) {
	game.isReset = true;
	game.collision.reset();
	game.handlers = [];
}

export const handlers = {
	handler: {
		random({ pick }) {
			const breed = () => pick([...BREEDS, Collision.ANY_BREED]);
			return [pick(HANDLERS), ...pick([[breed(), breed()], [breed(), pick(FIXTURES)], [pick(FIXTURES), breed()]]), pick(["", "", "", ...ACTIONS]), pick(["", "contact", "rest"])];
		},
		play(game, kind, breed, other, action, takes) {
			const call = (collider, collidee, contact) => {
				assert.ok(!game.isReset, "a handler after a reset");
				game.calls.push([kind, game.numberOf(collider), game.numberOf(collidee), ...(contact ? [contact.time, contact.depth, contact.normal.x, contact.point.x] : [])]);
				if (contact) checkContact(game, collider, collidee, contact);
				act(game, action, collidee);
			};
			const takers = { "": (a, b) => call(a, b, null), contact: (a, b, contact) => call(a, b, contact), rest: (...all) => call(...all) };
			game.collision[kind](breed, other, takers[takes]);
			game.handlers.push([breed, other, takers[takes]]);
		},
	},
	unhandle: {
		random: ({ integer }) => [integer(99)],
		play(game, place) {
			if (game.handlers.length === 0) return;
			const [removed] = game.handlers.splice(place % game.handlers.length, 1);
			assert.ok(game.collision.removeHandler(...removed), "a handler was not there");
		},
	},
	reset: { random: () => [], play: reset },
};
