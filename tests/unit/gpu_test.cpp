// The Vulkan layer: buffers, the account of memory, programs and dispatches.

#include <doctest/doctest.h>

#include <algorithm>
#include <numeric>

#include "gpu/recorder.h"
#include "support/device.h"

namespace crsh::gpu {
namespace {

TEST_SUITE_BEGIN("subset");

struct Count {
  uint32_t count;
};

std::vector<uint32_t> counted(size_t count) {
  std::vector<uint32_t> values(count);
  std::iota(values.begin(), values.end(), 0u);
  return values;
}

TEST_CASE("what is uploaded comes back, also in several pieces of staging") {
  for (const size_t count : {size_t(1), size_t(1000), size_t(3'000'001)}) {
    const std::vector<uint32_t> values = counted(count);
    const Buffer buffer = upload(test::device(), values, "values");
    CHECK(download<uint32_t>(test::device(), buffer, count) == values);
    CHECK(download<uint32_t>(test::device(), buffer, 1, count - 1)[0] == count - 1);
  }
}

TEST_CASE("an upload of nothing can be bound") {
  const Buffer buffer = upload(test::device(), std::vector<uint32_t>{}, "nothing");
  CHECK(buffer.bytes() == 16);
  CHECK(download<uint32_t>(test::device(), buffer, 0).empty());
}

TEST_CASE("a moved buffer leaves an empty one and frees its memory once") {
  const uint64_t before = test::device().allocated_bytes();
  {
    Buffer first(test::device(), 1000, "first");
    Buffer second = std::move(first);
    CHECK(second.bytes() == 1000);
    Buffer third(test::device(), 2000, "third");
    third = std::move(second);
    CHECK(third.bytes() == 1000);
    CHECK(test::device().allocated_bytes() > before);
  }
  CHECK(test::device().allocated_bytes() == before);
}

TEST_CASE("a dispatch past 65,535 workgroups reaches every element and none twice") {
  const uint32_t count = 65535 * 64 + 12345;
  Device& device = test::device();
  Buffer numbers(device, count * sizeof(uint32_t), "numbers");
  Recorder recorder(device);
  recorder.fill(numbers, 0xFFFFFFFF, count);
  recorder.dispatch("primitives/iota", count, Count{count}, {{"numbers", numbers}});
  recorder.submit();
  CHECK(download<uint32_t>(device, numbers, count) == counted(count));
}

TEST_CASE("a dispatch over nothing records nothing") {
  Buffer numbers(test::device(), 16, "numbers");
  Recorder recorder(test::device());
  recorder.dispatch("primitives/iota", 0, Count{0}, {{"numbers", numbers}});
  recorder.submit();
}

TEST_CASE("part of a buffer is bound by offset and bytes") {
  Device& device = test::device();
  const uint64_t alignment = std::max<uint64_t>(device.limits().binding_alignment, 4);
  const uint32_t skipped = static_cast<uint32_t>(alignment / sizeof(uint32_t));
  Buffer numbers(device, 2 * alignment, "numbers");
  Recorder recorder(device);
  recorder.fill(numbers, 7, 2 * skipped);
  recorder.dispatch("primitives/iota", skipped, Count{skipped}, {{"numbers", Binding(numbers, alignment, alignment)}});
  std::vector<uint32_t> expected(skipped, 7);
  for (uint32_t i = 0; i < skipped; ++i) expected.push_back(i);
  CHECK(recorder.read<uint32_t>(numbers, 2 * skipped) == expected);
}

TEST_CASE("commands see each other's results in the order of recording") {
  Device& device = test::device();
  const uint32_t count = 1000;
  Buffer first(device, count * sizeof(uint32_t), "first"), second(device, count * sizeof(uint32_t), "second");
  Recorder recorder(device);
  recorder.dispatch("primitives/iota", count, Count{count}, {{"numbers", first}});
  recorder.fill(first, 5, 1, 3);
  recorder.copy(first, 0, second, 0, first.bytes());
  recorder.fill(first, 9, count);
  std::vector<uint32_t> expected = counted(count);
  expected[3] = 5;
  CHECK(recorder.read<uint32_t>(second, count) == expected);
  CHECK(recorder.read<uint32_t>(first, 2, 998) == std::vector<uint32_t>{9, 9});
}

TEST_CASE("a read larger than the staging of a recorder is whole") {
  Device& device = test::device();
  const uint32_t count = 100'000;
  Buffer numbers(device, count * sizeof(uint32_t), "numbers");
  Recorder recorder(device);
  recorder.dispatch("primitives/iota", count, Count{count}, {{"numbers", numbers}});
  CHECK(recorder.read<uint32_t>(numbers, count) == counted(count));
}

TEST_CASE("a submit holds more dispatches than one descriptor pool holds sets") {
  Device& device = test::device();
  Buffer numbers(device, 64, "numbers");
  Recorder recorder(device);
  for (int round = 0; round < 2; ++round) {
    for (int i = 0; i < 1000; ++i) recorder.dispatch("primitives/iota", 16, Count{16}, {{"numbers", numbers}});
    CHECK(recorder.read<uint32_t>(numbers, 16) == counted(16));
  }
}

TEST_CASE("times go to the stage that is under way, however often it changes") {
  Device& device = test::device();
  const uint32_t count = 1 << 16;
  Buffer numbers(device, count * sizeof(uint32_t), "numbers");
  Recorder recorder(device);
  for (int i = 0; i < 1500; ++i) {  // more than the profiler has queries
    recorder.stage(i % 2 ? Stage::shading : Stage::raster);
    if (i % 2) recorder.dispatch("primitives/iota", count, Count{count}, {{"numbers", numbers}});
  }
  recorder.submit();
  const auto times = recorder.profiler().take_milliseconds();
  CHECK(times[size_t(Stage::shading)] > times[size_t(Stage::raster)]);
  CHECK(times[size_t(Stage::hierarchy_traversal)] == 0);
  CHECK(recorder.profiler().take_milliseconds()[size_t(Stage::shading)] == 0);
}

TEST_CASE("making a pipeline and its first run, in which drivers compile, are timed apart from the stage") {
  Device own(test::device().request());
  Buffer numbers(own, 64, "numbers");
  Recorder recorder(own);
  recorder.stage(Stage::shading);
  const auto run = [&] {
    recorder.dispatch("primitives/iota", 16, Count{16}, {{"numbers", numbers}});
    recorder.submit();
    return recorder.profiler().take_milliseconds()[size_t(Stage::shading)];
  };
  const double first = run(), pipelines = recorder.take_pipeline_milliseconds();
  CHECK(pipelines > 0);
  CHECK(first > 0);
  CHECK(run() > 0);
  CHECK(recorder.take_pipeline_milliseconds() == 0);
  CHECK(download<uint32_t>(own, numbers, 16) == counted(16));
}

TEST_CASE("submit_past submits once the recorded work has reached the bound") {
  Device& device = test::device();
  Buffer numbers(device, 64, "numbers");
  Recorder recorder(device);
  recorder.fill(numbers, 0, 16);
  recorder.dispatch("primitives/iota", 16, Count{16}, {{"numbers", numbers}}, 10);
  recorder.submit_past(11);
  CHECK(download<uint32_t>(device, numbers, 16) != counted(16));
  recorder.dispatch("primitives/iota", 16, Count{16}, {{"numbers", numbers}}, 1);
  recorder.submit_past(11);
  CHECK(download<uint32_t>(device, numbers, 16) == counted(16));
}

bool needs_ray_queries(std::string_view file) {
  const std::vector<Declared> arguments = reflect(embedded_spirv(file)).arguments;
  return std::ranges::find(arguments, Resource::acceleration_structure, &Declared::kind) != arguments.end();
}

TEST_CASE("every embedded compute shader that this device can use becomes a program") {
  size_t programs = 0;
  for (const std::string_view file : embedded_files()) {
    if (!file.ends_with(".comp") || (needs_ray_queries(file) && !test::device().info().ray_queries)) continue;
    const Kernel kernel(std::string(file.substr(0, file.size() - 5)));
    CAPTURE(file);
    CHECK(test::device().program(kernel).group_size() >= 1);
    ++programs;
  }
  CHECK(programs > 0);
}

TEST_CASE("the reflection of a shader has its bindings, push block and workgroup") {
  const Reflection reflection = reflect(embedded_spirv("primitives/iota.comp"));
  CHECK(reflection.arguments == std::vector{Declared{"numbers", Resource::storage_buffer}});
  CHECK(reflection.push_bytes == sizeof(Count));
  CHECK(reflection.local_size[0] == 64);
  CHECK(reflection.local_size_id[0] == Reflection::no_constant);
}

TEST_CASE("kernels with clusters of lanes tell lanes apart, so that their subgroups are full; others do not") {
  for (const std::string_view file : embedded_files()) {
    if (!file.starts_with("traversal/group_walk") && !file.starts_with("intersection/node_walk")) continue;
    CAPTURE(file);
    CHECK(reflect(embedded_spirv(file)).tells_lanes_apart == (file.find("-no-shuffle") == file.npos));
  }
  CHECK(!reflect(embedded_spirv("primitives/iota.comp")).tells_lanes_apart);
}

TEST_CASE("images of every format can be made and bound") {
  const uint64_t before = test::device().allocated_bytes();
  {
    const Image colour(test::device(), 16, 9, Format::rgba32f, "colour");
    const Image id(test::device(), 16, 9, Format::r32u, "id");
    Image depth(test::device(), 16, 9, Format::depth32f, "depth");
    Image moved = std::move(depth);
    CHECK(moved.width() == 16);
    CHECK(moved.format() == Format::depth32f);
    CHECK(test::device().allocated_bytes() >= before + 16 * 9 * (16 + 4 + 4));
  }
  CHECK(test::device().allocated_bytes() == before);
}

bool is_embedded(std::string_view file) {
  const std::vector<std::string_view> files = embedded_files();
  return std::binary_search(files.begin(), files.end(), file);
}

TEST_CASE("a draw clears its attachments, and no command brings a validation message") {
  if (!is_embedded("raster/surface.vert")) {
    MESSAGE("skipped: this build leaves shaders/raster out (CRSH_ONLY)");
    return;
  }
  Device& device = test::device();
  constexpr Format rgba = Format::rgba32f;
  const std::vector<Format> formats = {rgba, rgba, rgba, rgba, Format::r32u};
  std::vector<Image> images;
  for (const Format format : formats) images.emplace_back(device, 7, 5, format, "attachment");
  std::vector<const Image*> colours;
  for (const Image& image : images) colours.push_back(&image);
  const Image depth(device, 7, 5, Format::depth32f, "depth");
  const DrawProgram program(device, "raster/surface", formats);

  Buffer pixels(device, 35 * 16, "pixels");
  Recorder recorder(device);
  recorder.fill(pixels, 1, 35 * 4);
  recorder.draw(program, {colours, &depth, true}, 0, 0, NoPush{}, {});  // nothing is bound for no vertices
  recorder.copy(images[0], pixels);
  CHECK(recorder.read<uint32_t>(pixels, 35 * 4) == std::vector<uint32_t>(35 * 4, 0));
  recorder.copy(images[4], pixels);
  CHECK(recorder.read<uint32_t>(pixels, 35) == std::vector<uint32_t>(35, 0));
  CHECK(device.validation_messages() == 0);
}

TEST_SUITE_END();

}  // namespace
}  // namespace crsh::gpu
