#include "manual.hpp"

#include <fmt/core.h>

namespace carom::app {

namespace {

/// Text of roff: a backslash is a sign, and so are a point and a quote where a line begins; a hyphen may become another sign.
std::string roff(const std::string& text) {
  std::string s;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if ((i == 0 || text[i - 1] == '\n') && (c == '.' || c == '\'')) s += "\\&";
    s += c == '\\' ? "\\e" : c == '-' ? "\\-" : c == '\'' ? "\\(aq" : std::string(1, c);
  }
  return s;
}

std::string section(const std::string& name, const std::string& text) { return ".SH " + name + "\n" + text + "\n"; }

std::string usage(const CommandText& command) {
  std::string s = "\\fBcarom " + roff(command.name) + "\\fR [OPTION]...";
  for (const OptionText& option : command.options)
    if (option.positional) s += " \\fI" + roff(option.names.front()) + "\\fR";
  return s;
}

std::string paragraph(const OptionText& option) {
  std::string head;
  for (const std::string& name : option.names)
    head += (head.empty() ? "" : ", ") + ((option.positional ? "\\fI" : "\\fB") + roff(name) + "\\fR");
  if (!option.value.empty() && !option.positional) head += " \\fI" + roff(option.value) + "\\fR";
  return ".TP\n" + head + "\n" + roff(option.description) + "\n";
}

/// Lines as they stand.
std::string verbatim(const std::string& text) { return text.empty() ? "" : ".PP\n.nf\n" + roff(text) + "\n.fi\n"; }

std::string part(const CommandText& command) {
  std::string s = ".SS " + roff(command.name) + "\n" + usage(command) + "\n.PP\n" + roff(command.description) + ".\n";
  for (const OptionText& option : command.options) s += paragraph(option);
  return s + verbatim(command.footer);
}

}  // namespace

std::string manual_page(const CommandTree& tree) {
  std::string s = ".TH CAROM 1 \"\" \"carom " CAROM_VERSION "\"\n";
  s += section("NAME", "carom \\- " + roff(tree.program.description));
  s += section("SYNOPSIS", "\\fBcarom\\fR \\fICOMMAND\\fR [OPTION]...");
  s += section("DESCRIPTION",
               "carom moves hard balls exactly: it computes in closed form when each pair of balls, or ball and wall, will "
               "touch, and\nresolves the collisions one by one in the order of their times. A scene is a TOML file.\n" +
                   verbatim(tree.program.footer));
  s += ".SH COMMANDS\n";
  for (const CommandText& command : tree.commands) s += part(command);
  s += section("EXIT STATUS",
               ".TP\n0\ndone\n.TP\n1\na bug in carom\n.TP\n2\nthe scene or the command line is wrong; nothing was written\n.TP\n3\n"
               "to go on would be meaningless, or output could not be written\n.TP\n130, 143\ninterrupted, terminated; output "
               "is complete to that event");
  s += section("FILES",
               ".TP\n\\fIFILE\\fR.part\na file that is not whole yet. It gets its name when it is; after a full disk it keeps this one.");
  s += section("ENVIRONMENT", ".TP\nNO_COLOR\nif set, nothing is coloured\n.TP\nUSER\nauthor of H5MD files");
  return s;
}

}  // namespace carom::app
