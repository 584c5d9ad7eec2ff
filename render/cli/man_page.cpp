// SPDX-License-Identifier: MIT
#include "man_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <sstream>

namespace occlude::cli {
namespace {

/// Text of a line as man(7) wants it; a line must not begin with a dot or a quote.
std::string escaped(const std::string& text) {
  std::string result = text.starts_with('.') || text.starts_with('\'') ? "\\&" : "";
  for (const char c : text) {
    if (c == '\\') {
      result += "\\e";
    } else {
      if (c == '-') result += '\\';
      result += c;
    }
  }
  return result;
}

std::string in_capitals(std::string text) {
  std::ranges::transform(text, text.begin(), [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return text;
}

/// Lines stay lines.
std::string paragraph(const std::string& text) {
  std::string result = ".PP\n";
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) result += escaped(line) + "\n.br\n";
  return text.empty() ? "" : result;
}

std::string entry(const OptionText& option) {
  return fmt::format(".TP\n\\fB{}\\fR{}\n{}\n", escaped(fmt::format("{}", fmt::join(option.names, ", "))),
                     escaped(option.value), escaped(option.text));
}

std::string entries(const CommandText& command) {
  std::string text, group;
  for (const OptionText& option : command.options) {
    if (option.group != group) text += fmt::format(".PP\n{}:\n", escaped(option.group));
    group = option.group;
    text += entry(option);
  }
  return text;
}

/// A section for each command that does something, in the order of the help.
std::string sections(const CommandText& command) {
  std::string text;
  for (const CommandText& part : command.commands) {
    text += fmt::format(".SH {}\n{}\n", escaped(in_capitals(part.name)), escaped(part.text));
    text += entries(part) + paragraph(part.footer) + sections(part);
  }
  return text;
}

}  // namespace

std::string man_page(const CommandText& program) {
  std::string text =
      fmt::format(".TH {} 1\n.ad l\n.SH NAME\n{} \\- {}\n.SH SYNOPSIS\n.B {}\nCOMMAND [OPTIONS]\n.SH COMMANDS\n",
                  in_capitals(program.name), program.name, escaped(program.text), program.name);
  for (const CommandText& command : program.commands) {
    text += fmt::format(".TP\n\\fB{}\\fR\n{}\n", escaped(command.name), escaped(command.text));
  }
  text += ".SH OPTIONS\n" + entries(program) + sections(program);
  return text +
         ".SH EXIT STATUS\n0: done. 1: a check failed. 2: bad input, or output that cannot be written. 130: interrupted.\n";
}

}  // namespace occlude::cli
