#include "cli/xml_text.h"

#include <boost/algorithm/string/replace.hpp>

#include "cli/layer.h"
#include "io/foreign_text.h"

namespace flowcert::cli {

namespace {

// XML 1.0 has no control characters, and is UTF-8 here.
std::string xml_line(std::string_view line) {
  std::string escaped = io::on_one_line(line);
  boost::algorithm::replace_all(escaped, "&", "&amp;");
  boost::algorithm::replace_all(escaped, "<", "&lt;");
  boost::algorithm::replace_all(escaped, ">", "&gt;");
  boost::algorithm::replace_all(escaped, "\"", "&quot;");
  return escaped;
}

}  // namespace

std::string xml_text(const std::string& text) {
  std::string escaped;
  std::string_view rest = text;
  for (std::size_t end = rest.find('\n'); end != std::string_view::npos; end = rest.find('\n')) {
    escaped += xml_line(rest.substr(0, end)) + '\n';
    rest.remove_prefix(end + 1);
  }
  return escaped + xml_line(rest);
}

}  // namespace flowcert::cli
