/** The panel beside the world: figures, meetings of agents, totals. */
import { button, h, short } from "../../shared/dom.js";
import { Figures } from "../../shared/figures.js";
import { fixed, texts } from "../../shared/language.js";
import { FRAMES_A_SECOND } from "../game/world.js";

const words = texts.play;
const LISTED = 12;

const breedName = (breed) => texts.breeds[breed] ?? breed;

/** An agent's name: its breed, and its number in the game. */
export const nameOf = ({ breed, number }) => `${breedName(breed)} ${number}`;

/** What is counted after a time until the figures are shown: milliseconds, frames of the game, pictures, and the largest numbers in a frame. */
const countsFrom = (since) => ({ since, ms: 0, scriptMs: 0, frames: 0, pictures: 0, most: { pairs: 0, tests: 0, collisions: 0 } });

export class Panel {
	#counts = countsFrom(0);
	#shown = "";
	#chosen = "";
	#next = 0;

	/**
	 * @param {import("../game/world.js").World} world
	 * @param {(agent: object) => void} onChoose called with an agent that the user chose
	 */
	constructor(world, onChoose) {
		this.world = world;
		this.onChoose = onChoose;
		this.figures = new Figures(words.panel);
		this.list = h("ol.met", { "aria-label": words.events, tabindex: "0" });
		this.cast = h("ul.cast");
		this.totals = h("ul.totals", { "aria-label": words.totals });
		this.element = h("div.panel", {},
			h("h2.visually-hidden", {}, words.cast), this.cast,
			h("details.numbers", {}, h("summary", {}, words.figures),
				this.figures.element,
				h("div.meetings", {}, h("h2", {}, words.events), this.totals, this.list)));
	}

	/** Counts a frame. */
	count() {
		const { collisionMs, scriptMs, collisions } = this.world;
		const counts = this.#counts;
		counts.ms += collisionMs;
		counts.scriptMs += scriptMs;
		counts.frames++;
		const { candidatePairs: pairs, tests, hierarchyTests, collisions: touching } = collisions.collision.statistics;
		for (const [name, value] of Object.entries({ pairs, tests: tests + hierarchyTests, collisions: touching })) counts.most[name] = Math.max(counts.most[name], value);
	}

	/** Shows the figures; twice a second while the game runs. */
	show(now = 0) {
		this.#counts.pictures++;
		const { since, ms, scriptMs, frames, pictures, most } = this.#counts;
		if (now > 0 && now - since < 500) return;
		const { agents, frame, meetingCount: meetings, touching } = this.world;
		// while the game stands still, the last figures stay
		const counted = frames > 0 || frame === 0 ? { ms: short(ms / frames), scripts: short(scriptMs / frames), ...most } : {};
		const fps = now > 0 ? Math.round((pictures * 1000) / (now - since)) : "–";
		this.figures.show({ ...counted, agents: agents.length, meetings, ...(now === 0 && { collisions: touching }), fps });
		this.restartCount(now);
		this.#list();
		this.#listCast();
	}

	restartCount(now = 0) {
		this.#counts = countsFrom(now);
	}

	/** Lists the agents by breed. Clicking a breed's name chooses its agents one after the other. */
	#listCast() {
		const counts = new Map();
		for (const { breed } of this.world.agents) counts.set(breed, (counts.get(breed) ?? 0) + 1);
		const shown = [...this.cast.children].map(({ dataset }) => dataset.breed);
		if ([...counts.keys()].join("\n") !== shown.join("\n")) {
			this.cast.replaceChildren(...[...counts.keys()].map((breed) => h("li", { "data-breed": breed }, button("", () => this.#choose(breed), { title: words.castNote }))));
		}
		for (const { dataset, firstChild } of this.cast.children) firstChild.textContent = `${breedName(dataset.breed)} ${counts.get(dataset.breed)}`;
	}

	#choose(breed) {
		const all = this.world.agents.filter((agent) => agent.breed === breed);
		this.#next = this.#chosen === breed ? this.#next + 1 : 0;
		this.#chosen = breed;
		this.onChoose(all[this.#next % all.length]);
	}

	#list() {
		const { meetings, totals, meetingCount, frame: now } = this.world;
		const shown = `${meetingCount} ${now < (meetings[0]?.frame ?? 0)} ${meetings[0]?.frame}`;
		if (shown === this.#shown) return;
		this.#shown = shown;
		this.list.replaceChildren(...(meetings.length === 0 ? [h("li", {}, words.noEvents)] : meetings.slice(0, LISTED).map(({ frame, a, b, names }) => h("li", {},
			h("time", {}, words.after(fixed(frame / FRAMES_A_SECOND, 1))), ` ${words.met(nameOf({ breed: names[0], number: a.number }), nameOf({ breed: names[1], number: b.number }))}`))));
		this.totals.replaceChildren(...[...totals].sort(([, a], [, b]) => b - a).slice(0, 8).map(([names, count]) => h("li", {}, `${names.split("\n").map(breedName).join(" × ")} `, h("b", {}, String(count)))));
	}
}
