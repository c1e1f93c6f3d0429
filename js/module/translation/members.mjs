/** The names that members of classes have in the module, which the compiler has mangled. */

const ENGINE_PREFIX = "starlogo_engine__";

/**
 * A private member has its name from the source, unless a base or an extending class has a member of that name too. A game's class may
 * extend a public class and have any name without $, also `_color`. So private members of a public class, and of what it extends, get a $
 * before their name (`$_color`), and so do members of the namespace engine.
 */
export class MemberNames {
	#privateNames = new Map();

	/**
	 * @param units the definitions of the program, by qualified name
	 * @param signatures the public declarations, by qualified name
	 */
	constructor(units, signatures) {
		const basesOf = (unit) => (unit ? [unit, ...basesOf(units.get(unit.base))] : []);
		const owners = ownersOf([...units.values()]);
		const extensible = new Set([...signatures.keys()].flatMap((qname) => basesOf(units.get(qname))));
		for (const [plain, having] of owners) {
			const shared = new Set([...having].flatMap((unit) => basesOf(unit).filter((base) => base !== unit && having.has(base)).flatMap((base) => [unit, base])));
			for (const unit of having) {
				const name = extensible.has(unit) ? `$${plain}` : plain;
				const isTaken = shared.has(unit) || (name !== plain && owners.has(ENGINE_PREFIX + plain));
				this.#privateNames.set(unit.mangled + plain, isTaken ? `${name}$${unit.name}` : name);
			}
		}
	}

	/** The name in the text for a member's name in the compiler's output. */
	nameOf(name) {
		if (name.startsWith(ENGINE_PREFIX)) return `$${name.slice(ENGINE_PREFIX.length)}`;
		return this.#privateNames.get(name) ?? name;
	}
}

/** For each name in the sources, the definitions with such a member. */
function ownersOf(units) {
	const owners = new Map();
	for (const unit of units) {
		for (const name of [...unit.types.keys(), ...unit.members.map((member) => member.name)]) {
			const plain = name.startsWith(unit.mangled) ? name.slice(unit.mangled.length) : name;
			if (!owners.has(plain)) owners.set(plain, new Set());
			owners.get(plain).add(unit);
		}
	}
	return owners;
}
