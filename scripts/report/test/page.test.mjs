// The page in Chromium: what it shows is what the program wrote, and everything on it works.
import assert from "node:assert/strict";
import { after, before, describe, test } from "node:test";
import { launch, open } from "./chromium.mjs";
import { runStudies } from "./studies.mjs";
import { decodeSurface, valuesOf } from "../src/surface_data.js";
import { errorText, intervalText, slopeText } from "../src/text.js";

let studies, browser;
before(async () => {
  studies = runStudies();
  browser = await launch();
});
after(async () => {
  await browser?.close();
  studies?.remove();
});

async function withPage(file, options, use) {
  const page = await open(browser, file, options);
  try {
    await use(page);
    assert.deepEqual(page.complaints, []);
  } finally {
    await page.context().close();
  }
}

/** Traces of a chart that have this meaning. */
const traces = (page, chart, meta) =>
  page.evaluate(
    ([id, wanted]) =>
      document.getElementById(id).data.filter((trace) => trace.meta === wanted).map(({ x, y, name }) => ({ x: [...x], y: [...y], name })),
    [chart, meta],
  );

const near = (actual, expected) => {
  assert.equal(actual.length, expected.length);
  actual.forEach((value, i) => assert.ok(Math.abs(value - expected[i]) <= 1e-12 * Math.abs(expected[i]), `${value} is not ${expected[i]}`));
};
const mean = (values) => values.reduce((sum, value) => sum + value, 0) / values.length;

describe("what is shown", () => {
  test("error curves, bands, fits and slopes are those of summary.json", () =>
    withPage(studies.flat.page, {}, async (page) => {
      assert.equal(await page.title(), "flat – Gridstep");
      for (const norm of ["sup", "rms", "mean"]) {
        await page.locator(`label[for=norm-${norm}]`).click();
        const series = studies.flat.summary.convergence.filter((entry) => entry.norm === norm);
        assert.equal(series.length, 4);
        const [means, lower, upper, fits] = await Promise.all(
          ["mean", "lower", "upper", "fit"].map((meta) => traces(page, "errors-chart", meta)),
        );
        const buttons = await page.locator("#curves button").allTextContents();
        series.forEach((entry, i) => {
          const h = entry.levels.map((level) => level.h);
          near(means[i].x, h);
          near(means[i].y, entry.levels.map((level) => mean(level.errors)));
          near(lower[i].y, entry.levels.map((level) => Math.min(...level.errors)));
          near(upper[i].y, entry.levels.map((level) => Math.max(...level.errors)));
          near(fits[i].y, fits[i].x.map((step) => entry.constant * step ** entry.slope));
          assert.ok(buttons[i].includes(`${slopeText(entry.slope)} ${intervalText(entry.interval)}`), buttons[i]);
          assert.ok(buttons[i].endsWith(entry.verdict), buttons[i]);
        });
        const references = await traces(page, "errors-chart", "reference");
        assert.deepEqual(new Set(series.map((entry) => entry.expected).filter((p) => p !== null)).size, references.length);
        for (const { x, y } of references) near([Math.log(y[1] / y[0]) / Math.log(x[1] / x[0])], [1 / 3]);
      }
    }));

  test("so are the scan, the times and their exponents, and work and precision", () =>
    withPage(studies.flat.page, {}, async (page) => {
      const { convergence, cost, work_precision } = studies.flat.summary;
      const sup = ({ norm }) => norm === "sup";
      const scans = await traces(page, "scan-chart", "scan");
      convergence.filter(sup).forEach(({ scan }, i) => {
        near(scans[i].x, scan.map((row) => row.coarsest));
        near(scans[i].y, scan.map((row) => row.slope));
      });
      const times = await traces(page, "time-chart", "time");
      const exponents = await page.locator("#exponents tbody tr").allTextContents();
      const fits = await traces(page, "time-chart", "fit");
      assert.equal(times.length, cost.length);
      cost.forEach(({ steps, time_in_h }, i) => {
        near(times[i].y, steps.map((step) => step.seconds_eval));
        near([Math.log(fits[i].y[1] / fits[i].y[0]) / Math.log(fits[i].x[1] / fits[i].x[0])].map((p) => Number(p.toFixed(9))), [Number(time_in_h.toFixed(9))]);
        assert.ok(exponents[i].includes(time_in_h.toFixed(2).replace("-", "−")), exponents[i]);
      });
      const points = await traces(page, "work-chart", "work");
      work_precision.filter(sup).forEach((curve, i) => {
        near(points[i].x, curve.points.map((point) => point.seconds));
        near(points[i].y, curve.points.map((point) => point.error));
      });
    }));

  test("the choices leave the curves that they name", () =>
    withPage(studies.solid.page, {}, async (page) => {
      const { convergence } = studies.solid.summary;
      await page.selectOption("#estimator", "ii-covariance");
      await page.selectOption("#shape", { index: 2 });
      await page.selectOption("#quantity", "gaussian");
      const shape = await page.inputValue("#shape");
      const wanted = convergence.filter(
        (e) => e.shape === shape && e.estimator === "ii-covariance" && e.quantity === "gaussian" && e.norm === "sup",
      );
      const shown = await traces(page, "errors-chart", "mean");
      assert.equal(shown.length, 1);
      near(shown[0].y, wanted[0].levels.map((level) => mean(level.errors)));
      assert.equal(await page.locator("#slopes tbody tr").count(), 1);
    }));

  test("the table has every series, and sorts by its columns", () =>
    withPage(studies.flat.page, {}, async (page) => {
      await page.locator("#everything").check();
      const rows = page.locator("#slopes tbody tr");
      assert.equal(await rows.count(), studies.flat.summary.convergence.length);
      const title = page.locator("#slopes th button", { hasText: /^slope$/ });
      const column = await page.locator("#slopes th").allTextContents().then((titles) => titles.findIndex((t) => t.startsWith("slope")));
      const shown = async () => page.locator(`#slopes tbody td:nth-child(${column + 1})`).allTextContents();
      const slopes = studies.flat.summary.convergence.map(({ slope }) => slope).sort((a, b) => a - b).map(slopeText);
      await title.click();
      assert.deepEqual(await shown(), slopes);
      assert.equal(await page.locator("#slopes th[aria-sort=ascending]").count(), 1);
      await title.click();
      assert.deepEqual(await shown(), slopes.reverse());
      assert.ok(await title.evaluate((button) => button === document.activeElement), "the title keeps the focus");
    }));

  test("the table says where a guard fell back, and what was rotated", () =>
    withPage(studies.guarded.page, {}, async (page) => {
      await page.locator("#everything").check();
      const cells = async (title) => {
        const titles = await page.locator("#slopes th").allTextContents();
        return page.locator(`#slopes tbody td:nth-child(${titles.indexOf(title) + 1})`).allTextContents();
      };
      const { work, surfels } = studies.guarded.records.find((r) => r.estimator === "ii-ho1-guarded" && r.h === 0.5);
      const share = `${((100 * work.fallbacks) / surfels).toPrecision(3)} %`;
      const estimators = await cells("estimator");
      assert.deepEqual(
        await cells("fallbacks there"),
        estimators.map((name) => (name === "ii-ho1-guarded" ? share : "none")),
      );
      assert.ok((await cells("shape")).every((shape) => shape === "torus:major=6,minor=2, rotated"));
    }));

  test("provenance is there, and texts are texts", () =>
    withPage(studies.flat.page, {}, async (page) => {
      assert.equal(await page.locator("#subtitle").textContent(), "Two shapes</script><b>bold</b>");
      const text = await page.locator("#provenance").textContent();
      const { commit, compiler, cpu } = studies.flat.summary.provenance;
      for (const part of [commit, compiler, cpu]) assert.ok(text.includes(part), part);
    }));

  test("several studies stand side by side", () =>
    withPage(studies.both, {}, async (page) => {
      await page.selectOption("#shape", { index: 1 });
      await page.selectOption("#estimator", "ii");
      const names = (await traces(page, "errors-chart", "mean")).map(({ name }) => name);
      assert.deepEqual(names, ["flat (flat)", "flat (again)"]);
      assert.equal(await page.locator("#provenances article").count(), 2);
    }));
});

describe("toggles", () => {
  test("a curve pressed away leaves all charts, and comes back", () =>
    withPage(studies.flat.page, {}, async (page) => {
      const counts = async () =>
        Promise.all(
          [["errors-chart", "mean"], ["scan-chart", "scan"], ["time-chart", "time"], ["work-chart", "work"]].map(
            async ([chart, meta]) => (await traces(page, chart, meta)).length,
          ),
        );
      const button = page.locator("#curves button").first();
      assert.deepEqual(await counts(), [4, 4, 6, 4]);
      await button.click();
      assert.equal(await button.getAttribute("aria-pressed"), "false");
      assert.deepEqual(await counts(), [3, 3, 4, 3]);
      await button.click();
      assert.deepEqual(await counts(), [4, 4, 6, 4]);
    }));

  test("dark as the system, and by the button", async () => {
    const paper = (page) => page.evaluate(() => getComputedStyle(document.body).backgroundColor);
    const ink = (page) => page.evaluate(() => document.getElementById("errors-chart").data.at(-1).line.color);
    await withPage(studies.flat.page, { colorScheme: "dark" }, async (page) => {
      const [dark, darkInk] = [await paper(page), await ink(page)];
      assert.equal(await page.locator("#theme").getAttribute("aria-pressed"), "true");
      await page.click("#theme");
      assert.notEqual(await paper(page), dark);
      assert.notEqual(await ink(page), darkInk);
      await page.click("#theme");
      assert.equal(await paper(page), dark);
    });
  });

  test("everything is reached and worked by the keyboard", () =>
    withPage(studies.solid.page, {}, async (page) => {
      await page.locator("#stage").scrollIntoViewIfNeeded();
      await page.waitForSelector("#stage canvas");
      await page.evaluate(() => document.activeElement.blur());
      const reached = new Set();
      for (let i = 0; i < 200; ++i) {
        await page.keyboard.press("Tab");
        const at = await page.evaluate(() => {
          const { activeElement: node } = document;
          if (node === document.body) return null;
          const seen = node.type === "radio" ? node.nextElementSibling : node;
          const name = node.getAttribute("aria-label") || node.labels?.[0]?.textContent || node.textContent;
          return { id: node.id || node.parentElement.id || node.tagName, outline: getComputedStyle(seen).outlineStyle, name };
        });
        if (!at) break;
        assert.notEqual(at.outline, "none", `${at.id} does not show the focus`);
        if (at.id !== "provenances") assert.ok(at.name?.trim(), `${at.id} has no name`);
        reached.add(at.id);
      }
      for (const id of ["theme", "shape", "estimator", "quantity", "norm-sup", "everything", "surface-shape", "surface-estimator", "surface-quantity", "surface-colour-estimate", "turn", "stage"])
        assert.ok(reached.has(id), `${id} is not reached`);
      await page.locator("#curves button").first().focus();
      await page.keyboard.press("Space");
      assert.equal(await page.locator("#curves button").first().getAttribute("aria-pressed"), "false");
      assert.ok(await page.evaluate(() => document.activeElement.closest("#curves")), "the focus stays");
      await page.locator("#norm-sup").focus();
      await page.keyboard.press("ArrowRight");
      assert.ok(await page.locator("#norm-rms").isChecked());
    }));
});

/** How many different colours an element shows, and a sum that tells pictures apart. */
const pictureOf = async (page, locator) => {
  const image = (await locator.screenshot()).toString("base64");
  return page.evaluate(async (data) => {
    const bitmap = await createImageBitmap(await new Promise((done) => {
      const bytes = Uint8Array.from(atob(data), (c) => c.charCodeAt(0));
      done(new Blob([bytes], { type: "image/png" }));
    }));
    const context = new OffscreenCanvas(bitmap.width, bitmap.height).getContext("2d");
    context.drawImage(bitmap, 0, 0);
    const pixels = new Uint32Array(context.getImageData(0, 0, bitmap.width, bitmap.height).data.buffer);
    let sum = 0;
    for (const pixel of pixels) sum = (sum * 31 + pixel) % 4294967291;
    return { colours: new Set(pixels).size, sum };
  }, image);
};
const picture = (page) => pictureOf(page, page.locator("#stage canvas"));
/** Until two pictures in a row are the same. */
const atRest = async (page) => {
  for (let before = await picture(page), i = 0; ; ++i) {
    await page.waitForTimeout(500);
    const now = await picture(page);
    if (now.sum === before.sum || i > 40) return now;
    before = now;
  }
};
const show = async (page) => {
  await page.locator("#stage").scrollIntoViewIfNeeded();
  await page.waitForSelector("#stage canvas");
  return atRest(page);
};

describe("the surface", () => {
  test("is drawn, coloured, turned, and shows directions", () =>
    withPage(studies.solid.page, {}, async (page) => {
      const pictures = [await show(page)];
      assert.ok(pictures[0].colours > 50, `${pictures[0].colours} colours`);
      const next = async (action) => {
        await action();
        pictures.push(await atRest(page));
      };
      await next(() => page.locator("label[for=surface-colour-truth]").click());
      await next(() => page.locator("label[for=surface-colour-error]").click());
      assert.ok((await page.locator("#scale").textContent()).startsWith("error of mean curvature"));
      await next(() => page.selectOption("#surface-estimator", { label: "ii-covariance, R = 1.5 h^(1/3)" }));
      await next(() => page.selectOption("#surface-quantity", "gaussian"));
      await next(() => page.click("#directions"));
      await next(() => page.locator("#stage canvas").press("ArrowLeft"));
      await next(() => page.locator("#stage canvas").press("+"));
      await next(() => page.selectOption("#surface-shape", { index: 1 }));
      assert.equal(new Set(pictures.map(({ sum }) => sum)).size, pictures.length, "every action changes the picture");
    }));

  test("turns by itself, until told to stop", () =>
    withPage(studies.solid.page, {}, async (page) => {
      await show(page);
      await page.click("#turn");
      const before = await picture(page);
      await page.waitForTimeout(1500);
      assert.notEqual((await picture(page)).sum, before.sum);
      await page.click("#turn");
      const stopped = await atRest(page);
      await page.waitForTimeout(1000);
      assert.equal((await picture(page)).sum, stopped.sum);
    }));

  test("has the numbers of the records", () =>
    withPage(studies.solid.page, {}, async (page) => {
      const { surfaces } = await page.evaluate(() => JSON.parse(document.getElementById("report-data").textContent).studies[0]);
      assert.equal(surfaces.length, 2);
      for (const { id, shape, h, estimators } of surfaces) {
        const arrays = decodeSurface(JSON.parse(await page.evaluate((place) => document.getElementById(place).textContent, id)));
        estimators.forEach(({ estimator, quantities }, i) => {
          const record = studies.solid.records.find((r) => r.shape === shape && r.h === h && r.shift === 0 && r.estimator === estimator);
          assert.equal(arrays.signs.length, record.surfels);
          for (const quantity of quantities) {
            const errors = valuesOf(arrays, i, quantity, "error").filter((e) => !Number.isNaN(e));
            assert.equal(errors.length, record.errors[quantity].count);
            const sup = errors.reduce((most, e) => Math.max(most, Math.abs(e)), 0);
            assert.ok(Math.abs(sup - record.errors[quantity].sup) < 1e-5 * record.errors[quantity].sup, `${shape} ${quantity}`);
          }
        });
      }
    }));

  test("gives way to a sentence where there is no WebGL", () => {
    const before = () => {
      const original = HTMLCanvasElement.prototype.getContext;
      HTMLCanvasElement.prototype.getContext = function (kind, ...rest) {
        return kind.startsWith("webgl") ? null : original.call(this, kind, ...rest);
      };
    };
    return withPage(studies.solid.page, { before }, async (page) => {
      await page.locator("#stage").scrollIntoViewIfNeeded();
      await page.getByText("This browser has no WebGL").waitFor();
    });
  });
});

describe("one surface at several radii", () => {
  const radii = () => studies.radii.summary.detail.levels;
  const views = (page) => page.locator("#views .view");
  const pictures = async (page) => {
    await atRest(page);
    return Promise.all(radii().map((_, i) => pictureOf(page, views(page).nth(i))));
  };
  const sums = (list) => list.map(({ sum }) => sum);
  const allDiffer = (before, after, what) => before.forEach((sum, i) => assert.notEqual(sum, after[i], `${what}: view ${i}`));
  const arraysOf = async (page) => decodeSurface(JSON.parse(await page.evaluate(() => document.getElementById("surface-0").textContent)));

  test("stands side by side, each radius named, without what has nothing to show", () =>
    withPage(studies.radii.page, {}, async (page) => {
      await show(page);
      assert.deepEqual(await page.locator("#views figcaption").allTextContents(), ["R = 2.4, 8 voxels", "R = 1.5, 5 voxels", "R = 0.9, 3 voxels"]);
      const boxes = await Promise.all(radii().map((_, i) => views(page).nth(i).boundingBox()));
      for (const { y, width } of boxes) assert.deepEqual([y, width].map(Math.round), [boxes[0].y, boxes[0].width].map(Math.round));
      assert.ok(boxes[0].x + boxes[0].width < boxes[1].x);
      assert.equal(await page.locator("canvas").count(), 1, "one context");
      assert.deepEqual(await page.locator("nav a:visible").allTextContents(), ["Surface", "Radii", "Provenance"]);
      for (const id of ["convergence", "surface-estimator", "surface-colour"]) assert.ok(!(await page.locator(`#${id}`).isVisible()), id);
      assert.equal(await page.locator(".chart:visible").count(), 0);
      const provenance = await page.locator("#provenance").textContent();
      assert.ok(provenance.includes(studies.radii.summary.provenance.compiler) && !provenance.includes("undefined"), provenance);
    }));

  test("every view is drawn, and follows the quantity, the directions and the camera", () =>
    withPage(studies.radii.page, {}, async (page) => {
      await page.addStyleTag({ content: "canvas { outline: none !important }" }); // of the focus: no part of the pictures
      await show(page);
      const first = await pictures(page);
      for (const { colours } of first) assert.ok(colours > 50, `${colours} colours`);
      assert.equal(new Set(sums(first)).size, 3, "radii differ");
      let before = sums(first);
      for (const [what, action] of [
        ["quantity", () => page.selectOption("#surface-quantity", "gaussian")],
        ["directions", () => page.click("#directions")],
        ["turned", () => page.locator("#stage canvas").press("ArrowLeft")],
        ["closer", () => page.locator("#stage canvas").press("+")],
      ]) {
        await action();
        const after = sums(await pictures(page));
        allDiffer(before, after, what);
        before = after;
      }
      await page.click("#directions");
      const without = sums(await pictures(page));
      allDiffer(before, without, "without directions");
      await page.click("#directions");
      assert.deepEqual(sums(await pictures(page)), before, "and with them again");
    }));

  test("one scale of colours spans the values of all radii, and says so", () =>
    withPage(studies.radii.page, {}, async (page) => {
      await show(page);
      const { estimates } = await arraysOf(page);
      for (const quantity of ["mean", "gaussian", "k1", "k2"]) {
        await page.selectOption("#surface-quantity", quantity);
        const all = Float32Array.from(estimates.flatMap((columns) => [...columns[quantity]])).sort();
        const at = (part) => errorText(all[Math.round(part * (all.length - 1))]);
        const ticks = await page.locator("#scale .tick").allTextContents();
        assert.deepEqual([ticks[0], ticks[2]], [at(0.01), at(0.99)], quantity);
      }
      assert.match(await page.locator("#surface-facts").textContent(), /one scale of colours for all radii, which ends where 1 %/);
    }));

  test("values are those of the files, the table that of summary.json", () =>
    withPage(studies.radii.page, {}, async (page) => {
      const { signs, truth, estimates, directions } = await arraysOf(page);
      assert.deepEqual(truth, {});
      assert.equal(signs.length, studies.radii.summary.detail.surfels);
      const rows = await page.locator("#radii tbody tr").evaluateAll((list) => list.map((row) => [...row.cells].map((cell) => cell.textContent)));
      assert.equal(rows.length, 4 * 3);
      radii().forEach(({ quantities, surfaces, digital_radius, radius }, i) => {
        assert.equal(directions[i].length, 6 * signs.length);
        const ply = studies.radii.read(surfaces.find((name) => name.endsWith(".ply"))).split("\n");
        const header = ply.indexOf("end_header");
        const titles = ply.slice(ply.findIndex((line) => line.startsWith("property list")) + 1, header).map((line) => line.split(" ")[2]);
        const faces = ply.slice(-signs.length - 1, -1).map((line) => line.split(" "));
        ["mean", "gaussian", "k1", "k2"].forEach((quantity, q) => {
          const expected = Float32Array.from(faces, (words) => Number(words[5 + titles.indexOf(quantity)]));
          assert.deepEqual(estimates[i][quantity], expected);
          const { mean: average, quantiles } = quantities[quantity];
          const numbers = [digital_radius, radius].map((value) => String(Number(value.toPrecision(4))));
          assert.deepEqual(rows[3 * q + i].slice(1), [...numbers, ...[average, ...quantiles].map(errorText)]);
        });
      });
    }));

  test("is reached and turned by the keyboard", () =>
    withPage(studies.radii.page, {}, async (page) => {
      await show(page);
      await page.evaluate(() => document.activeElement.blur());
      const reached = [];
      for (let i = 0; i < 40; ++i) {
        await page.keyboard.press("Tab");
        const at = await page.evaluate(() => document.activeElement.id || document.activeElement.tagName);
        if (at === "BODY") break;
        reached.push(at);
        if (at === "CANVAS") assert.ok(await page.evaluate(() => document.activeElement.getAttribute("aria-label")));
      }
      for (const id of ["theme", "surface-shape", "surface-quantity", "directions", "turn", "CANVAS"]) assert.ok(reached.includes(id), `${id}: ${reached}`);
      for (const id of ["surface-estimator", "estimator", "everything"]) assert.ok(!reached.includes(id), id);
    }));

  test("stands beside other studies", () =>
    withPage(studies.mixed, {}, async (page) => {
      await show(page);
      assert.equal(await page.locator(".chart:visible").count(), 4);
      assert.equal(await page.locator("#views .view").count(), 1);
      await page.selectOption("#surface-shape", { index: 2 });
      await atRest(page);
      assert.equal(await page.locator("#views .view").count(), 3);
      assert.ok((await pictureOf(page, views(page).last())).colours > 50);
      assert.ok(!(await page.locator("#surface-estimator").isVisible()));
      await page.selectOption("#surface-shape", { index: 0 });
      await atRest(page);
      assert.equal(await page.locator("#views .view").count(), 1);
      assert.ok((await picture(page)).colours > 50);
      assert.ok(await page.locator("#surface-estimator").isVisible());
      assert.equal(await page.locator("#radii table").count(), 1);
    }));

  test("that is too large is left out, and both page and terminal say so", () =>
    withPage(studies.large.page, {}, async (page) => {
      const { surfels } = studies.large.summary.detail;
      const reason = new RegExp(`sphere:radius=19 at h = 0.15: ${surfels} surfels, more than the 200000 that a page shows`);
      assert.match(await page.locator("#surfaces-left-out").textContent(), reason);
      assert.match(studies.large.said.replaceAll(/\s+/g, " "), reason);
      assert.ok(!(await page.locator("#stage").isVisible()));
      assert.equal(await page.locator("#radii tbody tr").count(), 1);
    }));
});

describe("every width", () => {
  for (const width of [400, 1600])
    for (const name of ["solid", "radii"])
      test(`${name}: ${width} px without scrolling sideways`, () =>
        withPage(studies[name].page, { viewport: { width, height: 900 } }, async (page) => {
          if (name === "solid") await page.locator("#everything").check();
          await page.locator("#stage").scrollIntoViewIfNeeded();
          await page.waitForSelector("#stage canvas");
          assert.equal(await page.evaluate(() => document.scrollingElement.scrollWidth), width);
          const tooWide = await page.evaluate(() =>
            [...document.querySelectorAll("select, button, .chart, #stage, .view, h1, h2, fieldset")]
              .filter((node) => !node.closest(".scroll") && node.getBoundingClientRect().right > innerWidth)
              .map((node) => node.id || node.textContent),
          );
          assert.deepEqual(tooWide, []);
        }));

  test("on a narrow screen, radii stand one above the other, and those scrolled to are drawn", () =>
    withPage(studies.radii.page, { viewport: { width: 400, height: 500 } }, async (page) => {
      await show(page);
      const places = page.locator("#views .view");
      const boxes = await Promise.all([0, 1, 2].map((i) => places.nth(i).boundingBox()));
      assert.ok(boxes[0].y + boxes[0].height < boxes[1].y && boxes[1].y + boxes[1].height < boxes[2].y);
      await page.evaluate(() => scrollTo({ top: 0, behavior: "instant" }));
      await places.nth(2).scrollIntoViewIfNeeded();
      await page.waitForTimeout(1000);
      assert.ok((await pictureOf(page, places.nth(2))).colours > 50);
    }));
});
