// Which curves, quantity and norm are shown: the form at the top, and the curves that were pressed away.

import { byId, chosenRadio, fillRadios, fillSelect } from "./elements.js";
import { entryOf, labelsOf } from "./curves.js";
import { quantityText } from "./text.js";

const all = "all";
const mostAtOnce = 10; // curves that can still be told apart
const distinct = (values) => [...new Set(values)];

// What curves are chosen by, and the order in which one value is taken where all would be too many.
const choices = [
  { id: "shape", of: (curve) => curve.shape, everything: "all shapes" },
  { id: "noise", of: (curve) => String(curve.noise), everything: "all levels" },
  { id: "estimator", of: (curve) => curve.estimator, everything: "all estimators" },
];

export class Selection {
  #curves;
  #hidden = new Set();
  #changed = () => {};

  constructor(curves) {
    this.#curves = curves;
    for (const { id, of, everything } of choices) {
      const values = distinct(curves.map(of));
      const options = values.map((value) => [value, value]);
      fillSelect(byId(id), values.length > 1 ? [[all, everything], ...options] : options);
    }
    byId("noise").parentElement.hidden = byId("noise").options.length <= 1;
    for (const { id } of choices)
      if (this.#inForm().length > mostAtOnce && byId(id).options.length > 1) byId(id).selectedIndex = 1;
    const norms = distinct(curves.flatMap((curve) => curve.convergence.map(({ norm }) => norm)));
    fillRadios(byId("norm"), "norm", norms.map((norm) => [norm, norm]));
    this.#fillQuantities();
    byId("choices").addEventListener("change", () => {
      this.#fillQuantities();
      this.#changed();
    });
    byId("choices").addEventListener("submit", (event) => event.preventDefault());
  }

  onChange(changed) {
    this.#changed = changed;
  }

  #inForm() {
    return this.#curves.filter((curve) =>
      choices.every(({ id, of }) => [all, of(curve)].includes(byId(id).value)),
    );
  }

  #fillQuantities() {
    const quantities = distinct(this.#inForm().flatMap((curve) => curve.convergence.map(({ quantity }) => quantity)));
    fillSelect(byId("quantity"), quantities.map((quantity) => [quantity, quantityText(quantity)]));
  }

  get quantity() {
    return byId("quantity").value;
  }

  get norm() {
    return byId("norm").querySelector("input") ? chosenRadio(byId("norm")) : "";
  }

  /** The curves that the form asks for and that have errors in its quantity and norm, each with a label and a number,
   *  and whether it is visible. */
  get curves() {
    const curves = this.#inForm().filter((curve) => entryOf(curve.convergence, this));
    const labels = labelsOf(curves);
    return curves.map((curve, number) => ({
      ...curve,
      label: labels[number],
      number,
      visible: !this.#hidden.has(curve.key),
      series: entryOf(curve.convergence, this),
      points: entryOf(curve.work, this),
    }));
  }

  toggle(curve) {
    if (!this.#hidden.delete(curve.key)) this.#hidden.add(curve.key);
    this.#changed();
  }
}
