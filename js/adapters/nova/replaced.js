/** Replaces members of the client's objects, and restores them later. */
export class Replaced {
	#given = [];

	/** Whether any member is replaced. */
	get any() {
		return this.#given.length > 0;
	}

	/** Replaces a member by the result of `make`, which is called with the old member. */
	put(object, name, make) {
		const given = Object.getOwnPropertyDescriptor(object, name);
		Object.defineProperty(object, name, { value: make(object[name]), writable: true, configurable: true, enumerable: given?.enumerable ?? false });
		this.#given.push(() => {
			if (given) Object.defineProperty(object, name, given);
			else delete object[name];
		});
	}

	/** Restores all members. */
	giveBack() {
		for (const give of this.#given.splice(0).reverse()) give();
	}
}
