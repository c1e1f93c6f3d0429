#!/usr/bin/env node
/**
 * Serves the built playground, on loopback unless told otherwise, and prints its address. If other machines reach it, it prints all its
 * addresses, and a QR code of the first one.
 *
 *   node js/playground/serve.mjs FOLDER [PORT [HOST]]     HOST 0.0.0.0 is this machine's network
 */
import os from "node:os";
import { serve } from "../../build/headless/server.mjs";
import { addressesOf, qrOf } from "./announce.mjs";

const LOOPBACK = "127.0.0.1";
const [folder, port = 0, host = LOOPBACK] = process.argv.slice(2);
const { url } = await serve(null, { "": folder }, { port: Number(port), host });
const [first, ...others] = addressesOf(host, new URL(url).port, os.networkInterfaces());
console.log(`the playground is at ${first} (stop with Ctrl+C)`);
for (const other of others) console.log(`                 or ${other}`);
if (host !== LOOPBACK) {
	const { LC_ALL, LC_CTYPE, LANG } = process.env;
	console.log(["", ...qrOf(first, /utf-?8/i.test(LC_ALL || LC_CTYPE || LANG || "")), ""].join("\n"));
	console.log("Machines in the same network can open it. If they cannot, this machine's firewall has to allow it.");
}
