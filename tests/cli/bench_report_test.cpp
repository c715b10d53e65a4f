// What crsh bench prints and writes: its tables, CSV and page.

#include <doctest/doctest.h>

#include <set>
#include <sstream>

#include "output/whole_file.h"
#include "support/bench_run.h"
#include "support/temporary_folder.h"

namespace crsh {
namespace {

using test::bench;
using test::cornell;
using test::glass;

TEST_CASE("the tables have the paper's row names, and a column a scene") {
  const test::Outcome outcome = bench({glass, cornell, "--repeat", "1", "--warmup", "0"});
  REQUIRE(outcome.status == 0);
  for (const char* text : {"Table 1",
                           "TOTAL # ISECT",
                           "RELATIVE %",
                           "Brute Force",
                           "RAH Algorithm",
                           "Our Algorithm (crsh-2017)",
                           "Our Algorithm (crsh)",
                           "GLASS",
                           "CORNELL",
                           "Table 2: glass",
                           "Table 2: cornell",
                           "LEVEL 2",
                           "LEVEL 1",
                           "# SH INTERSECTIONS",
                           "# SH MISSES",
                           "# SH HITS",
                           "# RE INTERSECTIONS",
                           "Table 3",
                           "TIME (MS)",
                           "RAY CREATION",
                           "RAY COMPRESSION",
                           "RAY SORTING",
                           "RAY DECOMPRESSION",
                           "HIERARCHY CREATION",
                           "HIERARCHY TRAVERSAL",
                           "FINAL INTERSECTION TESTS",
                           "vs RAH"}) {
    CAPTURE(text);
    CHECK(outcome.out.find(text) != std::string::npos);
  }
  CHECK(outcome.out.find("vs RAH") > outcome.out.find("Table 3"));
}

TEST_CASE("the CSV has as many fields in each row as in its header, and times in the rows of sums alone") {
  const test::TemporaryFolder folder;
  REQUIRE(
      bench({glass, "--repeat", "2", "--warmup", "0", "--algorithms", "rah,crsh", "--csv", folder / "a.csv"}).status ==
      0);
  const std::string text = output::read_whole(folder / "a.csv");
  std::istringstream stream(text);
  std::set<ptrdiff_t> commas;
  size_t sums = 0, timed = 0;
  for (std::string line; std::getline(stream, line);) {
    commas.insert(std::ranges::count(line, ','));
    sums += line.find(",all,") != std::string::npos;
    timed += line.find(",,,,,") == std::string::npos;
  }
  CHECK(commas.size() == 1);
  CHECK(sums == 2);
  CHECK(timed == 3);  // the header, too
  CHECK(text.starts_with("scene,label,algorithm,triangles,kind,bounce,count,"));
}

/// What `text` has between `before` and `after`, each time.
std::vector<std::string> all_between(const std::string& text, const std::string& before, const std::string& after) {
  std::vector<std::string> found;
  for (size_t at = 0; (at = text.find(before, at)) != std::string::npos;) {
    at += before.size();
    found.push_back(text.substr(at, text.find(after, at) - at));
  }
  return found;
}

TEST_CASE("the report is one page that loads nothing, with tables, charts, pictures, machine and command") {
  const test::TemporaryFolder folder;
  const test::Outcome outcome = bench({glass, "--repeat", "1", "--warmup", "0", "--algorithms", "bvh,rah,crsh",
                                       "--vary", "arity=8", "--report", folder / "a.html"});
  CAPTURE(outcome.err);
  REQUIRE(outcome.status == 0);
  const std::string page = output::read_whole(folder / "a.html");
  CHECK(page.starts_with("<!DOCTYPE html>"));
  for (const char* loading : {"http:", "https:", "<script", "<link", "@import", "src='//"})
    CHECK(page.find(loading) == std::string::npos);
  for (const std::string& source : all_between(page, "src='", "'"))
    CHECK(source.starts_with("data:image/png;base64,iVBORw0KGgo"));
  for (const std::string& address : all_between(page, "url(", ")")) CHECK(address.starts_with("#p"));
  CHECK(all_between(page, "<figure>", "</figure>").size() == 4);  // the picture, and a heat map each
  for (const char* text :
       {"Table 1", "Table 2", "Table 3", "glass: tests a level", "glass: time a stage", "--vary arity=8",
        "subgroups of", "Single rays (bvh)", "Our Algorithm (crsh arity=8)", "key=spherical", "nodes=fixed",
        "fit=merged", "interval=off", "levels=2", "bound=sphere-cone", "mesh-culling=off"}) {
    CAPTURE(text);
    CHECK(page.find(text) != std::string::npos);
  }
  CHECK(outcome.out.find("crsh, each option by itself") != std::string::npos);
}

TEST_CASE("--sweep shows growth with lights and pixels, as tables and curves; brute force has no part in it") {
  const test::TemporaryFolder folder;
  const test::Outcome outcome = bench({glass, "--repeat", "1", "--warmup", "0", "--algorithms", "brute,bvh", "--ablate",
                                       "none", "--sweep", "lights,pixels", "--report", folder / "a.html"});
  REQUIRE(outcome.status == 0);
  const size_t at = outcome.out.find("Growth with lights: glass");
  REQUIRE(at != std::string::npos);
  CHECK(outcome.out.find("growth, 8.00X", at) != std::string::npos);
  CHECK(outcome.out.find("growth, 16.00X", at) != std::string::npos);
  CHECK(outcome.out.find("Brute Force", at) == std::string::npos);
  CHECK(outcome.out.find("binned SAH build") != std::string::npos);
  const std::string page = output::read_whole(folder / "a.html");
  CHECK(page.find("glass: growth with lights</title>") != std::string::npos);
  CHECK(page.find("glass: growth with pixels</title>") != std::string::npos);
}

TEST_CASE("the report's tags are closed in turn, also where names are hostile") {
  if (test::run_program("python3", {"--version"}).status != 0) {
    MESSAGE("skipped: python3 is not here");
    return;
  }
  const test::TemporaryFolder folder;
  const std::string hostile = folder / "a<b>&'\"c.glb";
  output::write_whole(hostile, output::read_whole(glass));
  REQUIRE(bench({hostile, "--repeat", "1", "--warmup", "0", "--algorithms", "crsh", "--report", folder / "a.html"})
              .status == 0);
  const test::Outcome parsed = test::run_program("python3", {"-c", R"(
import html.parser, sys
void = {'meta', 'img', 'br'}
class Tags(html.parser.HTMLParser):
    open = []
    def handle_starttag(self, tag, attributes):
        if tag not in void: self.open.append(tag)
    def handle_startendtag(self, tag, attributes): pass
    def handle_endtag(self, tag):
        assert self.open.pop() == tag, tag
tags = Tags()
tags.feed(open(sys.argv[1]).read())
assert not tags.open, tags.open
)",
                                                             folder / "a.html"});
  CHECK(parsed.err == "");
  CHECK(parsed.status == 0);
}

}  // namespace
}  // namespace crsh
