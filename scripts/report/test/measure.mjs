// How fast a page is, on this machine: npm run measure -- REPORT.html
// Opening counts until a curve can be pressed, or the table of radii is there; frames are those of the surface while it
// turns, WebGL in software.
import { statSync } from "node:fs";
import { loadavg } from "node:os";
import { resolve } from "node:path";
import { launch, open } from "./chromium.mjs";

const file = resolve(process.argv[2]);
const browser = await launch();
const start = performance.now();
const page = await open(browser, file);
await page.locator("#curves button:visible, #radii td:visible").first().click({ trial: true });
const opened = performance.now() - start;
console.log(`${(statSync(file).size / 1e6).toFixed(1)} MB, opened in ${(opened / 1000).toFixed(2)} s (load ${loadavg()[0].toFixed(1)})`);
if (await page.locator("#stage").isVisible()) {
  await page.locator("#stage").scrollIntoViewIfNeeded();
  await page.waitForSelector("#stage canvas");
  await page.click("#turn");
  const frames = 60;
  const seconds = await page.evaluate(async (count) => {
    const next = () => new Promise(requestAnimationFrame);
    await next();
    const first = await next();
    let last = first;
    for (let i = 0; i < count; ++i) last = await next();
    return (last - first) / 1000;
  }, frames);
  console.log(`${await page.locator("#surface-facts").textContent()}`.split(" · ")[0] + `: ${(frames / seconds).toFixed(1)} frames a second (load ${loadavg()[0].toFixed(1)})`);
}
await browser.close();
