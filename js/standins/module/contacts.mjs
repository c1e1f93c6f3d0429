/** The third argument of handlers in JavaScript. There a function need not declare how many arguments it takes. */

const PARTS = ["time", "point", "normal", "depth"];

/**
 * Whether a handler that declares fewer than three arguments may still read a third: by `(...all)`, a default value or `arguments`, or
 * because it is bound or a mock, whose code is not known.
 */
export function mayTakeMore(handler) {
	const text = Function.prototype.toString.call(handler);
	const start = text.indexOf("(");
	let end = start;
	for (let depth = 0; end < text.length; end++) {
		if (text[end] === "(") depth++;
		else if (text[end] === ")" && --depth === 0) break;
	}
	return /\.\.\.|=/.test(text.slice(start, end)) || /\barguments\b|\[native code\]/.test(text);
}

/** A Contact that is computed when it is first read, because most of these handlers do not read it. */
class ContactWhenAsked {
	#contact = new Contact();
	#ask = null;

	constructor() {
		for (const name of PARTS) {
			let value = this.#contact[name];
			const get = () => {
				this.#find();
				return value;
			};
			Object.defineProperty(this.#contact, name, { enumerable: true, configurable: true, get, set: (given) => (value = given) });
		}
	}

	/** Sets the pair. After the frame, the contact keeps the values that it had when it was read. */
	of(contacts, pair, first, second, isBack) {
		this.#ask = { contacts, pair, first, second, isBack };
		return this.#contact;
	}

	#find() {
		const ask = this.#ask;
		this.#ask = null;
		if (ask === null || ask.contacts.system === null) return;
		const known = ask.contacts.contactOf(ask.pair, ask.first, ask.second, ask.isBack);
		this.#contact.time = known.time;
		this.#contact.depth = known.depth;
		this.#contact.point.copyFrom(known.point);
		this.#contact.normal.copyFrom(known.normal);
	}
}

const whenAsked = new WeakMap();

/** A Contact that is computed when it is first read, by FrameContacts.contactOf. */
export function contactWhenAsked(contacts, ...pair) {
	if (!whenAsked.has(contacts)) whenAsked.set(contacts, new ContactWhenAsked());
	return whenAsked.get(contacts).of(contacts, ...pair);
}
