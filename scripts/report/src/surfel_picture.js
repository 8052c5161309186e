// Which surfel each pixel of a view shows, and how deep it lies: drawn once a frame, for all views that show the surface
// from the same eye in colours of their own. Many radii then cost little more than one.

import {
  DepthTexture,
  GLSL3,
  Mesh,
  NearestFilter,
  RawShaderMaterial,
  RedIntegerFormat,
  Scene,
  UnsignedIntType,
  WebGLRenderTarget,
} from "three";

const vertexShader = `
  uniform mat4 modelViewMatrix, projectionMatrix;
  in vec3 position, rectangle;
  in vec2 corner;
  out vec2 place;
  flat out vec3 inside;
  void main() {
    place = corner;
    inside = rectangle;
    gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
  }`;

// Nothing is 0; else the axis of the normal is in the lowest two bits, the number of the texel plus one above.
const fragmentShader = `
  precision highp float;
  precision highp int;
  uniform uint axis;
  in vec2 place;
  flat in vec3 inside; // first texel, width, height
  out uint surfel;
  void main() {
    vec2 cell = clamp(floor(place), vec2(0.0), inside.yz - 1.0);
    surfel = uint(inside.x + cell.y * inside.y + cell.x + 1.0) << 2 | axis;
  }`;

export class SurfelPicture {
  #geometry;
  #target;
  #scene = new Scene();

  constructor(geometry) {
    this.#geometry = geometry;
    this.#target = new WebGLRenderTarget(1, 1, {
      format: RedIntegerFormat,
      type: UnsignedIntType,
      internalFormat: "R32UI",
      minFilter: NearestFilter,
      magFilter: NearestFilter,
      depthTexture: new DepthTexture(1, 1, UnsignedIntType),
    });
    for (const { axis, buffer } of geometry.parts) {
      const uniforms = { axis: { value: axis } };
      const mesh = new Mesh(buffer, new RawShaderMaterial({ glslVersion: GLSL3, vertexShader, fragmentShader, uniforms }));
      mesh.frustumCulled = false;
      this.#scene.add(mesh);
    }
  }

  get geometry() {
    return this.#geometry;
  }
  get surfels() {
    return this.#target.texture;
  }
  get depths() {
    return this.#target.depthTexture;
  }

  /** As the camera sees it, in so many pixels. */
  draw(renderer, camera, width, height) {
    this.#geometry.faceEye(camera.position);
    this.#target.setSize(width, height);
    renderer.setRenderTarget(this.#target);
    renderer.render(this.#scene, camera);
    renderer.setRenderTarget(null);
  }

  dispose() {
    this.#target.depthTexture.dispose();
    this.#target.dispose();
    for (const { material } of this.#scene.children) material.dispose();
    this.#geometry.dispose();
  }
}
