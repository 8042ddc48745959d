// The rows that a claim names, list by list: contact sets, polygons and samples. use(rows) is called for each.
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "certify/layer.h"
#include "flowcert/claim.h"
#include "io/line_reader.h"

namespace flowcert::certify {

// Throws InvalidInput with the place for a row that the input does not have.
void require_ids(std::span<const PointId> ids, const PointSet& points, const LinePlace& place);

// The polygon or the samples of a piece.
[[nodiscard]] const auto& names_in(const auto& piece) {
  if constexpr (requires { piece.polygon; }) {
    return piece.polygon;
  } else {
    return piece.samples;
  }
}

template <typename Use>
void for_each_rows(const StableSet<ClaimedPosition>& set, const Use& use) {
  for (const auto& segment : set.segments) {
    use(segment.samples);
    if (segment.front_contact) use(*segment.front_contact);
    if (segment.back_contact) use(*segment.back_contact);
  }
  for (const auto& interval : set.intervals) use(interval.polygon);
  for (const auto& sector : set.sectors) use(sector.samples);
}

template <typename Use>
void for_each_rows(const UnstableSurface<ClaimedPosition>& set, const Use& use) {
  const auto use_all = [&use](const auto& pieces) {
    for (const auto& piece : pieces) use(names_in(piece));
  };
  use_all(set.traces), use_all(set.runs), use_all(set.sheets), use_all(set.segments);
}

template <typename Use>
void for_each_rows(const ClaimedPockets& pockets, const Use& use) {
  const auto use_witnesses = [&use](const std::vector<ClaimedWitness>& witnesses) {
    std::ranges::for_each(witnesses, use, &ClaimedWitness::contact);
  };
  for (const ClaimedPocket& pocket : pockets.pockets) {
    std::ranges::for_each(pocket.maxima, use);
    if (pocket.peaks) use_witnesses(*pocket.peaks);
    if (pocket.cell) std::ranges::for_each(*pocket.cell, use, &ClaimedCellPart::contact);
    if (pocket.mouths) {
      for (const ClaimedMouth& mouth : *pocket.mouths) use(mouth.at.contact);
    }
    if (pocket.widest_path) use_witnesses(pocket.widest_path->witnesses);
  }
  if (pockets.outside) std::ranges::for_each(*pockets.outside, use);
  for (const auto* whole : {&pockets.pore_limiting_radius, &pockets.largest_cavity_radius}) {
    if (*whole && (*whole)->radius) use_witnesses((*whole)->radius->witnesses);
  }
}

}  // namespace flowcert::certify
