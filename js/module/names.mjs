/** Lists the names of ActionScript that the module takes from elsewhere, and the names that it exports. */
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { readSignatures } from "./signatures.mjs";

/** The project's folder. */
export const ROOT = fileURLToPath(new URL("../..", import.meta.url));

/** The folders of the module's sources. A file in an earlier folder replaces one of the same name in a later folder. */
export const SOURCES = ["js/standins/module", "js/standins/common", "src"].map((folder) => join(ROOT, folder));

/** What the translated classes use in place of classes and functions in ActionScript: names in the *.mjs of js/standins/module. */
export const EXTERNALS = {
	ArgumentError: "ArgumentError",
	"flash.errors.EOFError": "EOFError",
	"flash.utils.ByteArray": "ByteArray",
	"flash.utils.getQualifiedClassName": "classNameOf",
	"starlogo.data.isProbablyMisspelt": "$isProbablyMisspelt",
	"starlogo.data.zeroedInts": "$zeroedInts",
	"starlogo.data.zeroedNumbers": "$zeroedNumbers",
	"starlogo.data.hintOfName": "$hintOfName",
	"starlogo.data.textOf": "$textOf",
	"starlogo.data.warn": "$warn",
	"starlogo.data.warnOfNoParameters": "$warnOfNoParameters",
	"starlogo.agents.warnOfBreeds": "$warnOfBreeds",
	"starlogo.queries.motion.warnOfInside": "$warnOfInside",
	"starlogo.data.warnOfUnknownProperties": "$warnOfUnknownProperties",
	"starlogo.handlers.mayTakeContact": "mayTakeContact",
	"starlogo.handlers.requireParameters": "$warnOfHandler",
	"starlogo.handlers.warnOfMissingBreeds": "$warnOfMissingBreeds",
	"standin.LocalStore.read": "readLocal",
	"standin.LocalStore.remove": "removeLocal",
	"standin.LocalStore.write": "writeLocal",
	"standin.Machine.className": "classNameOf",
	"standin.Machine.clearTimeout": "clearTimeout",
	"standin.Machine.addFrameListener": "addFrameListener",
	"standin.Machine.removeFrameListener": "removeFrameListener",
	"standin.Machine.now": "now",
	"standin.Machine.setTimeout": "setTimeout",
	"standin.Machine.reportError": "reportError",
	"standin.Machine.unhandledEvent": "unhandledEvent",
	"standin.Network.fetch": "fetchFile",
};

/** Where the compiler writes its files, in the folder of a translation. */
export const compiledFolder = (folder) => join(folder, "out/bin/js-debug");

/** The compiler's file of a class. */
export const compiledFile = (folder, qname) => join(compiledFolder(folder), `${qname.replaceAll(".", "/")}.js`);

/** The package for clients with Away3D only. */
export const AWAY3D = "starlogo.away3d";

/** Public classes of the engine that the module lacks, with the reason. */
export const LEFT_OUT = new Map([["starlogo.diagnostics.CollisionMonitor", "it draws on Flash's stage"]]);

/** Classes of Flash that appear in the engine's public names. The module exports them too. */
const FROM_FLASH = [
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

/**
 * Classes of Flash whose names the platform has too. index.d.ts declares their types but does not export their names, so that editors do
 * not suggest them instead of the platform's.
 */
export const PLATFORM_NAMES = new Set(["Event", "TextEvent", "ErrorEvent", "ProgressEvent"]);

/** The declarations that the module exports, by qualified name: the engine's public ones, and Flash's. */
export function publicSignatures() {
	const types = readSignatures(SOURCES);
	const isOwn = (qname) => qname.startsWith("starlogo.") && !qname.startsWith(AWAY3D);
	const own = [...types.keys()].filter((qname) => isOwn(qname) && !types.get(qname).isPrivate && !LEFT_OUT.has(qname));
	return new Map([...own, ...FROM_FLASH].map((qname) => [qname, types.get(qname)]));
}

/** The classes that the module consists of, with all that they use: those of publicSignatures(), and one of the stand-ins. */
export const moduleRoots = (types = publicSignatures()) => [...types.keys(), "standin.Machine"];
