// crsh diff on files, and against OpenImageIO's idiff where it is installed.

#include <doctest/doctest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <random>

#include "crsh/layers.h"
#include "output/diff.h"
#include "output/exr.h"
#include "output/png.h"
#include "output/whole_file.h"
#include "support/pictures.h"
#include "support/program.h"
#include "support/temporary_folder.h"

namespace crsh {
namespace {

using test::crsh;

const std::vector<std::string> all_layers = {"", "Z", "N", "Albedo"};

/// A folder with a.exr and a.png of one picture, and b.exr and b.png where one value of the beauty is other.
struct Files {
  test::TemporaryFolder folder;
  explicit Files(float other = 0.9f) {
    Picture picture = test::plain_picture(20, 10, {0.5f, 0.25f, 0.125f, 1});
    picture.layers.push_back({"Z", {"Z"}, std::vector<float>(200, 3.0f)});
    write(picture, "a");
    picture.layers[0].values[(3 * 20 + 7) * 4 + 1] = other;
    write(picture, "b");
  }
  void write(const Picture& picture, const std::string& name) const {
    output::write_exr(folder / (name + ".exr"), picture, all_layers, {});
    output::write_whole(folder / (name + ".png"),
                        output::encode_png(picture.layers[0], picture.width, picture.height, 0));
  }
  [[nodiscard]] test::Outcome diff(const std::string& extension, std::vector<std::string> options = {}) const {
    options.insert(options.begin(), {"diff", folder / ("a." + extension), folder / ("b." + extension)});
    return crsh(options);
  }
};

TEST_CASE("equal files end with 0, different ones with 3 and the worst pixel") {
  const Files files;
  CHECK(crsh({"diff", files.folder / "a.exr", files.folder / "a.exr", "--exact", "--layers", "all"}).out == "equal\n");
  const test::Outcome outcome = files.diff("exr", {"--exact"});
  CHECK(outcome.status == 3);
  CHECK(outcome.err.empty());
  CHECK(outcome.out ==
        "different: 1 of 200 pixels (0.5%), worst at pixel 7,3 channel G: 0.25 against 0.899902344 (difference "
        "0.7222)\n");
  CHECK(files.diff("png").status == 3);
  CHECK(files.diff("exr", {"--exact", "--layers", "Z"}).status == 0);
}

TEST_CASE("the tolerance decides") {
  const Files files;
  CHECK(files.diff("exr", {"--fail-percent", "1", "--hard-fail", "1"}).status == 0);
  CHECK(files.diff("exr", {"--fail-percent", "0.4", "--hard-fail", "1"}).status == 3);
  CHECK(files.diff("exr", {"--fail", "0.8"}).status == 0);
}

TEST_CASE("sizes and channels that differ end with 3, what cannot be read with 1") {
  const Files files;
  files.write(test::plain_picture(4, 4, {1, 1, 1, 0.5f}), "b");
  CHECK(files.diff("exr").status == 3);
  CHECK(files.diff("png").out == "sizes differ: 20x10 against 4x4\n");
  files.write(test::plain_picture(20, 10, {1, 1, 1, 0.5f}), "b");
  CHECK(files.diff("png").out == "channels differ: B G R against A B G R\n");
  for (const std::string& bad : {std::string("/no/such"), files.folder.path().string()}) {
    const test::Outcome outcome = crsh({"diff", files.folder / "a.png", bad});
    CHECK(outcome.status == 1);
    CHECK(outcome.error_lines() == 1);
  }
}

TEST_CASE("wrong usage of diff") {
  const Files files;
  CHECK(files.diff("png", {"--exact", "--fail", "0.1"}).status == 2);
  CHECK(files.diff("png", {"-o", "-", "--json", "-"}).status == 2);
  CHECK(files.diff("png", {"-o", "x.jpg"}).status == 2);
  CHECK(files.diff("png", {"--layers", "Q"}).status == 2);
  CHECK(files.diff("png", {"--fail", "-1"}).status == 2);
  for (const auto& [a, b] : {std::pair{"a.png", "a.exr"}, {"a.exr", "b.png"}}) {
    const test::Outcome outcome = crsh({"diff", files.folder / a, files.folder / b});
    CHECK(outcome.status == 2);
    CHECK(outcome.error_lines() == 1);
  }
  CHECK(crsh({"help", "diff"}).out.find("one of each, as in a.exr b.png, is wrong") != std::string::npos);
}

TEST_CASE("JSON and picture are written; on standard output they are alone there") {
  const Files files;
  const test::Outcome outcome = files.diff("png", {"--json", "-", "-o", files.folder / "difference.png"});
  const auto json = nlohmann::json::parse(outcome.out);
  CHECK(json["worst"]["x"] == 7);
  CHECK(json["worst"]["y"] == 3);
  CHECK(outcome.error_lines() == 1);
  const output::Image picture = output::read_image(files.folder / "difference.png");
  CHECK(picture.channels[0].bits[3 * 20 + 7] == 255);
  CHECK(output::decode_png(files.diff("png", {"-o", "-"}).out, "stdout").width == 20);
}

// ---- against idiff

bool idiff_is_here() {
  static const bool here = test::run_program("idiff", {"--help"}).status == 0;
  if (!here) MESSAGE("idiff is not installed (openimageio-tools): not compared with it");
  return here;
}

/// Two noisy PNG files that differ a little here and there. Opaque: idiff premultiplies, we compare what the file
/// holds.
void write_noisy_pair(const test::TemporaryFolder& folder, uint32_t seed) {
  std::mt19937 random(seed);
  Picture picture = test::plain_picture(32, 32, {0, 0, 0, 1});
  std::vector<float>& values = picture.layers[0].values;
  const auto write = [&](const std::string& name) {
    output::write_whole(folder / name, output::encode_png(picture.layers[0], 32, 32, 0));
  };
  for (size_t index = 0; index < values.size(); ++index)
    if (index % 4 != 3) values[index] = float(random() % 1000) / 1000;
  write("a.png");
  for (size_t index = 0; index < values.size(); ++index)
    if (index % 4 != 3 && random() % 300 == 0) values[index] += float(random() % 100) / 1000;
  write("b.png");
}

TEST_CASE("idiff judges PNG files alike, whatever the tolerance") {
  if (!idiff_is_here()) return;
  size_t equal = 0, different = 0;
  for (uint32_t seed = 0; seed < 3; ++seed) {
    const test::TemporaryFolder folder;
    write_noisy_pair(folder, seed);
    const std::string a = folder / "a.png", b = folder / "b.png";
    for (const std::string fail : {"0", "0.02"})
      for (const std::string percent : {"0.5", "2"})
        for (const std::string hard : {"0.06", "1"}) {
          const output::Tolerance tolerance{.exact = false,
                                            .fail = std::stod(fail),
                                            .fail_percent = std::stod(percent),
                                            .hard_fail = std::stod(hard)};
          const bool ours = output::compare(output::read_image(a), output::read_image(b), {"beauty"}, tolerance).same;
          const auto theirs = test::run_program(
              "idiff", {"-warn", "1", "-fail", fail, "-failpercent", percent, "-hardfail", hard, a, b});
          INFO("seed ", seed, ", --fail ", fail, " --fail-percent ", percent, " --hard-fail ", hard);
          CHECK(ours == (theirs.status == 0));
          (ours ? equal : different) += 1;
        }
  }
  CHECK(equal > 2);
  CHECK(different > 2);
}

TEST_CASE("idiff finds our EXR files equal and different where we do") {
  if (!idiff_is_here()) return;
  const Files files(0.2503f);
  const auto theirs = [&](const std::string& b) {
    return test::run_program("idiff", {"-fail", "0", "-warn", "0", files.folder / "a.exr", files.folder / b}).status;
  };
  CHECK(theirs("a.exr") == 0);
  CHECK(theirs("b.exr") != 0);
  CHECK(files.diff("exr", {"--exact"}).status == 3);
}

/// A picture with every layer, and the file of it in which one value of one layer is other.
Picture layered_picture(LayerId other = LayerId::beauty, float change = 0) {
  Picture picture{.width = 5, .height = 3, .layers = {}};
  for (const LayerId layer : LayerSet::all().members()) {
    Layer& made = picture.layers.emplace_back(Layer{picture_layer(layer), channels_of(layer), {}, {}});
    const bool numbers = is_numbers(layer);
    if (numbers) made.ids.assign(15, 7);
    else made.values.assign(15 * made.channels.size(), 0.5f);
    if (layer != other) continue;
    if (numbers) made.ids[4] += change != 0;
    else made.values[4] += change;
  }
  return picture;
}

TEST_CASE("a value that differs is seen in its own layer and no other, and idiff sees it, too") {
  const test::TemporaryFolder folder;
  const std::vector<std::string> every = picture_layers(LayerSet::all());
  output::write_exr(folder / "a.exr", layered_picture(), every, {});
  const bool idiff = idiff_is_here();
  const LayerSet of_each_type = {LayerId::beauty, layer_named("Object"), layer_named("Tests.node")};
  for (const LayerRow& row : layer_table) {
    CAPTURE(row.name);
    const LayerId layer = layer_named(row.name);
    output::write_exr(folder / "b.exr", layered_picture(layer, 0.25f), every, {});
    const output::Image a = output::read_image(folder / "a.exr"), b = output::read_image(folder / "b.exr");
    for (const LayerRow& compared : layer_table)
      CHECK(output::compare(a, b, {std::string(compared.name)}, {.exact = true}).same == (&compared != &row));
    if (idiff && of_each_type.has(layer))
      CHECK(test::run_program("idiff", {"-fail", "0", "-warn", "0", folder / "a.exr", folder / "b.exr"}).status != 0);
  }
}

}  // namespace
}  // namespace crsh
