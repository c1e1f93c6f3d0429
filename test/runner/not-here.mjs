import { AWAY3D } from "../../js/module/names.mjs";

const ON_THE_STAGE = "the monitor draws on Flash's stage";
const FLEXUNIT = "it tests how FlexUnit's runner is filtered";
const COLLECTED = "V8 collects garbage while a test runs, and boxes numbers until it has optimised a function";
const E4X = "it reads describeType's XML";
const HINTS = "in JavaScript an error tells the nearest name: input.test.mjs";
const REFUSED = "in JavaScript null is refused where the engine is called: input.test.mjs";
const ANY_NUMBER = "in JavaScript a function takes any number of arguments";

/** The test classes, and tests, that can't run on the ES module, and why. Those that need a player are left out too. */
export const NOT_HERE = new Map([
	["starlogo.diagnostics.CollisionMonitorTest", ON_THE_STAGE],
	["starlogo.collision.AllocationTest", COLLECTED],
	["starlogo.queries.QueriesAllocationTest", COLLECTED],
	["starlogo.collision.CollisionStatisticsTest.copiesAndResetsEveryNumber", E4X],
	["starlogo.collision.CollisionHandlersTest.handlersThatFlashCouldNotCallAreRefused", ANY_NUMBER],
	["starlogo.collision.CollisionHandlersTest.aFilterWithoutParametersIsTold", ANY_NUMBER],
	["starlogo.data.HintOfNameTest", HINTS],
	["starlogo.NullInputTest", REFUSED],
	["support.TestFilterTest", FLEXUNIT],
]);

/** Whether a test class, by its text, compares the stand-ins with Flash's own classes, or needs Away3D. Node cannot run it. */
export const needsPlayer = (text) => ["standin.flash.", AWAY3D].some((name) => text.includes(name));
