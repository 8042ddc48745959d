// The property `certificate` holds on what is right, and finds each planted fault.
#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "fuzz/inputs/large_configurations.h"
#include "fuzz/inputs/stable_configurations.h"
#include "fuzz/properties/certificate.h"
#include "fuzz/properties/input_points.h"
#include "tests/cites.h"

namespace flowcert::property::certificate_property_test {
namespace {

// The input has one triangulation alone, and pairs of dimension 0 and 1.
const fuzz::Input kInput{
    {{0, 0, 0}, {7, 1, 0}, {2, 8, 1}, {1, 2, 9}, {6, 7, 8}, {9, 3, 7}, {3, 11, 6}, {13, 9, 2}, {5, 4, 15}}};

CertifiedAnswer answer_of(const fuzz::Input& input) { return certified_answer(FlowComplex(point_set_of(input))); }

std::string kind_of(const std::optional<Disagreement>& found) { return found ? found->kind : "none"; }

TEST(CertificateProperty, HoldsOnAllFamiliesAndOnLargeInputs) {
  const Property& certificate = *property_named("certificate");
  for (const fuzz::Family& family : fuzz::families_and_stable_ones()) {
    for (std::uint64_t seed = 0; seed < 5; ++seed) {
      const auto found = disagreement(certificate, {fuzz::draw(family, seed, 80), StartChoice{}});
      EXPECT_FALSE(found) << family.name << ' ' << seed << ": " << found->complaint;
    }
  }
  for (const auto& make : {fuzz::lattice_piece, fuzz::lattice_layers, fuzz::integer_spheres, fuzz::rounded_capsule}) {
    const auto found = disagreement(certificate, {make(300, 1), StartChoice{}});
    EXPECT_FALSE(found) << found->complaint;
  }
  EXPECT_FALSE(disagreement(certificate, {fuzz::Input{}, StartChoice{}}));
}

TEST(CertificateProperty, FindsCellsThatAreNoDelaunayTriangulation) {
  CITES("FC-CERT-02");
  CertifiedAnswer answer = answer_of(kInput);
  ASSERT_EQ(kind_of(disproof(kInput, answer)), "none");
  // The cells were right before a point moved. They still are positive and paired, but that point is inside a sphere.
  fuzz::Input moved = kInput;
  moved.rows[4] = {5, 5, 4};
  const auto found = disproof(moved, answer);
  ASSERT_EQ(kind_of(found), "rejected");
  EXPECT_TRUE(found->complaint.starts_with("certificate rejected: T")) << found->complaint;
  EXPECT_EQ(kind_of(disproof(moved, answer_of(moved))), "none");

  const std::string right = answer.certificate;
  for (std::size_t k = right.find("\n\n") + 2; k < right.size(); ++k) {
    answer.certificate = right;
    answer.certificate[k] = static_cast<char>(answer.certificate[k] ^ 1);  // another point in a cell
    const std::string kind = kind_of(disproof(kInput, answer));
    EXPECT_TRUE(kind == "rejected" || kind == "undecoded") << kind << " of byte " << k;
  }
  answer.certificate = right.substr(0, right.size() - 1);
  EXPECT_EQ(kind_of(disproof(kInput, answer)), "undecoded");
}

TEST(CertificateProperty, FindsStationaryPointsThatAreWrong) {
  CITES("FC-CERT-03", "FC-CERT-04", "FC-CERT-05");
  const CertifiedAnswer right = answer_of(kInput);
  for (std::size_t k = 0; k < right.stationary.size(); ++k) {
    CertifiedAnswer answer = right;
    answer.stationary.erase(answer.stationary.begin() + static_cast<std::ptrdiff_t>(k));
    EXPECT_EQ(kind_of(disproof(kInput, answer)), "stationary") << k;
    answer = right;
    ++answer.stationary[k].first.hull_dimension;
    EXPECT_EQ(kind_of(disproof(kInput, answer)), "stationary") << k;
    answer = right;
    answer.stationary[k].second.push_back(8);
    EXPECT_EQ(kind_of(disproof(kInput, answer)), "stationary") << k;
  }
}

TEST(CertificateProperty, FindsPairsThatAreWrong) {
  CITES("FC-CERT-06");
  const CertifiedAnswer right = answer_of(kInput);
  ASSERT_GE(right.pairs.back().dimension, 1);
  for (std::size_t k = 0; k < right.pairs.size(); ++k) {
    CertifiedAnswer answer = right;
    answer.pairs.erase(answer.pairs.begin() + static_cast<std::ptrdiff_t>(k));
    EXPECT_EQ(kind_of(disproof(kInput, answer)), "pairs") << k;
    answer = right;
    answer.pairs[k].birth += oracle::Rational(1) / 1'000'000'000;
    EXPECT_EQ(kind_of(disproof(kInput, answer)), "pairs") << k;
    answer = right;
    ++answer.pairs[k].dimension;
    std::sort(answer.pairs.begin(), answer.pairs.end());
    EXPECT_EQ(kind_of(disproof(kInput, answer)), "pairs") << k;
  }
}

}  // namespace
}  // namespace flowcert::property::certificate_property_test
