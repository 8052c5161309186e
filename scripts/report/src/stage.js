// Where a surface is drawn: canvas, camera and controls. A frame is drawn when something changed; while it moves, one
// pixel of the screen is one of the picture, or several are where frames would come too slowly; at rest it is drawn finer.

import { LinearSRGBColorSpace, PerspectiveCamera, Scene, Spherical, WebGLRenderer } from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";

const restPixels = 2;
const restAfter = 200; // ms
const leastPixels = 0.35;
const slowest = 1 / 24; // s a frame: a little faster than the 20 frames a second that look smooth
const turnSpeed = 2; // of OrbitControls: a turn in 30 s
const keys = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };

export class Stage {
  #renderer;
  #scene = new Scene();
  #camera = new PerspectiveCamera(30, 1, 0.1, 10);
  #controls;
  #mesh = null;
  #lines = null;
  #frame = 0;
  #rest = 0;
  #clock = 0;
  #movingPixels = 1;
  #pace = 0; // s a frame while it moves, smoothed

  /** Throws where there is no WebGL. */
  constructor(place, description) {
    const canvas = document.createElement("canvas");
    const context = canvas.getContext("webgl2", { alpha: true, antialias: false });
    if (!context) throw new Error("no WebGL");
    this.#renderer = new WebGLRenderer({ canvas, context });
    this.#renderer.outputColorSpace = LinearSRGBColorSpace; // colours come as the screen wants them
    this.#renderer.setPixelRatio(1);
    canvas.tabIndex = 0;
    canvas.setAttribute("role", "img");
    canvas.setAttribute("aria-label", description);
    place.replaceChildren(canvas);
    this.#controls = new OrbitControls(this.#camera, canvas);
    this.#controls.enableDamping = false;
    this.#controls.enablePan = false;
    this.#controls.autoRotateSpeed = turnSpeed;
    this.#controls.addEventListener("change", () => this.#moved());
    // The wheel scrolls the page until the surface was clicked on.
    this.#controls.enableZoom = false;
    canvas.addEventListener("focus", () => (this.#controls.enableZoom = true));
    canvas.addEventListener("blur", () => (this.#controls.enableZoom = false));
    canvas.addEventListener("keydown", (event) => this.#key(event));
    new ResizeObserver(() => this.#resize(place)).observe(place);
  }

  show(mesh) {
    if (this.#mesh) {
      this.#scene.remove(this.#mesh.object);
      this.#mesh.dispose();
    }
    this.#mesh = mesh;
    this.#scene.add(mesh.object);
    const distance = (1.1 * mesh.radius) / Math.sin((Math.PI / 360) * this.#camera.fov);
    this.#camera.near = distance / 100;
    this.#camera.far = 4 * distance;
    this.#camera.position.set(0.62, 0.42, 0.66).setLength(distance);
    this.#camera.updateProjectionMatrix();
    this.#controls.minDistance = distance / 8;
    this.#controls.maxDistance = 2 * distance;
    this.#controls.update();
    this.redraw();
  }

  /** Lines over the surface, or null for none. */
  showLines(lines) {
    if (this.#lines) {
      this.#scene.remove(this.#lines.object);
      this.#lines.dispose();
    }
    this.#lines = lines;
    if (lines) this.#scene.add(lines.object);
    this.redraw();
  }

  turn(on) {
    this.#controls.autoRotate = on;
    this.#moved();
  }

  /** At the next frame, once, whoever asks. */
  redraw() {
    if (!this.#frame) this.#frame = requestAnimationFrame((now) => this.#draw(now));
  }

  #draw(now) {
    const seconds = Math.min(0.1, (now - this.#clock) / 1000);
    if (now - this.#clock < restAfter) this.#keepPace(seconds);
    this.#frame = 0;
    this.#clock = now;
    if (!this.#mesh) return;
    this.#mesh.faceEye(this.#camera.position);
    this.#renderer.render(this.#scene, this.#camera);
    clearTimeout(this.#rest);
    if (this.#controls.autoRotate) this.#controls.update(seconds);
    else this.#rest = setTimeout(() => this.#setPixels(restPixels), restAfter);
  }

  /** Fewer pixels for as long as frames come too slowly: in software, pixels cost as much as the surface does. */
  #keepPace(seconds) {
    this.#pace += 0.4 * (seconds - this.#pace);
    if (this.#pace < slowest || this.#movingPixels <= leastPixels) return;
    this.#movingPixels = Math.max(leastPixels, this.#movingPixels * Math.SQRT1_2);
    this.#pace = 0;
  }

  #moved() {
    this.#setPixels(this.#movingPixels);
    this.redraw();
  }

  #setPixels(ratio) {
    if (this.#renderer.getPixelRatio() === ratio) return;
    this.#renderer.setPixelRatio(ratio);
    this.redraw();
  }

  #resize(place) {
    const { clientWidth: width, clientHeight: height } = place;
    if (!width || !height) return;
    this.#renderer.setSize(width, height);
    this.#camera.aspect = width / height;
    // A narrow screen sees as much as a square one.
    this.#camera.zoom = Math.min(1, width / height);
    this.#camera.updateProjectionMatrix();
    this.#moved();
  }

  #key(event) {
    if (event.key === "+" || event.key === "-") {
      const factor = event.key === "+" ? 1 / 1.1 : 1.1;
      const length = this.#camera.position.length() * factor;
      this.#camera.position.setLength(Math.min(this.#controls.maxDistance, Math.max(this.#controls.minDistance, length)));
    } else if (keys[event.key]) {
      const [aside, up] = keys[event.key];
      const place = new Spherical().setFromVector3(this.#camera.position);
      place.theta += 0.1 * aside;
      place.phi += 0.1 * up;
      this.#camera.position.setFromSpherical(place.makeSafe());
    } else {
      return;
    }
    event.preventDefault();
    this.#controls.update();
  }
}
