/** Figures in a list, each with its name. */
import { h } from "./dom.js";

export class Figures {
	/**
	 * @param {Record<string, string>} names what the figures are called, by their keys
	 * @param {(key: string) => object} propertiesOf further properties of a figure's element
	 */
	constructor(names, propertiesOf = () => ({})) {
		this.cells = Object.fromEntries(Object.keys(names).map((key) => [key, h("dd", {}, "–")]));
		this.element = h("dl.figures", {}, ...Object.entries(names).map(([key, name]) => h("div", propertiesOf(key), this.cells[key], h("dt", {}, name))));
	}

	/** Shows some figures by their keys, and hides those whose value is null. The others stay. */
	show(values) {
		for (const [key, value] of Object.entries(values)) {
			this.cells[key].textContent = value;
			this.cells[key].parentElement.hidden = value === null;
		}
	}
}
