import { INSTALLATION_KEY } from "./installation.js";
import { STRUCTURES } from "./traits.js";

const YES_OR_NO = { options: ["true", "false"], codeOf: (value) => `String(${value}) === "true"` };

/** The blocks by name: their text, their choices, the trait that they set, and the JavaScript that makes the trait's value. */
const BLOCKS = {
	"starlogo-collision-hierarchical": { label: "hierarchical @value", trait: "hierarchical", ...YES_OR_NO },
	"starlogo-collision-depth": {
		label: "collision depth @value", trait: "depth", codeOf: (value) => `Math.min(99, Math.max(0, Math.round(${value}) || 0))`,
	},
	"starlogo-collision-sweeps": { label: "sweeping @value", trait: "sweeps", ...YES_OR_NO },
	"starlogo-collision-structure": { label: "collide as @value", trait: "structure", options: STRUCTURES, codeOf: (value) => value },
};

/**
 * Adds blocks for traits that the client has no blocks for (thesis §7.1 to 7.3). They go into the drawer that has the client's collision
 * block. Compiled programs look for the installed engine when they run. Without it the blocks do nothing.
 */
export function addBlocks(window) {
	const { sb, Compilation, DataStructures } = window;
	const drawer = drawerOf(window);
	if (!drawer) throw new TypeError("the window has no editor of blocks, or it has none for collisions");
	const present = new Set(drawer.getChildBlocks().map((block) => block.getName()));
	const added = [];
	for (const [name, { label, trait, options, codeOf }] of Object.entries(BLOCKS)) {
		Compilation.BlockTable.table.set(name, nodeClassOf(DataStructures.ASTNode, trait, codeOf));
		if (present.has(name)) continue;
		const spec = {
			name,
			label,
			color: drawer.getColor(),
			connections: ["after", "before"],
			shape: "",
			arguments: [{
				name: "value",
				dataType: options ? "none" : "string",
				socketType: options ? "list" : "internal",
				options: (options ?? []).map((value) => ({ label: value, value })),
			}],
			returnType: "command",
		};
		sb.ScriptBlocksJSON.genusMap[name] = spec;
		const block = new sb.Block(spec);
		drawer.addBlock(block);
		added.push(block);
	}
	return {
		/** Removes them from the drawer. Blocks in programs stay. */
		remove() {
			for (const block of added.splice(0)) drawer.removeBlock(block);
		},
	};
}

/** The drawer of a window's editor that has the client's collision block; undefined if there is none. */
export function drawerOf({ sb, Compilation }) {
	const drawers = Compilation?.BlockTable?.table ? sb?.WebLogoDemo?.workspace?.getDrawers() : [];
	return drawers?.find((one) => one.getChildBlocks().some((block) => block.getName() === "collision"));
}

/** The class that the client compiles a block to: a statement that sets a trait of the program's agent. */
function nodeClassOf(ASTNode, trait, codeOf) {
	const call = (value) => `Execution.Collisions[Symbol.for("${INSTALLATION_KEY}")]?.changeTraits(__wl_agt, { ${trait}: ${codeOf(value)} });`;
	return class extends ASTNode {
		constructor() {
			super(1, 0);
		}

		to_js_no_yield() {
			return call(this.args.data[0].to_js_no_yield());
		}

		to_js_setup() {
			return `${this.args.data[0].to_js_setup()};`;
		}

		to_js_final() {
			return call(this.args.data[0].to_js_final());
		}
	};
}
