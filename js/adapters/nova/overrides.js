/** Replaces members of the client's objects, and restores them later. */
export class Overrides {
	#restores = [];

	/** Whether any member is replaced. */
	get any() {
		return this.#restores.length > 0;
	}

	/** Replaces a member by the result of `make`, which is called with the old member. */
	apply(object, name, make) {
		const old = Object.getOwnPropertyDescriptor(object, name);
		Object.defineProperty(object, name, { value: make(object[name]), writable: true, configurable: true, enumerable: old?.enumerable ?? false });
		this.#restores.push(() => {
			if (old) Object.defineProperty(object, name, old);
			else delete object[name];
		});
	}

	/** Restores all members. */
	restore() {
		for (const restore of this.#restores.splice(0).reverse()) restore();
	}
}
