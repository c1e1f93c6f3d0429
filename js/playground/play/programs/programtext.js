/** Programs as texts: in addresses, for comparison, as names of files. */
import { texts } from "../../shared/language.js";
import { isProgram, packed, unpacked } from "../../shared/files/packing.js";

/** A program as text for an address. */
export const toLink = packed;

/** The program in such a text. Throws if there is none. */
export async function fromLink(text) {
	const program = await unpacked(text);
	if (!isProgram(program)) throw new Error("no program");
	return program;
}

/**
 * The parts of a program that change its game. Left out are the places of blocks, which ones are folded, and the collision system, which
 * can change during the game.
 */
export const meaning = (program) => JSON.stringify(program, function meant(key, value) {
	return key === "system" || key === "languageVersion" || ("type" in this && ["id", "x", "y", "collapsed"].includes(key)) ? undefined : value;
});

/** A title with a number behind it, if it is used already. */
export function freeName(title, isUsed) {
	let name = title;
	for (let number = 2; isUsed(name); number++) name = texts.play.another(title, number);
	return name;
}

/** A name that is allowed for a file on every system. */
export const fileName = (title) => title.replaceAll(/[\\/:*?"<>|\p{Cc}]+/gu, " ").replaceAll(/\s+/g, " ").trim() || "program";
