/** The collision engine for the StarLogo Nova client. */
export { installInto } from "./installation.js";
export { addButton } from "./button.js";
export { addBlocks } from "./drawer.js";
