/**
 * Measure: shows how long a frame's collisions take on this machine, by system and number of agents, beside the times of another machine.
 */
import { CollisionBlocks } from "starlogo-collision";
import { CAST } from "../shared/scattered.js";
import { button, choice, field, fileButton, h, modes, short, table } from "../shared/dom.js";
import { download } from "../shared/files/download.js";
import { texts } from "../shared/language.js";
import { recallList, rememberValue } from "../shared/files/memory.js";
import { MODEL_FILE } from "../shared/files/files.js";
import { loadLand } from "../shared/files/models.js";
import { ownModels } from "../shared/files/ownmodels.js";
import { Requests } from "../shared/requests.js";
import { chart, fileOf } from "./chart.js";
import { Live } from "./live.js";
import { COUNTS, isMeasured, measureAll } from "./times.js";

const words = texts.measure;
const KEY = "starlogo-playground.measured";
const MOST_KEPT = 12;
const FIRST_MOST = 400;
/** The share of times from which on the machine is called busy. */
const BUSY = 0.2;

export async function createView(main) {
	const [{ greatLand }, own] = await Promise.all([loadLand(CAST), ownModels()]);
	const view = new MeasureView(main, greatLand);
	view.live.offer(own);
	return view;
}

class MeasureView {
	/**
	 * The measurement: the machine's name, the date, the number of processors, and for each system pairs of a number of agents and
	 * milliseconds.
	 */
	result = null;
	/** The measurement of another machine, or an earlier one of this machine. */
	other = null;
	/** The measurement of the file that was opened last. */
	#file = null;
	#requests = new Requests();
	#isRunning = false;
	#most = FIRST_MOST;
	#unkept = null;

	constructor(main, greatLand) {
		this.greatLand = greatLand;
		this.name = h("input", { type: "text", value: words.thisMachine, maxlength: 40 });
		this.startButton = button(words.start, () => (this.#isRunning ? this.#stop(words.stopped) : this.run()), { class: "primary" });
		this.status = h("p.status", { role: "status" }, words.ready);
		this.busy = h("p.busy", { role: "status", hidden: true }, words.busy);
		this.others = h("select", { onchange: () => this.#choose(this.others.value) });
		this.picture = h("div.chart", { tabindex: "0", role: "group", "aria-label": words.chart });
		this.table = h("div.table", { tabindex: "0", role: "region", "aria-label": words.table });
		const most = choice(COUNTS.slice(2).map((count) => [String(count), String(count)]), String(FIRST_MOST), (count) => {
			this.#most = Number(count);
		});
		this.keepers = [button(words.keep, () => this.#keep()), button(words.download, () => download(JSON.stringify(this.result, null, 1), words.fileName, "application/json")),
			button(words.downloadChart, () => download(fileOf(this.picture.firstChild), words.chartName, "image/svg+xml"))];
		this.live = new Live(greatLand);
		this.series = h("div.series", { hidden: true });
		main.replaceChildren(modes(words, "live", (mode) => this.#turnTo(mode)), this.live.element, this.series);
		this.series.append(
			h("section.measuring", { "aria-label": words.title },
				h("div.tools", {}, this.startButton, field(words.most, most), this.status), this.busy, this.picture,
				h("div.tools", {}, field(words.machine, this.name), ...this.keepers, field(words.beside, this.others), fileButton(words.open, ".json", (file) => this.openFile(file)), h("small.hint", {}, words.openHint))),
			h("section.facts", {}, h("div.card", {}, h("h2", {}, words.title), h("p.note", {}, words.how), this.table)));
		this.live.open();
		this.#listOthers();
		this.#show();
		this.forgetSize = onSize(this.picture, () => this.#show());
	}

	/** Shows either a game that runs or the series of all systems. */
	#turnTo(mode) {
		if (mode === "series") this.live.stop();
		else if (this.#isRunning) this.#stop(words.stopped);
		this.live.element.hidden = mode !== "live";
		this.series.hidden = mode === "live";
		if (mode === "series") this.#show();
	}

	/** Measures from the beginning. */
	async run() {
		const isWanted = this.#requests.begin();
		const points = Object.fromEntries(CollisionBlocks.systemNames.map((name) => [name, []]));
		this.result = { machine: this.name.value.trim() || words.thisMachine, date: new Date().toISOString(), processors: navigator.hardwareConcurrency ?? 0, browser: navigator.userAgent, points };
		this.#isRunning = true;
		this.startButton.textContent = words.stop;
		this.#show();
		this.status.textContent = words.running;
		this.busy.hidden = true;
		let [all, busy] = [0, 0];
		await measureAll(this.greatLand, this.#most, (system, count, ms, isBusy) => {
			all++;
			if (isBusy) busy++;
			// the browser's clock is coarse: a time below its step is not 0
			points[system].push([count, Math.max(ms, 0.001)]);
			this.#show();
		}, isWanted);
		if (!isWanted()) return;
		this.#stop(words.done);
		this.busy.hidden = busy <= BUSY * all;
	}

	#stop(text) {
		this.#requests.begin();
		this.#isRunning = false;
		this.startButton.textContent = words.start;
		this.status.textContent = text;
		this.#show();
	}

	#show() {
		const listed = (result) => CollisionBlocks.systemNames.map((name) => ({ name: texts.systems[name], points: result?.points[name] ?? [] }));
		this.picture.replaceChildren(chart(words, COUNTS, listed(this.result), this.other && listed(this.other), ...roomIn(this.picture)));
		for (const each of this.keepers) each.disabled = this.#isRunning || this.result === null;
		const at = (result, name, count) => result?.points[name]?.find(([each]) => each === count)?.[1];
		const cell = (name, count) => [this.result, this.other].map((result) => at(result, name, count)).map((ms) => (ms === undefined ? "–" : short(ms)));
		this.table.replaceChildren(table([words.agents, ...CollisionBlocks.systemNames.map((name) => texts.systems[name])],
			COUNTS.map((count) => h("tr", {}, h("th", { scope: "row" }, String(count)), ...CollisionBlocks.systemNames.map((name) => {
				const [mine, its] = cell(name, count);
				return h("td", {}, mine, this.other ? h("small", {}, ` / ${its}`) : null);
			})))));
	}

	get #all() {
		return this.#unkept ?? recallList(KEY).filter(isMeasured);
	}

	#keep() {
		const all = [...this.#all, { ...this.result, machine: this.name.value.trim() || words.thisMachine }].slice(-MOST_KEPT);
		const isKept = rememberValue(KEY, all);
		if (!isKept) this.#unkept = all;
		this.status.textContent = isKept ? words.kept : words.notKept;
		this.#listOthers();
	}

	#listOthers() {
		const title = ({ machine, date }) => words.entry(machine, new Date(date).toLocaleString(texts.code, { dateStyle: "short", timeStyle: "short" }));
		const entries = [...this.#all.entries(), ...(this.#file ? [["file", this.#file]] : [])];
		this.others.replaceChildren(h("option", { value: "" }, words.nothing), ...entries.map(([value, each]) => h("option", { value, selected: each.date === this.other?.date }, title(each))));
	}

	#choose(value) {
		this.other = value === "file" ? this.#file : this.#all[value] ?? null;
		this.#show();
	}

	/** Shows the measurement of another machine beside this one's. While a game runs, its agents get the model in a file. */
	async openFile(file, files) {
		if (MODEL_FILE.test(file.name) && this.series.hidden) return this.live.openFile(file, files);
		try {
			const result = JSON.parse(await file.text());
			if (!isMeasured(result)) throw new Error("something else");
			this.other = this.#file = result;
			this.#listOthers();
			this.#show();
			this.status.textContent = words.opened(result.machine);
		} catch {
			this.status.textContent = words.broken(file.name);
		}
	}

	close() {
		this.#requests.begin();
		this.forgetSize();
		this.live.close();
	}
}

/** The width and the height within an element's padding. */
function roomIn(element) {
	const { paddingLeft, paddingTop } = getComputedStyle(element);
	return [element.clientWidth - 2 * Number.parseFloat(paddingLeft), element.clientHeight - 2 * Number.parseFloat(paddingTop)].map((room) => Math.max(0, room));
}

/** Calls a function when an element gets another size. Returns what ends that. */
function onSize(element, listener) {
	let size = "";
	const observer = new ResizeObserver(() => {
		const now = roomIn(element).join(" ");
		if (now === size) return;
		size = now;
		listener();
	});
	observer.observe(element);
	return () => observer.disconnect();
}
