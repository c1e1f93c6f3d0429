/** What developer tools, Node and JSON.stringify show of public classes. */

/** The state of an object, for tools: its public fields and settable properties that are no objects. Internal names begin with _ or $. */
export function $stateOf(object) {
	const state = {};
	const note = (name, value) => {
		if (!/^[_$]/.test(name) && typeof value !== "function") state[name] = value;
	};
	const chain = [];
	for (let each = Object.getPrototypeOf(object); each !== null && each !== Object.prototype; each = Object.getPrototypeOf(each)) chain.unshift(each);
	for (const [name, { get, set }] of chain.flatMap((each) => Object.entries(Object.getOwnPropertyDescriptors(each)))) {
		if (!get || name === "__proto__") continue;
		try {
			const value = get.call(object);
			if (set || typeof value !== "object" || value === null) note(name, value);
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
	const inspect = function(depth, options, inspectAny) {
		const name = this.constructor.name;
		if (depth < 0 || typeof inspectAny !== "function") return `[${name}]`;
		if (showing.has(this)) return `[Circular ${name}]`;
		showing.add(this);
		try {
			return `${name} ${inspectAny($stateOf(this), { ...options, depth })}`;
		} finally {
			showing.delete(this);
		}
	};
	Object.defineProperties(type.prototype, {
		[Symbol.toStringTag]: { configurable: true, get() { return this.constructor.name; } },
		toJSON: { configurable: true, writable: true, value: function toJSON() { return $stateOf(this); } },
		[Symbol.for("nodejs.util.inspect.custom")]: { configurable: true, writable: true, value: inspect },
	});
	return type;
}
