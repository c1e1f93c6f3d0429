#!/usr/bin/env node
/**
 * Whether Flash accepts the compiled engine: each function says how many values it keeps on its stack, and Flash refuses one that keeps more
 * (VerifyError #1023) when it is first called. The compiler's optimiser, which works where an SWF is compiled without -debug, replaces a local
 * that is written and then read twice by two copies on the stack, and may forget that this is one more. Ruffle does not mind. Reads such an SWF
 * as the SDK's swfdump prints it, lists what Flash would refuse, and exits with 1 if there is any.
 *
 *   swfdump -abc release.swf > file; node test/structure/stacks.mjs file
 */
import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';

const FEWEST_FUNCTIONS = 2000;

/** How many values an instruction takes from the stack and leaves there. OP_0x53 applies Vector to one type; bkpt is the number of types. */
const EFFECTS = [
	[0, 0, 'bkpt debug debugfile debugline declocal declocal_i inclocal inclocal_i jump kill label nop popscope returnvoid'],
	[0, 1, 'findproperty findpropstrict getglobalscope getlex getlocal getlocal0 getlocal1 getlocal2 getlocal3 getscopeobject hasnext2 newactivation '
		+ 'newcatch newfunction pushbyte pushdouble pushfalse pushint pushnan pushnull pushshort pushstring pushtrue pushuint pushundefined'],
	[1, 0, 'iffalse iftrue lookupswitch pop pushscope pushwith returnvalue setlocal setlocal0 setlocal1 setlocal2 setlocal3 throw'],
	[1, 1, 'astype bitnot checkfilter coerce coerce_a coerce_s convert_b convert_d convert_i convert_o convert_s convert_u decrement decrement_i '
		+ 'deleteproperty esc_xattr esc_xelem getproperty getslot getsuper increment increment_i istype negate negate_i newclass not typeof'],
	[1, 2, 'dup'],
	[2, 0, 'ifeq ifge ifgt ifle iflt ifne ifnge ifngt ifnle ifnlt ifstricteq ifstrictne initproperty setproperty setslot setsuper'],
	[2, 1, 'OP_0x53 add add_i astypelate bitand bitor bitxor divide equals greaterequals greaterthan hasnext in instanceof istypelate lessequals '
		+ 'lessthan lshift modulo multiply multiply_i nextname nextvalue rshift strictequals subtract subtract_i urshift'],
	[2, 2, 'swap'],
];

/** The same of instructions with a number of arguments: beside the arguments, and how many values an argument is. */
const CALLS = [
	[0, 1, 1, 'newarray'], [0, 1, 2, 'newobject'], [1, 0, 1, 'callpropvoid callsupervoid constructsuper'],
	[1, 1, 1, 'callproperty callproplex callstatic callsuper construct constructprop'], [2, 1, 1, 'call'],
];

const NAMES_ITS_PROPERTY = /property|super|descendants|constructprop/;
const ENDS = /^(?:jump|lookupswitch|returnvalue|returnvoid|throw)$/;
const effects = new Map(EFFECTS.flatMap(([takes, leaves, names]) => names.split(' ').map((name) => [name, { takes, leaves, each: 0 }])));
for (const [takes, leaves, each, names] of CALLS) {
	names.split(' ').forEach((name) => effects.set(name, { takes, leaves, each }));
}

/** How much an instruction changes the number of values. @throws {Error} if it is not in the lists */
function changeOf(name, operands) {
	const effect = effects.get(name);
	if (!effect) {
		throw new Error(`test/structure/stacks.mjs does not know the instruction ${name}`);
	}
	// a name that is known when it runs, as the index in list[i], is on the stack too
	const isNameOnStack = NAMES_ITS_PROPERTY.test(name) && /:null(?: \(\d+\))?$/.test(operands);
	const count = effect.each > 0 ? Number(/(\d+)\W?$/.exec(operands)[1]) : 0;
	return effect.leaves - effect.takes - effect.each * count - (isNameOnStack ? 1 : 0);
}

/**
 * How many values a function keeps at most. At a label there are as many as at the jumps there, which may stand below it. Where an error is caught
 * it is the only one. What no jump leads to begins without values.
 */
function deepestOf(instructions) {
	const atLabels = new Map(instructions.map(({ label }, at) => [label, at]));
	const catches = [...instructions.keys()].filter((at) => instructions[at].name === 'newcatch').map((at) => [at, 1]);
	// the last one is next
	const open = [...[...instructions.keys()].reverse().map((at) => [at, 0]), ...catches];
	const done = new Set();
	let deepest = 0;
	while (open.length > 0) {
		let [at, depth] = open.pop();
		for (let isEnd = false; !isEnd && at < instructions.length && !done.has(at); at++) {
			const { name, operands } = instructions[at];
			done.add(at);
			depth += changeOf(name, operands);
			deepest = Math.max(deepest, depth);
			const targets = /^(?:if|jump|lookupswitch)/.test(name) ? operands.match(/L\d+/g) ?? [] : [];
			open.push(...targets.map((target) => [atLabels.get(target), depth]));
			isEnd = ENDS.test(name);
		}
	}
	return deepest;
}

/**
 * The functions in what swfdump prints, and those that keep more values than they say, in words.
 *
 * @param {string} dump what swfdump -abc prints
 * @returns {{count: number, faults: string[]}}
 */
export function stacksIn(dump) {
	const faults = [];
	let [count, header, said, instructions] = [0, '', 0, []];
	for (const line of dump.split('\n')) {
		header = /^ {4}function (.*)$/.exec(line)?.[1] ?? header;
		const [, most] = /^ {4}maxStack:(\d+)/.exec(line) ?? [];
		if (most) {
			[said, instructions] = [Number(most), []];
		} else if (header && /^ {4}\d+ Extras/.test(line)) {
			const deepest = deepestOf(instructions);
			count++;
			if (deepest > said) {
				faults.push(`${header} keeps ${deepest} values on its stack, and says ${said}: Flash refuses it. `
					+ 'Write it in another order, so that no local is read twice just after it is written');
			}
			header = '';
		} else if (header) {
			// the end of a text with a line end stands before the next instruction
			const [, label, name, operands] = /^(?:\S*")?\s+(?:(L\d+):\s*)?(\w+)\s*(.*?)\s*$/s.exec(line) ?? [];
			if (name) {
				instructions.push({ label, name, operands });
			}
		}
	}
	return { count, faults };
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
	const { count, faults } = stacksIn(readFileSync(process.argv[2], 'utf8'));
	if (count < FEWEST_FUNCTIONS) {
		faults.push(`only ${count} functions: is ${process.argv[2]} a dump of the engine?`);
	}
	console.log(faults.join('\n') || `stacks: Flash accepts all ${count} functions`);
	process.exitCode = faults.length > 0 ? 1 : 0;
}
