// Making elements; texts are never read as HTML.

export function element(name, attributes = {}, ...children) {
  const made = document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
  made.append(...children);
  return made;
}

export const byId = (id) => document.getElementById(id);

/** Fills a select with [value, text] pairs, and keeps the value chosen where it is still among them. */
export function fillSelect(select, options, wanted = select.value) {
  select.replaceChildren(...options.map(([value, text]) => element("option", { value }, text)));
  if (options.some(([value]) => value === wanted)) select.value = wanted;
}

/** Radio buttons in a fieldset; the first is chosen. */
export function fillRadios(fieldset, name, options) {
  options.forEach(([value, text], i) => {
    const input = element("input", { type: "radio", name, value, id: `${name}-${value}` });
    input.checked = i === 0;
    fieldset.append(input, element("label", { for: input.id }, text));
  });
}

export const chosenRadio = (fieldset) => fieldset.querySelector("input:checked").value;

export function isPressed(button) {
  return button.getAttribute("aria-pressed") === "true";
}

/** A button that is either pressed or not. */
export function onToggle(button, changed) {
  button.addEventListener("click", () => {
    button.setAttribute("aria-pressed", String(!isPressed(button)));
    changed(isPressed(button));
  });
}
