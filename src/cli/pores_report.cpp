#include "cli/pores_report.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "cli/command.h"
#include "cli/table.h"

namespace flowcert::cli {

namespace {

constexpr std::size_t kShownRooms = 20, kShownWindows = 5, kShownAtoms = 12;

// A millionth of an ångström can be seen; very small and very large lengths have five digits.
std::string length_text(double value) {
  const double size = std::fabs(value);
  return (size >= 1e-2 && size < 1e6) || value == 0 ? fmt::format("{:.6f}", value) : fmt::format("{:.5g}", value);
}

std::string rounded_text(const Rational& number) { return fmt::format("{}", nearest_or_infinity(number)); }

// "0 C, 4 C and 7 more"
std::string some_atoms_text(const AtomNames* atoms, const std::vector<std::uint32_t>& ids, bool shows_all) {
  const std::size_t shown = shows_all ? ids.size() : std::min(ids.size(), kShownAtoms);
  std::vector<std::string> texts;
  for (const std::uint32_t id : std::span(ids).first(shown)) {
    texts.push_back(atoms != nullptr ? unbroken(fmt::format("{} {}", id, atoms->text(id))) : std::to_string(id));
  }
  const std::size_t others = ids.size() - shown;
  return fmt::format("{}{}", fmt::join(texts, ", "), others > 0 ? fmt::format(" and {} more", others) : "");
}

void print_ball_counts(const BallSet& balls) {
  print_row("balls", with_commas(balls.size()));
  if (const std::size_t hidden = balls.size() - balls.visible().size(); hidden > 0) {
    print_row("hidden balls", with_commas(hidden), "inside of another ball, whatever the probe");
  }
}

class Report {
 public:
  explicit Report(const PoresReport& report)
      : report_(report), pores_(report.what.pores), probe_(report.what.probe), atoms_(report.what.atoms) {
    shown_ = pores_.chambers().size();
    if (!report.shows_all) shown_ = std::min(shown_, kShownRooms);
  }

  void print() const {
    print_wrapped(fmt::format("{}, radii {}", report_.input, report_.what.radii));
    print_wrapped(
        "Lengths are radii of a probe that just fits, beyond the surfaces of the balls; regions are those of its "
        "centre. To touch is to fit.");
    print_counts();
    if (shown_ == 0) return print_that_there_is_none();
    print_chambers();
    print_windows();
    print_witnesses();
  }

 private:
  void print_counts() const {
    print_ball_counts(pores_.balls());
    print_row("chambers", with_commas(pores_.chambers().size()),
              report_.what.depth == 0 ? "of any depth"
                                      : fmt::format("of depth {} or more", rounded_text(report_.what.depth)));
    if (probe_) print_probe();
    if (!pores_.chambers().empty()) print_diameters();
    print_row("all of it", seconds_text(report_.seconds));
  }

  void print_probe() const {
    std::size_t open = 0, closed = 0;
    for (const Chamber& chamber : pores_.chambers()) {
      const ChamberStatus status = pores_.status(chamber, *probe_);
      open += status == ChamberStatus::kOpen;
      closed += status == ChamberStatus::kClosed;
    }
    print_row("probe", rounded_text(*probe_));
    print_row("open chambers", with_commas(open), "their gates are as wide");
    print_row("closed chambers", with_commas(closed), "they are as wide, and their gates are not");
    print_row("cavities", with_commas(pores_.cavities_at(*probe_)),
              "of any depth, from which the probe cannot get out");
  }

  void print_diameters() const {
    const auto& chambers = pores_.chambers();
    const WidestChambers widest = widest_chambers(pores_);
    if (widest.of_peak) {
      print_row("largest cavity diameter", diameter(chambers[*widest.of_peak].peaks[0]),
                fmt::format("twice the widest peak, of chamber {} (LCD)", *widest.of_peak));
    }
    if (widest.of_exit) {
      print_row("pore limiting diameter", diameter(*chambers[*widest.of_exit].exit),
                fmt::format("twice the widest exit, of chamber {} (PLD; of a finite set)", *widest.of_exit));
    }
  }

  void print_that_there_is_none() const {
    print_wrapped(pores_.cavities().empty() ? "no chamber: from wherever a probe fits, it can get out"
                                            : fmt::format("no chamber is as deep as {}; --depth 0 tells all",
                                                          rounded_text(report_.what.depth)));
  }

  void print_chambers() const {
    print_wrapped(
        fmt::format("\n{}", shown_ == pores_.chambers().size() ? "chambers, from the deepest one"
                                                               : fmt::format("the {} deepest chambers of {}", shown_,
                                                                             with_commas(pores_.chambers().size()))),
        2);
    print_wrapped(
        "  peak: where it is widest; gate: the widest way to a higher chamber or the outside; exit: the widest way to "
        "the outside; < 0: none where balls do not overlap",
        2);
    Table table(probe_ ? "rrrrrrl" : "rrrrrr", {"chamber", "peak", "gate", "depth", "exit", "windows"});
    if (probe_) table.cell("probe");
    for (std::size_t number = 0; number < shown_; ++number) {
      const Chamber& chamber = pores_.chambers()[number];
      const QuadraticNumber gate = chamber.gates.empty() ? QuadraticNumber() : pores_.value(chamber.gates[0]);
      table.row(std::to_string(number)).cell(value(chamber.peaks[0]));
      table.cell(chamber.gates.empty() ? "< 0" : length_text(nearest_or_infinity(gate)));
      table.cell(length_text(nearest_difference(pores_.value(chamber.peaks[0]), gate)));
      table.cell(chamber.exit ? value(*chamber.exit) : "< 0").cell(chamber.windows.size());
      if (probe_) table.cell(status_text(pores_.status(chamber, *probe_)));
    }
    table.print();
  }

  void print_windows() const {
    Table table("rrrrrll", {"from", "x", "y", "z", "diameter", "to", "atoms"});
    for (std::size_t number = 0; number < shown_; ++number) {
      std::vector<std::uint32_t> windows = pores_.chambers()[number].windows;
      if (!report_.shows_all && windows.size() > kShownWindows) windows.resize(kShownWindows);
      for (const std::uint32_t place : windows) {
        const PoreWindow& window = pores_.windows()[place];
        add_place(table.row(std::to_string(number)), window.point);
        table.cell(diameter(window.point)).cell(rooms_text(window, number)).cell(atoms_text(window.point));
      }
    }
    if (table.height() == 1) return print_wrapped("\nno window");
    print_wrapped(fmt::format("\ntheir windows, from the widest down{}: the narrowest places of ways to other chambers",
                              report_.shows_all ? "" : fmt::format(", at most {} of each", kShownWindows)),
                  2);
    table.print();
  }

  void print_witnesses() const {
    print_wrapped("\ntheir peaks and gates, and the atoms nearest to these places", 2);
    Table table("rlrrrl", {"chamber", "of", "x", "y", "z", "atoms"});
    for (std::size_t number = 0; number < shown_; ++number) {
      const Chamber& chamber = pores_.chambers()[number];
      add_witnesses(table, number, "peak", chamber.peaks);
      add_witnesses(table, number, "gate", chamber.gates);
    }
    table.print();
  }

  // The first one of several is told, but for --all.
  void add_witnesses(Table& table, std::size_t chamber, const char* what, const std::vector<std::uint32_t>& all) const {
    for (std::size_t k = 0; k < (report_.shows_all ? all.size() : std::min<std::size_t>(all.size(), 1)); ++k) {
      table.row(std::to_string(chamber));
      table.cell(all.size() == 1 ? what : fmt::format("{}, {} of {}", what, k + 1, all.size()));
      add_place(table, all[k]);
      table.cell(atoms_text(all[k]));
    }
  }

  [[nodiscard]] std::string rooms_text(const PoreWindow& window, std::size_t chamber) const {
    std::vector<std::string> rooms;
    for (const std::uint32_t room : window.rooms) {
      if (room == chamber) continue;
      const std::size_t chambers = pores_.chambers().size();
      rooms.push_back(room == Pores::kOutside ? "outside"
                      : room < chambers       ? std::to_string(room)
                                              : fmt::format("vestibule {}", room - chambers));
    }
    return fmt::format("{}", fmt::join(rooms, ", "));
  }
  [[nodiscard]] std::string atoms_text(std::uint32_t point) const {
    return some_atoms_text(atoms_, pores_.points()[point].contact, report_.shows_all);
  }

  // Adds three cells.
  void add_place(Table& table, std::uint32_t point) const {
    for (const QuadraticNumber& coordinate : pores_.center(point)) {
      const double x = nearest_or_infinity(coordinate);
      table.cell(std::fabs(x) < 1e6 ? fmt::format("{:.3f}", x) : fmt::format("{:.4g}", x));
    }
  }
  [[nodiscard]] std::string value(std::uint32_t point) const {
    return length_text(nearest_or_infinity(pores_.value(point)));
  }
  [[nodiscard]] std::string diameter(std::uint32_t point) const {
    return length_text(nearest_or_infinity(QuadraticNumber(Rational(2)) * pores_.value(point)));
  }

  const PoresReport& report_;
  const Pores& pores_;
  const std::optional<Rational>& probe_;
  const AtomNames* atoms_;
  std::size_t shown_ = 0;
};

}  // namespace

void print_pores_report(const PoresReport& report) { Report(report).print(); }

void print_cavity_curve(const Pores& pores) {
  print_wrapped("\nthe number of cavities, for probes up to this radius and above that of the next row", 2);
  Table table("rr", {"probe", "cavities"});
  for (const CavityStep& step : pores.cavity_steps()) {
    table.row(length_text(nearest_or_infinity(pores.value(step.point)))).cell(step.count);
  }
  table.print();
}

void print_cavities_report(const CavitiesReport& report) {
  const CavitiesToWrite& what = report.what;
  print_wrapped(fmt::format("{}, radii {}", report.input, what.radii));
  print_wrapped(
      "The probe's radius is measured to the surfaces of the balls; cavities are the places of its centre from which "
      "it "
      "cannot get out. To touch is to fit.");
  print_ball_counts(what.balls);
  print_row("probe", rounded_text(what.probe));
  print_row("cavities", with_commas(what.cavities.size()));
  print_row("all of it", seconds_text(report.seconds));
  if (what.cavities.empty()) return print_wrapped("no cavity: from wherever the probe fits, it can get out");
  const std::size_t all = what.cavities.size(), shown = report.shows_all ? all : std::min(all, kShownRooms);
  print_wrapped(fmt::format("\n{}the atoms that line them",
                            shown == all ? "cavities, and "
                                         : fmt::format("the first {} cavities of {}, and ", shown, with_commas(all))),
                2);
  Table table("rrl", {"cavity", "atoms", ""});
  for (std::size_t number = 0; number < shown; ++number) {
    const auto& atoms = what.cavities[number].lining;
    table.row(std::to_string(number)).cell(atoms.size()).cell(some_atoms_text(what.atoms, atoms, report.shows_all));
  }
  table.print();
}

}  // namespace flowcert::cli
