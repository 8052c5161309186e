// The digital surface: what the form asks for, on the stage, with the scale of its colours. Of several radii, all are on
// the stage side by side, in the same colours; else one estimator is chosen.

import { coloursOf, errorRange, gradientOf, valueRange } from "./colour_scale.js";
import { studyName } from "./curves.js";
import { crossesOf, DirectionLines } from "./direction_lines.js";
import { byId, chosenRadio, element, fillRadios, fillSelect, isPressed, onToggle } from "./elements.js";
import { Stage } from "./stage.js";
import { SurfaceColours } from "./surface_colours.js";
import { decodeSurface, valuesOf } from "./surface_data.js";
import { SurfaceGeometry } from "./surface_geometry.js";
import { SurfelPicture } from "./surfel_picture.js";
import { countText, digitalRadiusText, errorText, quantityText, radiusText, stepText } from "./text.js";

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
  /** Which of the surface's estimators are on the stage. */
  get #onStage() {
    return this.#surface.side_by_side ? [...this.#surface.estimators.keys()] : [this.#estimator];
  }
  /** Without a truth, there are estimates alone. */
  get #kind() {
    return this.#surface.side_by_side ? "estimate" : chosenRadio(byId("surface-colour"));
  }

  #fillEstimators() {
    const { estimators, side_by_side = false } = this.#surface;
    const choices = side_by_side ? [] : estimators;
    fillSelect(
      byId("surface-estimator"),
      choices.map((e, i) => [String(i), [e.estimator, radiusText(e)].filter(Boolean).join(", ")]),
    );
    byId("surface-estimator").parentElement.hidden = byId("surface-colour").hidden = side_by_side;
    const shown = this.#onStage.map((i) => estimators[i]);
    fillSelect(byId("surface-quantity"), shown[0].quantities.map((q) => [q, quantityText(q)]));
    byId("directions").disabled = !shown.some(({ directions }) => directions);
  }

  #arrays({ id }) {
    if (!this.#decoded.has(id)) this.#decoded.set(id, decodeSurface(JSON.parse(byId(id).textContent)));
    return this.#decoded.get(id);
  }

  #show() {
    if (!this.#stage) return;
    const arrays = this.#arrays(this.#surface);
    if (this.#shown?.surface !== this.#surface) this.#setStage(arrays);
    const quantity = byId("surface-quantity").value;
    const kind = this.#kind;
    const lists = this.#onStage.map((estimator) => valuesOf(arrays, estimator, quantity, kind));
    const scale = kind === "error" ? "errors" : "values";
    const range = kind === "error" ? errorRange(lists[0]) : valueRange(...this.#estimatesAndTruth(arrays, quantity));
    this.#shown.coloured.forEach((colours, i) => colours.colour(coloursOf(lists[i], range, scale)));
    this.#showScale(kind, quantity, scale, range);
    this.#showFacts(quantity);
    this.#showDirections();
  }

  #estimatesAndTruth(arrays, quantity) {
    const truth = arrays.truth[quantity];
    return [...this.#onStage.map((i) => arrays.estimates[i][quantity]), ...(truth ? [truth] : [])];
  }

  /** As many views as there are estimators to be seen at once, each under its radius. */
  #setStage(arrays) {
    const { estimators, side_by_side, h } = this.#surface;
    const caption = (i) => (side_by_side ? [element("figcaption", {}, digitalRadiusText(estimators[i], h))] : []);
    const views = this.#onStage.map((i) => element("figure", {}, ...caption(i), element("div", { class: "view" })));
    byId("views").classList.toggle("several", Boolean(side_by_side));
    byId("views").replaceChildren(...views);
    const picture = new SurfelPicture(new SurfaceGeometry(arrays));
    const coloured = views.map(() => new SurfaceColours(picture));
    this.#shown = { surface: this.#surface, coloured, crosses: null };
    this.#stage.show(picture, coloured, views.map((view) => view.lastChild));
  }

  #showDirections() {
    if (!this.#stage) return;
    const arrays = this.#arrays(this.#surface);
    if (!isPressed(byId("directions"))) return this.#stage.showLines([]);
    const crosses = (this.#shown.crosses ??= crossesOf(arrays));
    const directions = this.#onStage.map((i) => arrays.directions[i]);
    this.#stage.showLines(directions.map((list) => list && new DirectionLines(arrays, crosses, list)));
  }

  #showScale(kind, quantity, scale, [low, high]) {
    byId("scale").replaceChildren(
      element("span", { class: "title" }, `${kind} of ${quantityText(quantity)}`),
      element("span", { class: "gradient", style: `background:${gradientOf(scale)}` }),
      ...[low, (low + high) / 2, high].map((value) => element("span", { class: "tick" }, errorText(value))),
    );
  }

  #showFacts(quantity) {
    const { surfels, side_by_side } = this.#surface;
    byId("surface-facts").replaceChildren(
      [
        `${countText(surfels)} surfels`,
        ...(side_by_side ? this.#factsOfRadii() : this.#factsOfErrors(quantity)),
        "directions: black along κ₁, white along κ₂",
      ].join(" · "),
    );
  }

  #factsOfRadii() {
    const { estimators } = this.#surface;
    return [estimators[0].estimator, "one scale of colours for all radii, which ends where 1 % of their values together lie beyond"];
  }

  #factsOfErrors(quantity) {
    const { singular, offset, estimators } = this.#surface;
    const errors = estimators[this.#estimator].errors[quantity];
    return [
      `shift ${offset.map((x) => x.toFixed(3).replace("-", "−")).join(", ")} of a cell`,
      `error sup ${errorText(errors.sup)}, rms ${errorText(errors.rms)}`,
      ...(singular ? [`${countText(singular)} at singular points, grey`] : []),
      "colours end where 1 % of the values lie beyond",
    ];
  }
}

/** Shows the surfaces of all studies, or hides their section where there are none. */
export function startSurfaceView(studies) {
  const surfaces = studies.flatMap((study) =>
    study.surfaces.map((surface) => ({ ...surface, study: studyName(study, studies) })),
  );
  const leftOut = studies.flatMap((study) => study.surfaces_left_out);
  byId("surfaces-left-out").replaceChildren(...leftOut.map((reason) => element("li", {}, `Left out: ${reason}`)));
  byId("surface").hidden = !surfaces.length && !leftOut.length;
  for (const id of ["surface-choices", "stage", "scale", "surface-facts"]) byId(id).hidden = !surfaces.length;
  if (surfaces.length) new SurfaceView(surfaces).startWhenSeen();
}
