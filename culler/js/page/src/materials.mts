// SPDX-License-Identifier: MIT
import * as THREE from "three";

/** Of a picture, no more than that: corners have one colour each, whatever is in between. */
const kTextureSize = 256;

/** The colour of the vertices of a geometry with one material: of material, vertex and texture together. */
export class ColourOf {
  readonly #vertexColours: THREE.BufferAttribute | THREE.InterleavedBufferAttribute | undefined;
  readonly #places: THREE.BufferAttribute | THREE.InterleavedBufferAttribute | undefined;
  readonly #base: THREE.Color;
  readonly #texture: {readonly map: THREE.Texture; readonly pixels: ImageData} | undefined;
  readonly #opacity: number;
  readonly #colour = new THREE.Color();
  readonly #sample = new THREE.Color();
  readonly #place = new THREE.Vector2();

  constructor(geometry: THREE.BufferGeometry, given: THREE.Material) {
    const material = given as THREE.MeshPhysicalMaterial, {map} = material;
    this.#vertexColours = material.vertexColors ? geometry.getAttribute("color") : undefined;
    this.#base = material.color ?? new THREE.Color(1, 1, 1);
    const pixels = map ? pixelsOf(map) : undefined;
    if (map && pixels) this.#texture = {map, pixels};
    this.#places = this.#texture && geometry.getAttribute(map!.channel === 0 ? "uv" : `uv${map!.channel}`);
    const lightComesThrough = material.transparent || material.alphaTest > 0 || (material.transmission ?? 0) > 0 || material.opacity < 1;
    this.#opacity = lightComesThrough ? 0 : 255;
  }

  /** Red, green and blue, and 255 or, if light comes through, 0. */
  vertex(i: number): [number, number, number, number] {
    const colour = this.#colour.copy(this.#base);
    if (this.#vertexColours) colour.multiply(this.#sample.fromBufferAttribute(this.#vertexColours, i));
    if (this.#texture && this.#places) {
      colour.multiply(this.#sampleAt(this.#texture, this.#place.set(this.#places.getX(i), this.#places.getY(i))));
    }
    colour.convertLinearToSRGB();
    const [red, green, blue] = colour.toArray().map(part => Math.round(255 * Math.min(1, Math.max(0, part))));
    return [red!, green!, blue!, this.#opacity];
  }

  #sampleAt({map, pixels: {data, width, height}}: {map: THREE.Texture; pixels: ImageData}, place: THREE.Vector2): THREE.Color {
    map.transformUv(place);
    const x = Math.min(width - 1, Math.floor(place.x * width)), y = Math.min(height - 1, Math.floor(place.y * height));
    const at = 4 * (y * width + x);
    return this.#sample.setRGB(data[at]! / 255, data[at + 1]! / 255, data[at + 2]! / 255, THREE.SRGBColorSpace);
  }
}

const known = new WeakMap<THREE.Texture, ImageData>();

function pixelsOf(map: THREE.Texture): ImageData | undefined {
  const image = map.image as (CanvasImageSource & {width: number; height: number}) | undefined;
  if (!image?.width) return undefined;
  const found = known.get(map);
  if (found) return found;
  const width = Math.min(kTextureSize, image.width), height = Math.min(kTextureSize, image.height);
  const context = new OffscreenCanvas(width, height).getContext("2d")!;
  context.drawImage(image, 0, 0, width, height);
  const pixels = context.getImageData(0, 0, width, height);
  known.set(map, pixels);
  return pixels;
}
