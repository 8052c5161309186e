// All tests, as ctest runs them; 77 says that they were skipped.
import { spawnSync } from "node:child_process";
import { existsSync, readdirSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { chromiumPath } from "./chromium.mjs";

const folder = fileURLToPath(new URL(".", import.meta.url));
if (!chromiumPath()) {
  console.log("skipped: there is no Chromium (Debian: apt-get install chromium); CHROMIUM may say where one is");
  process.exit(77);
}
const files = readdirSync(folder).filter((name) => name.endsWith(".test.mjs")).map((name) => folder + name);
process.exit(spawnSync(process.execPath, ["--test", ...files], { stdio: "inherit" }).status ?? 1);
