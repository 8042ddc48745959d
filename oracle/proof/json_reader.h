// Reads JSON as flowcert writes it, without blanks, from the beginning to the end: a file is never held whole.
#pragma once

#include "points.h"

class JsonReader {
 public:
  explicit JsonReader(const std::string& path) : path_(path), file_(path, std::ios::binary) {
    if (!file_.is_open()) cannot_decide(path + ": cannot be read");
  }
  [[noreturn]] void fail(const std::string& why) const {
    cannot_decide(path_ + ":" + std::to_string(line_) + ": cannot be decoded: " + why);
  }
  std::size_t line() const { return line_; }
  const std::string& skipped() const { return skipped_; }  // names of keys
  int next() { return file_.rdbuf()->sgetc(); }            // the next character, or EOF

  bool take(char c) { return next() == c && (pass(), true); }
  bool take(const std::string& text) {  // or a part of it, if it is not there
    return std::all_of(text.begin(), text.end(), [this](char c) { return take(c); });
  }
  void need(const std::string& text) {
    if (!take(text)) fail("it is not as flowcert writes it");
  }
  // The next key of an object that has begun, with what is around it, or nothing at the object's end.
  std::string key() {
    if (take('}')) return "";
    if (last_ != '{') need(",");
    std::string text = string();
    need(":");
    return text;
  }
  // Passes over those of the keys in `others` that come, with their values, and over the key that is due.
  void need_key(const std::string& due, const std::vector<std::string>& others = {}) {
    std::string found = key();
    for (; std::find(others.begin(), others.end(), found) != others.end(); found = key()) {
      skip_value();
      skipped_ += (skipped_.empty() ? "" : ", ") + found;
    }
    if (found != due) fail("the key \"" + found + "\" is not proved" + (due.empty() ? "" : ", " + due + " is due"));
  }
  std::string string() {  // without escapes
    need("\"");
    std::string text;
    while (next() >= ' ' && next() != '"' && next() != '\\') text += pass();
    need("\"");
    return text;
  }
  std::string word() {  // a number or null
    std::string text;
    while (std::isalnum(next()) != 0 || next() == '-' || next() == '+' || next() == '.') text += pass();
    return text;
  }
  void skip_value() {
    int depth = 0;
    const auto is_end = [&] { return depth == 0 && (next() == ',' || next() == '}'); };
    do {
      if (next() < ' ' || is_end()) fail("a value is due");
      depth += (next() == '[' || next() == '{' ? 1 : 0) - (next() == ']' || next() == '}' ? 1 : 0);
      next() == '"' ? void(string()) : void(pass());
    } while (!is_end());
  }

 private:
  char pass() {
    last_ = static_cast<char>(file_.rdbuf()->sbumpc());
    if (last_ == '\n') ++line_;
    return last_;
  }

  const std::string path_;
  std::ifstream file_;
  std::size_t line_ = 1;
  char last_ = 0;  // that was passed
  std::string skipped_;
};
