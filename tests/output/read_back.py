#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Opens every .pvd, .vtp and .vti file in a folder with VTK's own readers.

    read_back.py FOLDER [EXPECTATIONS.json]

Without expectations each file has to be read without an error of VTK, with a time, arrays of the length of
its points or cells, connectivity within its points, and finite positions; each frame of a .pvd has to exist
and hold the time that the .pvd gives. Expectations name files (relative to the folder) and what they hold:

    {"p.vtp": {"points": 2, "cells": 2, "cell_size": 1, "time": 0.5, "positions": [[x, y, z], ...],
               "point_data": {"radius": {"type": "float", "values": [...]}}, "cell_data": {...},
               "extent": [...], "origin": [...], "spacing": [...]}}

A value null stands for NaN. Values of type float are compared to 1e-6, all others exactly. Ends with status
1 and a line per fault on stderr.
"""
import json
import math
import pathlib
import sys
import xml.etree.ElementTree

from vtkmodules.vtkCommonCore import vtkStringOutputWindow
from vtkmodules.vtkIOXML import vtkXMLImageDataReader, vtkXMLPolyDataReader

READERS = {".vtp": vtkXMLPolyDataReader, ".vti": vtkXMLImageDataReader}
SINGLE = 1e-6  # relative, of numbers stored with 24 bits


class Faults:
    def __init__(self):
        self.lines = []

    def check(self, good, where, text):
        if not good:
            self.lines.append(f"{where}: {text}")


def read(path, faults):
    """The data set of a file; whatever VTK says meanwhile is a fault."""
    reader = READERS[path.suffix]()
    for source in (reader, reader.GetExecutive()):
        source.AddObserver("ErrorEvent", lambda *_: faults.check(False, path, "VTK reports an error"))
        source.AddObserver("WarningEvent", lambda *_: faults.check(False, path, "VTK gives a warning"))
    reader.SetFileName(str(path))
    faults.check(reader.CanReadFile(str(path)), path, "VTK cannot read this file")
    reader.Update()
    faults.check(reader.GetErrorCode() == 0, path, f"VTK error code {reader.GetErrorCode()}")
    return reader.GetOutput()


def values_of(array):
    return [array.GetComponent(i, k)
            for i in range(array.GetNumberOfTuples()) for k in range(array.GetNumberOfComponents())]


def time_of(data):
    array = data.GetFieldData().GetArray("TimeValue")
    return array.GetValue(0) if array and array.GetNumberOfTuples() == 1 else None


def check_shape(path, data, faults):
    """What holds for every file."""
    faults.check(time_of(data) is not None, path, "has no TimeValue")
    for owner, count in ((data.GetPointData(), data.GetNumberOfPoints()),
                         (data.GetCellData(), data.GetNumberOfCells())):
        for i in range(owner.GetNumberOfArrays()):
            array = owner.GetArray(i)
            faults.check(array is not None and array.GetNumberOfTuples() == count, path,
                         f"array {owner.GetArrayName(i)} has a wrong length")
    if path.suffix != ".vtp" or data.GetNumberOfPoints() == 0:
        return
    faults.check(all(math.isfinite(x) for x in values_of(data.GetPoints().GetData())), path,
                 "has a position that is not finite")
    for kind in (data.GetVerts(), data.GetPolys()):
        if kind.GetNumberOfCells() > 0:
            low, high = kind.GetConnectivityArray().GetRange()
            faults.check(low >= 0 and high < data.GetNumberOfPoints(), path, "connectivity leaves the points")


def same(found, wanted, tolerance):
    if wanted is None:
        return math.isnan(found)
    return abs(found - wanted) <= tolerance * abs(wanted)


def check_values(where, array, wanted, faults):
    if array is None:
        faults.check(False, where, "is missing")
        return
    faults.check(array.GetDataTypeAsString() == wanted["type"], where,
                 f"has type {array.GetDataTypeAsString()}, not {wanted['type']}")
    found = values_of(array)
    faults.check(len(found) == len(wanted["values"]), where, f"has {len(found)} values")
    tolerance = SINGLE if wanted["type"] == "float" else 0.0
    for i, (value, target) in enumerate(zip(found, wanted["values"])):
        if not same(value, target, tolerance):
            faults.check(False, where, f"value {i} is {value!r}, not {target!r}")
            return


def check_expected(path, data, wanted, faults):
    def equal(key, found):
        if key in wanted:
            faults.check(found == wanted[key], path, f"{key} is {found}, not {wanted[key]}")

    equal("points", data.GetNumberOfPoints())
    equal("cells", data.GetNumberOfCells())
    equal("time", time_of(data))
    if path.suffix == ".vti":
        equal("extent", list(data.GetExtent()))
        equal("origin", list(data.GetOrigin()))
        equal("spacing", list(data.GetSpacing()))
    if "cell_size" in wanted:
        sizes = {data.GetCell(i).GetNumberOfPoints() for i in range(data.GetNumberOfCells())}
        faults.check(sizes == {wanted["cell_size"]}, path, f"cells have {sizes} points")
    if "connectivity" in wanted:
        found = values_of(data.GetPolys().GetConnectivityArray())
        faults.check(found == wanted["connectivity"], path, f"connectivity is {found}")
    if "positions" in wanted:
        found = [list(data.GetPoint(i)) for i in range(data.GetNumberOfPoints())]
        faults.check(found == wanted["positions"], path, "positions differ")
    for key, owner in (("point_data", data.GetPointData()), ("cell_data", data.GetCellData())):
        for name, values in wanted.get(key, {}).items():
            check_values(f"{path}: {name}", owner.GetArray(name), values, faults)


def check_series(path, faults):
    """Each frame of a collection exists, can be read and has its time."""
    last = -math.inf
    for frame in xml.etree.ElementTree.parse(path).getroot().iter("DataSet"):
        time, file = float(frame.get("timestep")), path.parent / frame.get("file")
        faults.check(time >= last, path, f"time goes back to {time}")
        last = time
        if not file.is_file():
            faults.check(False, path, f"frame {file} is missing")
            continue
        found = time_of(read(file, faults))
        faults.check(found == time, path, f"frame {file} has time {found}, not {time}")
    faults.check(last > -math.inf, path, "has no frames")


def main():
    folder = pathlib.Path(sys.argv[1])
    expectations = json.loads(pathlib.Path(sys.argv[2]).read_text()) if len(sys.argv) > 2 else {}
    # A window of text instead of stderr, so that what VTK says beside its events is noticed as well.
    window = vtkStringOutputWindow()
    window.SetInstance(window)
    faults = Faults()
    count = 0
    for path in sorted(folder.rglob("*")):
        if path.suffix in READERS:
            data = read(path, faults)
            check_shape(path, data, faults)
            check_expected(path, data, expectations.pop(str(path.relative_to(folder)), {}), faults)
            count += 1
        elif path.suffix == ".pvd":
            check_series(path, faults)
            count += 1
    faults.check(count > 0, folder, "holds no files for VTK")
    for name in expectations:
        faults.check(False, folder / name, "is missing")
    faults.check(not window.GetOutput(), folder, f"VTK says {window.GetOutput()}")
    for line in faults.lines:
        print(line, file=sys.stderr)
    print(f"{count} files read, {len(faults.lines)} faults")
    return 1 if faults.lines else 0


if __name__ == "__main__":
    sys.exit(main())
