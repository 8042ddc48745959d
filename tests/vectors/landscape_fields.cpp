#include "tests/vectors/landscape_fields.h"

#include <algorithm>

#include "oracle/orbit.h"
#include "tests/vectors/manifold_fields.h"

namespace oracle::vectors {

namespace {

using Places = std::vector<std::size_t>;
using All = std::vector<StationaryPoint>;

Json index_of(const StationaryPoint& x) { return record_field(x)["index"]; }

Json contacts(const All& all, const Places& places) {
  Json field = Json::array();
  for (const std::size_t place : places) field.push_back(all[place].contact);
  return field;
}

}  // namespace

Json location_field(const Point& x, const Location& location) {
  Json field;
  field["position"] = position_field(x);
  field["kind"] = "infinity";
  field["index"] = nullptr;
  field["contact"] = nullptr;
  if (location.limit) {
    field["kind"] = location.limit->is_critical() ? "critical" : "regular";
    field["index"] = index_of(*location.limit);
    field["contact"] = location.limit->contact;
  }
  field["nearest"] = location.nearest;
  return field;
}

// ---- Merge trees ----

namespace {

// Nothing stands for infinity.
Json leaf_field(const StationaryPoint* leaf) {
  Json field;
  field["contact"] = nullptr;
  field["squared_distance"] = nullptr;
  if (leaf == nullptr) return field;
  field["contact"] = leaf->contact;
  field["squared_distance"] = leaf->squared_distance.str();
  return field;
}

Json tree_field(const All& all, const MergeTree& tree, const Places& leaves) {
  Json field;
  field["leaves"] = Json::array();
  for (std::size_t leaf = 0; leaf < tree.leaves; ++leaf) {
    field["leaves"].push_back(leaf_field(leaf < leaves.size() ? &all[leaves[leaf]] : nullptr));
  }
  field["nodes"] = Json::array();
  for (const MergeNode& node : tree.nodes) {
    Json& one = field["nodes"].emplace_back();
    one["squared_distance"] = node.value.str();
    one["parts"] = node.parts;
    one["joined_by"] = contacts(all, node.points);
  }
  return field;
}

}  // namespace

Json trees_field(const All& all, const Trees& trees) {
  Places samples(trees.components.leaves);
  for (std::size_t k = 0; k < samples.size(); ++k) samples[k] = k;
  Json field;
  field["pockets"] = tree_field(all, trees.pockets, maxima_places(all));
  field["components"] = tree_field(all, trees.components, samples);
  return field;
}

// ---- Pockets ----

namespace {

const char* passage_word(Passage passage) {
  switch (passage) {
    case Passage::kCavity:
      return "cavity";
    case Passage::kPocket:
      return "pocket";
    case Passage::kChannel:
      break;
  }
  return "channel";
}

Json witness_field(const StationaryPoint& x) {
  Json field;
  field["contact"] = x.contact;
  field["center"] = position_field(x.center);
  return field;
}

Json path_field(const All& all, const WidestPath& path) {
  Json field;
  field["squared_radius"] = path.value.str();
  field["gates"] = Json::array();
  for (const std::size_t gate : path.gates) field["gates"].push_back(witness_field(all[gate]));
  return field;
}

Json numbers_field(const Pockets& found, const Places& numbers) {
  Json field = Json::array();
  for (const std::size_t number : numbers) {
    field.push_back(number == found.pockets.size() ? -1 : static_cast<std::int64_t>(number));
  }
  return field;
}

Json mouth_field(const All& all, const PocketAnswer& answer, std::size_t mouth) {
  Json field;
  field["contact"] = all[mouth].contact;
  field["squared_radius"] = all[mouth].squared_distance.str();
  field["between"] = numbers_field(answer.found, answer.between.at(mouth));
  return field;
}

Json pocket_field(const All& all, const PocketAnswer& answer, const Pocket& pocket) {
  Json field;
  field["peaks"] = Json::array();
  for (const std::size_t peak : pocket.peaks) {
    Json& one = field["peaks"].emplace_back(witness_field(all[peak]));
    one["squared_radius"] = all[peak].squared_distance.str();
  }
  field["maxima"] = contacts(all, pocket.maxima);
  field["difference_of_squares"] = Rational(pocket.height - pocket.highest_mouth).str();
  field["volume"] = pocket.volume.str();
  field["cell"] = Json::array();
  for (const std::size_t place : pocket.cell) {
    Json& one = field["cell"].emplace_back();
    one["index"] = index_of(all[place]);
    one["contact"] = all[place].contact;
  }
  field["mouths"] = Json::array();
  for (const std::size_t mouth : pocket.mouths) field["mouths"].push_back(mouth_field(all, answer, mouth));
  field["neighbours"] = numbers_field(answer.found, pocket.neighbours);
  field["widest_path"] = path_field(all, pocket.to_infinity);
  return field;
}

Json balls_field(const All& all, const Places& balls) {
  if (balls.empty()) return nullptr;
  Json field;
  field["squared_radius"] = all[balls.front()].squared_distance.str();
  field["balls"] = Json::array();
  for (const std::size_t ball : balls) field["balls"].push_back(witness_field(all[ball]));
  return field;
}

Json probe_field(const ProbeAnswer& probe) {
  Json field;
  field["probe"] = probe.radius.str();
  field["is"] = Json::array();
  for (const Passage passage : probe.passages) field["is"].push_back(passage_word(passage));
  return field;
}

}  // namespace

Json pockets_field(const All& all, const std::vector<PocketAnswer>& answers) {
  Json field = Json::array();
  for (const PocketAnswer& answer : answers) {
    Json& one = field.emplace_back();
    one["squared_persistence"] = Rational(answer.persistence * answer.persistence).str();
    const auto widest = widest_path(answer.found);
    one["pore_limiting_radius"] = widest ? path_field(all, *widest) : Json(nullptr);
    one["largest_cavity_radius"] = balls_field(all, largest_balls(all, answer.found));
    one["outside"] = contacts(all, answer.found.outside);
    one["pockets"] = Json::array();
    for (const Pocket& pocket : answer.found.pockets) one["pockets"].push_back(pocket_field(all, answer, pocket));
    one["probes"] = Json::array();
    for (const ProbeAnswer& probe : answer.probes) one["probes"].push_back(probe_field(probe));
  }
  return field;
}

// ---- The medial axis ----

Json medial_field(const All& all, const MedialAnswer& answer) {
  Json field;
  field["angles"] = Json::array();
  for (const AngleAnswer& angle : answer.angles) {
    Json& one = field["angles"].emplace_back();
    one["angle"] = std::to_string(angle.degrees);
    one["above"] = contacts(all, angle.above);
  }
  field["persistences"] = Json::array();
  for (const LengthAnswer& length : answer.lengths) {
    Json& one = field["persistences"].emplace_back();
    one["squared_persistence"] = Rational(length.persistence * length.persistence).str();
    one["levels"] = Json::array();
    for (const LevelCount& level : length.levels) {
      Json& count = one["levels"].emplace_back();
      count["index"] = level.index;
      count["squared_distance"] = level.value.str();
      count["points"] = level.points;
      count["above"] = level.above;
    }
  }
  return field;
}

// ---- Infinity ----

namespace {

// What skeleton_field() says of an unbounded segment or interval, without what is not there at infinity.
Json far_field(const Json& piece) {
  Json field;
  for (const auto& [key, value] : piece.items()) {
    if (key == "front") field.update(value);
    if (key != "front" && key != "front_contact") field[key] = value;
  }
  return field;
}

}  // namespace

Json infinity_field(const PointSet& set, const StableSet& infinity) {
  const Json all = skeleton_field(set, infinity);
  Json field;
  for (const char* key : {"segments", "intervals", "sectors"}) field[key] = Json::array();
  for (const char* key : {"segments", "intervals", "sectors"}) field[std::string("unbounded_") + key] = Json::array();
  for (const char* key : {"segments", "intervals"}) {
    for (const Json& piece : all[key]) {
      const bool is_far = piece["front"].is_object();
      field[is_far ? std::string("unbounded_") + key : key].push_back(is_far ? far_field(piece) : piece);
    }
  }
  for (std::size_t i = 0; i < infinity.sectors.size(); ++i) {
    field[is_unbounded(infinity.sectors[i]) ? "unbounded_sectors" : "sectors"].push_back(all["sectors"][i]);
  }
  return field;
}

// ---- Statistics ----

Json statistics_field(const StatisticsAnswer& answer) {
  const auto times = [](const std::map<std::size_t, std::size_t>& counted) {
    Json field = Json::array();
    for (const auto& [number, count] : counted) field.push_back(Json::array({number, count}));
    return field;
  };
  Json field;
  field["n_u2"] = times(answer.n_u2);
  field["n_s2"] = times(answer.n_s2);
  field["n_wcc"] = times(answer.n_wcc);
  return field;
}

}  // namespace oracle::vectors
