#include "numbers.h"

#include <gmp.h>

#include <stdexcept>

namespace flowcert::python {

namespace py = pybind11;

namespace {

py::object integer_of(const __mpz_struct* value) {
  // A sign and a zero at the end.
  std::string digits(mpz_sizeinbase(value, 16) + 2, '\0');
  mpz_get_str(digits.data(), 16, value);
  PyObject* const integer = PyLong_FromString(digits.c_str(), nullptr, 16);
  if (integer == nullptr) throw py::error_already_set();
  return py::reinterpret_steal<py::object>(integer);
}

}  // namespace

py::tuple ratio_of(const Rational& value) {
  const auto* const ratio = value.backend().data();
  return py::make_tuple(integer_of(mpq_numref(ratio)), integer_of(mpq_denref(ratio)));
}

py::tuple ratios_of(const RationalPoint& point) {
  return py::make_tuple(ratio_of(point[0]), ratio_of(point[1]), ratio_of(point[2]));
}

Rational rational_of(const std::string& hexadecimal) {
  Rational value;
  auto* const ratio = value.backend().data();
  if (mpq_set_str(ratio, hexadecimal.c_str(), 16) != 0 || mpz_sgn(mpq_denref(ratio)) <= 0) {
    throw std::invalid_argument("not a fraction of hexadecimal numbers: " + hexadecimal);
  }
  mpq_canonicalize(ratio);
  return value;
}

RationalPoint point_of(const std::array<std::string, 3>& hexadecimal) {
  return {rational_of(hexadecimal[0]), rational_of(hexadecimal[1]), rational_of(hexadecimal[2])};
}

std::string decimal_text(const std::string& hexadecimal) { return to_text(rational_of(hexadecimal)); }

}  // namespace flowcert::python
