"""Claims in VTP files that VTK itself writes, in every way that it can, read by `flowcert check`.

usage: vtk_claims_test.py FLOWCERT

Each file claims the critical points of an acute triangle, rightly, as TTK's ScalarFieldCriticalPoints lays them out; a
second one has the index of one of them wrong. Compressors other than zlib have to be refused by name.
"""
import itertools
import json
import os
import subprocess
import sys
import tempfile

from vtkmodules import vtkCommonCore as core
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter

TRIANGLE = [(0, 0, 0), (4, 0, 0), (1, 3, 0)]
CLAIMS = [(0, p) for p in TRIANGLE] + [(1, (2, 0, 0)), (1, (0.5, 1.5, 0)), (1, (2.5, 1.5, 0)), (2, (2, 1, 0))]

MODES = ["ascii", "binary", "appended base64", "appended raw"]
COMPRESSORS = {"none": 0, "zlib": 1, "LZ4": 2, "LZMA": 3}
TYPES = [core.VTK_CHAR, core.VTK_SIGNED_CHAR, core.VTK_UNSIGNED_CHAR, core.VTK_INT, core.VTK_ID_TYPE, core.VTK_FLOAT,
         core.VTK_DOUBLE]


def poly_data(claims, position_type, index_type):
    points = core.vtkPoints()
    points.SetDataType(position_type)
    indices = core.vtkDataArray.CreateDataArray(index_type)
    indices.SetName("CriticalType")
    others = core.vtkFloatArray()
    others.SetName("Scalar")
    vertices = vtkCellArray()
    for index, position in claims:
        vertices.InsertNextCell(1)
        vertices.InsertCellPoint(points.InsertNextPoint(position))
        indices.InsertNextTuple1(index)
        others.InsertNextTuple1(0.5)
    data = vtkPolyData()
    data.SetPoints(points)
    data.SetVerts(vertices)
    data.GetPointData().SetScalars(others)
    data.GetPointData().AddArray(indices)
    return data


def write(path, data, mode, compressor, header_bits, is_big_endian):
    writer = vtkXMLPolyDataWriter()
    writer.SetFileName(path)
    writer.SetInputData(data)
    if mode == "ascii":
        writer.SetDataModeToAscii()
    elif mode == "binary":
        writer.SetDataModeToBinary()
    else:
        writer.SetDataModeToAppended()
        writer.SetEncodeAppendedData(mode == "appended base64")
    writer.SetCompressorType(COMPRESSORS[compressor])
    (writer.SetHeaderTypeToUInt64 if header_bits == 64 else writer.SetHeaderTypeToUInt32)()
    (writer.SetByteOrderToBigEndian if is_big_endian else writer.SetByteOrderToLittleEndian)()
    assert writer.Write() == 1


def fault_of(flowcert, folder, claims, types, ways):
    """What is wrong with the verdict, or None."""
    points, claim = os.path.join(folder, "points.xyz"), os.path.join(folder, "claim.vtp")
    write(claim, poly_data(claims, *types), *ways)
    run = subprocess.run([flowcert, "check", points, claim, "--json"], capture_output=True, text=True, timeout=60)
    mode, compressor = ways[0], ways[1]
    if compressor in ("LZ4", "LZMA") and mode != "ascii":
        named = f"compressed by 'vtk{compressor}DataCompressor'" in run.stderr
        return None if run.returncode == 2 and named else f"not refused by name: {run.stderr}"
    if run.stderr:
        return run.stderr
    is_right = claims is CLAIMS
    if run.returncode != (0 if is_right else 1):
        return f"exit status {run.returncode}"
    report = json.loads(run.stdout)
    if report["claim_format"] != "vtp" or report["claimed"] != ([3, 3, 1, 0] if is_right else [3, 3, 0, 1]):
        return f"{report['claim_format']} {report['claimed']}"
    return None


def main():
    flowcert = sys.argv[1]
    wrong = CLAIMS[:-1] + [(3, CLAIMS[-1][1])]
    count, faults = 0, []
    with tempfile.TemporaryDirectory() as folder:
        with open(os.path.join(folder, "points.xyz"), "w", encoding="ascii") as file:
            file.writelines("%g %g %g\n" % p for p in TRIANGLE)
        for ways in itertools.product(MODES, COMPRESSORS, (32, 64), (False, True)):
            for k, index_type in enumerate(TYPES):
                types = (core.VTK_DOUBLE if k % 2 else core.VTK_FLOAT, index_type)
                claims = wrong if k == 3 else CLAIMS
                fault = fault_of(flowcert, folder, claims, types, ways)
                count += 1
                if fault:
                    faults.append(f"{ways} {types}: {fault.strip()}")
    for fault in faults[:20]:
        print(fault)
    print(f"{count} files written by VTK {core.vtkVersion.GetVTKVersion()}, {len(faults)} faults")
    return 1 if faults or count == 0 else 0


if __name__ == "__main__":
    sys.exit(main())
