/** Who is in a game. */
import { Agent } from "starlogo-collision";
import { OWN_COLOURS } from "../shared/colours.js";

/** An agent of a game, with what blocks ask about it. */
export class Being extends Agent {
	born = 0;
	/** Which of all that the game has made it is: the same in another game that has gone the same way. */
	number = 0;
	/** Where it was when the frame began: x, y, z, heading. */
	before = [0, 0, 0, 0];
	isAlive = true;
	/** What it says, and until when. */
	said = { text: "", until: 0 };
	/** The frame in which it last touched another one, and that in which such a touch began. */
	touched = -1;
	hit = -1000;
	color = OWN_COLOURS;
}
