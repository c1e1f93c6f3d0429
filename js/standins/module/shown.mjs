/** What developer tools, Node and JSON.stringify show of public classes. */

/** The state of an object, for tools: its public fields and settable properties that are no objects. Internal names begin with _ or $. */
export function $stateOf(object) {
	const state = {};
	const note = (name, value) => {
		if (!/^[_$]/.test(name) && typeof value !== "function") state[name] = value;
	};
	for (const [name, { get, set }] of $inheritedBy(object)) {
		try {
			const value = get?.call(object);
			if (get && (set || typeof value !== "object" || value === null)) note(name, value);
		} catch {
			// it can't be read now
		}
	}
	for (const name of Object.keys(object)) note(name, object[name]);
	return state;
}

/** The names and descriptors of what an object's classes have, those of the farthest base first. */
export function $inheritedBy(object) {
	const type = Object.getPrototypeOf(object);
	return type && type !== Object.prototype ? [...$inheritedBy(type), ...Object.entries(Object.getOwnPropertyDescriptors(type))] : [];
}

/** What is shown of each object: always the same, so that tools see that an object names itself. */
const shown = new WeakMap();

/** Makes JSON.stringify and Node's console.log show a class's objects as $stateOf describes them. */
export function $shown(type) {
	Object.defineProperties(type.prototype, {
		[Symbol.toStringTag]: { configurable: true, get() { return this.constructor.name; } },
		toJSON: { configurable: true, writable: true, value(key) { return key === undefined ? $stateOf(this) : shownOf(this); } },
		[Symbol.for("nodejs.util.inspect.custom")]: { configurable: true, writable: true, value() { return shownOf(this); } },
	});
	return type;
}

/** The state of an object, in one of a class of the same name. */
function shownOf(object) {
	let state = shown.get(object);
	if (state === undefined) {
		const { name } = object.constructor;
		state = new ({ [name]: class {} }[name])(); // which gives the class its name
		shown.set(object, state);
	}
	for (const key of Object.keys(state)) delete state[key];
	return Object.assign(state, $stateOf(object));
}
