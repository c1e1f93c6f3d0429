/** What was put in the place of members of the client's objects, to be given back. */
export class Replaced {
	#given = [];

	/** Whether anything is. */
	get any() {
		return this.#given.length > 0;
	}

	/** Puts what `make` makes of a member in its place. */
	put(object, name, make) {
		const given = Object.getOwnPropertyDescriptor(object, name);
		Object.defineProperty(object, name, { value: make(object[name]), writable: true, configurable: true, enumerable: given?.enumerable ?? false });
		this.#given.push(() => {
			if (given) Object.defineProperty(object, name, given);
			else delete object[name];
		});
	}

	/** Gives all back. */
	giveBack() {
		for (const give of this.#given.splice(0).reverse()) give();
	}
}
