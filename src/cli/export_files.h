// The files of `compute --export DIR`, for viewers and mesh programs (src/cli/manual/exports.md).
//
// Guarantees: each file is written as soon as what it shows is made, and appears whole or not at all. What was made for
// it is given back before the next one. If one cannot be written, those before it stay, and the error's line says so.
#pragma once

#include <functional>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "cli/layer.h"
#include "flowcert/flow_complex.h"
#include "io/clip_box.h"

namespace flowcert::cli {

struct ExportChoice {
  std::string directory;
  bool critical = true, surfaces = true, lines = true;
  bool cells = false, fans = false, infinity = false, sheets = false;  // they need limits and volumes
  std::optional<Rational> clip = 3;  // how large the box is at which files end; nothing for none
};

// How large the box is at which files end, from the text of --clip: a number from 1, or none. Throws InvalidInput.
[[nodiscard]] std::optional<Rational> clip_factor(const std::string& text);

// The box at which what goes to infinity ends; nothing for no factor, or no points.
[[nodiscard]] std::optional<ClipBox> clip_box(const PointSet& points, const std::optional<Rational>& factor);

// Throws OutputError.
void make_directory(const std::string& directory);

// Puts a file into the directory. `write` is told what the file was made by.
using WriteExport = std::function<void(std::ostream& out, const std::string& made_by)>;
void write_export(const std::string& directory, const std::string& name, const FlowComplex& complex,
                  const WriteExport& write);

// Writes a table to a file, or to standard output for "-". Returns whether it went there. An empty path writes nothing.
bool write_table(const std::string& path, const std::function<void(std::ostream& out)>& write);

class ExportFiles {
 public:
  // input_name is for messages. Throws OutputError if the directory exists and is none.
  ExportFiles(ExportChoice choice, std::string input_name);

  // Writes the files for which the complex needed this part. The directory is made before the first one.
  void write_after(const FlowComplex& complex, FlowComplexPart part);

 private:
  // Makes the data of a file by make(progress), and writes it. what: is exported, for the line of progress.
  template <typename Make>
  void write(const FlowComplex& complex, const char* name, const char* what, const Make& make);
  void write_surfaces(const FlowComplex& complex);
  void write_sheets(const FlowComplex& complex);
  void write_file(const char* name, const FlowComplex& complex, const WriteExport& write);
  // Runs what writes a file. An error says which file it was and which are there.
  void attempt(const char* name, const std::function<void()>& write);
  [[nodiscard]] std::string what_stays() const;

  ExportChoice choice_;
  std::string input_name_;
  std::vector<std::string> written_;
};

}  // namespace flowcert::cli
