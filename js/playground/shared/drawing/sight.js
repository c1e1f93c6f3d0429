/** Shows agents on a stage as a collision system sees them. */
import { CollisionBlocks, Contact, StructureBlocks, Vector3D } from "starlogo-collision";
import { fixed, texts } from "../language.js";
import { LINES, VERDICTS } from "./colours.js";
import { short } from "../dom.js";

const contact = new Contact();
const [from, to] = [new Vector3D(), new Vector3D()];

export class Sight {
	/** @param {Function|null} AgentQueries answers how far agents are apart; null as long as only contacts are shown */
	constructor(stage, greatLand, models, agents, system, AgentQueries = null) {
		Object.assign(this, { stage, models, agents });
		this.blocks = new CollisionBlocks(greatLand, agents);
		this.structures = new StructureBlocks(this.blocks);
		this.queries = AgentQueries && new AgentQueries(this.blocks.collision);
		this.use(system);
	}

	/** Loads what answers how far agents are apart. */
	async load() {
		const { AgentQueries } = await import("../queries.js");
		this.queries ??= new AgentQueries(this.blocks.collision);
	}

	get system() {
		return this.blocks.systemName;
	}

	use(name) {
		this.blocks.useCollisionSystem(name);
	}

	/** Takes the agents' present places, for questions and on the stage. */
	update() {
		this.queries?.update(this.agents);
		this.stage.showAgents(this.agents, this.models);
	}

	/** Draws the shapes that the collision system tests. */
	showTested(isShown = true) {
		const lines = this.stage.wireframe("tested", { color: LINES.tested, opacity: this.system === CollisionBlocks.EXACT ? 0.4 : 1 });
		for (const agent of isShown ? this.agents : []) lines.showLines(this.structures.linesOf(agent));
	}

	/** Draws the gap or the contact between two agents. Returns words for it; null if they are apart and load() has to be called first. */
	showMeeting(a, b) {
		const { collisionSystem } = this.blocks.collision;
		const areApart = !collisionSystem.areColliding(a, b);
		const lines = this.stage.wireframe("meeting", { color: areApart ? LINES.distance : VERDICTS.hit, isOnTop: true });
		this.stage.showDepth(null);
		if (areApart) {
			if (!this.queries) return null;
			const distance = this.queries.distance(a, b, from, to);
			lines.showLines([from.x, from.y, from.z, to.x, to.y, to.z]);
			this.stage.tell(texts.meeting.gap(short(distance)), (from.x + to.x) / 2, (from.y + to.y) / 2, (from.z + to.z) / 2);
			return texts.meeting.apart(short(distance), placeText(from), placeText(to));
		}
		collisionSystem.contactOf(a, b, contact);
		lines.showContact(contact);
		this.stage.showDepth(contact);
		this.stage.tell(texts.meeting.deep(short(contact.depth)), contact.point.x, contact.point.y, contact.point.z);
		return texts.meeting.contact(short(contact.depth), placeText(contact.point), placeText(contact.normal));
	}
}

/** A place or a direction in words. */
export const placeText = ({ x, y, z }) => [x, y, z].map((each) => fixed(Math.abs(each) < 0.005 ? 0 : each, 2)).join(texts.numbers.between);
