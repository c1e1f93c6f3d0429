/** The collision engine for the StarLogo Nova client. */
import { addButton, toolbarOf } from "./button.js";
import { addBlocks, drawerOf } from "./drawer.js";
import { installInto, installedIn } from "./installation.js";

export { addBlocks, addButton, installInto };

const added = new WeakMap();

/** For a bookmarklet: the first call installs the engine, its button and its blocks. The next call removes them all. */
export function toggle(window, options = {}) {
	if (added.has(window)) {
		for (const part of added.get(window)) part.remove();
		added.delete(window);
		installedIn(window)?.uninstall();
	} else {
		toolbarOf(window);
		if (installedIn(window) === null) installInto(window, options);
		added.set(window, [addButton(window, options), ...(drawerOf(window) ? [addBlocks(window)] : [])]);
	}
}
