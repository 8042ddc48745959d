// A directory for temporary files that goes away with the object, and with all that is in it.
#pragma once

#include <filesystem>

#include "fuzz/judge/layer.h"

namespace flowcert::judge {

class ScratchFolder {
 public:
  // In the directory for temporary files (TMPDIR, or /tmp). Throws std::filesystem::filesystem_error.
  ScratchFolder();
  // In another one, under this name, which must be new.
  explicit ScratchFolder(const std::filesystem::path& path);
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace flowcert::judge
