// What shaders declare: names of what they bind, how much they bind, and devices that bind too little.

#include <doctest/doctest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstring>
#include <functional>
#include <vector>

#include "gpu/embedded.h"
#include "gpu/needs.h"
#include "gpu/recorder.h"
#include "support/device.h"

namespace crsh::gpu {
namespace {

TEST_SUITE_BEGIN("subset");

const std::vector<Declared> declared = {{"rays", Resource::storage_buffer}, {"hits", Resource::storage_buffer}};

std::string complaint(const std::vector<std::string_view>& names) { return misnamed("some/kernel", declared, names); }

TEST_CASE("arguments are named as the shader declares them, in any order, each once") {
  CHECK(complaint({"rays", "hits"}).empty());
  CHECK(complaint({"hits", "rays"}).empty());
  CHECK(complaint({"rays", "hit"}) == "some/kernel takes rays, hits, and is given rays, hit");
  CHECK(complaint({"rays"}) == "some/kernel takes rays, hits, and is given rays");
  CHECK(complaint({"rays", "rays"}) == "some/kernel takes rays, hits, and is given rays, rays");
  CHECK(complaint({"rays", "hits", "more"}) == "some/kernel takes rays, hits, and is given rays, hits, more");
  CHECK(complaint({}) == "some/kernel takes rays, hits, and is given nothing");
}

/// What a child process that runs `call` wrote to stderr before it aborted; empty where it did not.
std::string aborted_with(const std::function<void()>& call) {
  std::array<int, 2> pipe_ends{};
  REQUIRE(pipe(pipe_ends.data()) == 0);
  const pid_t child = fork();
  if (child == 0) {
    std::signal(SIGABRT, SIG_DFL);  // not the test runner's
    dup2(pipe_ends[1], STDERR_FILENO);
    call();
    _exit(0);
  }
  close(pipe_ends[1]);
  std::string text;
  for (char c = 0; read(pipe_ends[0], &c, 1) == 1;) text += c;
  close(pipe_ends[0]);
  int status = 0;
  waitpid(child, &status, 0);
  return WIFSIGNALED(status) && WTERMSIG(status) == SIGABRT ? text : "";
}

TEST_CASE("a dispatch with a wrong name, one too few or one too many stops with both lists") {
  const Buffer numbers(test::device(), 64, "numbers");
  Recorder recorder(test::device());
  (void)test::device().program("primitives/iota");  // not to be compiled by a forked process
  const uint32_t count = 16;
  const auto dispatch = [&](std::initializer_list<Argument> arguments) {
    return aborted_with([&] { recorder.dispatch("primitives/iota", count, count, arguments); });
  };
  CHECK(dispatch({{"numbers", numbers}}).empty());
  CHECK(dispatch({{"number", numbers}}).find("primitives/iota takes numbers, and is given number\n") !=
        std::string::npos);
  CHECK(dispatch({}).find("is given nothing") != std::string::npos);
  CHECK(dispatch({{"numbers", numbers}, {"numbers", numbers}}).find("is given numbers, numbers") != std::string::npos);
  const Image image(test::device(), 4, 4, Format::r32u, "image");
  CHECK(dispatch({{"numbers", image}}).find("numbers of primitives/iota is of another kind") != std::string::npos);
  const BufferSet tables(test::device(), std::array{BufferSet::Member{"more", numbers}});
  CHECK(dispatch({tables, {"numbers", numbers}}).find("the tables of primitives/iota") != std::string::npos);
}

TEST_CASE("arguments reach the bindings of their names, in whatever order they are given") {
  const std::vector<uint32_t> ones(64, 1);
  const Buffer source = upload(test::device(), ones, "source"), sums(test::device(), 64, "sums");
  Recorder recorder(test::device());
  recorder.fill(sums, 0, 16);
  const struct {
    uint32_t quads;
    uint32_t lanes;
    uint32_t first_lane;
  } push{16, 1, 0};
  recorder.dispatch(Kernel("primitives/scan_sum", {{0, 16}, {1, 16}}), 1, push, {{"sums", sums}, {"source", source}});
  CHECK(recorder.read<uint32_t>(sums, 1)[0] == 64);
  CHECK(recorder.read<uint32_t>(source, 64) == ones);
}

TEST_CASE("the names of a shader are its arrays' and images', and tables are a set of their own") {
  const Reflection trim = reflect(embedded_spirv("coherence/trim.comp"));
  CHECK(names_of(trim.arguments) == "sparse, flags, ends, rays, slots");
  CHECK(trim.tables.empty());
  const Reflection hits = reflect(embedded_spirv("surfaces/from_hits.comp"));
  CHECK(names_of(hits.tables).starts_with("corner_a, corner_b, corner_c, triangles, vertices"));
  CHECK(hits.tables[0].kind == Resource::texel_buffer);
  CHECK(hits.tables[5].kind == Resource::storage_buffer);
}

TEST_CASE("a shader whose buffer has another name cannot stand for the embedded one") {
  const std::span<const uint32_t> embedded = embedded_spirv("primitives/iota.comp");
  std::vector<uint32_t> words(embedded.begin(), embedded.end());
  CHECK(misfit("primitives/iota.comp", words).empty());
  uint32_t numb = 0;
  std::memcpy(&numb, "numb", 4);
  uint32_t lumb = 0;
  std::memcpy(&lumb, "lumb", 4);
  std::replace(words.begin(), words.end(), numb, lumb);  // "numbers" becomes "lumbers"
  CHECK(misfit("primitives/iota.comp", words) == "its bindings' names have changed");
}

TEST_CASE("no embedded shader binds more than 16 storage buffers, as many texel buffers, or 8 of anything else") {
  const StageLimits& most = max_needed();
  CHECK(most.storage_buffers <= 16);
  CHECK(most.sampled_images <= 16);  // what every device has
  CHECK(most.storage_images <= 8);
  CHECK(most.colour_attachments <= 8);
  CHECK(most.fragment_outputs <= 16);
  for (const std::string_view file : embedded_files()) {
    if (!file.ends_with(".comp")) continue;
    CAPTURE(file);
    CHECK(needs_of(reflect(embedded_spirv(file))).storage_buffers <= most.storage_buffers);
  }
  CHECK(needs_of(reflect(embedded_spirv("surfaces/from_raster.comp"))).storage_images == 5);
}

TEST_CASE("a device that binds too little is told from one that binds enough, by name and number") {
  const StageLimits needed{16, 5, 8, 5, 9};
  CHECK(too_few(needed, needed).empty());
  CHECK(too_few({500000, 500000, 500000, 8, 500000}, needed).empty());
  CHECK(too_few({4, 4, 16, 4, 4}, needed) == "it binds 4 storage buffers at once, 16 are needed");
  CHECK(too_few({16, 4, 16, 4, 4}, needed) == "it binds 4 storage images at once, 5 are needed");
  CHECK(too_few({16, 5, 7, 8, 16}, needed) == "it binds 7 texel buffers at once, 8 are needed");
  CHECK(too_few({16, 5, 16, 4, 16}, needed) == "it binds 4 colour attachments at once, 5 are needed");
  CHECK(too_few({16, 5, 16, 8, 8}, needed) == "it binds 8 fragment resources at once, 9 are needed");
  CHECK(needs_text({32, 16, 128, 8, 64}, needed).starts_with("16 of 32 storage buffers, 5 of 16 storage images, "));
  CHECK(too_few(test::device().info().stage, max_needed()).empty());
}

TEST_SUITE_END();

}  // namespace
}  // namespace crsh::gpu
