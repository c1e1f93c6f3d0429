/** The game: a player and enemies who walk in a level, bullets that sweep, and what is saved. It draws nothing, and z is up. */
import { Agent, AgentFilter, AgentQueries, Collision, CombinationCollider, Footing, Sphere, Vector3D } from "starlogo-collision";

const GRAVITY = 0.008; // patches a frame, in each frame
const JUMP = 0.18;
const BULLET_FRAMES = 90;
const ENEMY_SPEED = 0.035;
const ENEMY_COLOURS = [0xc8322b, 0xe06a1f, 0xb0265a, 0x8f3fb0];
const STRIDE = { stepHeight: 0.3, snap: 0.3, slopeDegrees: 50 };
const radians = (degrees) => (degrees * Math.PI) / 180;

/** Whoever walks: it remembers how fast it falls and what it stands on. */
class Walker extends Agent {
	speed = 0; // upwards
	footing = new Footing();

	constructor(breed, x, y, z, color) {
		super("person", breed);
		this.color = color;
		this.moveTo(x, y, z);
	}
}

class Bullet extends Agent {
	frames = Infinity; // how long it has flown; Infinity before it is shot
	constructor() {
		super("sphere", "bullets");
		Object.assign(this, { size: 0.2, color: 0xffc21a, sweeps: true });
	}
}

/** What the player does until a key is pressed: it goes round, jumps and shoots. */
export const wander = (frame) => ({ turn: Math.sin(frame / 50), walk: 1, jumps: frame % 200 === 0, shoots: frame % 30 === 0 });

export class Game {
	shots = 0;
	hits = 0;
	#queries;
	#collision;
	#bullets = Array.from({ length: 20 }, () => new Bullet());
	#solid = AgentFilter.ofBreeds("levels");
	#random = 7;

	/** @param {object} greatLand has the models "level", "person", a capsule, and "sphere" */
	constructor(greatLand) {
		this.#collision = new Collision(Object.assign(new CombinationCollider(greatLand), { exact: true }));
		this.#queries = new AgentQueries(this.#collision);
		this.level = Object.assign(new Agent("level", "levels"), { hierarchical: true }); // its triangles decide
		this.player = new Walker("players", 0, 0, 0.5, 0x2f77c4);
		this.enemies = Array.from({ length: 40 }, (_, i) => {
			const [angle, radius] = [2.4 * i, 8 + 1.4 * Math.sqrt(4 * i)];
			return new Walker("enemies", radius * Math.cos(angle), radius * Math.sin(angle), 6, ENEMY_COLOURS[i % ENEMY_COLOURS.length]);
		});
		this.#collision.onCollisionStart("bullets", Collision.ANY_BREED, (bullet, other) => this.#hit(bullet, other));
		this.#queries.update(this.agents);
		for (const walker of this.walkers) this.#queries.walk(walker, 0, 0, { ...STRIDE, fall: Infinity }, walker.footing); // down to the ground
		this.#collision.update(this.agents); // so that there is a frame to go back to
	}

	get agents() {
		return [this.level, ...this.walkers, ...this.bullets];
	}

	/** The player and the enemies. */
	get walkers() {
		return [this.player, ...this.enemies];
	}

	/** The bullets that fly. */
	get bullets() {
		return this.#bullets.filter(({ frames }) => frames < BULLET_FRAMES);
	}

	/** Goes on by a frame. `wish` has how the player turns and walks, from -1 to 1, and whether it jumps and shoots. */
	step({ turn, walk, jumps, shoots }) {
		const { player } = this;
		this.#queries.update(this.agents);
		player.heading -= 2.5 * turn;
		this.#walk(player, 0.08 * walk, jumps);
		for (const enemy of this.enemies) {
			const [dx, dy] = [player.x - enemy.x, player.y - enemy.y];
			if (Math.hypot(dx, dy) < 15 && this.#queries.canSee(enemy, player, this.#solid)) enemy.heading = (Math.atan2(dy, dx) * 180) / Math.PI;
			else if (enemy.footing.part < 0.3) enemy.heading += 20 + 90 * this.#next();
			this.#walk(enemy, Math.hypot(dx, dy) < 1.5 ? 0 : ENEMY_SPEED, false);
			if (enemy.z < -10) this.#dropIn(enemy); // it has walked off the level's edge
		}
		for (const bullet of this.bullets) {
			const angle = radians(bullet.heading);
			bullet.moveTo(bullet.x + 0.6 * Math.cos(angle), bullet.y + 0.6 * Math.sin(angle), bullet.z - 0.003 * bullet.frames);
			bullet.frames++;
		}
		if (shoots) this.#shoot(); // it flies from the next frame on, so all of its way is tested
		this.#collision.update(this.agents);
	}

	/**
	 * Where a camera behind the player can be, and where it looks: no wall is between them, and none touches it. It looks over the player's head at
	 * what is in front.
	 */
	cameraPlace() {
		const { player } = this;
		const eye = new Vector3D(player.x, player.y, player.z + 1.5);
		const angle = radians(player.heading);
		const [frontX, frontY] = [Math.cos(angle), Math.sin(angle)];
		const [dx, dy, dz] = [-5.5 * frontX, -5.5 * frontY, 1.6];
		const free = this.#queries.castShape(new Sphere(eye, 0.25), dx, dy, dz, this.#solid)?.time ?? 1;
		return { camera: new Vector3D(eye.x + free * dx, eye.y + free * dy, eye.z + free * dz), aim: new Vector3D(eye.x + 4 * frontX, eye.y + 4 * frontY, eye.z) };
	}

	/** The height and the normal of the ground below a walker, where its shadow is; null if there is none. */
	groundBelow({ x, y, z, footing }) {
		if (footing.stands) return { z, normal: footing.normal };
		const hit = this.#queries.cast(new Vector3D(x, y, z + 0.5), new Vector3D(0, 0, -1), 30, this.#solid);
		return hit && { z: hit.point.z, normal: hit.normal };
	}

	/** All that a later frame depends on. The snapshot has the agents' traits, what touches and what carries; the rest is the game's own. */
	save() {
		const own = this.#movers.map(({ speed, frames, footing }) => ({ speed, frames, stands: footing?.stands, part: footing?.part }));
		return { own, shots: this.shots, hits: this.hits, random: this.#random, agents: [...this.#collision.lastAgents], bytes: this.#collision.snapshot(true) };
	}

	/** Goes back to what save() gave. */
	goBackTo({ own, shots, hits, random, agents, bytes }) {
		this.#collision.restore(bytes, agents);
		this.#movers.forEach((mover, i) => {
			const { stands, part, ...rest } = own[i];
			Object.assign(mover, rest);
			if (mover.footing) Object.assign(mover.footing, { stands, part });
		});
		Object.assign(this, { shots, hits });
		this.#random = random;
	}

	get #movers() {
		return [...this.walkers, ...this.#bullets];
	}

	#walk(walker, distance, jumps) {
		const { footing, heading } = walker;
		walker.speed = footing.stands ? (jumps ? JUMP : 0) : walker.speed - GRAVITY;
		if (walker.speed > 0) this.#queries.moveUntilTouch(walker, 0, 0, walker.speed);
		const options = { ...STRIDE, fall: Math.max(0, -walker.speed) };
		this.#queries.walk(walker, distance * Math.cos(radians(heading)), distance * Math.sin(radians(heading)), options, footing);
	}

	#shoot() {
		const bullet = this.#bullets.find(({ frames }) => frames >= BULLET_FRAMES);
		if (!bullet) return;
		const { x, y, z, heading } = this.player;
		bullet.jumpTo(x + 0.6 * Math.cos(radians(heading)), y + 0.6 * Math.sin(radians(heading)), z + 1.2);
		bullet.heading = heading;
		bullet.frames = 0;
		this.shots++;
	}

	#hit(bullet, other) {
		if (bullet.frames >= BULLET_FRAMES) return; // it has hit another one in this frame
		bullet.frames = BULLET_FRAMES;
		if (other.breed !== "enemies") return;
		this.hits++;
		this.#dropIn(other);
	}

	#dropIn(enemy) {
		enemy.jumpTo(20 * (this.#next() - 0.5), 20 * (this.#next() - 0.5), 8);
		enemy.footing = new Footing();
		enemy.speed = 0;
	}

	/** A random number from 0 to 1. Each game has the same ones. */
	#next() {
		this.#random = (this.#random * 16807) % 2147483647;
		return this.#random / 2147483647;
	}
}
