// All unstable sets of dimension 2 for viewers: as VTP with all of their parts, as the same data in memory, and as PLY
// with triangles (src/cli/manual/exports.md).
//
// Guarantees: coordinates are the doubles nearest to the exact ones. In a set, points are one iff their exact positions
// are equal, but for those at which the box cuts. What is written does not depend on the number of threads. It takes
// memory for some sets at once: all of them wait in files without names.
#pragma once

#include <memory>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "flowcert/flow_complex.h"
#include "io/vtk_exports.h"

namespace flowcert {

class UnstableSurfaceExport {
 public:
  // Makes all sets, or those of these stationary points alone, by place in the list, ascending. The folder must exist.
  // Without a box, parts that reach to infinity are left out. It throws InvalidInput where a coordinate is beyond the
  // doubles, and OutputError where the folder cannot be written.
  UnstableSurfaceExport(const FlowComplex& complex, const std::optional<ClipBox>& box, const std::string& folder,
                        const Progress& progress = {}, const std::vector<std::size_t>* records = nullptr);
  ~UnstableSurfaceExport();
  UnstableSurfaceExport(const UnstableSurfaceExport&) = delete;
  UnstableSurfaceExport& operator=(const UnstableSurfaceExport&) = delete;

  // What the VTP file has.
  [[nodiscard]] PolyData data() const;
  // comment: of one line, without "--".
  void write_vtp(std::ostream& out, const std::string& comment) const;
  // Throws InvalidInput where there are more points or triangles than its numbers can say.
  void write_ply(std::ostream& out, const std::string& comment) const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace flowcert
