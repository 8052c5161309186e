// Makes dist/report.html: the page without data, with its style, its code and the libraries in one file.
import { build } from "esbuild";
import { mkdir, readFile, writeFile } from "node:fs/promises";

const here = (path) => new URL(path, import.meta.url);

async function bundled(entry) {
  const result = await build({
    entryPoints: [here(entry).pathname],
    bundle: true,
    minify: true,
    write: false,
    format: entry.endsWith(".js") ? "iife" : undefined,
    target: ["chrome100", "firefox100", "safari15.4"],
    legalComments: "none",
  });
  return result.outputFiles[0].text.trim();
}

async function licence(library, name) {
  const text = await readFile(here(`node_modules/${library}/LICENSE`), "utf8");
  return `${name}\n${text.trim()}\n`;
}

const [page, style, code, ...licences] = await Promise.all([
  readFile(here("src/index.html"), "utf8"),
  bundled("src/style.css"),
  bundled("src/main.js"),
  licence("plotly.js-basic-dist-min", "plotly.js"),
  licence("three", "three.js"),
]);
const parts = {
  "<!--licences-->": `<!--\n${licences.join("\n").replaceAll("--", "- -")}-->`,
  "<!--style-->": `<style>${style}</style>`,
  // "</script" may only end the element; in code it stands in texts, where the backslash says nothing.
  "<!--code-->": `<script>${code.replaceAll("</script", "<\\/script")}</script>`,
};
let text = page;
for (const [place, part] of Object.entries(parts)) {
  if (text.split(place).length !== 2) throw new Error(`src/index.html must have one ${place}`);
  text = text.replace(place, () => part);
}
const data = "<!--gridstep-data-->"; // filled in by the program
if (text.split(data).length !== 2) throw new Error(`the page must have one ${data}`);
await mkdir(here("dist"), { recursive: true });
await writeFile(here("dist/report.html"), text);
