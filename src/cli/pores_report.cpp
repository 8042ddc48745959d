#include "cli/pores_report.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "cli/command.h"
#include "cli/table.h"

namespace flowcert::cli {

namespace {

constexpr std::size_t kShownChambers = 20, kShownWindows = 5;

// A millionth of an ångström can be seen; very small and very large lengths have seven digits.
std::string length_text(double value) {
  const double size = std::fabs(value);
  return (size >= 1e-2 && size < 1e6) || value == 0 ? fmt::format("{:.6f}", value) : fmt::format("{:.7g}", value);
}

class Report {
 public:
  explicit Report(const PoresReport& report)
      : report_(report), pores_(report.what.pores), probe_(report.what.probe), atoms_(report.what.atoms) {
    shown_ = pores_.chambers().size();
    if (!report.shows_all) shown_ = std::min(shown_, kShownChambers);
  }

  void print() const {
    print_wrapped(fmt::format("{}, radii {}", report_.input, report_.radii));
    print_wrapped(
        "Lengths are radii of a probe that just fits, beyond the surfaces of the balls; regions are those of its "
        "centre. To touch is to fit.");
    print_counts();
    if (shown_ == 0) return;
    print_chambers();
    print_windows();
  }

 private:
  void print_counts() const {
    const std::size_t all = pores_.balls().size();
    print_row("balls", with_commas(all));
    if (const std::size_t hidden = all - pores_.balls().visible().size(); hidden > 0) {
      print_row("hidden balls", with_commas(hidden), "inside of another ball, whatever the probe");
    }
    print_row("chambers", with_commas(pores_.chambers().size()),
              fmt::format("of depth {} or more; {} of any depth", to_text_of(report_.what.depth),
                          with_commas(pores_.cavities().size())));
    if (probe_) print_probe();
    if (!pores_.chambers().empty()) print_diameters();
    print_row("all of it", seconds_text(report_.seconds));
  }

  static std::string to_text_of(const Rational& number) { return fmt::format("{}", nearest_or_infinity(number)); }

  void print_probe() const {
    std::size_t open = 0, closed = 0;
    for (const Chamber& chamber : pores_.chambers()) {
      const ChamberStatus status = pores_.status(chamber, *probe_);
      open += status == ChamberStatus::kOpen;
      closed += status == ChamberStatus::kClosed;
    }
    print_row("probe", to_text_of(*probe_));
    print_row("open chambers", with_commas(open), "their gates are as wide");
    print_row("closed chambers", with_commas(closed), "they are as wide, and their gates are not");
    print_row("cavities", with_commas(pores_.cavities_at(*probe_)),
              "of any depth, from which the probe cannot get out");
  }

  void print_diameters() const {
    std::size_t widest = 0;
    std::optional<std::size_t> limiting;
    const auto& chambers = pores_.chambers();
    for (std::size_t number = 0; number < chambers.size(); ++number) {
      if (rank(chambers[number].peaks[0]) < rank(chambers[widest].peaks[0])) widest = number;
      const std::optional<std::uint32_t> exit = chambers[number].exit;
      if (exit && (!limiting || rank(*exit) < rank(*chambers[*limiting].exit))) limiting = number;
    }
    print_row("largest cavity diameter", diameter(chambers[widest].peaks[0]),
              fmt::format("twice the widest peak, of chamber {} (LCD)", widest));
    if (limiting) {
      print_row("pore limiting diameter", diameter(*chambers[*limiting].exit),
                fmt::format("twice the widest exit, of chamber {} (PLD; of a finite set)", *limiting));
    }
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
    Table table(probe_ ? "rrrrrrrrrl" : "rrrrrrrrr",
                {"chamber", "x", "y", "z", "peak", "gate", "depth", "exit", "windows"});
    if (probe_) table.cell("probe");
    for (std::size_t number = 0; number < shown_; ++number) {
      const Chamber& chamber = pores_.chambers()[number];
      add_place(table.row(std::to_string(number)), chamber.peaks[0]);
      table.cell(value(chamber.peaks[0]));
      if (chamber.gates.empty()) {
        table.cell("< 0").cell("");
      } else {
        table.cell(value(chamber.gates[0]));
        table.cell(length_text(nearest_difference(pores_.value(chamber.peaks[0]), pores_.value(chamber.gates[0]))));
      }
      table.cell(chamber.exit ? value(*chamber.exit) : "< 0").cell(chamber.windows.size());
      if (probe_) table.cell(status_text(pores_.status(chamber, *probe_)));
    }
    table.print();
  }

  void print_windows() const {
    print_wrapped(fmt::format("\ntheir windows, from the widest down{}: the narrowest places of ways to other chambers",
                              report_.shows_all ? "" : fmt::format(", at most {}", kShownWindows)),
                  2);
    Table table("rrrrrll", {"chamber", "x", "y", "z", "diameter", "to", "atoms"});
    for (std::size_t number = 0; number < shown_; ++number) {
      std::vector<std::uint32_t> windows = pores_.chambers()[number].windows;
      if (!report_.shows_all && windows.size() > kShownWindows) windows.resize(kShownWindows);
      for (const std::uint32_t place : windows) {
        const PoreWindow& window = pores_.windows()[place];
        add_place(table.row(std::to_string(number)), window.point);
        table.cell(diameter(window.point)).cell(rooms_text(window, number)).cell(atoms_text(window.point));
      }
    }
    table.print();
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
    std::vector<std::string> texts;
    for (const std::uint32_t id : pores_.points()[point].contacts) {
      texts.push_back(atoms_ != nullptr ? unbroken(fmt::format("{} {}", id, atoms_->text(id))) : std::to_string(id));
    }
    return fmt::format("{}", fmt::join(texts, ", "));
  }

  void add_place(Table& table, std::uint32_t point) const {
    for (const QuadraticNumber& coordinate : pores_.position(point)) {
      table.cell(fmt::format("{:.3f}", nearest_or_infinity(coordinate)));
    }
  }
  [[nodiscard]] std::uint32_t rank(std::uint32_t point) const { return pores_.points()[point].rank; }
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

}  // namespace flowcert::cli
