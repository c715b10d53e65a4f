// The bar on a terminal and the JSON lines.

#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include "output/progress.h"

namespace crsh::output {
namespace {

TEST_CASE("durations read like a person says them") {
  CHECK(duration_text(0.2) == "0 s");
  CHECK(duration_text(59.4) == "59 s");
  CHECK(duration_text(200) == "3 min 20 s");
  CHECK(duration_text(7500) == "2 h 5 min");
  CHECK(duration_text(-1) == "0 s");
}

TEST_CASE("a bar is drawn over itself and leaves the screen at the end") {
  std::string text;
  {
    Progress progress(Progress::Mode::bar, 2, [&](const std::string& more) { text += more; });
    progress.update(0, 0, 0.5);
    CHECK(text.find("#######.....") != std::string::npos);
    CHECK(text.find(" 25% ") != std::string::npos);
    progress.update(1, 1, 1);
    CHECK(text.find("100% 0 s left") != std::string::npos);
    CHECK(text.find('\n') == std::string::npos);
  }
  CHECK(text.ends_with("\r\x1b[K"));
}

TEST_CASE("a bar is not drawn more often than eyes see") {
  size_t times = 0;
  Progress progress(Progress::Mode::bar, 1, [&](const std::string&) { ++times; });
  for (int step = 0; step < 1000; ++step) progress.update(0, 0, step / 2000.0);
  CHECK(times < 20);
}

TEST_CASE("JSON has an object a line with the members of the contract") {
  std::string text;
  Progress progress(Progress::Mode::json, 4, [&](const std::string& more) { text += more; });
  progress.update(12, 3, 1);
  const auto event = nlohmann::json::parse(text);
  CHECK(event["event"] == "progress");
  CHECK(event["frame"] == 12);
  CHECK(event["frames"] == 4);
  CHECK(event["done"] == 1.0);
  CHECK(event["eta_s"] == 0.0);
  text.clear();
  progress.written("a \"b\".png");
  CHECK(nlohmann::json::parse(text) == nlohmann::json{{"event", "written"}, {"path", "a \"b\".png"}});
  CHECK(text.ends_with("}\n"));
}

TEST_CASE("none says nothing") {
  std::string text;
  Progress progress(Progress::Mode::none, 1, [&](const std::string& more) { text += more; });
  progress.update(0, 0, 1);
  progress.written("a.png");
  progress.clear();
  CHECK(text.empty());
}

}  // namespace
}  // namespace crsh::output
