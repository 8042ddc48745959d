// The balls of atoms, exact, and which of them are hidden in others.
//
// Guarantees: nothing is rounded. Ids are places in the input; equal balls are not merged: the later one is hidden.
// Source: spec clauses FC-BALL-01 and FC-BALL-02.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "flowcert/rational.h"

namespace flowcert {

struct Ball {
  RationalPoint center;
  Rational radius;
};

class BallSet {
 public:
  // Throws std::invalid_argument for a radius of 0 or below. O(n log n) where few balls are much larger than others.
  explicit BallSet(std::vector<Ball> balls);

  [[nodiscard]] std::size_t size() const { return balls_.size(); }
  [[nodiscard]] const Ball& operator[](std::size_t id) const { return balls_[id]; }

  // The balls that are not inside another one, ascending.
  [[nodiscard]] const std::vector<std::uint32_t>& visible() const { return visible_; }
  // The hidden balls that touch this visible one from inside, ascending. At a point that it is nearest to, they can be
  // as near.
  [[nodiscard]] std::span<const std::uint32_t> tangent_inside(std::uint32_t id) const { return tangent_[id]; }

  // All numbers times this are integers: x, y, z and the radius of each ball, as rationals and as nearest doubles.
  [[nodiscard]] const Rational& scale() const { return scale_; }
  [[nodiscard]] const std::array<Rational, 4>& scaled(std::uint32_t id) const { return scaled_[id]; }
  [[nodiscard]] const std::array<double, 4>& rounded(std::uint32_t id) const { return rounded_[id]; }
  // Whether all of these doubles are the integers themselves.
  [[nodiscard]] bool are_doubles() const { return are_doubles_; }

 private:
  void scale_all();
  void find_hidden();
  [[nodiscard]] int compare_reach(std::uint32_t inner, std::uint32_t outer) const;

  std::vector<Ball> balls_;
  Rational scale_ = 1;
  std::vector<std::array<Rational, 4>> scaled_;
  std::vector<std::array<double, 4>> rounded_;
  bool are_doubles_ = true;
  std::vector<std::uint32_t> visible_;
  std::vector<std::vector<std::uint32_t>> tangent_;
};

}  // namespace flowcert
