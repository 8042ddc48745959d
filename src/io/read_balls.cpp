#include "flowcert/read_balls.h"

#include <fmt/format.h>

#include <utility>

#include "io/ball_rows.h"
#include "io/input_bytes.h"
#include "io/number_text.h"
#include "io/point_formats.h"

namespace flowcert {

BallFile read_balls_from(std::string_view bytes, const std::string& name, const ReadingOptions& options,
                         const AtomRadii& radii) {
  io::BallRows balls(radii, name, options.finite);
  BallFile read;
  read.file = io::read_content(bytes, name, options, &balls);
  if (const std::size_t atoms = balls.named_elements(); atoms > 0) {
    read.file.notes.push_back(
        {0, fmt::format("the file does not say the elements of {}; they are taken from their names",
                        io::counted(atoms, "atom"))});
  }
  read.balls = balls.take();
  return read;
}

BallFile read_balls(const std::string& path, const ReadingOptions& options, const AtomRadii& radii) {
  return read_balls_from(io::read_bytes(path, options.progress), path, options, radii);
}

}  // namespace flowcert
