/** What developer tools, Node and JSON.stringify show of public classes. */

/** The state of an object, for tools: its public fields and settable properties that are no objects. Internal names begin with _ or $. */
export function $stateOf(object) {
	const state = {};
	const note = (name, value) => {
		if (!/^[_$]/.test(name) && typeof value !== "function") state[name] = value;
	};
	const chain = [];
	let type = object;
	while ((type = Object.getPrototypeOf(type)) && type !== Object.prototype) chain.unshift(type);
	for (const [name, { get, set }] of chain.flatMap((each) => Object.entries(Object.getOwnPropertyDescriptors(each)))) {
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

/** The objects that are being shown: one that names another names itself by way of that one. */
const showing = new Set();

/** Makes JSON.stringify and Node's console.log show a class's objects as $stateOf describes them. */
export function $shown(type) {
	Object.defineProperties(type.prototype, {
		[Symbol.toStringTag]: { configurable: true, get() { return this.constructor.name; } },
		toJSON: { configurable: true, writable: true, value() { return $stateOf(this); } },
		[Symbol.for("nodejs.util.inspect.custom")]: { configurable: true, writable: true, value: inspected },
	});
	return type;
}

function inspected(depth, options, inspect) {
	const { name } = this.constructor;
	if (depth < 0 || !inspect || showing.has(this)) return `[${name}]`;
	showing.add(this);
	try {
		return `${name} ${inspect($stateOf(this), { ...options, depth })}`;
	} finally {
		showing.delete(this);
	}
}
