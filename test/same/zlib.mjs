/** Of node:zlib what the tests' archives need. */
export { deflateSync as deflateRawSync } from "fflate";
