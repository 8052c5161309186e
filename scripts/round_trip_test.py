#!/usr/bin/env python3
"""Reads the surfaces and volumes that the program writes with readers of others (VTK, meshio, NumPy), and finds the
same points, squares and values in all of them.

    scripts/round_trip_test.py PATH_OF_GRIDSTEP     exits with 77 where a reader is missing

On Debian: apt-get install --no-install-recommends python3-vtk9 python3-meshio python3-numpy
"""

import csv
import gzip
import os
import struct
import subprocess
import sys
import tempfile
from pathlib import Path

try:
    import meshio
    import numpy as np
    import vtkmodules.vtkIOGeometry as vtk_geometry
    import vtkmodules.vtkIOXML as vtk_xml
    from vtkmodules.util.numpy_support import vtk_to_numpy
except ImportError as missing:
    # Debian's modules belong to Debian's Python, which need not be the first in the path.
    debian = "/usr/bin/python3"
    if os.path.realpath(sys.executable) != os.path.realpath(debian) and os.path.exists(debian):
        os.execv(debian, [debian, *sys.argv])
    print(f"skipped: {missing}")
    sys.exit(77)

SIZE, SPACING = (9, 8, 7), 0.5
VECTORS = ("normal", "dir1", "dir2")


def volume():
    """Two balls, so that there are two components; as z, y, x, the order of the bytes."""
    z, y, x = np.indices(SIZE[::-1])
    big = (x - 3) ** 2 + (y - 3) ** 2 + (z - 3) ** 2 <= 6
    return (big | ((x == 8) & (y == 7) & (z == 6))).astype(np.uint8)


def run(*arguments):
    return subprocess.run([sys.argv[1], *map(str, arguments)], check=True, capture_output=True, text=True, timeout=60)


def corners_of(cell, step):
    """The set of the corners of a surfel, from its Khalimsky coordinates."""
    axis = [c % 2 for c in cell].index(0)
    corners = set()
    for u in (-1, 1):
        for v in (-1, 1):
            corner = list(cell)
            corner[(axis + 1) % 3] += u
            corner[(axis + 2) % 3] += v
            corners.add(tuple(step * (c - 1) / 2 for c in corner))
    return corners


def check_mesh(what, points, squares, cells):
    assert len(squares) == len(cells), what
    assert len({tuple(p) for p in points}) == len(points), f"{what}: a vertex twice"
    for square, cell in zip(squares, cells):
        assert {tuple(points[i]) for i in square} == corners_of(cell, SPACING), what


def main():
    voxels = volume()
    with tempfile.TemporaryDirectory(prefix="gridstep_") as name:
        folder = Path(name)
        nrrd = folder / "balls.nrrd"
        s = SPACING
        nrrd.write_bytes(
            f"NRRD0004\ntype: uint8\ndimension: 3\nsizes: {SIZE[0]} {SIZE[1]} {SIZE[2]}\nspacings: {s} {s} {s}\n"
            "encoding: gzip\n\n".encode() + gzip.compress(voxels.tobytes())
        )
        files = [folder / f"balls.{kind}" for kind in ("csv", "npy", "ply", "vtp", "obj")]
        outs = [part for file in files for part in ("--out", file)]
        run("estimate", "--volume", nrrd, "--radius", 1.5, "--estimator", "ii-covariance", *outs)

        with open(files[0]) as file:
            rows = list(csv.DictReader(file))
        columns = {title: np.array([float(row[title]) for row in rows]) for title in rows[0]}
        quantities = [t for t in columns if t not in ("kx", "ky", "kz", "x", "y", "z")]
        cells = [tuple(int(row["k" + axis]) for axis in "xyz") for row in rows]
        assert set(columns["component"]) == {0, 1}

        # The surface is that of the voxels: between 1 and 0 there is a surfel, and nowhere else.
        padded = np.pad(voxels, 1).astype(int)
        assert len(rows) == sum(int(np.abs(np.diff(padded, axis=axis)).sum()) for axis in range(3))
        for cell in cells:
            axis = [c % 2 for c in cell].index(0)
            sides = []
            for step in (-1, 1):
                spel = list(cell)
                spel[axis] += step
                x, y, z = ((c - 1) // 2 + 1 for c in spel)
                sides.append(padded[z, y, x])
            assert sorted(sides) == [0, 1], cell
        for k, axis in enumerate("xyz"):
            assert np.array_equal(columns[axis], [SPACING * (cell[k] - 1) / 2 for cell in cells])

        table = np.load(files[1])
        assert list(table.dtype.names) == list(columns)
        for title, values in columns.items():
            assert np.array_equal(table[title], values), title

        ply = meshio.read(files[2])
        check_mesh("PLY", ply.points, ply.cells_dict["quad"], cells)
        for title in quantities:
            assert np.array_equal(ply.cell_data[title][0], columns[title]), f"PLY {title}"

        reader = vtk_xml.vtkXMLPolyDataReader()
        reader.SetFileName(str(files[3]))
        reader.Update()
        vtp = reader.GetOutput()
        squares = vtk_to_numpy(vtp.GetPolys().GetConnectivityArray()).reshape(-1, 4)
        check_mesh("VTP", vtk_to_numpy(vtp.GetPoints().GetData()), squares, cells)
        data = vtp.GetCellData()
        scalars = [t for t in quantities if t.rsplit("_", 1)[0] not in VECTORS]
        assert data.GetNumberOfArrays() == len(scalars) + len(VECTORS)
        for title in scalars:
            assert np.array_equal(vtk_to_numpy(data.GetArray(title)), columns[title]), f"VTP {title}"
        for vector in VECTORS:
            expected = np.column_stack([columns[f"{vector}_{axis}"] for axis in "xyz"])
            assert np.array_equal(vtk_to_numpy(data.GetArray(vector)), expected), f"VTP {vector}"

        obj = meshio.read(files[4])
        check_mesh("OBJ", obj.points, obj.cells_dict["quad"], cells)
        # VTK reads OBJ in single precision, and has a point for each pair of vertex and texture coordinate.
        reader = vtk_geometry.vtkOBJReader()
        reader.SetFileName(str(files[4]))
        reader.Update()
        obj = reader.GetOutput()
        points = vtk_to_numpy(obj.GetPoints().GetData()).astype(float)
        values = vtk_to_numpy(obj.GetPointData().GetTCoords())[:, 0]
        assert obj.GetNumberOfCells() == len(cells)
        for i, cell in enumerate(cells):
            ids = [obj.GetCell(i).GetPointId(k) for k in range(4)]
            assert {tuple(points[j]) for j in ids} == corners_of(cell, SPACING), "OBJ"
            assert all(values[j] == np.float32(columns["mean"][i]) for j in ids), "OBJ value"

        # Volumes: every format that is written holds the same voxels.
        for extension in ("vol", "longvol", "pgm3d", "raw", "nrrd"):
            copy, back = folder / f"copy.{extension}", folder / "back.nrrd"
            run("convert", nrrd, copy)
            layout = ("--size", ",".join(map(str, SIZE))) if extension == "raw" else ()
            run("convert", copy, back, *layout, "--threshold", "1,1")
            assert back.read_bytes().endswith(voxels.tobytes()), extension
        run("convert", nrrd, folder / "copy.vti")
        reader = vtk_xml.vtkXMLImageDataReader()
        reader.SetFileName(str(folder / "copy.vti"))
        reader.Update()
        vti = reader.GetOutput()
        assert vti.GetDimensions() == SIZE and vti.GetSpacing() == (SPACING,) * 3
        assert np.array_equal(vtk_to_numpy(vti.GetPointData().GetScalars()), voxels.ravel())

        # NIfTI-1 written by hand from its definition, with a scaling: 1 becomes 3.
        header = bytearray(352)
        struct.pack_into("<i", header, 0, 348)
        struct.pack_into("<8h", header, 40, 3, *SIZE, 1, 1, 1, 1)
        struct.pack_into("<2h", header, 70, 2, 8)
        struct.pack_into("<8f", header, 76, *[SPACING] * 8)
        struct.pack_into("<3f", header, 108, 352, 2, 1)
        header[344:348] = b"n+1\0"
        (folder / "balls.nii.gz").write_bytes(gzip.compress(bytes(header) + voxels.tobytes()))
        run("convert", folder / "balls.nii.gz", folder / "back.nrrd", "--threshold", "2.5,3.5")
        assert (folder / "back.nrrd").read_bytes().endswith(voxels.tobytes())
        print(f"{len(rows)} surfels, {len(quantities)} columns: the same in CSV, NPY, PLY, VTP and OBJ")


if __name__ == "__main__":
    main()
