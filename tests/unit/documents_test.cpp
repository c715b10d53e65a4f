// What is written for people: links lead somewhere, the README stays short, and a folder's README is found.

#include <doctest/doctest.h>

#include <algorithm>
#include <cctype>
#include <iterator>
#include <regex>
#include <set>
#include <sstream>

#include "support/source_tree.h"

namespace crsh {
namespace {

namespace fs = std::filesystem;
const fs::path top = CRSH_SOURCE_DIR;

struct Link {
  fs::path file;       ///< what it names, in the project
  std::string anchor;  ///< what follows #
};

/// A document without code, in which brackets mean something else.
std::string prose_of(const fs::path& document) {
  std::istringstream text(test::text_of(document));
  std::string prose;
  bool fenced = false;
  for (std::string line; std::getline(text, line);) {
    if (line.starts_with("```")) fenced = !fenced;
    else if (!fenced) prose += line + "\n";
  }
  return std::regex_replace(prose, std::regex("`[^`\n]*`"), "``");
}

/// Links and pictures that name a file of the project.
std::vector<Link> links_of(const fs::path& document) {
  static const std::regex link("\\]\\(([^)#\\s]*)#?([^)\\s]*)\\)");
  const std::string prose = prose_of(document);
  std::vector<Link> links;
  for (std::sregex_iterator match(prose.begin(), prose.end(), link), end; match != end; ++match) {
    const std::string target = (*match)[1];
    if (target.starts_with("http")) continue;
    const fs::path file = target.empty() ? document : document.parent_path() / target;
    links.push_back({file.lexically_normal(), (*match)[2]});
  }
  return links;
}

/// The name by which a link reaches a heading: small letters and digits, hyphens for blanks, nothing else.
std::string anchor_of(const std::string& heading) {
  std::string anchor;
  for (const char letter : heading) {
    if (std::isalnum(static_cast<unsigned char>(letter)) || letter == '-' || letter == '_')
      anchor += char(std::tolower(letter));
    else if (letter == ' ') anchor += '-';
  }
  return anchor;
}

std::set<std::string> anchors_of(const fs::path& document) {
  std::istringstream text(test::text_of(document));
  std::set<std::string> anchors;
  for (std::string line; std::getline(text, line);)
    if (line.starts_with('#') && line.find("# ") != std::string::npos)
      anchors.insert(anchor_of(line.substr(line.find("# ") + 2)));
  return anchors;
}

TEST_CASE("every link of a document leads to a file, and to a heading where it names one") {
  size_t links = 0;
  for (const fs::path& document : test::files_of_project({".md"})) {
    CAPTURE(document);
    for (const Link& link : links_of(document)) {
      CAPTURE(link.file);
      CAPTURE(link.anchor);
      CHECK(fs::exists(link.file));
      if (!link.anchor.empty()) CHECK(anchors_of(link.file).contains(link.anchor));
      ++links;
    }
  }
  CHECK(links > 20);
}

TEST_CASE("a path of src/, tools/ or tests/ that a README names is there") {
  static const std::regex path("`((src|tools|tests)/[A-Za-z0-9_./-]+)`");
  for (const fs::path& document : test::files_of_project({".md"})) {
    if (document.filename() != "README.md") continue;
    CAPTURE(document);
    const std::string text = test::text_of(document);
    for (std::sregex_iterator match(text.begin(), text.end(), path), end; match != end; ++match) {
      const std::string named = (*match)[1];
      CAPTURE(named);
      CHECK(fs::exists(top / named));
    }
  }
}

TEST_CASE("the README has at most 1,300 words and 150 lines") {
  const std::string text = test::text_of(top / "README.md");
  std::istringstream words(text);
  CHECK(std::distance(std::istream_iterator<std::string>(words), {}) <= 1300);
  CHECK(std::ranges::count(text, '\n') <= 150);
}

TEST_CASE("every folder's README is linked from another document") {
  std::set<fs::path> linked;
  const std::vector<fs::path> documents = test::files_of_project({".md"});
  for (const fs::path& document : documents)
    for (const Link& link : links_of(document))
      if (link.file != document) linked.insert(link.file);
  for (const fs::path& document : documents) {
    CAPTURE(document);
    CHECK((document.parent_path() == top.lexically_normal() || linked.contains(document.lexically_normal())));
  }
}

}  // namespace
}  // namespace crsh
