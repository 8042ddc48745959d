#include "io/write_cycles.h"

#include <algorithm>
#include <optional>
#include <span>
#include <string>
#include <variant>

#include "geometry/difference_of_roots.h"
#include "geometry/floating_point.h"
#include "io/json_fields.h"
#include "io/layer.h"

namespace flowcert {

using namespace io;

namespace {

class CycleFields {
 public:
  explicit CycleFields(const CyclesToWrite& what)
      : complex_(what.complex), stationary_(complex_.stationary()), persistence_(complex_.persistence()) {
    if (what.has_witness) loops_.emplace(stationary_, complex_.links(), persistence_);
  }

  [[nodiscard]] Json of(const Cycle& cycle) const {
    const Rational birth = persistence_.squared_value(cycle.pair.birth);
    const Rational death = persistence_.squared_value(*cycle.pair.death);
    Json json;
    json["birth"] = critical_point_field(complex_, cycle.pair.birth, birth);
    json["death"] = critical_point_field(complex_, *cycle.pair.death, death);
    json["length"] = double_field(geometry::nearest_difference_of_roots(death, birth));
    if (cycle.level) json["squared_level"] = to_text(cycle.level->exact());
    std::visit([&](const auto& chain) { add(json, chain); }, cycle.chain);
    if (loops_) json["witness"] = witness(cycle.pair);
    return json;
  }

 private:
  void add(Json& json, const LoopCycle& loop) const {
    json["edges"] = contacts(loop.edges);
    json["polygons"] = loop.polygons;
    json["surface"] = contacts(loop.surface);
    json["loop_length"] = double_field(loop_length(complex_, loop));
  }

  void add(Json& json, const Void& space) const {
    json["maxima"] = contacts(space.maxima);
    json["cell"] = Json::array();
    for (const std::uint32_t record : space.cell) {
      json["cell"].push_back(
          {{"index", index_field(stationary_.index(record))}, {"contact", stationary_.contact(record)}});
    }
    json["walls"] = contacts(space.walls);
    json["volume"] = double_field(complex_.volumes().nearest_sum(space.cell));
  }

  void add(Json& json, const JoinedComponents& joined) const {
    json["components"] = Json::array();
    for (const std::vector<std::uint32_t>& component : joined) {
      Json samples = Json::array();
      for (const std::uint32_t sample : component) samples.push_back(stationary_.contact(sample).front());
      json["components"].push_back(std::move(samples));
    }
  }

  [[nodiscard]] Json witness(const PersistencePair& pair) const {
    const LoopWitness found = loops_->witness(pair);
    Json json;
    json["loop"] = contacts(found.loop);
    json["surface"] = contacts(found.surface);
    json["cocycle"] = contacts(found.cocycle);
    json["met"] = contacts(found.met);
    return json;
  }

  [[nodiscard]] Json contacts(std::span<const std::uint32_t> records) const {
    Json all = Json::array();
    for (const std::uint32_t record : records) all.push_back(stationary_.contact(record));
    return all;
  }

  const FlowComplex& complex_;
  const StationaryPoints& stationary_;
  const Persistence& persistence_;
  std::optional<Loops> loops_;
};

}  // namespace

void write_cycles(std::ostream& out, const CyclesToWrite& what) {
  const geometry::IeeeDoubles ieee;
  const CycleFields fields(what);
  Json json = header_fields("flowcert-cycles", 1, what.complex.points());
  add_counts(json, what.complex.points(), what.complex.stationary());
  json["dimension"] = what.dimension;
  json["pairs"] = std::ranges::count_if(what.complex.persistence().pairs(), [&](const PersistencePair& pair) {
    return pair.dimension == what.dimension && pair.death;
  });
  // The cycles come last, and are written as they are made.
  json["cycles"] = Json::array();
  std::string text = json.dump();
  text.resize(text.size() - 2);
  out << text;
  for (std::size_t k = 0; k < what.cycles.size(); ++k) {
    out << (k > 0 ? "," : "") << fields.of(what.cycles[k]).dump();
  }
  out << "]}\n";
}

}  // namespace flowcert
