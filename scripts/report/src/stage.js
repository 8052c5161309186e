// Where surfaces are drawn: canvas, camera and controls. One canvas lies over all views, each drawn into its own part by
// the same camera, so that they turn together. A frame is drawn when something changed; while it moves, one pixel of the
// screen is one of the picture, or several are where frames would come too slowly; at rest it is drawn finer.

import { LinearSRGBColorSpace, PerspectiveCamera, Scene, Spherical, WebGLRenderer } from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";

const restPixels = 2;
const restAfter = 200; // ms
const leastPixels = 0.25;
const slowest = 1 / 24; // s a frame: a little faster than the 20 frames a second that look smooth
const turnSpeed = 2; // of OrbitControls: a turn in 30 s
const keys = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };

export class Stage {
  #frameElement;
  #renderer;
  #camera = new PerspectiveCamera(30, 1, 0.1, 10);
  #controls;
  #picture = null;
  #views = []; // { place, scene, colours, lines, part of the canvas }
  #drawn = []; // the views in the last frame: others are blank
  #sight = new IntersectionObserver(() => {
    if (this.#viewsInSight().some((view) => !this.#drawn.includes(view))) this.redraw();
  });
  #frame = 0;
  #rest = 0;
  #clock = 0;
  #movingPixels = 1;
  #pace = 0; // s a frame while it moves, smoothed

  /** Throws where there is no WebGL. */
  constructor(frame, description) {
    const canvas = document.createElement("canvas");
    const context = canvas.getContext("webgl2", { alpha: true, antialias: false });
    if (!context) throw new Error("no WebGL");
    this.#renderer = new WebGLRenderer({ canvas, context });
    this.#renderer.outputColorSpace = LinearSRGBColorSpace; // colours come as the screen wants them
    this.#renderer.setPixelRatio(1);
    this.#renderer.setScissorTest(true);
    canvas.tabIndex = 0;
    canvas.setAttribute("role", "img");
    canvas.setAttribute("aria-label", description);
    frame.append(canvas);
    this.#frameElement = frame;
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
    new ResizeObserver(() => this.#resize()).observe(frame);
  }

  /** One picture in several colours, each over its place: elements of one size within the frame. */
  show(picture, coloured, places) {
    this.showLines([]);
    for (const { colours } of this.#views) colours.dispose();
    this.#picture?.dispose();
    this.#picture = picture;
    this.#views = coloured.map((colours, i) => ({ place: places[i], scene: new Scene().add(colours.object), colours, lines: null }));
    const distance = (1.1 * picture.geometry.radius) / Math.sin((Math.PI / 360) * this.#camera.fov);
    this.#camera.near = distance / 100;
    this.#camera.far = 4 * distance;
    this.#camera.position.set(0.62, 0.42, 0.66).setLength(distance);
    this.#controls.minDistance = distance / 8;
    this.#controls.maxDistance = 2 * distance;
    // Several views leave no room beside them: on a screen to be touched, moving up and down scrolls the page.
    this.#renderer.domElement.style.touchAction = coloured.length > 1 ? "pan-y" : "none";
    this.#sight.disconnect();
    for (const place of places) this.#sight.observe(place);
    this.#resize();
    this.#controls.update();
    this.redraw();
  }

  /** Lines over the surface of each view; none where the list has none. */
  showLines(lines) {
    this.#views.forEach((view, i) => {
      if (view.lines) {
        view.scene.remove(view.lines.object);
        view.lines.dispose();
      }
      view.lines = lines[i] ?? null;
      if (view.lines) view.scene.add(view.lines.object);
    });
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
    if (now - this.#clock < restAfter && this.#renderer.getPixelRatio() <= this.#movingPixels) this.#keepPace(seconds);
    this.#frame = 0;
    this.#clock = now;
    if (!this.#picture) return;
    this.#drawn = this.#viewsInSight();
    if (this.#drawn.length) this.#drawPicture(this.#drawn[0].part);
    for (const { scene, part } of this.#drawn) {
      this.#renderer.setViewport(part.left, part.bottom, part.width, part.height);
      this.#renderer.setScissor(part.left, part.bottom, part.width, part.height);
      this.#renderer.render(scene, this.#camera);
    }
    clearTimeout(this.#rest);
    if (this.#controls.autoRotate) this.#controls.update(seconds);
    else this.#rest = setTimeout(() => this.#setPixels(restPixels), restAfter);
  }

  #viewsInSight() {
    const { top } = this.#renderer.domElement.getBoundingClientRect();
    return this.#views.filter(({ part }) => part && top + part.top <= innerHeight && top + part.top + part.height >= 0);
  }

  /** In the pixels of a view, all of which are of one size. */
  #drawPicture({ width, height }) {
    const ratio = this.#renderer.getPixelRatio();
    this.#picture.draw(this.#renderer, this.#camera, Math.round(ratio * width), Math.round(ratio * height));
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

  /** No more than a canvas may have: with many views it is long. */
  #setPixels(wanted) {
    const { clientWidth, clientHeight } = this.#frameElement;
    const ratio = Math.min(wanted, this.#renderer.capabilities.maxTextureSize / Math.max(clientWidth, clientHeight));
    if (this.#renderer.getPixelRatio() === ratio) return;
    this.#renderer.setPixelRatio(ratio);
    this.redraw();
  }

  #resize() {
    const { clientWidth: width, clientHeight: height } = this.#frameElement;
    if (!width || !height || !this.#views.length) return;
    this.#renderer.setSize(width, height);
    const canvas = this.#renderer.domElement.getBoundingClientRect();
    for (const view of this.#views) {
      const place = view.place.getBoundingClientRect();
      const top = place.top - canvas.top;
      const { width: across, height: down } = place;
      view.part = { left: place.left - canvas.left, top, width: across, height: down, bottom: height - top - down };
    }
    const [{ part }] = this.#views;
    this.#camera.aspect = part.width / part.height;
    // A narrow view sees as much as a square one.
    this.#camera.zoom = Math.min(1, part.width / part.height);
    this.#camera.updateProjectionMatrix();
    this.#controls.rotateSpeed = height / part.height; // the controls count in heights of the canvas
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
