/** Blockly's own words in the page's language. They are loaded before Blockly. */
import { loadWords, texts } from "../../shared/language.js";

const LANGUAGES = { en: () => import("blockly/msg/en"), de: () => import("blockly/msg/de") };

/** The words, after loadMessages. */
export let messages = {};

export async function loadMessages() {
	await loadWords("game");
	messages = { ...(await LANGUAGES[texts.code]()).default, ...texts.blockly };
}
