/** What the browser remembers between visits. It may refuse: then the page remembers what it shows, until it is closed. */

/** A text that is remembered; null if there is none. */
export function recall(key) {
	try {
		return localStorage.getItem(key);
	} catch {
		return null;
	}
}

/** Remembers a text; null forgets it. Returns false if the browser refuses. */
export function remember(key, text) {
	try {
		if (text === null) localStorage.removeItem(key);
		else localStorage.setItem(key, text);
		return true;
	} catch {
		return false;
	}
}

/** The value in a text that is remembered, in JSON's notation; null if there is none, or something else. */
export function recallValue(key) {
	try {
		return JSON.parse(recall(key));
	} catch {
		return null;
	}
}

/** Remembers a value in JSON's notation. Returns false if the browser refuses. */
export const rememberValue = (key, value) => remember(key, JSON.stringify(value));

/** The list in such a text; an empty one if there is none. */
export function recallList(key) {
	const value = recallValue(key);
	return Array.isArray(value) ? value : [];
}
