// See scratch_folder.h.
#include "fuzz/judge/scratch_folder.h"

#include <stdlib.h>

#include <cerrno>
#include <string>
#include <system_error>

namespace flowcert::judge {

namespace fs = std::filesystem;

ScratchFolder::ScratchFolder() {
  std::string name = (fs::absolute(fs::temp_directory_path()) / "flowcert-XXXXXX").string();
  if (::mkdtemp(name.data()) == nullptr) {
    throw fs::filesystem_error("no temporary directory", name,
                               std::error_code(errno, std::generic_category()));
  }
  path_ = name;
}

ScratchFolder::ScratchFolder(const fs::path& path) : path_(path) { fs::create_directory(path_); }

ScratchFolder::~ScratchFolder() {
  std::error_code failure;
  fs::remove_all(path_, failure);
  if (!failure) return;
  // A folder that its program has closed to everyone, us included.
  std::error_code ignored;
  const auto skip = fs::directory_options::skip_permission_denied;
  fs::permissions(path_, fs::perms::owner_all, ignored);
  for (fs::recursive_directory_iterator entry(path_, skip, ignored), end; !ignored && entry != end;
       entry.increment(ignored)) {
    std::error_code unchanged;
    if (entry->is_directory(unchanged) && !entry->is_symlink(unchanged)) {
      fs::permissions(entry->path(), fs::perms::owner_all, unchanged);
    }
  }
  fs::remove_all(path_, ignored);
}

}  // namespace flowcert::judge
