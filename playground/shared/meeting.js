/** How two agents are apart, or touch. */
import { AgentQueries, Contact, Vector3D } from "starlogo-collision";
import { texts } from "../texts.js";
import { short } from "./dom.js";

const COLOUR = 0xd81b60;
const contact = new Contact();
const [from, to] = [new Vector3D(), new Vector3D()];

/** Draws how two agents are apart, or touch, as a collision system sees them; what to say of it. */
export function showMeeting(stage, system, a, b) {
	const lines = stage.wireframe("meeting", COLOUR, true);
	if (system.areColliding(a, b)) {
		lines.showContact(system.contactOf(a, b, contact));
		return texts.meeting.contact(short(contact.depth), placeText(contact.point), placeText(contact.normal));
	}
	const distance = new AgentQueries(system).distance(a, b, from, to);
	lines.showLines([from.x, from.y, from.z, to.x, to.y, to.z]);
	return texts.meeting.apart(short(distance), placeText(from), placeText(to));
}

/** A place, or a direction, in words. */
export const placeText = ({ x, y, z }) => [x, y, z].map((each) => (Math.abs(each) < 0.005 ? 0 : each).toFixed(2)).join(", ");
