// Puts the models of the StarLogo Nova client, and their transform files, into files that tests can load: nova.json has all of them,
// nova-thesis.json those of the thesis's table by the names that it has for them.
//
//     node test/models/nova.mjs <folder that has the client> <folder to write to>
//
// Each file is an object: { name: { obj: "v 1 2 3...", slb: "rotate 90 0 0" } }, with null where there is no transform file.

import { existsSync, mkdirSync, readFileSync, readdirSync, writeFileSync } from 'node:fs'
import { join, sep } from 'node:path'

const THESIS = {
  bear: 'animals/bear/bear', dragon: 'animals/dragon/dragon', seagull: 'animals/seagull/seagull', tree: 'landscape/tree/tree',
  kelp: 'landscape/kelp/kelp', fortress: 'buildings/fortress/fortress_textured_sketchup', spaceship: 'vehicles/spaceship/spaceship1',
  fireman: 'people/fireman/fireman', cylinder: 'basic-shapes/cylinder/cylinder',
}

const [client, out] = process.argv.slice(2)
if (!out) {
  console.error('usage: node test/models/nova.mjs <folder that has the client> <folder to write to>')
  process.exit(2)
}
const files = readdirSync(client, { recursive: true }).map(String).filter(file => file.endsWith('.obj')).sort()
// the client is there several times, for each project and language
const shapes = files.find(file => file.split(sep).join('/').endsWith(`shapes/${THESIS.bear}.obj`))?.slice(0, -`${THESIS.bear}.obj`.length)
if (shapes === undefined) {
  console.error(`${client}, which NOVA names, has no shapes/${THESIS.bear}.obj of the StarLogo Nova client`)
  process.exit(1)
}

function read(name) {
  const file = join(client, shapes, name)
  return { obj: readFileSync(`${file}.obj`, 'utf8'), slb: existsSync(`${file}.slb`) ? readFileSync(`${file}.slb`, 'utf8') : null }
}

const names = files.filter(file => file.startsWith(shapes)).map(file => file.slice(shapes.length, -'.obj'.length))
mkdirSync(out, { recursive: true })
writeFileSync(join(out, 'nova.json'), JSON.stringify(Object.fromEntries(names.map(name => [name, read(name)]))))
writeFileSync(join(out, 'nova-thesis.json'), JSON.stringify(Object.fromEntries(Object.entries(THESIS).map(([name, file]) => [name, read(file)]))))
console.log(`the StarLogo Nova client's: ${names.length} models`)
