// What JavaScript says to the modules, and how they answer.
//
// Guarantees: bytes and numbers are copied once, in or out. What is wrong with an input leaves a module as a text, the
// sentence of the program for it, which index.js makes an error of.
#pragma once

#include <emscripten/val.h>

#include <cstddef>
#include <exception>
#include <initializer_list>
#include <new>
#include <optional>
#include <span>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "flowcert/progress.h"
#include "flowcert/rational.h"
#include "flowcert/read_points.h"
#include "io/foreign_text.h"

namespace flowcert::web {

using emscripten::val;

// An object of options. What is undefined or null is not there.
class Said {
 public:
  explicit Said(val object) : object_(std::move(object)) {}

  [[nodiscard]] val operator[](const char* name) const { return object_[name]; }
  [[nodiscard]] bool has(const char* name) const { return !object_[name].isUndefined() && !object_[name].isNull(); }
  // A number becomes the decimals that JavaScript prints.
  [[nodiscard]] std::string text(const char* name, std::string otherwise = "") const;
  // One of these words, or empty where nothing is said. Throws InvalidInput for any other one.
  [[nodiscard]] std::string word(const char* name, std::initializer_list<const char*> words) const;
  // One text, or an array of them.
  [[nodiscard]] std::vector<std::string> texts(const char* name) const;
  [[nodiscard]] bool flag(const char* name) const { return has(name) && object_[name].as<bool>(); }
  [[nodiscard]] double number(const char* name, double otherwise) const;
  // Throws InvalidInput for what is no whole number from 0 on.
  [[nodiscard]] std::size_t count(const char* name, std::size_t otherwise) const;
  // A length that the program takes as `option`.
  [[nodiscard]] std::optional<Rational> length(const char* name, const char* option) const;

  // How a file of points is read.
  [[nodiscard]] ReadingOptions reading() const;
  // Calls the function `progress`, if there is one.
  void tell(const std::string& part, std::size_t done, std::size_t total) const;
  [[nodiscard]] Progress telling(const char* part) const;

 private:
  val object_;
};

// The bytes of a Uint8Array.
[[nodiscard]] std::string bytes_of(const val& array);

// Copies numbers into an array of JavaScript's.
template <class Number>
[[nodiscard]] val array_of(std::span<Number> numbers) {
  return val(emscripten::typed_memory_view(numbers.size(), numbers.data())).template call<val>("slice");
}

[[nodiscard]] val array_of_bytes(const std::string& bytes);

// What is written to a stream, as a text or as a Uint8Array.
[[nodiscard]] val written_text(const auto& write) {
  std::ostringstream out;
  write(out);
  return val(std::move(out).str());
}
[[nodiscard]] val written_bytes(const auto& write) {
  std::ostringstream out;
  write(out);
  return array_of_bytes(std::move(out).str());
}

// The result of the work, or JavaScript's exception.
template <class Work>
auto answer(const Work& work) {
  std::string sentence;
  try {
    return work();
  } catch (const std::bad_alloc&) {
    sentence = "out of memory";
  } catch (const std::exception& error) {
    sentence = io::on_one_line(error.what());
  }
  val(sentence).throw_();
}

}  // namespace flowcert::web
