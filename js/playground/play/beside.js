/** Plays the same game a second time with another collision system, beside the first one. It has the same start and the same keys. */
import { h } from "../shared/dom.js";
import { fixed, texts } from "../shared/language.js";
import { judge, verdictsOf } from "../shared/pairs.js";
import { LandStage } from "./screen/landstage.js";
import { nameOf } from "./screen/panel.js";
import { Scene } from "./screen/scene.js";
import { FRAMES_A_SECOND, World } from "./game/world.js";

const words = texts.play;

export class Beside {
	/** The frames in which the two games reported different touches, in order, and the first difference. */
	#frames = [];
	#first = "";

	/**
	 * @param {object} view Play, which has the game
	 * @param {string} system the collision system
	 */
	constructor(view, system) {
		this.view = view;
		this.host = h("div.world");
		this.screen = h("div.screen", {}, this.host);
		view.layout.screens.append(this.screen);
		this.stage = new LandStage(this.host, words.besideWorld(texts.systems[system]));
		this.world = new World(view.world.greatLand);
		this.world.useSystem(system);
		this.world.isSystemFixed = this.world.isWatched = view.world.isWatched = true;
		this.scene = new Scene(this.stage, this.world, view.models, this.screen);
		this.stage.controls?.addEventListener("change", () => {
			if (!this.#isFollowing) view.stage.lookAs(this.stage);
		});
		this.count = h("span");
		this.first = h("span", { role: "status" });
		this.note = h("p.differences", {}, this.count, " ", this.first);
		view.layout.screens.after(this.note);
		view.scene.isBeside = true;
		view.scene.caption.hidden = this.scene.caption.hidden = false;
	}

	#isFollowing = false;

	begin(program, seed) {
		this.world.begin(program, seed);
		this.#frames.length = 0;
		this.#first = "";
		this.scene.begin();
		for (const { scene } of [this.view, this]) scene.differing = new Map();
	}

	/** Moves the agent that is the same as one of the first game to the same place. */
	moveLike({ number, x, y, z }) {
		this.world.agents.find((agent) => agent.number === number)?.jumpTo(x, y, z);
		if (!this.view.isRunning && this.world.frame > 0) this.world.collideAgain();
	}

	/** Does a frame, before the first game does its own. */
	step() {
		if (this.world.ended) return;
		this.world.input.copyFrom(this.view.world.input, this.world.agents);
		this.world.step();
	}

	/** Goes back to a frame of the first game. */
	goTo(frame) {
		this.world.history.show(Math.max(0, this.world.frame + this.world.history.back - frame));
		while (this.#frames.at(-1) > frame) this.#frames.pop();
		this.compare();
	}

	/** Finds the agents that touch in only one of the two games. */
	compare() {
		const games = [this.view, this];
		// a game that has ended stands still
		const [mine, its] = games.map(({ world }) => (this.world.frame === this.view.world.frame ? world.pairs : new Map()));
		const { wrong, missed } = judge(mine, its);
		const only = [wrong, missed];
		games.forEach(({ world, scene }, i) => {
			const numbered = new Map(world.agents.map((agent) => [agent.number, agent]));
			const here = (pairs) => pairs.flat().map(({ number }) => numbered.get(number)).filter(Boolean);
			scene.differing = verdictsOf({ missed: here(only[1 - i]), wrong: here(only[i]) });
		});
		const { frame } = this.view.world;
		const at = only[0].length > 0 ? 0 : 1;
		if (only[at].length === 0 || this.#frames.at(-1) >= frame) return;
		if (this.#frames.length === 0) {
			const [[a, b]] = only[at];
			this.#first = words.firstDifference(fixed(frame / FRAMES_A_SECOND, 1), systemOf(games[at]), nameOf(a), nameOf(b));
		}
		this.#frames.push(frame);
	}

	draw() {
		const { view, world, scene, stage } = this;
		this.#isFollowing = true;
		stage.lookAs(view.stage);
		scene.camera = "all";
		scene.isEngineShown = view.scene.isEngineShown;
		scene.draw();
		this.#isFollowing = false;
		for (const game of [view, this]) game.scene.caption.textContent = words.reports(systemOf(game), game.world.pairs.size, game.world.meetingCount);
		const { length } = this.#frames;
		this.count.textContent = length === 0 ? words.noDifference : words.differences(length);
		const first = length === 0 ? "" : this.#first;
		if (this.first.textContent !== first) this.first.textContent = first;
		scene.goal.hidden = true;
	}

	close() {
		const { view } = this;
		view.world.isWatched = false;
		view.scene.differing = new Map();
		view.scene.isBeside = false;
		view.scene.caption.hidden = true;
		this.note.remove();
		this.stage.close();
		this.screen.remove();
	}
}

const systemOf = ({ world }) => texts.systems[world.collisions.systemName];
