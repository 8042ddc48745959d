// flowcert-oracle: the reference on the command line.
//
//   stationary INPUT        lists all stationary points of a small input, by search over all subsets
//   certify INPUT RECORDS   judges claimed stationary points, drawn at random, by linear scans
//   orbit INPUT --from X    the flow from one position, by linear scans over all points
//   witness INPUT CYCLES    judges what shows that pairs of dimension 1 occur, by linear scans
//   pores BALLS             chambers between balls, by search over all subsets
//
// Exit status: 0 all right; 1 a claim is wrong; 2 unusable input or usage, with one line on standard error. Without a
// command it prints what there is on standard output. Nothing was judged then, so the status is 2.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <memory>
#include <numeric>
#include <random>
#include <sstream>
#include <string_view>

#include "oracle/fast/point_set.h"
#include "oracle/orbit.h"
#include "oracle/program/answer_fields.h"
#include "oracle/program/out_of_memory.h"
#include "oracle/program/pores_field.h"
#include "oracle/program/read_balls.h"
#include "oracle/program/read_points.h"
#include "oracle/program/read_records.h"
#include "oracle/program/read_witnesses.h"
#include "oracle/program/waiting_line.h"
#include "oracle/stationary_points.h"

namespace {

constexpr int kWrong = 1;
constexpr int kUnusable = 2;

void print_json(const oracle::Answer& answer) {
  oracle::Json header;
  header["format"] = "oracle-stationary-points";
  header["format_version"] = 1;
  header["points"] = answer.points;
  header.update(oracle::counts_field(answer));
  std::cout << header.dump() << '\n';
  for (const auto& s : answer.stationary) std::cout << oracle::record_field(s).dump() << '\n';
}

std::string exact_text(const oracle::Rational& x) { return x.str(); }

// A long number is rounded for people, and marked with ~.
std::string short_text(const oracle::Rational& x) {
  std::string exact = x.str();
  if (exact.size() <= 10) return exact;
  return "~" + boost::multiprecision::mpf_float_50(x).str(6);
}

using NumberText = std::string (*)(const oracle::Rational&);

std::string text(const oracle::Point& x, NumberText number) {
  return number(x[0]) + " " + number(x[1]) + " " + number(x[2]);
}

void print_text(const oracle::StationaryPoint& s, NumberText number) {
  std::cout << "index " << s.face_dimension;
  if (s.face_dimension != s.hull_dimension) std::cout << '-' << s.hull_dimension;
  std::cout << " at " << text(s.center, number) << " contact";
  for (const std::size_t name : s.contact) std::cout << ' ' << name;
  std::cout << " squared_distance " << number(s.squared_distance) << '\n';
}

void print_text(const oracle::Answer& answer) {
  const auto critical = answer.critical_counts();
  const auto regular = answer.regular_counts();
  std::cout << "points " << answer.points << ", merged duplicates " << answer.merged_duplicates << "\ncritical "
            << critical[0] << ' ' << critical[1] << ' ' << critical[2] << ' ' << critical[3]
            << "\nregular stationary 1-2: " << regular[0] << ", 1-3: " << regular[1] << ", 2-3: " << regular[2] << '\n';
  for (const auto& s : answer.stationary) print_text(s, exact_text);
}

void print_json(const oracle::PointSet& set, const oracle::Point& start, const oracle::Orbit& path) {
  oracle::Json object;
  object["format"] = "oracle-orbit";
  object["format_version"] = 1;
  object.update(oracle::orbit_field(set, start, path));
  std::cout << object.dump() << '\n';
}

void print_text(const oracle::PointSet& set, const oracle::Point& start, const oracle::Orbit& path) {
  std::cout << "orbit from " << text(start, short_text) << '\n' << std::left;
  const auto row = [](std::string_view number, std::string_view type, std::string_view driver, std::string_view end) {
    std::cout << std::setw(4) << number << std::setw(8) << type << ' ' << std::setw(36) << driver << ' '
              << std::setw(36) << end;
  };
  if (!path.segments.empty()) {
    row("", "type", "driver", "end");
    std::cout << " contact set of the end\n";
  }
  for (std::size_t k = 0; k < path.segments.size(); ++k) {
    const oracle::FlowSegment& segment = path.segments[k];
    row(std::to_string(k + 1), segment_type(set, segment), text(segment.driver, short_text),
        segment.end ? text(*segment.end, short_text) : "infinity");
    for (const std::size_t name : segment.end_contact) std::cout << ' ' << name;
    std::cout << '\n';
  }
  std::cout << (path.segments.empty() ? "stays: " : "ends: ");
  if (!path.limit) std::cout << "infinity\n";
  if (path.limit) print_text(*path.limit, short_text);
}

std::string with_commas(std::size_t number) {
  std::string digits = std::to_string(number);
  for (std::size_t place = digits.size(); place > 3; place -= 3) digits.insert(place - 3, 1, ',');
  return digits;
}

// Small inputs get the plain class. On larger ones its search would take up to twenty times as long, its scan forty.
std::unique_ptr<oracle::PointSet> point_set(const std::vector<std::array<double, 3>>& rows) {
  constexpr std::size_t kMostPlainPoints = 24;
  if (rows.size() <= kMostPlainPoints) return std::make_unique<oracle::PointSet>(rows);
  return std::make_unique<oracle::fast::PointSet>(rows);
}

oracle::Answer search(const std::vector<std::array<double, 3>>& rows) {
  const oracle::WaitingLine line("searching all subsets");
  return oracle::stationary_points(*point_set(rows));
}

oracle::Orbit follow(const oracle::PointSet& set, const oracle::Point& start) {
  const oracle::WaitingLine line("following the orbit");
  return oracle::orbit(set, start);
}

int run_stationary(const std::string& input, bool json, std::size_t limit) {
  const auto rows = oracle::read_point_file(input);
  if (rows.size() > limit) {
    throw oracle::UnusableInput(input + ": " + with_commas(rows.size()) +
                                " points; the search over all subsets of four takes time n^5 (see --limit)");
  }
  const oracle::Answer answer = search(rows);
  json ? print_json(answer) : print_text(answer);
  return 0;
}

// Ascending places of `count` records out of `size`, or of all of them.
std::vector<std::size_t> draw(std::size_t size, std::size_t count, std::uint64_t seed) {
  std::vector<std::size_t> all(size);
  std::iota(all.begin(), all.end(), std::size_t{0});
  std::vector<std::size_t> drawn;
  std::mt19937_64 random(seed);
  std::sample(all.begin(), all.end(), std::back_inserter(drawn), count, random);
  return drawn;
}

struct Certified {
  std::size_t right = 0, drawn = 0, points = 0;
};

// Whether the records of samples have their positions. Where they do not, `compute` took other points from the file,
// because of an option or of what it knows of the format. Where a sample is no record, that is left to the sampling.
bool are_of_these_points(const oracle::RecordFile& file, const std::vector<std::array<double, 3>>& rows,
                         const std::string& records, oracle::WaitingLine& line) {
  for (std::size_t place = 0; place < file.records.size(); ++place) {
    if (!file.records[place].starts_with("{\"index\":0,")) continue;
    const std::string where = records + ":" + std::to_string(place + 2) + ": ";
    const oracle::StationaryPoint claim = oracle::parse_record(file.records[place], where).claim;
    if (claim.contact.size() != 1 || claim.contact[0] >= rows.size()) continue;
    if (claim.center == oracle::exact(rows[claim.contact[0]])) continue;
    line.say(where + "FC-IN-03: point " + std::to_string(claim.contact[0]) + " is elsewhere in the input");
    return false;
  }
  return true;
}

// Says what is wrong, line by line. Nothing is certified where the records are of other points.
std::optional<Certified> certify_records(const std::string& input, const std::string& records, std::size_t sample,
                                         std::uint64_t seed) {
  oracle::WaitingLine line("certifying");
  const auto rows = oracle::read_point_file(input);
  const auto points = point_set(rows);
  const oracle::PointSet& set = *points;
  std::ifstream in(records);
  if (!in) throw oracle::UnusableInput(records + ": cannot be opened");
  const oracle::RecordFile file = oracle::read_record_file(in, records);
  if (file.points != rows.size() || file.merged_duplicates != set.merged_duplicates) {
    line.say(records + ":1: FC-IN-03: the header claims " + std::to_string(file.points) + " points and " +
             std::to_string(file.merged_duplicates) + " merged, the input has " + std::to_string(rows.size()) +
             " and " + std::to_string(set.merged_duplicates));
    return std::nullopt;
  }
  if (!are_of_these_points(file, rows, records, line)) return std::nullopt;
  const auto drawn = draw(file.records.size(), sample, seed);
  Certified result{0, drawn.size(), set.points.size()};
  std::size_t judged = 0;
  for (const std::size_t place : drawn) {
    line.tell(judged++, drawn.size());
    const std::string where = records + ":" + std::to_string(place + 2) + ": ";
    const oracle::Record claimed = oracle::parse_record(file.records[place], where);
    const auto fault = claimed.fault ? claimed.fault : oracle::certify(set, claimed.claim);
    if (!fault) ++result.right;
    if (fault) line.say(where + fault->clause + ": " + fault->explanation);
  }
  return result;
}

int run_certify(const std::string& input, const std::string& records, std::size_t sample, std::uint64_t seed) {
  const auto start = std::chrono::steady_clock::now();
  const auto result = certify_records(input, records, sample, seed);
  if (!result) return kWrong;
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  std::cout << "oracle: " << with_commas(result->right) << " of " << with_commas(result->drawn)
            << " sampled stationary points certified by linear scan over " << with_commas(result->points)
            << " points, exactly (" << std::lround(seconds.count()) << " s)\n";
  return result->right == result->drawn ? 0 : kWrong;
}

int run_orbit(const std::string& input, const std::string& from, bool json) {
  const oracle::Point start = oracle::parse_position(from, "--from: ");
  const auto points = point_set(oracle::read_point_file(input));
  const oracle::PointSet& set = *points;
  if (set.points.empty()) throw oracle::UnusableInput(input + ": there are no points");
  const oracle::Orbit path = follow(set, start);
  json ? print_json(set, start, path) : print_text(set, start, path);
  return 0;
}

std::string contact_text(const oracle::Contact& contact) {
  std::string text;
  for (const std::size_t name : contact) text += (text.empty() ? "" : ",") + std::to_string(name);
  return text;
}

int run_witness(const std::string& input, const std::string& cycles) {
  std::ifstream in(cycles);
  if (!in) throw oracle::UnusableInput(cycles + ": cannot be opened");
  const std::vector<oracle::Witness> witnesses = oracle::read_witnesses(in, cycles);
  if (witnesses.empty()) throw oracle::UnusableInput(cycles + ": there are no cycles");
  const auto points = point_set(oracle::read_point_file(input));
  oracle::WaitingLine line("judging witnesses");
  bool are_right = true;
  for (std::size_t k = 0; k < witnesses.size(); ++k) {
    line.tell(k, witnesses.size());
    const std::string fault = oracle::fault(*points, witnesses[k]);
    line.say("pair " + contact_text(witnesses[k].birth) + "/" + contact_text(witnesses[k].death) + ": " +
             (fault.empty() ? "accepted" : "refused: " + fault));
    are_right = are_right && fault.empty();
  }
  return are_right ? 0 : kWrong;
}

oracle::Rational length(const std::string& text, const std::string& option) {
  const oracle::Rational number = oracle::exact_number(text, option + ": ");
  if (number < 0) throw oracle::UnusableInput(option + ": " + text + " is below 0");
  return number;
}

int run_pores(const std::string& input, const std::string& depth, const std::string& probe, std::size_t limit) {
  oracle::PoresQuestion asked{{}, length(depth, "--depth"), std::nullopt};
  if (!probe.empty()) asked.probe = length(probe, "--probe");
  asked.balls = oracle::read_ball_file(input);
  if (asked.balls.size() > limit) {
    throw oracle::UnusableInput(input + ": " + with_commas(asked.balls.size()) +
                                " balls; the search over all subsets of four takes time n^5 (see --limit)");
  }
  const oracle::WaitingLine line("searching all subsets");
  std::cout << oracle::pores_answer(asked).dump() << '\n';
  return 0;
}

// Help with its examples first. It is made here, because versions of CLI11 lay it out differently.
struct HelpFormatter : CLI::Formatter {
  static std::string row(const std::string& left, const std::string& right) {
    std::ostringstream out;
    out << std::left << std::setw(30) << "  " + left << right << '\n';
    return out.str();
  }
  static std::string options(const char* heading, const CLI::App& app, bool positional) {
    std::string text;
    for (const CLI::Option* option : app.get_options()) {
      if (option->get_positional() != positional) continue;
      std::string left = option->get_name(positional, !positional);
      if (option->get_type_size() != 0) left += ' ' + option->get_type_name();
      if (!option->get_default_str().empty()) left += '=' + option->get_default_str();
      if (option->get_required()) left += " REQUIRED";
      text += row(left, option->get_description());
    }
    return text.empty() ? "" : std::string("\n") + heading + ":\n" + text;
  }
  std::string make_help(const CLI::App* app, std::string name, CLI::AppFormatMode) const override {
    std::string usage = "Usage: " + name + " [OPTIONS]", commands;
    for (const CLI::Option* option : app->get_options()) {
      if (option->get_positional()) usage += ' ' + option->get_name(true, false);
    }
    for (const CLI::App* command : app->get_subcommands({})) {
      commands += row(command->get_name(), command->get_description());
    }
    if (!commands.empty()) {
      usage += " SUBCOMMAND";
      commands = "\nSubcommands:\n" + commands;
    }
    return app->get_description() + '\n' + usage + "\n\n" + app->get_footer() + '\n' +
           options("Positionals", *app, true) + options("Options", *app, false) + commands;
  }
};

int run(int argc, char** argv) {
  CLI::App app{"The exact reference: flow and stationary points by their definitions alone"};
  app.name("flowcert-oracle");
  app.formatter(std::make_shared<HelpFormatter>());
  app.require_subcommand(1);
  app.footer(
      "Examples:\n  flowcert-oracle stationary cube.xyz\n"
      "  flowcert-oracle certify bunny.xyz bunny.jsonl --sample 200 --seed 1");
  std::string input, records, from, cycles, probe, depth = "0";
  bool json = false;
  std::size_t limit = 100, ball_limit = 40;
  std::int64_t sample = 200;
  std::uint64_t seed = 1;

  CLI::App& list = *app.add_subcommand("stationary", "List all stationary points of a small input");
  list.add_option("INPUT", input, "XYZ file, or OBJ (.obj)")->required();
  list.add_flag("--json", json, "JSON Lines instead of text");
  list.add_option("--limit", limit, "Refuse inputs of more points")->capture_default_str();
  list.footer(
      "Examples:\n  flowcert-oracle stationary cube.xyz\n"
      "  flowcert-oracle stationary cube.xyz --json");

  CLI::App& judge = *app.add_subcommand("certify", "Judge claimed stationary points of an input of any size");
  judge.add_option("INPUT", input, "XYZ file, or OBJ (.obj)")->required();
  judge.add_option("RECORDS", records, "What 'flowcert compute -o' wrote for it")->required();
  judge.add_option("--sample", sample, "How many records to draw; all if there are fewer")
      ->capture_default_str()
      ->check(CLI::Range(std::int64_t{1}, std::int64_t{1} << 62));
  judge.add_option("--seed", seed, "Seed of the draw")->capture_default_str();
  judge.footer(
      "Examples:\n  flowcert-oracle certify bunny.xyz bunny.jsonl --sample 200 --seed 1\n"
      "  flowcert-oracle certify cube.xyz cube.jsonl");

  CLI::App& flow = *app.add_subcommand("orbit", "Follow the flow from a position, segment by segment");
  flow.add_option("INPUT", input, "XYZ file, or OBJ (.obj)")->required();
  flow.add_option("--from", from,
                  "The position X,Y,Z: decimals (the nearest doubles), hex floats or fractions p/q (exact)")
      ->required();
  flow.add_flag("--json", json, "One JSON object, all exact, instead of a table");
  flow.footer(
      "Examples:\n  flowcert-oracle orbit bunny.xyz --from -1/2,0.25,0x1p-3\n"
      "  flowcert-oracle orbit cube.xyz --from 1/3,1/4,1/5 --json");

  CLI::App& shown = *app.add_subcommand("witness", "Judge witnesses of tunnels of an input of any size");
  shown.add_option("INPUT", input, "XYZ file, or OBJ (.obj)")->required();
  shown.add_option("CYCLES", cycles, "What 'flowcert cycles --witness --json' printed for it")->required();
  shown.footer(
      "Examples:\n  flowcert-oracle witness cube.xyz cube.json\n"
      "  flowcert-oracle witness bunny.xyz bunny.json");

  CLI::App& rooms = *app.add_subcommand("pores", "Chambers between a few balls, with their windows, in JSON");
  rooms.add_option("BALLS", input, "Lines x y z r: decimals or fractions p/q (exact)")->required();
  rooms.add_option("--depth", depth, "List the chambers of this depth or deeper")->capture_default_str();
  rooms.add_option("--probe", probe, "List the cavities at this probe, too, by the balls that line them");
  rooms.add_option("--limit", ball_limit, "Refuse inputs of more balls")->capture_default_str();
  rooms.footer("Examples:\n  flowcert-oracle pores cage.balls\n  flowcert-oracle pores cage.balls --depth 1/2");

  if (argc <= 1) {
    std::cout << app.help();
    return kUnusable;
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& request) {  // --help
    return app.exit(request);
  } catch (const CLI::ParseError& error) {
    throw oracle::UnusableInput(std::string(error.what()) + " (see --help)");
  }
  if (shown.parsed()) return run_witness(input, cycles);
  if (rooms.parsed()) return run_pores(input, depth, probe, ball_limit);
  if (flow.parsed()) return run_orbit(input, from, json);
  return list.parsed() ? run_stationary(input, json, limit)
                       : run_certify(input, records, static_cast<std::size_t>(sample), seed);
}

}  // namespace

int main(int argc, char** argv) {
  oracle::prepare_for_out_of_memory();
  try {
    const int status = run(argc, argv);
    std::cout.flush();
    if (std::cout) return status;
    std::cerr << "flowcert-oracle: standard output cannot be written\n";
  } catch (const std::exception& error) {
    // A path may hold a line's end, but an error is one line.
    std::string line = error.what();
    std::replace_if(line.begin(), line.end(), [](char c) { return (c >= 0 && c < 0x20) || c == 0x7f; }, '?');
    std::cerr << "flowcert-oracle: " << line << '\n';
  }
  return kUnusable;
}
