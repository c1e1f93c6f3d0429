#!/usr/bin/env node
/**
 * Writes the engine and its FlexUnit tests as one module, which run.mjs runs.
 *
 * node test/runner/bundle.mjs TRANSPILED OUT
 */
import { writeFileSync } from "node:fs";
import { standinsText, translate } from "../../js/module/assemble.mjs";
import { publicSignatures } from "../../js/module/names.mjs";

const [transpiled, out] = process.argv.slice(2);
const flexunit = new URL("flexunit.mjs", import.meta.url).href;
const ASSERTS = ["Equals", "StrictlyEquals", "True", "False", "Null", "NotNull"];
const externals = {
	"flash.external.ExternalInterface": "ExternalInterface",
	"flash.utils.Dictionary": "Dictionary",
	"flash.utils.getQualifiedClassName": "getQualifiedClassName",
	"org.flexunit.async.Async": "Async",
	"org.flexunit.asserts.fail": "fail",
	"org.flexunit.internals.AssumptionViolatedException": "AssumptionViolatedException",
	...Object.fromEntries(ASSERTS.map((name) => [`org.flexunit.asserts.assert${name}`, `assert${name}`])),
	"standin.Network.fetch": "fetchFixture",
};

const program = translate(transpiled, publicSignatures(), { externals, isForTests: true });
const text = program.text();
const classes = program.names.filter((qname) => program.testsOf(qname).length > 0)
	.map((qname) => `{ name: "${qname}", type: ${program.shortName(qname)}, metadata: ${JSON.stringify(program.testsOf(qname))} }`);
writeFileSync(out, `import * as flexunit from "${flexunit}";
const { ${[...new Set(Object.values(externals))].filter((name) => name !== "fetchFixture").join(", ")}, missing: $missing } = flexunit;
${standinsText()}
flexunit.extendByteArray(ByteArray);
let fetchFixture = null;

/** Sets what stands in for fetch: a function like fetchFile of machine.mjs, but with plain bytes. */
export function setFetch(fetchFile) {
    fetchFixture = (url, onProgress, onDone, onError) => fetchFile(url, onProgress, (bytes) => onDone(new ByteArray(bytes)), onError);
}

${text}
export const CLASSES = [
	${classes.join(",\n\t")}
];
export { ByteArray, flexunit, ${program.names.map((qname) => program.shortName(qname)).join(", ")} };
`);
