// SPDX-License-Identifier: MIT
// What may be seen from an eye, by the visible sets of `occlude bake`. Usage: node print_visible_sets.mjs FILE X Y Z
import {readFileSync} from 'node:fs'
import {VisibleSets} from './visible_sets.mjs'

const [file, ...eye] = process.argv.slice(2)
try {
  if (eye.length !== 3 || eye.some((x) => x === '' || Number.isNaN(Number(x)))) throw new Error('expected FILE X Y Z')
  const sets = new VisibleSets(new Uint8Array(readFileSync(file)).buffer)
  sets.check()
  const cell = sets.cellAt(eye.map(Number))
  console.log(cell === undefined ? 'in no cell' : `cell ${cell}`)
  if (cell !== undefined) {
    console.log(['items', ...sets.visible(cell)].join(' '))
    console.log(['cells', ...sets.visibleCells(cell)].join(' '))
  }
} catch (error) {
  console.error(`${file}: ${error.message}`)
  process.exitCode = 2
}
