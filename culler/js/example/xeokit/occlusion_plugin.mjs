// SPDX-License-Identifier: MIT
// A plug-in of xeokit: objects of models are not drawn while they are hidden. Viewers need `readableGeometryEnabled: true`.
import {load} from "occlude";

const surfaces = new Set(["triangles", "solid", "surface"]);
const multiply = (a, b) => Float64Array.from({length: 16}, (_, i) =>
  [0, 1, 2, 3].reduce((sum, k) => sum + a[4 * k + (i % 4)] * b[i - (i % 4) + k], 0));

/** The triangles of a mesh in the world. */
function trianglesOf(mesh) {
  const vertices = [], indices = [];
  mesh.getEachVertex(([x, y, z]) => vertices.push(x, y, z));
  mesh.getEachIndex(i => indices.push(i));
  return {vertices, indices};
}

/** Whether it lets nothing through. Colours are of each mesh, with opacity last. */
const isOpaque = ({meshes}) => meshes.every(({_colorize, textureSet}) => _colorize[3] === 255 && !textureSet);
/** Emphasised objects glow through others. */
const isEmphasised = entity => entity.xrayed || entity.highlighted || entity.selected;

/**
 * Hides by `culledVFC` of entities, which neither applications nor other plug-ins use.
 * - Objects come, go, move, become transparent, x-rayed, selected or invisible: each frame looks.
 * - While there are section planes or lights that cast shadows, everything is drawn.
 * - With antialiasing and edges, edges of what is hidden show in a few pixels without this: depth of lines is taken beside of them.
 * - Picking finds what is drawn: what is hidden is found by no ray from elsewhere. destroy() makes it as it was.
 */
export class OcclusionPlugin {
  /** What is known of entities. */
  #known = new Map();

  static async of(viewer) {
    return new OcclusionPlugin(viewer, await load());
  }

  constructor(viewer, occlude) {
    this.viewer = viewer;
    this.isEnabled = true;
    this.occlude = occlude;
    this.scene = new occlude.Scene();
    this.view = new occlude.View();
    this.listener = viewer.scene.on("rendering", () => this.#cull());
  }

  /** How many objects are not drawn, those out of view included. */
  get hidden() {
    return [...this.#known.keys()].filter(({culledVFC}) => culledVFC).length;
  }

  destroy() {
    this.viewer.scene.off(this.listener);
    for (const entity of this.#known.keys()) entity.culledVFC = false;
    for (const each of [this.view, this.scene]) each.dispose();
  }

  #cull() {
    const {scene: viewed} = this.viewer;
    for (const entity of Object.values(viewed.objects)) this.#see(entity);
    for (const [entity, known] of this.#known) if (viewed.objects[entity.id] !== entity) this.#forget(entity, known);
    const isCut = Object.values(viewed.sectionPlanes).some(({active}) => active);
    const hasShadows = Object.values(viewed.lights).some(({castsShadow}) => castsShadow);
    const drawn = this.isEnabled && !isCut && !hasShadows ? this.#drawn() : undefined;
    for (const [entity, {id}] of this.#known) entity.culledVFC = drawn !== undefined && !drawn.has(id) && !isEmphasised(entity);
  }

  #drawn() {
    const {camera, canvas: {canvas}, edgeMaterial} = this.viewer.scene;
    this.scene.update();
    // Edges are lines, which reach out of what they are of by up to half of their width: also into the picture from beside it.
    const reach = edgeMaterial.edges ? edgeMaterial.edgeWidth + 1 : 0;
    const margin = this.occlude.marginFor(canvas.height) + reach / canvas.height;
    const matrix = multiply(camera.projMatrix, camera.viewMatrix);
    [canvas.width, canvas.height].forEach((size, row) => {
      for (let column = 0; column < 4; ++column) matrix[4 * column + row] *= size / (size + 2 * reach);
    });
    return new Set(this.scene.cull({matrix, depth: "minus_w_to_w", nearer: "less"}, this.view, {margin}).objects);
  }

  #see(entity) {
    const [...box] = entity.aabb;
    let known = this.#known.get(entity);
    if (known !== undefined && known.box.some((x, i) => x !== box[i])) {
      this.#forget(entity, known);
      known = undefined;
    }
    if (known === undefined) {
      const id = this.scene.addObject(box), meshes = entity.meshes.filter(({layer}) => surfaces.has(layer.primitive));
      const occluders = meshes.map(mesh => {
        const made = new this.occlude.OccluderMesh(trianglesOf(mesh));
        const occluder = this.scene.addOccluder(made, undefined, {object: id, oneSided: true});
        made.dispose(); // the occluder keeps it
        return occluder;
      });
      this.#known.set(entity, (known = {box, id, occluders, isVisible: true, isHiding: true}));
    }
    const isHiding = isOpaque(entity) && !isEmphasised(entity);
    if (known.isVisible !== entity.visible) this.scene.enableObjects([known.id], (known.isVisible = entity.visible));
    if (known.isHiding !== isHiding) this.scene.enableOccluders(known.occluders, (known.isHiding = isHiding));
  }

  #forget(entity, {id, occluders}) {
    this.scene.removeOccluders(occluders);
    this.scene.removeObjects([id]);
    this.#known.delete(entity);
  }
}
