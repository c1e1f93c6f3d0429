/** Reads options like name=value: an object of their values by names. Throws an Error if one has no name, or no sign. */
export function pairs(list) {
	return Object.fromEntries(list.map((entry) => {
		const [, name, value] = /^([^=]+)=([^]*)$/.exec(entry) ?? [];
		if (!name) {
			throw new Error(`expected name=value, not ${entry}`);
		}
		return [name, value];
	}));
}
