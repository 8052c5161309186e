// Surfels of one plane that face the same way, merged into rectangles: a digital surface has terraces, so there are four
// to five times fewer of them.

/** Axis of the normal: the one even coordinate of a surfel. */
function axisOf(cells, surfel) {
  for (let axis = 0; axis < 3; ++axis) if (cells[3 * surfel + axis] % 2 === 0) return axis;
  throw new Error("not a surfel");
}

/** Runs along u in one row, from surfels sorted by u. */
function* runsOf(row, u) {
  let run = [row[0]];
  for (const surfel of row.slice(1)) {
    if (u(surfel) !== u(run.at(-1)) + 2) {
      yield run;
      run = [];
    }
    run.push(surfel);
  }
  yield run;
}

/** Consecutive surfels with the same key. */
function* groupsBy(surfels, key) {
  for (let first = 0, next; first < surfels.length; first = next) {
    for (next = first + 1; next < surfels.length && key(surfels[next]) === key(surfels[first]); ) ++next;
    yield surfels.slice(first, next);
  }
}

/** Runs that end where those of the row before end belong to one rectangle. */
function rectanglesOfPlane(plane, u, v) {
  const finished = [];
  let open = new Map();
  let above = -Infinity;
  for (const row of groupsBy(plane, v)) {
    const adjacent = v(row[0]) === above + 2;
    const next = new Map();
    for (const run of runsOf(row, u)) {
      const key = `${u(run[0])} ${run.length}`;
      const rectangle = (adjacent && open.get(key)) || { width: run.length, surfels: [] };
      if (!rectangle.surfels.length) finished.push(rectangle);
      rectangle.surfels.push(...run);
      next.set(key, rectangle);
    }
    above = v(row[0]);
    open = next;
  }
  return finished;
}

/**
 * Six groups, by axis and sign of the normal; in each, rectangles sorted along the axis. A rectangle has its width and
 * its surfels, row by row: along u = axis + 1 (cyclically), rows along v = axis + 2.
 */
export function rectanglesOf({ cells, signs }) {
  const groups = [0, 1, 2].flatMap((axis) => [1, -1].map((sign) => ({ axis, sign, surfels: [] })));
  signs.forEach((sign, surfel) => groups[2 * axisOf(cells, surfel) + (sign > 0 ? 0 : 1)].surfels.push(surfel));
  return groups.map(({ axis, sign, surfels }) => {
    const coordinate = (k) => (surfel) => cells[3 * surfel + (k % 3)];
    const [along, u, v] = [coordinate(axis), coordinate(axis + 1), coordinate(axis + 2)];
    surfels.sort((a, b) => along(a) - along(b) || v(a) - v(b) || u(a) - u(b));
    return { axis, sign, rectangles: [...groupsBy(surfels, along)].flatMap((plane) => rectanglesOfPlane(plane, u, v)) };
  });
}
