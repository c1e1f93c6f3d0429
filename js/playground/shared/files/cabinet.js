/** Keeps objects in the browser's database between visits. */

/** The result of a request. */
const answer = (request) => new Promise((resolve, reject) => {
	request.onsuccess = () => resolve(request.result);
	request.onerror = () => reject(request.error);
});

export class Cabinet {
	/**
	 * @param {string} database its name in the browser
	 * @param {string} store the name of what is kept in it
	 * @param {string} keyPath the property of an object that no other one has
	 */
	constructor(database, store, keyPath) {
		Object.assign(this, { database, store, keyPath });
	}

	/** Does something with what is kept, and waits until the change is stored. Throws if the browser refuses. */
	async within(action) {
		const opening = indexedDB.open(this.database, 1);
		opening.onupgradeneeded = () => opening.result.createObjectStore(this.store, { keyPath: this.keyPath });
		const database = await answer(opening);
		try {
			const transaction = database.transaction(this.store, "readwrite");
			const ended = new Promise((resolve, reject) => {
				transaction.oncomplete = resolve;
				transaction.onabort = () => reject(transaction.error);
			});
			const [result] = await Promise.all([answer(action(transaction.objectStore(this.store))), ended]);
			return result;
		} finally {
			database.close();
		}
	}

	/** All that is kept; nothing if the browser refuses. */
	all() {
		return this.within((store) => store.getAll()).catch(() => []);
	}
}
