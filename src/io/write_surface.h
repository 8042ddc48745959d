// Surface meshes as PLY (binary, little endian, double coordinates) and OFF (text).
//
// Guarantees: coordinates read back to the same doubles; triangles keep their order.
#pragma once

#include <ostream>
#include <string>

#include "io/surface_mesh.h"

namespace flowcert::io {

// comment: one line.
void write_ply(std::ostream& out, const SurfaceMesh& mesh, const std::string& comment);
void write_off(std::ostream& out, const SurfaceMesh& mesh, const std::string& comment);

}  // namespace flowcert::io
