// A digital surface in colours: each pixel finds that of its surfel in a texture. New colours leave all else alone, and
// several of these share one picture of the surface.

import {
  AlwaysDepth,
  BufferAttribute,
  BufferGeometry,
  DataTexture,
  GLSL3,
  Mesh,
  RawShaderMaterial,
  RGBAFormat,
  UnsignedByteType,
} from "three";

const textureBits = 10; // texels of a row, as a power of two

const vertexShader = `
  in vec3 position;
  out vec2 place;
  void main() {
    place = 0.5 * position.xy + 0.5;
    gl_Position = vec4(position, 1.0);
  }`;

// Shaded by axis, so that steps can be told apart without lights.
const fragmentShader = `
  precision highp float;
  precision highp int;
  uniform highp usampler2D surfels;
  uniform highp sampler2D depths, colours;
  const float shades[3] = float[](0.86, 0.94, 1.0);
  in vec2 place;
  out vec4 colour;
  void main() {
    ivec2 pixel = ivec2(place * vec2(textureSize(surfels, 0)));
    uint surfel = texelFetch(surfels, pixel, 0).r;
    if (surfel == 0u) discard;
    int texel = int(surfel >> 2) - 1;
    ivec2 at = ivec2(texel & ${(1 << textureBits) - 1}, texel >> ${textureBits});
    colour = vec4(shades[surfel & 3u] * texelFetch(colours, at, 0).rgb, 1.0);
    gl_FragDepth = texelFetch(depths, pixel, 0).r; // for the lines over it
  }`;

// A triangle that covers the view.
const corners = new BufferAttribute(Float32Array.of(-1, -1, 0, 3, -1, 0, -1, 3, 0), 3);

export class SurfaceColours {
  #order;
  #texture;

  constructor(picture) {
    this.#order = picture.geometry.order;
    const width = 1 << textureBits;
    const height = Math.ceil(this.#order.length / width);
    this.#texture = new DataTexture(new Uint8Array(4 * width * height), width, height, RGBAFormat, UnsignedByteType);
    const uniforms = {
      surfels: { value: picture.surfels },
      depths: { value: picture.depths },
      colours: { value: this.#texture },
    };
    const settings = { glslVersion: GLSL3, vertexShader, fragmentShader, uniforms, depthFunc: AlwaysDepth };
    this.object = new Mesh(new BufferGeometry().setAttribute("position", corners), new RawShaderMaterial(settings));
    this.object.frustumCulled = false;
    this.object.renderOrder = -1; // lines come after it
  }

  /** Three bytes a surfel, in the order of the surfels. */
  colour(colours) {
    const texels = this.#texture.image.data;
    this.#order.forEach((surfel, texel) => {
      for (let k = 0; k < 3; ++k) texels[4 * texel + k] = colours[3 * surfel + k];
    });
    this.#texture.needsUpdate = true;
  }

  /** But for the picture, which others may share. */
  dispose() {
    this.#texture.dispose();
    this.object.geometry.dispose();
    this.object.material.dispose();
  }
}
