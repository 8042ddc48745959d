// `flowcert compute --export DIR`: the files that viewers open (spec/formats.md, "Exports").
//
// Guarantees: no file is begun before all are computed; each appears whole or not at all.
#pragma once

#include <string>

#include "cli/command.h"
#include "cli/compute_run.h"

namespace flowcert::cli {

// Throws OutputError where there is something that is not a directory, before anything is computed.
void check_export_directory(const std::string& directory);

// Makes the directory where there is none. run: with both manifolds. input_name: for messages.
void write_export_files(const std::string& directory, const std::string& input_name, const Input& input,
                        ComputeRun& run);

}  // namespace flowcert::cli
