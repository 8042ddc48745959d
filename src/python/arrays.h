// Vectors of the library as NumPy arrays, and rows of NumPy as points.
//
// Guarantees: nothing is copied. An array owns the vector that it was made of. All of these need Python's lock.
#pragma once

#include <pybind11/numpy.h>

#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "flowcert/point_set.h"

namespace flowcert::python {

// An array of this shape over a vector's memory, read as numbers of type Number.
template <class Number, class Item>
[[nodiscard]] pybind11::array array_of(std::vector<Item> items, std::vector<pybind11::ssize_t> shape) {
  auto owned = std::make_unique<std::vector<Item>>(std::move(items));
  const auto* const data = reinterpret_cast<const Number*>(owned->data());
  const pybind11::capsule owner(owned.get(), [](void* vector) { delete static_cast<std::vector<Item>*>(vector); });
  (void)owned.release();  // the capsule's now
  return pybind11::array(pybind11::dtype::of<Number>(), std::move(shape), data, owner);
}

template <class Number>
[[nodiscard]] pybind11::array array_of(std::vector<Number> numbers) {
  const auto size = static_cast<pybind11::ssize_t>(numbers.size());
  return array_of<Number>(std::move(numbers), {size});
}

// Places in some list, or rows of points.
[[nodiscard]] inline pybind11::array places_of(const std::vector<std::uint32_t>& places) {
  return array_of(std::vector<std::int64_t>(places.begin(), places.end()));
}

// Items of so many numbers each are the rows of an array.
template <class Number, class Item>
[[nodiscard]] pybind11::array rows_of(std::vector<Item> items) {
  static_assert(sizeof(Item) % sizeof(Number) == 0);
  const auto size = static_cast<pybind11::ssize_t>(items.size());
  return array_of<Number>(std::move(items), {size, sizeof(Item) / sizeof(Number)});
}

// The same array, which cannot be written to any more: several have it.
[[nodiscard]] inline pybind11::array shared(pybind11::array array) {
  array.attr("setflags")(pybind11::arg("write") = false);
  return array;
}

using PointRows = pybind11::array_t<double, pybind11::array::c_style>;

// The array must outlive this.
[[nodiscard]] inline std::span<const Point> points_of(const PointRows& rows) {
  static_assert(sizeof(Point) == 3 * sizeof(double));
  if (rows.ndim() != 2 || rows.shape(1) != 3) throw InvalidInput("points must have the shape (n, 3)");
  return {reinterpret_cast<const Point*>(rows.data()), static_cast<std::size_t>(rows.shape(0))};
}

}  // namespace flowcert::python
