#include "recipe.h"

#include <regex>
#include <sstream>
#include <stdexcept>

#include "output/whole_file.h"

namespace crsh::test {
namespace {

std::string contributing() { return output::read_whole(CRSH_SOURCE_DIR "/CONTRIBUTING.md"); }

std::string section_of(const std::string& text, const std::string& heading) {
  const size_t at = text.find("\n### " + heading + "\n");
  if (at == std::string::npos) throw std::runtime_error("CONTRIBUTING.md has no heading " + heading);
  const size_t begin = text.find('\n', at + 1);
  return text.substr(begin, std::min(text.find("\n### ", begin), text.find("\n## ", begin)) - begin);
}

/// What the words before a block of code say of it.
Edit edit_of(const std::string& words, const std::string& code) {
  static const std::regex into("`([^`]+)`,\\s+(before|in\\s+place\\s+of)\\s+`([^`]+)`:\\s*$"), whole("`([^`]+)`:\\s*$");
  std::smatch found;
  if (std::regex_search(words, found, into)) return {found[1], found[3], found[2] != "before", code};
  if (std::regex_search(words, found, whole)) return {found[1], "", false, code};
  throw std::runtime_error("CONTRIBUTING.md does not say where this goes:\n" + code);
}

void add_commands(const std::string& block, Recipe& recipe) {
  std::istringstream lines(block);
  for (std::string line; std::getline(lines, line);) recipe.commands.push_back(line);
}

}  // namespace

std::set<std::string> Recipe::files() const {
  std::set<std::string> names;
  for (const Edit& edit : edits) names.insert(edit.file);
  return names;
}

Recipe recipe(const std::string& heading) {
  const std::string text = section_of(contributing(), heading), fence = "```";
  Recipe recipe;
  for (size_t words = 0, at = text.find(fence); at != std::string::npos;) {
    const size_t begin = text.find('\n', at) + 1, end = text.find(fence, begin);
    const std::string language = text.substr(at + fence.size(), begin - 1 - at - fence.size());
    const std::string code = text.substr(begin, end - begin);
    if (language.empty()) add_commands(code, recipe);
    else recipe.edits.push_back(edit_of(text.substr(words, at - words), code));
    words = end + fence.size();
    at = text.find(fence, words);
  }
  return recipe;
}

std::string code_after(const std::string& words) {
  const std::string text = contributing();
  const size_t at = text.find(words);
  if (at == std::string::npos) throw std::runtime_error("CONTRIBUTING.md does not say " + words);
  const size_t begin = text.find('\n', text.find("```", at)) + 1;
  return text.substr(begin, text.find("```", begin) - begin);
}

}  // namespace crsh::test
