import { installInto, installedIn } from "./installation.js";
import { viewClassOf } from "./overlay.js";

/** The choices of the menu. null gives the client its own collisions back. */
const CHOICES = [
	["The client's own", null],
	["Bins", { system: "bins", exact: false }],
	["Tightest fits", { system: "tightest", exact: false }],
	["Hierarchies", { system: "hierarchical", exact: false }],
	["Triangles", { system: "hierarchical", exact: true }],
	["Combination", { system: "combination", exact: false }],
];

/** Adds a button to the toolbar of the client in a window. Its menu chooses the collision system, and whether the overlay is shown. */
export function addButton(window, options = {}) {
	return new Button(window, toolbarOf(window), options);
}

/** The toolbar of the client in a window. Throws if there is none. */
export function toolbarOf(window) {
	const bar = window.document?.querySelector("#toolbar ul.nav");
	if (!bar || !window.Execution?.Collisions) throw new TypeError("the window has no StarLogo Nova client with a toolbar");
	return bar;
}

class Button {
	#window;
	#options;
	#item;
	#link;
	#closes = new AbortController();
	// the ticked menu items, and what decides each tick
	#ticks = [];

	constructor(window, bar, options) {
		this.#window = window;
		this.#options = options;
		this.#link = this.#make("a", { href: "#", role: "button", "aria-haspopup": "true" }, "Collisions ", this.#make("b", { class: "caret" }));
		const menu = this.#make("ul", { class: "dropdown-menu", role: "menu" });
		for (const [text, choice] of CHOICES) menu.append(this.#entry("menuitemradio", text, () => this.#isChosen(choice), () => this.#choose(choice)));
		menu.append(
			this.#make("li", { class: "divider" }),
			this.#entry("menuitemcheckbox", "Wireframe", () => Boolean(installedIn(window)?.options.overlay), () => this.#toggleOverlay()),
		);
		this.#item = this.#make("li", { class: "dropdown", id: "starlogoCollisionLi" }, this.#link, menu);
		bar.insertBefore(this.#item, window.document.getElementById("statusBarLi"));
		this.#link.addEventListener("click", (event) => {
			event.preventDefault();
			this.#open(!this.#item.classList.contains("open"));
		});
		const { signal } = this.#closes;
		window.document.addEventListener("click", (event) => this.#item.contains(event.target) || this.#open(false), { signal });
		window.document.addEventListener("keydown", (event) => event.key === "Escape" && this.#open(false), { signal });
		this.#open(false);
	}

	/** Removes the button. The installed engine stays. */
	remove() {
		this.#closes.abort();
		this.#item.remove();
	}

	#open(isOpen) {
		this.#item.classList.toggle("open", isOpen);
		this.#link.setAttribute("aria-expanded", isOpen);
		for (const [link, tick, isTicked] of this.#ticks) {
			link.setAttribute("aria-checked", isTicked());
			tick.style.visibility = isTicked() ? "visible" : "hidden";
		}
	}

	#isChosen(choice) {
		const options = installedIn(this.#window)?.options ?? null;
		return choice === null ? options === null : options?.system === choice.system && options.exact === choice.exact;
	}

	#choose(choice) {
		const installation = installedIn(this.#window);
		if (installation !== null) this.#options = installation.options;
		if (choice === null) installation?.uninstall();
		else if (installation !== null) installation.exchange(choice);
		else installInto(this.#window, { ...this.#options, ...choice });
	}

	#toggleOverlay() {
		viewClassOf(this.#window); // throws if there is none
		const installation = installedIn(this.#window) ?? installInto(this.#window, { ...this.#options, overlay: false });
		installation.showOverlay(!installation.options.overlay);
	}

	#entry(role, text, isTicked, act) {
		const tick = this.#make("span", { "aria-hidden": "true" }, "\u2713 ");
		const link = this.#make("a", { href: "#", role }, tick, text);
		link.addEventListener("click", (event) => {
			event.preventDefault();
			act();
			this.#open(false);
		});
		this.#ticks.push([link, tick, isTicked]);
		return this.#make("li", {}, link);
	}

	#make(name, attributes, ...children) {
		const element = this.#window.document.createElement(name);
		for (const [attribute, value] of Object.entries(attributes)) element.setAttribute(attribute, value);
		element.append(...children);
		return element;
	}
}
