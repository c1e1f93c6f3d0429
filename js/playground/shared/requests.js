/** Requests whose answers come later: only the newest one's counts. */
export class Requests {
	#count = 0;

	/** Begins a request, which ends all earlier ones. Returns a function that tells whether it is still the newest. */
	begin() {
		const number = ++this.#count;
		return () => number === this.#count;
	}
}
