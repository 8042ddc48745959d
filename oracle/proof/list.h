// Compares a list of stationary points, as flowcert compute -o writes it, with those that were found, in every field.
#pragma once

#include <map>

#include "json_reader.h"
#include "stationary_points.h"

// numerator / denominator * 2^scale.
struct Fraction {
  mpz_class numerator, denominator;
  int scale;

  std::string text() const {  // in lowest terms
    mpq_class quotient(numerator, denominator);
    quotient.canonicalize();
    const auto shift = static_cast<mp_bitcnt_t>(std::abs(scale));
    quotient = scale >= 0 ? mpq_class(quotient << shift) : mpq_class(quotient >> shift);
    return quotient.get_str();
  }
  // The nearest double, ties to even; infinite where that overflows.
  double nearest() const {
    if (numerator == 0) return 0;
    mpz_class n = abs(numerator), d = abs(denominator);
    const auto bits = [](const mpz_class& z) { return static_cast<int>(mpz_sizeinbase(z.get_mpz_t(), 2)); };
    // With units of 2^exponent, n / d has 53 or 54 bits before the point, or fewer if the double is subnormal.
    int exponent = std::max(bits(n) - bits(d) + scale - 53, -1074);
    (scale > exponent ? n : d) <<= static_cast<mp_bitcnt_t>(std::abs(scale - exponent));
    if (bits(n / d) > 53) d *= 2, ++exponent;
    mpz_class whole = n / d;
    const int half = cmp(2 * (n % d), d);
    if (half > 0 || (half == 0 && whole % 2 == 1)) ++whole;
    const double magnitude = std::ldexp(whole.get_d(), exponent);
    return sgn(numerator) == sgn(denominator) ? magnitude : -magnitude;
  }
};

// Compares what a file has of stationary points, value by value, as they come.
class Comparison {
 public:
  Comparison(std::string claim, const std::string& path, const Points& points, const StationaryPoints& stationary)
      : reader(path), points_(points), stationary_(stationary), claim_(std::move(claim)) {}

  JsonReader reader;
  std::string skipped;  // names of keys

  [[noreturn]] void refute_here(const std::string& what) const {
    refute(claim_ + " refuted: line " + std::to_string(reader.line()) + ": " + what);
  }
  void compare(const std::string& what, const std::string& value) {
    const bool is_number = std::isdigit(static_cast<unsigned char>(value[0])) != 0;
    if (is_number ? reader.word() == value : reader.take(value)) return;
    if (reader.next() == EOF) reader.fail("cannot be decoded, it is cut short");
    refute_here(what + " is not " + value);
  }

  // Passes over those of the keys that come, with their values, and over the next key, which is returned.
  std::string skip(const std::string& keys) {
    std::string key = reader.key();
    for (; keys.find(" " + key + " ") != std::string::npos; key = reader.key()) {
      reader.skip_value();
      skipped += (skipped.empty() ? "" : ", ") + key;
    }
    return key;
  }
  void compare_header(const std::string& format) {
    reader.need("{\"format\":\"" + format + "\",\"format_version\":1");
    const std::string key = skip(" version commit kernel compiler cgal input_sha256 left_out ");
    if (key != "points") reader.fail("the key \"" + key + "\" is not proved, \"points\" is due");
    compare(key, std::to_string(points_.row_count()));
    reader.need_key("merged_duplicates");
    compare("merged_duplicates", std::to_string(points_.row_count() - points_.point_count()));
    const auto& n = stationary_.counts();
    reader.need_key("critical");
    compare("critical", text_of({n[0], n[1], n[2], n[3]}));
    reader.need_key("regular_stationary");
    compare("regular_stationary", "{\"1-2\":" + std::to_string(n[4]) + ",\"1-3\":" + std::to_string(n[5]) +
                                      ",\"2-3\":" + std::to_string(n[6]) + "}");
  }

  // Compares these fields of a stationary point, which come in this order.
  void compare_fields(const StationaryPoint& point, const std::vector<std::string>& fields) {
    const Simplex& v = point.simplex;
    const auto [from_first, denominator] = circumcenter<BigInteger>(points_, v);
    const mpz_class twice = 2 * denominator.value;
    const int exponent = points_.grid_exponent();
    const auto axis = [&](std::size_t k, const BigInteger& part) {
      return Fraction{points_.on_grid(v[0], k) * twice + part.value, twice, exponent};
    };
    const std::array<Fraction, 3> center{axis(0, from_first.x), axis(1, from_first.y), axis(2, from_first.z)};
    const Fraction squared{dot(from_first, from_first).value, twice * twice, 2 * exponent};
    for (const std::string& field : fields) {
      reader.need_key(field);
      if (field == "contact") {
        compare(field, text_of({point.contact.begin(), point.contact.end()}));
      } else if (field == "center") {
        compare(field, "[\"" + center[0].text() + "\",\"" + center[1].text() + "\",\"" + center[2].text() + "\"]");
      } else if (field == "squared_distance") {
        compare(field, "\"" + squared.text() + "\"");
      } else if (field == "center_double") {
        for (std::size_t k = 0; k < 3; ++k) {
          reader.need(k == 0 ? "[" : ",");
          compare_double(field, center[k]);
        }
        reader.need("]");
      } else {
        compare_double(field, squared);
      }
    }
  }
  static std::string text_of(const std::vector<std::size_t>& numbers) {
    std::string text;
    for (const std::size_t number : numbers) text += (text.empty() ? "[" : ",") + std::to_string(number);
    return (text.empty() ? "[" : text) + "]";
  }

 private:
  void compare_double(const std::string& what, const Fraction& exact) {
    const double expected = exact.nearest();
    const std::string word = reader.word();
    const char* at = word.c_str();
    double written = 0;
    const bool is_right = std::isinf(expected) ? word == "null" : read_decimal(at, written) && written == expected;
    if (!is_right || (*at != '\0' && word != "null")) refute_here(what + " is not the nearest double");
  }

  const Points& points_;
  const StationaryPoints& stationary_;
  const std::string claim_;
};

// Returns what of the list is proved, and what is not compared; line by line, and of its header.
struct ListProof {
  std::string fields, skipped;
};
inline ListProof compare_list(const std::string& path, const Points& points, const StationaryPoints& stationary) {
  Comparison list("list", path, points, stationary);
  JsonReader& reader = list.reader;
  list.compare_header("flowcert-stationary-points");
  reader.need_key("classes");
  std::map<Id, std::vector<std::size_t>> classes;
  for (Id row = 0; row < points.row_count(); ++row) {
    if (!points.is_id(row)) classes[points.id_of_row(row)].push_back(row);
  }
  std::string text;
  for (auto& [id, rows] : classes) {
    rows.insert(rows.begin(), id);
    text += (text.empty() ? "" : ",") + Comparison::text_of(rows);
  }
  list.compare("classes", "[" + text + "]");
  std::vector<std::string> fields{"contact", "center", "squared_distance", "center_double", "squared_distance_double"};
  if (const std::string key = reader.key(); key == "centers") {
    const std::string centers = reader.string();
    if (centers != "double" && centers != "none") reader.fail("\"centers\" is neither \"double\" nor \"none\"");
    fields.erase(fields.begin() + 1, centers == "none" ? fields.end() : fields.begin() + 3);
    reader.need_key("");
  } else if (!key.empty()) {
    reader.fail("the key \"" + key + "\" is not proved");
  }
  reader.need("\n");

  static const std::array<std::string, 7> kIndices{"0", "1", "2", "3", "[1,2]", "[1,3]", "[2,3]"};
  for (const StationaryPoint& point : stationary.all()) {
    if (reader.next() == EOF) list.refute_here("the list ends, and records are missing");
    reader.need_key("index");
    list.compare("index", kIndices[point.kind]);
    reader.need_key("kind");
    list.compare("kind", point.kind <= kIndex3 ? "\"critical\"" : "\"regular\"");
    list.compare_fields(point, fields);
    reader.need_key("");
    reader.need("\n");
  }
  if (reader.next() != EOF) list.refute_here("there are more records than stationary points");
  std::string proved = "index, kind";
  for (const std::string& field : fields) proved += ", " + field;
  return {proved, list.skipped};
}
