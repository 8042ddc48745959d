// Reads JSON as flowcert writes it, without blanks, from the beginning to the end: a file is never held whole.
#pragma once

#include <cstdio>
#include <memory>

#include "points.h"

class JsonReader {
 public:
  explicit JsonReader(const std::string& path) : path_(path), file_(std::fopen(path.c_str(), "rb"), &std::fclose) {
    if (file_ == nullptr) cannot_decide(path + ": cannot be read");
    pass();
  }
  [[noreturn]] void fail(const std::string& why) const {
    cannot_decide(path_ + ":" + std::to_string(line_) + ": " + why);
  }
  std::size_t line() const { return line_; }
  int next() const { return next_; }  // the next character, or EOF

  bool take(char c) { return next_ == c && (pass(), true); }
  bool take(const std::string& text) {  // or a part of it, if it is not there
    return std::all_of(text.begin(), text.end(), [this](char c) { return take(c); });
  }
  void need(const std::string& text) {
    if (!take(text)) fail("cannot be decoded: it is not as flowcert writes it");
  }
  // The next key of an object, with what is around it, or nothing at the object's end.
  std::string key() {
    if (take('}')) return "";
    if (!take(',')) need("{");
    std::string text = string();
    need(":");
    return text;
  }
  void need_key(const std::string& due) {
    const std::string found = key();
    if (found != due) fail("the key \"" + found + "\" is not proved" + (due.empty() ? "" : ", " + due + " is due"));
  }
  std::string string() {
    need("\"");
    std::string text;
    while (next_ >= ' ' && next_ != '"') text += pass();
    need("\"");
    return text;
  }
  std::string word() {  // a number or null
    std::string text;
    while (std::isalnum(next_) != 0 || next_ == '-' || next_ == '+' || next_ == '.') text += pass();
    return text;
  }
  void skip_value() {
    int depth = 0;
    const auto is_end = [&] { return depth == 0 && (next_ == ',' || next_ == '}'); };
    do {
      if (next_ < ' ' || is_end()) fail("cannot be decoded: it is not as flowcert writes it");
      depth += (next_ == '[' || next_ == '{' ? 1 : 0) - (next_ == ']' || next_ == '}' ? 1 : 0);
      next_ == '"' ? void(string()) : void(pass());
    } while (!is_end());
  }

 private:
  char pass() {
    const auto c = static_cast<char>(next_);
    if (c == '\n') ++line_;
    next_ = getc_unlocked(file_.get());
    if (next_ == EOF && std::ferror(file_.get()) != 0) fail("cannot be read");
    return c;
  }

  const std::string path_;
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> file_;
  std::size_t line_ = 1;
  int next_ = 0;
};
