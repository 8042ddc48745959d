// A decimal becomes a fraction: its digits over a power of ten.
#include "oracle/program/read_balls.h"

#include <fstream>

#include "oracle/program/read_points.h"
#include "oracle/program/read_records.h"

namespace oracle {

namespace {

std::optional<Rational> mantissa(std::string digits) {
  std::string denominator = "1";
  const std::size_t dot = digits.find('.');
  if (dot != std::string::npos) {
    denominator += std::string(digits.size() - dot - 1, '0');
    digits.erase(dot, 1);
  }
  const auto fraction = parse_rational(digits + "/" + denominator);
  return fraction ? std::optional(fraction->value) : std::nullopt;
}

// 10 to the power in the text. Four digits at most, so that no number becomes too long.
std::optional<Rational> power_of_ten(const std::string& text) {
  const std::size_t first = text.starts_with('-') || text.starts_with('+') ? 1 : 0;
  const std::size_t count = text.size() - first;
  if (count < 1 || count > 4 || text.find_first_not_of("0123456789", first) != std::string::npos) return std::nullopt;
  const Rational power(pow(Integer(10), static_cast<unsigned>(std::stoi(text.substr(first)))));
  return text.starts_with('-') ? 1 / power : power;
}

std::optional<Rational> parse_number(const std::string& text) {
  const std::size_t exponent = text.find_first_of("eE");
  const std::string digits = text.substr(0, exponent);
  if (digits.find('/') != std::string::npos) {
    const auto fraction = parse_rational(text);
    return fraction ? std::optional(fraction->value) : std::nullopt;
  }
  const auto number = mantissa(digits);
  const auto power = exponent == std::string::npos ? Rational(1) : power_of_ten(text.substr(exponent + 1));
  return number && power ? std::optional(*number * *power) : std::nullopt;
}

}  // namespace

Rational exact_number(const std::string& word, const std::string& where) {
  const bool has_plus = word.starts_with('+') && !word.starts_with("+-");
  const auto number = parse_number(has_plus ? word.substr(1) : word);
  if (!number) throw UnusableInput(where + "'" + word + "' is not a decimal or a fraction");
  return *number;
}

std::vector<Ball> read_balls(std::istream& in, const std::string& name) {
  std::vector<Ball> balls;
  std::size_t number = 0;
  for (std::string line; std::getline(in, line);) {
    const std::string where = name + ":" + std::to_string(++number) + ": ";
    const std::vector<std::string> words = fields(line.substr(0, line.find('#')));
    if (words.empty()) continue;
    if (words.size() != 4) {
      throw UnusableInput(where + "four numbers x y z r expected, found " + std::to_string(words.size()));
    }
    Ball ball;
    for (std::size_t axis = 0; axis < 3; ++axis) ball.centre[axis] = exact_number(words[axis], where);
    ball.radius = exact_number(words[3], where);
    if (ball.radius <= 0) throw UnusableInput(where + "the radius " + words[3] + " is not positive");
    balls.push_back(ball);
  }
  if (in.bad()) throw UnusableInput(name + ": cannot be read");
  return balls;
}

std::vector<Ball> read_ball_file(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  if (!in) throw UnusableInput(path + ": cannot be opened");
  return read_balls(in, path);
}

}  // namespace oracle
