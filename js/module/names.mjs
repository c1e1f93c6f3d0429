/** Which names of ActionScript the module has from elsewhere, and which it gives its users. */
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { readSignatures } from "./signatures.mjs";

/** The project's folder. */
export const ROOT = fileURLToPath(new URL("../..", import.meta.url));

/** Where the module's sources are; what an earlier folder has stands for others of its name. */
export const SOURCES = ["js/standins/module", "js/standins/common", "src"].map((folder) => join(ROOT, folder));

/** What the translated classes call beside themselves, and the stand-in's file that has it. */
export const EXTERNALS = {
	ArgumentError: ["language.mjs", "ArgumentError"],
	"flash.errors.EOFError": ["ByteArray.mjs", "EOFError"],
	"flash.utils.ByteArray": ["ByteArray.mjs", "ByteArray"],
	"starlogo.collision.contactWhenAsked": ["contacts.mjs", "contactWhenAsked"],
	"starlogo.search.textOf": ["language.mjs", "$named"],
	"starlogo.handlers.mayTakeMore": ["contacts.mjs", "mayTakeMore"],
	"standin.LocalStore.read": ["machine.mjs", "readLocal"],
	"standin.LocalStore.remove": ["machine.mjs", "removeLocal"],
	"standin.LocalStore.write": ["machine.mjs", "writeLocal"],
	"standin.Machine.className": ["machine.mjs", "classNameOf"],
	"standin.Machine.clearTimeout": ["machine.mjs", "clearTimeout"],
	"standin.Machine.frameListeners": ["machine.mjs", "frameListeners"],
	"standin.Machine.now": ["machine.mjs", "now"],
	"standin.Machine.setTimeout": ["machine.mjs", "setTimeout"],
	"standin.Machine.unheard": ["machine.mjs", "unheard"],
	"standin.Machine.uncaught": ["machine.mjs", "uncaught"],
	"standin.Network.fetch": ["machine.mjs", "fetchBytes"],
};

/** The package that only a client with Away3D has. */
export const AWAY3D = "starlogo.away3d";

/** Public classes of the engine that the module lacks, and why. */
export const LEFT_OUT = new Map([["starlogo.diagnostics.CollisionMonitor", "it draws on Flash's stage"]]);

/** The classes of Flash that the engine's own names speak of: the module's users get them too. */
export const FROM_FLASH = [
	"flash.geom.Vector3D",
	"flash.geom.Matrix3D",
	"flash.events.Event",
	"flash.events.EventDispatcher",
	"flash.events.IEventDispatcher",
	"flash.events.TextEvent",
	"flash.events.ErrorEvent",
	"flash.events.ProgressEvent",
	"flash.errors.IllegalOperationError",
];

/** Those whose names the platform has too: types know them, but declare no such names to import, so that no editor suggests them for its own. */
export const PLATFORM_NAMES = new Set(["Event", "TextEvent", "ErrorEvent", "ProgressEvent"]);

/** The declarations that the module exports, by qualified name: the engine's public ones, and those of Flash. */
export function publicSignatures() {
	const types = readSignatures(SOURCES);
	const own = [...types.keys()].filter((qname) => qname.startsWith("starlogo.") && !qname.startsWith(AWAY3D) && !types.get(qname).isPrivate && !LEFT_OUT.has(qname));
	return new Map([...own, ...FROM_FLASH].map((qname) => [qname, types.get(qname)]));
}
