#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Prints what VTK's own readers find in the frames of a .pvd series, as JSON."""
import json
import os
import sys
import xml.etree.ElementTree

from vtkmodules.vtkCommonCore import vtkStringOutputWindow, vtkOutputWindow
from vtkmodules.vtkIOXML import vtkXMLImageDataReader, vtkXMLPolyDataReader

series = sys.argv[1]
complaints = vtkStringOutputWindow()
vtkOutputWindow.SetInstance(complaints)


def values(arrays, name):
    array = arrays.GetArray(name)
    return [array.GetValue(k) for k in range(array.GetNumberOfValues())] if array else None


def opened(path):
    grid = path.endswith(".vti")
    reader = vtkXMLImageDataReader() if grid else vtkXMLPolyDataReader()
    if not reader.CanReadFile(path):
        sys.exit(f"{path}: VTK does not know this format")
    reader.SetFileName(path)
    reader.Update()
    data = reader.GetOutput()
    points, cells = data.GetPointData(), data.GetCellData()
    frame = {
        "points": data.GetNumberOfPoints(),
        "cells": data.GetNumberOfCells(),
        "bounds": data.GetBounds(),
        "point_arrays": [points.GetArrayName(k) for k in range(points.GetNumberOfArrays())],
        "cell_arrays": [cells.GetArrayName(k) for k in range(cells.GetNumberOfArrays())],
    }
    for name in ("id", "radius", "velocity"):
        frame[name] = values(points, name)
    for name in ("porosity", "counted_volume"):
        frame[name] = values(cells, name)
    return frame


frames = []
for entry in xml.etree.ElementTree.parse(series).getroot().iter("DataSet"):
    frame = opened(os.path.join(os.path.dirname(series), entry.get("file")))
    frame["time"] = float(entry.get("timestep"))
    frames.append(frame)
if complaints.GetOutput():
    sys.exit(complaints.GetOutput())
print(json.dumps(frames).replace("NaN", "null"))
