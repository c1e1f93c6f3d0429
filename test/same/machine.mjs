/** The soak for machines that are no Node: bundled into one file without imports. Says what happens by saySame(text), and ends with "hash ..." or "FAILED ...". */
import "./shims.mjs";
import { Event, SoakRun } from "tests";

const CHECK_EVERY = 100;

const run = new SoakRun(globalThis.sameFrames, CHECK_EVERY);
run.addEventListener(Event.COMPLETE, () => {
	globalThis.saySame(`hash ${run.hash}\n${run.problem === "" ? "" : `FAILED: ${run.problem}`}`);
});
run.start();
