// The manual page, made from the tables of options. It has no date, so that a build always gives the same page.

#include <fmt/format.h>

#include "cli/command.h"
#include "cli/values.h"
#include "crsh/version.h"

namespace crsh::cli {
namespace {

/// Text escaped for roff: hyphens stay hyphens, and no line is taken for a request.
std::string roff(const std::string& text) {
  std::string result;
  bool line_begins = true;
  for (const char c : text) {
    if (line_begins && (c == '.' || c == '\'')) result += "\\&";
    line_begins = c == '\n';
    if (c == '-') result += "\\-";
    else if (c == '\\') result += "\\e";
    else result += c;
  }
  return result;
}

std::string option_entry(const Option& option) {
  std::string names;
  for (const std::string& name : split(option.names, ','))
    names += fmt::format("{}\\fB{}\\fR", names.empty() ? "" : ", ", roff(name));
  if (!option.value.empty()) names += fmt::format(" \\fI{}\\fR", roff(option.value));
  const std::string initial = default_of(option);
  return fmt::format(".TP\n{}\n{}{}\n", names, roff(option.help),
                     initial.empty() ? "" : fmt::format(" [{}]", roff(initial)));
}

std::string command_section(const Command& command) {
  std::string text =
      fmt::format(".SH CRSH {}\n{}\n.PP\n{}\n", command.name, roff(usage_of(command)), roff(command.summary));
  for (const OptionGroup& group : command.groups) {
    text += fmt::format(".SS {}\n", roff(group.title));
    for (const Option& option : group.options)
      if (!option.hidden) text += option_entry(option);
  }
  return text + fmt::format(".PP\n.nf\n{}.fi\n", roff(command.epilogue));
}

}  // namespace

std::string manual_page() {
  std::string text = fmt::format(
      ".TH CRSH 1 \"\" \"crsh {}\"\n"
      ".SH NAME\n"
      "crsh \\- render glTF scenes with ray\\-traced shadows, reflections and refractions\n"
      ".SH SYNOPSIS\n"
      "\\fBcrsh\\fR \\fICOMMAND\\fR ...\n"
      ".SH DESCRIPTION\n"
      "Renders on any Vulkan device, without ray\\-tracing hardware, through a hierarchy over the rays. Data goes to "
      "standard\n"
      "output, everything else to standard error. An output file appears whole or not at all.\n",
      version);
  for (const Command& command : commands()) text += command_section(command);
  return text +
         ".SH EXIT STATUS\n"
         "0 done, 1 failed, 2 wrong usage, 3 images differ, 77 no usable Vulkan device.\n";
}

}  // namespace crsh::cli
