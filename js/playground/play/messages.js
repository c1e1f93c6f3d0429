/** Blockly's own words in the language of the page, loaded before Blockly is. */
import { texts } from "../shared/language.js";

const LANGUAGES = { en: () => import("blockly/msg/en"), de: () => import("blockly/msg/de") };

/** What loadMessages has loaded. */
export let messages = {};

export async function loadMessages() {
	messages = { ...(await LANGUAGES[texts.code]()).default, ...texts.blockly };
}
