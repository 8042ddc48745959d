// A part that most objects do not have: as std::optional, but of the size of a pointer where there is none. What a file
// of a million short records takes in memory depends on it.
#pragma once

#include <concepts>
#include <memory>
#include <optional>
#include <type_traits>
#include <utility>

namespace flowcert {

template <class T>
class Boxed {
  template <class U>
  static constexpr bool kIsValue = std::convertible_to<U, T> && !std::same_as<std::remove_cvref_t<U>, Boxed>;

 public:
  Boxed() = default;
  // As std::optional has it, these convert.
  // NOLINTNEXTLINE(google-explicit-constructor,hicpp-explicit-conversions)
  template <class U = T>
    requires kIsValue<U>
  Boxed(U&& value) : value_(std::make_unique<T>(std::forward<U>(value))) {}
  // NOLINTNEXTLINE(google-explicit-constructor,hicpp-explicit-conversions)
  Boxed(std::optional<T> value) : value_(value ? std::make_unique<T>(*std::move(value)) : nullptr) {}
  Boxed(const Boxed& other) : value_(other ? std::make_unique<T>(*other) : nullptr) {}
  Boxed(Boxed&&) noexcept = default;
  Boxed& operator=(const Boxed& other) {
    value_ = other ? std::make_unique<T>(*other) : nullptr;
    return *this;
  }
  Boxed& operator=(Boxed&&) noexcept = default;
  template <class U = T>
    requires kIsValue<U>
  Boxed& operator=(U&& value) {
    value_ = std::make_unique<T>(std::forward<U>(value));
    return *this;
  }
  ~Boxed() = default;

  [[nodiscard]] bool has_value() const { return value_ != nullptr; }
  explicit operator bool() const { return has_value(); }
  [[nodiscard]] T& operator*() { return *value_; }
  [[nodiscard]] const T& operator*() const { return *value_; }
  [[nodiscard]] T* operator->() { return value_.get(); }
  [[nodiscard]] const T* operator->() const { return value_.get(); }
  // Throws std::bad_optional_access if there is none.
  [[nodiscard]] const T& value() const {
    if (!value_) throw std::bad_optional_access();
    return *value_;
  }
  [[nodiscard]] T& value() { return const_cast<T&>(std::as_const(*this).value()); }
  template <class... Arguments>
  T& emplace(Arguments&&... arguments) {
    value_ = std::make_unique<T>(std::forward<Arguments>(arguments)...);
    return *value_;
  }
  void reset() { value_.reset(); }

 private:
  std::unique_ptr<T> value_;
};

}  // namespace flowcert
