#include "check.h"

#include <fmt/format.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "complex.h"
#include "flowcert/check.h"
#include "geometry/floating_point.h"
#include "released_lock.h"

namespace flowcert::python {

namespace py = pybind11;

namespace {

CheckOptions options_of(double tolerance, int highest_level, const std::vector<int>& indices) {
  if (!(0 <= tolerance && tolerance <= kLargestTolerance)) {
    throw InvalidInput(fmt::format("tolerance must be from 0 to {}", kLargestTolerance));
  }
  if (highest_level < 1 || highest_level > kLevels) throw InvalidInput("highest_level must be from 1 to 5");
  CheckOptions options{.tolerance = tolerance, .highest_level = highest_level, .indices = {}};
  for (const int index : indices) {
    if (index < 0 || index > 3) throw InvalidInput("indices must be from 0 to 3");
    options.indices.at(static_cast<std::size_t>(index)) = true;
  }
  return options;
}

py::dict finding_of(const Finding& finding) {
  py::dict fields;
  fields["level"] = finding.level;
  fields["reason"] = reason_text(finding.reason);
  fields["permitted"] = finding.is_variation;
  fields["decided"] = finding.is_decided;
  fields["clause"] = finding.clause;
  fields["line"] = finding.line;
  fields["contact"] = finding.contact;
  // A claim may have other bytes than UTF-8 in it.
  const auto text = [](const std::string& bytes) {
    return py::reinterpret_steal<py::object>(
        PyUnicode_DecodeUTF8(bytes.data(), static_cast<py::ssize_t>(bytes.size()), "replace"));
  };
  fields["claimed"] = text(finding.claimed);
  fields["truth"] = text(finding.truth);
  fields["sentence"] = text(finding.sentence);
  return fields;
}

py::dict report_of(const CheckReport& report, double tolerance) {
  py::list findings;
  for (const Finding& finding : report.findings) findings.append(finding_of(finding));
  py::dict fields;
  fields["verdict"] = verdict_text(report.verdict);
  fields["is_exact"] = report.is_exact;
  fields["parts"] = py::tuple(py::cast(report.profile.parts()));
  fields["statement"] = conformity_text(report.verdict, report.profile, tolerance);
  fields["claimed_counts"] = py::tuple(py::cast(report.claimed_counts));
  fields["true_counts"] = py::tuple(py::cast(report.true_counts));
  fields["levels"] = py::tuple(py::cast(report.conforms));
  fields["not_judged"] = report.not_judged;
  fields["not_decided"] = report.not_decided;
  fields["findings"] = findings;
  return fields;
}

// claim: the content of a file, or the path of one.
py::dict check_claim(const Complex& complex, const std::string& claim, bool is_path, double tolerance,
                     int highest_level, const std::vector<int>& indices, bool unlimited) {
  const CheckOptions options = options_of(tolerance, highest_level, indices);
  CheckReport report;
  {
    const ReleasedLock released;
    const std::string name = is_path ? claim : "claim";
    const Claim read = is_path ? read_claim(claim, unlimited) : read_claim_from(claim, name, unlimited);
    const FlowComplex& flow_complex = complex.flow_complex();
    require_rows(read, flow_complex.points(), name);
    report = check(flow_complex, read, options);
  }
  return report_of(report, tolerance);
}

}  // namespace

void add_check(py::module_& module) {
  module.def("check", check_claim, py::arg("complex"), py::arg("claim"), py::arg("is_path"), py::arg("tolerance"),
             py::arg("highest_level"), py::arg("indices"), py::arg("unlimited"),
             py::call_guard<geometry::IeeeDoubles>(), "What flowcert.check asks.");
}

}  // namespace flowcert::python
