#!/usr/bin/env node
/**
 * Looks at what asdoc has written. Two links that it gets wrong are put right: to classes of a package below which there are others, and
 * to an index of symbols where there are none. Superclasses that are not documented go, and the date, so that the same sources give the same pages. Defaults
 * of parameters are those of the sources. The script gets what pages need that are opened as files. Exit status: 1 where a link
 * leads nowhere, a public name or a package is not described, or a member is shown that only the engine's packages share.
 *
 *   node test/docs/asdoc.mjs bin/asdoc
 */
import { existsSync, readFileSync, readdirSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import { pathToFileURL } from 'node:url';

/** A page with its links right, without a date, and without superclasses that have no page. */
export function repaired(html) {
	return html.replaceAll('starlogo:', 'starlogo/').replace(/<a href="all-index-Symbols\.html"[^>]*>(.*?)<\/a>/g, '$1')
		.replace(/ <img [^>]*class="inheritArrow"> starlogo\.[\w.]+(?=<)/g, '')
		.replace(/<br\/>\w+ \w+ \d+ \d{4}, [\d:]+ [AP]M \w+/g, '');
}

/**
 * A class's page with the defaults of its source: where one is a name, such as Infinity, asdoc writes none in the signature and NaN at the parameter, and it
 * writes strings without quotes.
 */
export function withDefaults(html, source) {
	let page = html.replace(/( const \w+:String = )([^<"]*)(?=<\/code>)/g, '$1"$2"');
	for (const [, name, parameters] of source.matchAll(/public (?:\w+ )*function (\w+)\(([^)]*)\)/g)) {
		for (const [, parameter, preset] of parameters.matchAll(/(\w+:\w+) = ("[^"]*"|[A-Z][\w.]*)/g)) {
			const [label, type] = parameter.split(':');
			page = page.replace(new RegExp(`(\\b${name}(?:</a>)?\\([^)]*\\b${parameter})(?: = [^,)]*)?(?=[,)])`, 'g'), `$1 = ${preset}`)
				.replace(new RegExp(`(<a name="${name}\\([^"]*"></a>(?:(?!<a name=)[^])*?<span class="label">${label}</span>:${type}</code> \\(default = <code>)[^<]*`), `$1${preset}`);
		}
	}
	return page;
}

/**
 * What is added to asdoc's own script, for pages that are opened as files: there a browser lets no page look into another frame or into a
 * style sheet. So the title bar stays as it is, and inherited members are shown and hidden by rules of the page's own.
 */
const FOR_FILES = `
/* Added to the template. */
if (location.protocol == "file:")
{
    var inheritedRules = {};
    showTitle = function(title) { document.title = title; };
    titleBar_setSubTitle = titleBar_setSubNav = titleBar_gotoClassFrameAnchor = function() {};
    setInheritedVisible = function(show, selectorText)
    {
        var rules = document.getElementById("inheritedRules");
        if (!rules)
        {
            rules = document.head.appendChild(document.createElement("style"));
            rules.id = "inheritedRules";
        }
        inheritedRules[selectorText] = ".hideInherited" + selectorText + " { display: " + (show ? "revert" : "none") + " !important; } "
            + ".showInherited" + selectorText + " { display: " + (show ? "none" : "revert") + " !important; }";
        rules.textContent = Object.keys(inheritedRules).map(function(each) { return inheritedRules[each]; }).join(" ");
        setCookie("showInherited" + selectorText, show ? "true" : "false", new Date(3000,1,1,1,1), "/", document.location.domain);
        setRowColors(show, selectorText);
    };
}
`;

/** asdoc's script, for pages that are opened as files too. */
export function repairedScript(text) {
	return text.endsWith(FOR_FILES) ? text : text + FOR_FILES;
}

const textOf = (html) => html.replace(/<[^>]*>|&nbsp;/g, ' ').replace(/\s+/g, ' ').trim();

/** What is missing on a page: names in its summaries without a description. */
export function undescribedIn(html) {
	const members = [...html.matchAll(/class="signatureLink">(\w+)<\/a>(?:(?!class="signatureLink")[^])*?<div class="summaryTableDescription">([^]*?)<\/div>/g)];
	const listed = [...html.matchAll(/<td class="summaryTableSecondCol">(?:<i>)?<a [^>]*>([^<]*)<\/a>(?:<\/i>)?<\/td><td class="summaryTableLastCol">([^]*?)<\/td>/g)];
	return [...members, ...listed].filter(([, , description]) => textOf(description).replace(/\[[\w-]+\]/g, '').trim() === '').map(([, name]) => name);
}

/** The members on a page that are in the namespace engine. */
export function engineMembersIn(html) {
	return [...html.matchAll(/<code> *(?:\w+ )*engine (?:\w+ )*(\w+)(?=[^\w ])/g)].map(([, name]) => name);
}

/** The links of a page that lead to no file. */
export function brokenIn(html, exists) {
	return [...html.matchAll(/(?:href|src)="([^"#?]+)[^"]*"/g)].map(([, to]) => to)
		.filter((to) => !/^(?:https?|javascript|mailto):/.test(to) && !exists(to));
}

function look(folder) {
	const script = path.join(folder, 'asdoc.js');
	writeFileSync(script, repairedScript(readFileSync(script, 'utf8')));
	const pages = readdirSync(folder, { recursive: true }).filter((file) => file.endsWith('.html'));
	return pages.flatMap((file) => {
		const at = path.join(folder, file);
		const source = path.join('src', file.replace(/html$/, 'as'));
		const html = withDefaults(repaired(readFileSync(at, 'utf8')), existsSync(source) ? readFileSync(source, 'utf8') : '');
		writeFileSync(at, html);
		const broken = brokenIn(html, (to) => existsSync(path.join(path.dirname(at), decodeURI(to))));
		return [...broken.map((to) => `${file}: no ${to}`), ...engineMembersIn(html).map((name) => `${file}: ${name} is the engine's own, so it needs @private`),
			...undescribedIn(html).map((name) => `${file}: ${name} is not described`)];
	});
}

if (import.meta.url === pathToFileURL(process.argv[1] ?? '').href) {
	const problems = look(process.argv[2]);
	console.log(problems.join('\n'));
	process.exitCode = problems.length > 0 ? 1 : 0;
}
