// Small studies, run once with the program, and what they wrote.
import { execFileSync } from "node:child_process";
import { existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { fileURLToPath } from "node:url";

const program = process.env.GRIDSTEP ?? fileURLToPath(new URL("../../../build/gridstep", import.meta.url));

const flat = {
  name: "flat",
  description: "Two shapes</script><b>bold</b>",
  timing: true,
  sweeps: [
    {
      shapes: ["ellipse:a=6,b=3", "flower:radius=5,amplitude=1.5,petals=5"],
      estimators: ["ii", "mdca"],
      evaluations: ["masks", "full"],
      radii: [{ k: 2 }],
      schedule: { from: 0.5, to: 0.05, steps: 6 },
      shifts: 3,
    },
  ],
};

const solid = {
  name: "solid",
  sweeps: [
    {
      shapes: ["ellipsoid:a=4,b=3,c=2.5", "rounded-cube:radius=3"],
      estimators: ["ii", "ii-covariance"],
      evaluations: ["bricks"],
      radii: [{ k: 1.5 }],
      schedule: { from: 0.5, to: 0.15, steps: 5 },
      shifts: 2,
    },
  ],
};

const radii = {
  name: "radii",
  description: "One surface at several radii",
  detail: { shape: "ellipsoid:a=4,b=3,c=2.5", h: 0.3, digital_radii: [8, 5, 3] },
};

const large = { name: "large", detail: { shape: "sphere:radius=19", h: 0.15, estimator: "ii", digital_radii: [2] } };

const guarded = {
  name: "guarded",
  sweeps: [
    {
      shapes: ["torus:major=6,minor=2"],
      estimators: ["ii-ho1", "ii-ho1-guarded"],
      schedule: { values: [0.7, 0.5] },
      shifts: 1,
      rotate: true,
    },
  ],
};

export function runStudies() {
  const folder = mkdtempSync(join(tmpdir(), "gridstep-report-"));
  const gridstep = (...words) => execFileSync(program, words, { cwd: folder, stdio: ["ignore", "pipe", "pipe"], encoding: "utf8" });
  const study = (json, out) => {
    writeFileSync(join(folder, `${out}.json`), JSON.stringify(json));
    const said = gridstep("study", `${out}.json`, "--out", out);
    const read = (name) => readFileSync(join(folder, out, name), "utf8");
    const records = existsSync(join(folder, out, "records.jsonl")) ? read("records.jsonl").trim().split("\n").slice(1) : [];
    return {
      page: join(folder, out, "report.html"),
      said,
      read,
      summary: JSON.parse(read("summary.json")),
      records: records.map((line) => JSON.parse(line)),
    };
  };
  const studies = {
    flat: study(flat, "flat"),
    solid: study(solid, "solid"),
    guarded: study(guarded, "guarded"),
    radii: study(radii, "radii"),
    large: study(large, "large"),
  };
  study({ ...flat, seed: 2 }, "again");
  gridstep("report", "flat", "again", "--out", "both.html");
  gridstep("report", "solid", "radii", "--out", "mixed.html");
  const pages = { both: join(folder, "both.html"), mixed: join(folder, "mixed.html") };
  return { ...studies, ...pages, remove: () => rmSync(folder, { recursive: true }) };
}
