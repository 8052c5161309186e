// The digital surface: what the form asks for, on the stage, with the scale of its colours.

import { coloursOf, errorRange, gradientOf, valueRange } from "./colour_scale.js";
import { studyName } from "./curves.js";
import { DirectionLines } from "./direction_lines.js";
import { byId, chosenRadio, element, fillRadios, fillSelect, isPressed, onToggle } from "./elements.js";
import { Stage } from "./stage.js";
import { decodeSurface, valuesOf } from "./surface_data.js";
import { SurfaceMesh } from "./surface_mesh.js";
import { countText, errorText, quantityText, radiusText, stepText } from "./text.js";

const kinds = [["estimate", "estimate"], ["truth", "truth"], ["error", "error"]]; // prettier-ignore

class SurfaceView {
  #surfaces;
  #decoded = new Map();
  #stage = null;
  #shown = null;

  constructor(surfaces) {
    this.#surfaces = surfaces;
    const several = new Set(surfaces.map(({ study }) => study)).size > 1;
    const title = ({ study, shape, h }) => `${several ? `${study}: ` : ""}${shape}, h = ${stepText(h)}`;
    fillSelect(byId("surface-shape"), surfaces.map((surface, i) => [String(i), title(surface)]));
    fillRadios(byId("surface-colour"), "surface-colour", kinds);
    this.#fillEstimators();
    byId("surface-choices").addEventListener("submit", (event) => event.preventDefault());
    byId("surface-choices").addEventListener("change", () => {
      this.#fillEstimators();
      this.#show();
    });
    onToggle(byId("directions"), () => this.#showDirections());
    onToggle(byId("turn"), (on) => this.#stage?.turn(on));
  }

  /** WebGL and decoding wait until the surface comes into view. */
  startWhenSeen() {
    const observer = new IntersectionObserver((entries) => {
      if (!entries.some((entry) => entry.isIntersecting)) return;
      observer.disconnect();
      this.#start();
    });
    observer.observe(byId("stage"));
  }

  #start() {
    try {
      this.#stage = new Stage(byId("stage"), "Digital surface. Arrow keys turn it, plus and minus come closer and go away.");
    } catch {
      byId("stage").classList.add("sentence");
      byId("stage").replaceChildren("This browser has no WebGL: the surface cannot be drawn. Everything else on this page can.");
      byId("directions").disabled = byId("turn").disabled = true;
      return;
    }
    this.#show();
    this.#stage.turn(isPressed(byId("turn")));
  }

  get #surface() {
    return this.#surfaces[Number(byId("surface-shape").value)];
  }
  get #estimator() {
    return Number(byId("surface-estimator").value);
  }

  #fillEstimators() {
    const { estimators } = this.#surface;
    fillSelect(
      byId("surface-estimator"),
      estimators.map((e, i) => [String(i), [e.estimator, radiusText(e)].filter(Boolean).join(", ")]),
    );
    const { quantities, directions } = estimators[this.#estimator];
    fillSelect(byId("surface-quantity"), quantities.map((q) => [q, quantityText(q)]));
    byId("directions").disabled = !directions;
  }

  #arrays({ id }) {
    if (!this.#decoded.has(id)) this.#decoded.set(id, decodeSurface(JSON.parse(byId(id).textContent)));
    return this.#decoded.get(id);
  }

  #show() {
    if (!this.#stage) return;
    const arrays = this.#arrays(this.#surface);
    if (this.#shown?.surface !== this.#surface) {
      this.#shown = { surface: this.#surface, mesh: new SurfaceMesh(arrays) };
      this.#stage.show(this.#shown.mesh);
    }
    const quantity = byId("surface-quantity").value;
    const kind = chosenRadio(byId("surface-colour"));
    const values = valuesOf(arrays, this.#estimator, quantity, kind);
    const scale = kind === "error" ? "errors" : "values";
    const range =
      kind === "error" ? errorRange(values) : valueRange(arrays.estimates[this.#estimator][quantity], arrays.truth[quantity]);
    this.#shown.mesh.colour(coloursOf(values, range, scale));
    this.#showScale(kind, quantity, scale, range);
    this.#showFacts(quantity);
    this.#showDirections();
  }

  #showDirections() {
    const directions = this.#stage && this.#arrays(this.#surface).directions[this.#estimator];
    const wanted = directions && isPressed(byId("directions"));
    this.#stage?.showLines(wanted ? new DirectionLines(this.#arrays(this.#surface), directions) : null);
  }

  #showScale(kind, quantity, scale, [low, high]) {
    byId("scale").replaceChildren(
      element("span", { class: "title" }, `${kind} of ${quantityText(quantity)}`),
      element("span", { class: "gradient", style: `background:${gradientOf(scale)}` }),
      ...[low, (low + high) / 2, high].map((value) => element("span", { class: "tick" }, errorText(value))),
    );
  }

  #showFacts(quantity) {
    const { surfels, singular, offset, estimators } = this.#surface;
    const errors = estimators[this.#estimator].errors[quantity];
    byId("surface-facts").replaceChildren(
      [
        `${countText(surfels)} surfels`,
        `shift ${offset.map((x) => x.toFixed(3).replace("-", "−")).join(", ")} of a cell`,
        `error sup ${errorText(errors.sup)}, rms ${errorText(errors.rms)}`,
        ...(singular ? [`${countText(singular)} at singular points, grey`] : []),
        "colours end where 1 % of the values lie beyond",
        "directions: black along κ₁, white along κ₂",
      ].join(" · "),
    );
  }
}

/** Shows the surfaces of all studies, or hides their section where there are none. */
export function startSurfaceView(studies) {
  const surfaces = studies.flatMap((study) =>
    study.surfaces.map((surface) => ({ ...surface, study: studyName(study, studies) })),
  );
  const leftOut = studies.flatMap((study) => study.surfaces_left_out);
  byId("surfaces-left-out").replaceChildren(...leftOut.map((reason) => element("li", {}, `Left out: ${reason}`)));
  byId("surface").hidden = byId("surface-link").hidden = !surfaces.length && !leftOut.length;
  for (const id of ["surface-choices", "stage", "scale", "surface-facts"]) byId(id).hidden = !surfaces.length;
  if (surfaces.length) new SurfaceView(surfaces).startWhenSeen();
}
