#include "io/with_commas.h"

#include <fmt/format.h>

#include <locale>

namespace flowcert::io {

namespace {

struct Commas : std::numpunct<char> {
 protected:
  [[nodiscard]] char do_thousands_sep() const override { return ','; }
  [[nodiscard]] std::string do_grouping() const override { return "\3"; }
};

}  // namespace

std::string with_commas(unsigned long long value) {
  static const std::locale commas(std::locale::classic(), new Commas);
  return fmt::format(commas, "{:L}", value);
}

}  // namespace flowcert::io
