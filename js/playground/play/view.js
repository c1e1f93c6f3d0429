/** Play: a program of blocks beside its world. The view starts, stops and draws the game; screen/layout.js has its elements. */
import { CollisionBlocks } from "starlogo-collision";
import { button } from "../shared/dom.js";
import { dragAgents } from "../shared/drawing/dragging.js";
import { loadLand } from "../shared/files/models.js";
import { SHAPES } from "../shared/names.js";
import { texts } from "../shared/language.js";
import { Loop } from "../shared/loop.js";
import { Requests } from "../shared/requests.js";
import { BuildBar } from "./screen/buildbar.js";
import { Keys } from "./screen/keys.js";
import { ModelShelf } from "./programs/modelshelf.js";
import { LandStage } from "./screen/landstage.js";
import { Layout } from "./screen/layout.js";
import { loadMessages } from "./blocks/messages.js";
import { onGround } from "./game/moves.js";
import { Panel } from "./screen/panel.js";
import { Scene } from "./screen/scene.js";
import { Sound } from "./screen/sound.js";
import { Programs } from "./programs/programs.js";
import { meaning } from "./programs/programtext.js";
import { FRAMES_A_SECOND, SEED, World } from "./game/world.js";

const words = texts.play;
/** The most frames that are computed between two pictures to make up for lost time. */
const MOST_AT_ONCE = 8;
/** A game with at most so many agents is looked at closely. */
const FEW = 4;

export async function createView(main, link) {
	const messages = loadMessages();
	const { models, greatLand } = await loadLand(SHAPES);
	const view = new PlayView(main, models, new World(greatLand));
	const opening = view.open(link);
	await messages;
	const { finder } = view.programs;
	view.preview((await finder.first(link)).program);
	if (finder.isHome(link)) await view.programs.openHome();
	const [{ Editor }] = await Promise.all([messages.then(() => import("./blocks/editor.js")), view.modelShelf.loadKept()]);
	view.setEditor(Editor);
	await opening;
	return view;
}

class PlayView {
	#beginEditing;
	#loop = new Loop((now) => this.#frames(now));
	#speed = 1;
	isBroken = false;
	/** Whether the user has dragged anything. */
	isDragKnown = false;
	/** Resolved when the editor is loaded. */
	editing = new Promise((resolve) => {
		this.#beginEditing = resolve;
	});
	#begun = "";
	/** The button that undoes the last deletion. It is no longer offered after another change. */
	#undo = null;
	/** The seed of the game's random numbers. */
	#seed = SEED;
	/** Whether the game has started by itself, because a system was chosen. */
	#isSelfStarted = false;
	/** The game beside this one, or null. */
	#beside = null;
	#besideRequests = new Requests();

	constructor(main, models, world) {
		this.models = models;
		this.world = world;
		this.programs = new Programs(this);
		this.keys = new Keys(world.input);
		this.modelShelf = new ModelShelf(this);
		this.sound = new Sound();
		this.panel = new Panel(world, (agent) => this.#choose(agent));
		this.buildBar = new BuildBar(this);
		this.layout = this.#makeLayout(main);
		this.stage = new LandStage(this.layout.worldHost, words.world);
		this.scene = new Scene(this.stage, world, models, this.layout.screen, () => this.#restart());
		this.layout.placeCorner([this.scene.legend, this.keys.pad], [this.buildBar.checkBox, this.sound.button]);
		this.layout.worldHost.addEventListener("pointerdown", () => this.editor?.closeMenus());
		this.keys.listen(this.stage, (agent) => {
			world.input.clicked = agent;
			this.#choose(agent);
		}, () => {
			// as in Level; a game that is stepped through, or that is built, waits for “Run”
			if (this.editor && !this.isRunning && world.frame === 0 && !this.isBroken && !this.buildBar.isOn) this.run();
		});
		this.buildBar.listen(this.stage);
		dragAgents(this.stage, {
			// the camera would follow, and run away
			mayDrag: (agent) => agent.isAlive && (this.scene.camera === "all" || agent !== (this.scene.chosen ?? this.scene.main)),
			isStill: () => !this.isRunning,
			onMove: (agent, x, y) => {
				agent.jumpTo(onGround(x), onGround(y), agent.z);
				this.#drag(agent, false);
			},
			onDone: (agent) => this.#drag(agent, true),
		});
		this.stage.controls?.addEventListener("start", () => this.#forgetDragNote());
		world.onSystem = (name) => {
			this.layout.system.value = name;
		};
		world.useSystem(CollisionBlocks.TIGHTEST_FITS);
	}

	#makeLayout(main) {
		return new Layout(main, this, {
			run: () => this.#pressRun(),
			step: () => this.#step(),
			reset: () => this.#resetWithNewSeed(),
			useSystem: (name) => this.#useSystem(name),
			putBeside: (name) => this.putBeside(name),
			useCamera: (name) => this.#useCamera(name),
			setSpeed: (speed) => {
				this.#speed = speed;
			},
			goBack: (frames) => this.#goBack(frames),
			showSeen: (isOn) => {
				this.scene.isEngineShown = isOn;
				this.draw();
				this.#playOn();
			},
			closeMenus: () => this.editor?.closeMenus(),
			playOn: () => this.#playOn(),
		});
	}

	#useCamera(name) {
		this.scene.camera = name;
		this.scene.frameAgents(true);
		this.programs.keepCamera(name);
		this.draw();
		this.#playOn();
	}

	/** Shows the whole ground, from a camera that stays. */
	showGround() {
		this.layout.camera.value = "all";
		this.scene.showGround();
	}

	#choose(agent) {
		this.scene.chosen = agent;
		this.draw();
	}

	/** Called when the user drags an agent. A game that stands still shows at once who touches whom. */
	#drag(agent, isDone) {
		const { world } = this;
		if (isDone && this.buildBar.moved(agent)) return;
		this.#forgetDragNote();
		this.programs.lessonCard.begin();
		this.#beside?.moveLike(agent);
		if (!this.isRunning && world.frame > 0) this.#collideAgain(isDone);
		if (!this.isRunning) this.draw();
		if (isDone) this.#playOn();
	}

	/** Shows who touches whom in a frame that stands still. If it is amended, one can go back to what it shows. */
	#collideAgain(isAmended = false) {
		const { world } = this;
		const { ended } = world;
		this.#attempt(() => {
			world.history.goOn();
			world.collideAgain();
			this.#beside?.compare();
			if (isAmended) world.history.amend([...world.agents]);
		});
		if (world.ended !== ended) this.#end();
	}

	#forgetDragNote() {
		this.isDragKnown = true;
		this.layout.dragNote.hidden = true;
	}

	/** Shows the beginning of a program's game before its blocks are loaded. */
	async preview(program) {
		this.layout.isUsable = false;
		this.say(texts.loading);
		this.keys.show(program);
		if (this.#tryToShow(program)) return;
		await import("./game/lateengine.js").catch(() => null);
		if (!this.editor) this.#tryToShow(program);
	}

	/** Shows the beginning of a program's game. Returns whether it could: the game may need what is not loaded yet, or the program may be wrong. */
	#tryToShow(program) {
		try {
			this.world.begin(program);
			this.lookAt(program);
			return true;
		} catch {
			// an error is shown when the blocks are loaded
			this.world.agents.length = 0;
			this.draw();
			return false;
		}
	}

	/** Points the camera at a new program's game: the one that the user has chosen for it, or else the one that suits it. */
	lookAt(program, camera = null) {
		this.layout.camera.value = this.scene.lookAt(program, camera);
		// it matters where a few agents are looked at closely
		this.layout.showDragNote(!this.isDragKnown && !this.buildBar.isOn && this.scene.camera === "all" && this.world.agents.length <= FEW && Boolean(this.stage.renderer));
		this.draw();
	}

	/** Takes the editor, which the page loads last. */
	setEditor(Editor) {
		this.editor = new Editor(this.layout.blocksHost, this.layout.editBar, {
			onChange: (deleted) => this.#programChanged(deleted), pictureOf: (shape) => this.scene.pictureOf(shape), say: (text) => this.say(text),
		});
		this.layout.isUsable = true;
		this.#beginEditing();
	}

	/** Goes on with another collision system. */
	#useSystem(name) {
		const { isStale } = this;
		this.programs.useSystem(name);
		if (!isStale) this.#begun = meaning(this.programs.program);
		this.world.useSystem(name);
		// a game that stands still shows the new system's results
		if (!this.isRunning && this.world.frame > 0 && this.world.history.back === 0) {
			this.#collideAgain();
			this.#afterFrame();
		}
		// the lesson is about the system: its game shows at once what the system does
		const { lessonCard } = this.programs;
		if (lessonCard.isOfSystem) {
			this.reset();
			this.run();
			this.#isSelfStarted = true;
			this.showRun();
		} else lessonCard.hush();
		this.draw();
		this.#playOn();
	}

	/** Plays the same game with another system beside this one, from the start and with the same keys; "" removes it. */
	async putBeside(name) {
		const isWanted = this.#besideRequests.begin();
		const { Beside } = name === "" ? {} : await import("./beside.js");
		if (!isWanted()) return;
		const { isRunning } = this;
		this.#beside?.close();
		this.#beside = name === "" ? null : new Beside(this, name);
		this.layout.screens.classList.toggle("two", name !== "");
		this.reset();
		if (isRunning) this.run();
	}

	/** Gives the keyboard focus back to the game. */
	#playOn() {
		if (this.isRunning) this.layout.worldHost.focus({ preventScroll: true });
	}

	/** Opens the program in an address. */
	async open(link) {
		await this.editing;
		await this.programs.open(link);
	}

	/** Opens a file that the user has chosen, or dropped on the page. */
	openFile(file, files) {
		return this.programs.openFile(file, files);
	}

	/** Shows a message with a button, and returns the button. */
	offer(text, action, onclick) {
		const offered = button(action, onclick, { title: action });
		this.say(text, false, offered);
		return offered;
	}

	/** Plays a newly opened program: goes to its beginning, and points the camera at it. */
	play(program, camera) {
		this.reset({ seed: SEED });
		this.lookAt(program, camera);
	}

	/** Goes to the program's beginning, with other random numbers. Those of a lesson stay, because the teacher's page plays it again. */
	#resetWithNewSeed() {
		this.reset(this.programs.lessonCard.isOpen ? {} : { seed: 1 + Math.floor(Math.random() * 2147483646) });
	}

	/** Goes to the program's beginning, with the same random numbers or those of another seed. If it is quiet, the editor does not scroll to a wrong block. */
	reset({ isQuiet = false, seed = this.#seed } = {}) {
		this.#halt();
		this.#seed = seed;
		this.editor.mark(null);
		this.isBroken = false;
		this.say(words.ready);
		const { program } = this.programs;
		this.#begun = meaning(program);
		this.keys.show(program);
		this.#attempt(() => {
			this.#beside?.begin(program, this.#seed);
			this.world.begin(program, this.#seed);
		}, isQuiet);
		if (!this.isBroken && this.world.agents.length === 0) this.say(words.empty);
		this.layout.system.value = this.world.collisions.systemName;
		this.panel.restartCount();
		this.scene.begin();
		this.buildBar.begin();
		this.scene.frameAgents();
		this.programs.lessonCard.begin();
		this.scene.bestNote = "";
		this.scene.record = this.programs.record;
		this.draw();
	}

	/** Called when the user has changed the program, with the number of blocks that the change deleted. */
	#programChanged(deleted) {
		const isKept = this.programs.keepChange();
		// an error is marked at its block
		if (!this.isRunning && this.isStale) this.reset({ isQuiet: true });
		this.showRun();
		if (!isKept) this.say(words.notKept, true);
		else if (this.isRunning && this.isStale) this.say(words.stale);
		else if (deleted > 0 && !this.isRunning) this.#undo = this.offer(words.deleted(deleted), words.undo, () => {
			this.editor.undo();
			this.say(words.ready);
		});
		else if (this.#undo?.isConnected) this.say(words.ready);
	}

	#restart() {
		this.#resetWithNewSeed();
		this.run();
	}

	#pressRun() {
		if (!this.isRunning) this.run();
		else if (this.#isAnewOffered) this.#restart();
		else this.stop();
	}

	run() {
		// changes count from the beginning
		if (this.world.ended) this.#resetWithNewSeed();
		else if (this.isBroken || this.isStale) this.reset();
		if (this.isBroken) return;
		this.#isSelfStarted = false;
		this.#loop.run();
		this.layout.turnTo("game");
		this.showRun();
		this.say(words.running);
		this.layout.worldHost.focus({ preventScroll: true });
		this.panel.restartCount(performance.now());
	}

	get isRunning() {
		return this.#loop.isRunning;
	}

	/** This game, and the one beside it if there is one, each with its world, stage and scene. */
	get games() {
		return this.#beside ? [this, this.#beside] : [this];
	}

	get isStale() {
		return this.#begun !== meaning(this.programs.program);
	}

	/** Whether the button starts the running game anew. Who presses “Run” does not know yet that a game has started by itself, until a lesson says something to it. */
	get #isAnewOffered() {
		return this.isStale || this.#isSelfStarted;
	}

	stop() {
		this.#halt();
		this.say(words.stopped);
		this.draw();
	}

	/** Shows what the button does. */
	showRun() {
		this.layout.showRun(this.isRunning, this.#isAnewOffered);
	}

	#halt() {
		this.#loop.stop();
		this.showRun();
		this.world.input.releaseAll();
	}

	#step() {
		if (this.isRunning) this.stop();
		if (this.isBroken || this.world.ended || this.isStale) this.reset();
		if (this.isBroken) return;
		this.#stepGames();
		if (!this.isBroken) this.say(words.frame(this.world.frame));
		this.draw();
	}

	#stepGames() {
		this.#attempt(() => {
			this.#beside?.step();
			this.world.step();
			this.#beside?.compare();
		});
		this.#afterFrame();
		if (this.world.ended) this.#end();
	}

	/** Called after a frame. */
	#afterFrame() {
		this.panel.count();
		this.sound.hear(this.world);
		if (this.isBroken) return;
		const { lessonCard } = this.programs;
		const isSolved = lessonCard.look(this.world);
		if (this.#isSelfStarted && lessonCard.isJudged) {
			this.#isSelfStarted = false;
			this.showRun();
		}
		if (!isSolved) return;
		this.programs.solved(this.#begun);
		this.#celebrate(texts.lessons.done);
	}

	#end() {
		const { how, text } = this.world.ended;
		this.#halt();
		if (how === "won") {
			this.scene.bestNote = this.programs.win(this.world.seconds);
			this.draw();
			this.#celebrate(text);
		} else {
			this.sound.lost();
			this.say(text);
		}
	}

	/** Celebrates a success or a victory. */
	#celebrate(text) {
		this.sound.done();
		this.say(text);
		this.layout.celebrate();
	}

	#goBack(back) {
		if (this.isRunning) this.stop();
		this.isBroken = false;
		this.world.history.show(back);
		this.#beside?.goTo(this.world.frame);
		this.say(words.frame(this.world.frame));
		this.draw();
	}

	#frames(now) {
		for (let due = this.#loop.due(now, FRAMES_A_SECOND * this.#speed, MOST_AT_ONCE); due > 0 && this.isRunning; due--) this.#stepGames();
		this.draw();
	}

	/** Does something in which a program may fail. Shows the error. If it is quiet, the editor does not scroll to the wrong block. */
	#attempt(action, isQuiet = false) {
		if (this.isBroken) return;
		try {
			action();
		} catch (error) {
			this.isBroken = true;
			this.#halt();
			this.editor.mark(error.block ?? null, !isQuiet);
			this.say(words.problem(error.message), true);
		}
	}

	/** Shows a message, with further elements behind it. */
	say(text, isProblem = false, ...more) {
		this.layout.say(text, isProblem, ...more);
	}

	draw() {
		const { world } = this;
		this.scene.draw();
		this.buildBar.show();
		this.#beside?.draw();
		this.panel.show(this.isRunning ? performance.now() : 0);
		this.layout.showTime(world.history);
	}

	close() {
		this.#halt();
		this.#besideRequests.begin();
		this.#beside?.close();
		this.layout.close();
		this.sound.close();
		this.programs.close();
		this.editor?.close();
		this.stage.close();
	}
}
