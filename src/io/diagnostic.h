// What is said on standard error.
//
// Guarantees: a text that cannot be written, because the disk is full or standard error is closed or nobody reads it,
// is dropped, and the program goes on: its status and its outputs are as ever.
#pragma once

#include <string_view>

#include "io/layer.h"

namespace flowcert::io {

void tell(std::string_view text);

// Called at the beginning of a program. Opens what is closed of standard input, output and error, so that no file gets
// such a descriptor and then what is said there; reading and writing fail as before. A write beyond the limit of a
// file's size fails, too, and does not end the program.
void prepare_standard_streams();

}  // namespace flowcert::io
