/** The agents of a game. */
import { Agent } from "starlogo-collision";
import { OWN_COLOURS } from "../../shared/drawing/colours.js";

/** An agent of a game, with data for blocks. */
export class Being extends Agent {
	born = 0;
	/** Its number among all agents that the game has made. A game that goes the same way gives the same numbers. */
	number = 0;
	/** Its place when the frame began: x, y, z, heading. */
	before = [0, 0, 0, 0];
	isAlive = true;
	/** The id of the block that has made it. */
	maker = null;
	/** Its words, and the frame until which they are shown. */
	said = { text: "", until: 0 };
	/** The frame of its last touch, and the frame in which that touch began. */
	touched = -1;
	hit = -1000;
	/** Its upward speed, in patches a frame: more than 0 in a jump, less in a fall. */
	rise = 0;
	/** Its variables. Changed, it is another object, so that frames that are kept keep theirs. */
	own = {};

	constructor(shape, breed) {
		super(shape, breed);
		// a field of this name would hide the engine's
		this.color = OWN_COLOURS;
	}
}
