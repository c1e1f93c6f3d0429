/** Adobe's compilers, as the build calls them. */
import { spawnSync } from 'node:child_process';
import path from 'node:path';
import { inRoot } from '../../build/dist/project.mjs';

const flex = process.env.FLEX_HOME ?? inRoot('node_modules/flex-sdk/lib/flex_sdk');
const java = process.env.JAVA_HOME ? path.join(process.env.JAVA_HOME, 'bin/java') : 'java';

export const compc = (args, options) => run('compc', args, options);

export const mxmlc = (args, options) => run('mxmlc', args, options);

/** Runs one, and throws what it says if it fails. */
function run(tool, args, options = {}) {
	const { status, stdout, stderr } = spawnSync(java, [`-Dapplication.home=${flex}`, '-Xmx1g', '-XX:TieredStopAtLevel=1', '-XX:+UseSerialGC', '-Dfile.encoding=UTF-8',
		'-jar', path.join(flex, `lib/${tool}.jar`), '-load-config=', `-external-library-path+=${path.join(flex, 'frameworks/libs/air/airglobal.swc')}`,
		...args], { encoding: 'utf8', ...options });
	if (status !== 0) {
		throw new Error(`${tool}:\n${stdout}${stderr}`);
	}
}
