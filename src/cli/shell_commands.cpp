// `flowcert completion` and `flowcert manual` print what the build leaves in share/ of the build folder, for
// `cmake --install`. The hidden `flowcert share-files` writes it there.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>

#include "cli/command.h"
#include "cli/command_line.h"
#include "cli/completion_scripts.h"
#include "cli/manual_page.h"
#include "flowcert/reproducibility.h"
#include "io/number_text.h"
#include "io/output_file.h"

namespace flowcert::cli {

namespace {

namespace fs = std::filesystem;

std::string version_of_pages() { return "flowcert " + reproducibility().version; }

std::string script_for(const DescribedCommand& program, const std::string& shell) {
  if (shell == "bash") return bash_completion(program);
  return shell == "zsh" ? zsh_completion(program) : fish_completion(program);
}

std::string page_of(const DescribedCommand& program, const std::vector<std::string>& words) {
  const std::string name = fmt::format("{}{}{}", program.name, words.empty() ? "" : " ", fmt::join(words, " "));
  for (const DescribedCommand* command : with_all_below(program)) {
    if (command->name == name) return manual_page(program, *command, version_of_pages());
  }
  throw InvalidInput("there is no command " + in_quotes(fmt::format("{}", fmt::join(words, " "))));
}

void write_shared_file(const fs::path& path, const std::string& text) {
  fs::create_directories(path.parent_path());
  io::write_whole_file(path.string(), [&](std::ostream& out) { out << text; });
}

void write_shared_files(const fs::path& folder, const DescribedCommand& program) {
  write_shared_file(folder / "bash-completion/completions" / program.name, bash_completion(program));
  write_shared_file(folder / "zsh/site-functions" / ("_" + program.name), zsh_completion(program));
  write_shared_file(folder / "fish/vendor_completions.d" / (program.name + ".fish"), fish_completion(program));
  for (const DescribedCommand* command : with_all_below(program)) {
    write_shared_file(folder / "man/man1" / (page_name(*command) + ".1"),
                      manual_page(program, *command, version_of_pages()));
  }
}

void add_completion_command(CLI::App& app) {
  auto shell = std::make_shared<std::string>();
  CLI::App* command = app.add_subcommand("completion", "A script by which bash, zsh or fish completes words");
  command->group(kSetUpGroup);
  command->add_option("SHELL", *shell, "bash, zsh or fish")->required()->check(CLI::IsMember({"bash", "zsh", "fish"}));
  command->footer(
      "cmake --install puts all three where the shells look for them. A program that is not installed needs one of\n"
      "  source <(flowcert completion bash)       # in ~/.bashrc\n"
      "  source <(flowcert completion zsh)        # in ~/.zshrc, after compinit\n"
      "  flowcert completion fish | source        # in ~/.config/fish/config.fish\n\n"
      "Examples:\n  flowcert completion bash >flowcert.bash\n  flowcert completion zsh >_flowcert");
  command->callback([&app, shell] { fmt::print("{}", script_for(described(app), *shell)); });
}

void add_manual_command(CLI::App& app) {
  auto words = std::make_shared<std::vector<std::string>>();
  CLI::App* command = app.add_subcommand("manual", "The manual page of the program, or of a command, for man");
  command->group(kSetUpGroup);
  command->add_option("COMMAND", *words, "Of this command; of the program, without it");
  command->footer("Examples:\n  flowcert manual | man -l -\n  flowcert manual compute >flowcert-compute.1");
  command->callback([&app, words] { fmt::print("{}", page_of(described(app), *words)); });
}

void add_share_files_command(CLI::App& app) {
  auto folder = std::make_shared<std::string>();
  CLI::App* command = app.add_subcommand("share-files", "What is installed in share/: pages and completions");
  command->group("");
  command->add_option("FOLDER", *folder, "Where to write it")->required()->check(complaint_about_path);
  command->callback([&app, folder] { write_shared_files(*folder, described(app)); });
}

}  // namespace

void add_shell_commands(CLI::App& app) {
  add_completion_command(app);
  add_manual_command(app);
  add_share_files_command(app);
}

}  // namespace flowcert::cli
