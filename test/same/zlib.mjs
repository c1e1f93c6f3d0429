/** Of node:zlib what the tests' archives need. */
export { deflateRaw as deflateRawSync } from "pako";
