/**
 * Sets Blockly's language to the page's. Its keyboard plugin reads the words when it is loaded, so import this module before the plugin.
 */
import { FieldNumber, Msg, Toast, fieldRegistry, setLocale } from "blockly/core";
import { plain, texts } from "../../shared/language.js";
import { messages } from "./messages.js";

setLocale(messages);

/** The plugin has these hints only in English. */
const { show } = Toast;
Toast.show = (workspace, options) => {
	const hint = texts.blocklyHints[options.id];
	const modifier = Msg[/^Mac/.test(navigator.platform) ? "COMMAND_KEY" : "CONTROL_KEY"];
	show.call(Toast, workspace, hint ? { ...options, message: hint.replace("%1", modifier) } : options);
};

/** Numbers with the language's decimal sign. A point is accepted too. */
class LocalNumber extends FieldNumber {
	doClassValidation_(value) {
		return super.doClassValidation_(typeof value === "string" ? value.replace(texts.numbers.decimal, ".") : value);
	}

	getText_() {
		return super.getText_() ?? plain(this.value_, MOST_DIGITS);
	}

	getEditorText_(value) {
		return plain(value, MOST_DIGITS);
	}
}

const MOST_DIGITS = 10;

fieldRegistry.unregister("field_number");
fieldRegistry.register("field_number", LocalNumber);
