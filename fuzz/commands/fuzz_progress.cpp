#include "fuzz/commands/fuzz_progress.h"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

#include "cli/command.h"
#include "io/diagnostic.h"

namespace flowcert::commands {

namespace {

constexpr std::chrono::seconds kDelay{2};
constexpr std::chrono::milliseconds kRedraw{250};
constexpr std::size_t kCellWidth = 36;

std::pair<std::size_t, std::size_t> terminal_size() {
  winsize size{};
  if (::ioctl(STDERR_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col == 0) return {80, 24};
  return {size.ws_col, size.ws_row};
}

std::string time_text(double seconds) {
  const auto whole = static_cast<unsigned long long>(std::max(0.0, seconds));
  if (whole >= 3600) return fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
  return fmt::format("{}:{:02}", whole / 60, whole % 60);
}

// The lines have as many columns as the terminal has room for.
std::vector<std::string> family_lines(const fuzz::Tally& tally, std::size_t width) {
  const std::size_t cells = std::max<std::size_t>(1, width / kCellWidth);
  std::vector<std::string> lines;
  std::size_t k = 0;
  for (const auto& [name, cases] : tally.by_source) {
    if (k++ % cells == 0) lines.emplace_back();
    lines.back() += fmt::format("  {:<22} {:>10} ", name.substr(0, 22), with_commas(cases));
  }
  return lines;
}

}  // namespace

FuzzProgress::FuzzProgress(const fuzz::Campaign& campaign, std::optional<double> seconds)
    : campaign_(campaign),
      seconds_(seconds),
      cases_before_(campaign.tally().cases),
      is_terminal_(::isatty(STDERR_FILENO) == 1) {}

FuzzProgress::~FuzzProgress() { hide(); }

void FuzzProgress::hide() {
  if (lines_drawn_ == 0) return;
  io::tell(fmt::format("\r{}\033[J", lines_drawn_ > 1 ? fmt::format("\033[{}A", lines_drawn_ - 1) : ""));
  lines_drawn_ = 0;
}

std::string FuzzProgress::first_line(std::size_t cases) const {
  const double so_far = seconds_so_far();
  const double rate = static_cast<double>(cases - cases_before_) / so_far;
  double left = seconds_ ? *seconds_ - so_far : 0;
  std::string total;
  if (const auto expected = campaign_.expected_cases()) {
    const double by_count = rate > 0 ? static_cast<double>(*expected - std::min(cases, *expected)) / rate : 0;
    left = seconds_ ? std::min(left, by_count) : by_count;
    total = " of " + with_commas(*expected);
  }
  return fmt::format("{}{} cases, {:.0f}/s | {} | {}, {} | {} left", with_commas(cases), total, rate,
                     counted(campaign_.signatures().size(), "signature"),
                     counted(campaign_.failing_cases(), "failing case"),
                     counted(campaign_.counterexamples().size(), "finding"), time_text(left));
}

void FuzzProgress::operator()(std::size_t under_way) {
  const Clock::time_point now = Clock::now();
  if (!is_terminal_ || now - start_ < kDelay || now - last_drawn_ < kRedraw) return;
  last_drawn_ = now;
  const auto [width, height] = terminal_size();
  std::vector<std::string> lines{first_line(campaign_.tally().cases + under_way)};
  for (std::string& line : family_lines(campaign_.tally(), width)) lines.push_back(std::move(line));
  lines.resize(std::min(lines.size(), std::max<std::size_t>(height, 3) - 2));
  std::string text;
  for (const std::string& line : lines) text += (text.empty() ? "" : "\n") + line.substr(0, width - 1);
  hide();
  io::tell(text);
  lines_drawn_ = lines.size();
}

}  // namespace flowcert::commands
