#!/usr/bin/env python3
"""What VTK's own reader, which is ParaView's, finds in each file: a line of JSON a file; "no vtk" where it is not installed."""
import json
import sys

try:
    import vtk
except ImportError:
    print("no vtk")
    sys.exit(0)


def values(arrays):
    for k in range(arrays.GetNumberOfArrays()):
        array = arrays.GetArray(k)
        yield array.GetName(), [list(array.GetTuple(i)) for i in range(array.GetNumberOfTuples())]


for file in sys.argv[1:]:
    reader = vtk.vtkXMLPolyDataReader()
    reader.SetFileName(file)
    reader.Update()
    data = reader.GetOutput()
    print(json.dumps({
        "points": [list(data.GetPoint(i)) for i in range(data.GetNumberOfPoints())],
        "cells": [[data.GetCell(i).GetPointId(p) for p in range(data.GetCell(i).GetNumberOfPoints())]
                  for i in range(data.GetNumberOfCells())],
        "point_data": dict(values(data.GetPointData())),
        "cell_data": dict(values(data.GetCellData())),
        "errors": reader.GetErrorCode(),
    }))
