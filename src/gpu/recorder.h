#pragma once
// Records dispatches, draws and copies, each behind a barrier for the one before, and submits them.

#include <vulkan/vulkan.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <span>
#include <string_view>
#include <type_traits>
#include <vector>

#include "gpu/buffer.h"
#include "gpu/descriptors.h"
#include "gpu/image.h"
#include "gpu/profiler.h"
#include "gpu/program.h"
#include "gpu/submission.h"

namespace crsh::gpu {

/// For shaders without a push block.
struct NoPush {};

/// Colour attachments are cleared to 0 (or kept), depth to 0 (reversed: 0 is infinitely far).
struct Attachments {
  std::span<const Image* const> colours;
  const Image* depth = nullptr;
  bool clear = true;
};

/// Records one command buffer at a time. A full memory barrier follows every command, so that each sees the results of
/// those before it (0.15 µs on lavapipe; in this project nearly every command needs the results of the one before
/// anyway).
class Recorder {
 public:
  explicit Recorder(Device& device);
  Recorder(const Recorder&) = delete;
  Recorder& operator=(const Recorder&) = delete;

  [[nodiscard]] Device& device() { return device_; }
  [[nodiscard]] Profiler& profiler() { return profiler_; }
  /// Milliseconds since the last call that went to pipelines and to no stage: making them on the host, and their first
  /// runs, in which lavapipe compiles.
  [[nodiscard]] double take_pipeline_milliseconds();

  /// Work recorded from here on counts as this stage (Table 3's rows) until the next call.
  void stage(Stage stage);

  /// Runs `kernel` over `count` invocations (whole workgroups: the shader compares its index with a count of its own).
  /// `push` is a struct as the shader declares it. `arguments` are {"name", buffer or image} by the shader's names, in
  /// any order, and its tables where it has some: names, kinds and sizes are asserted against the shader. Nothing is
  /// recorded where count is 0. Dispatches go 2-D past 65,535 groups: lib/invocation.glsl gives the shader its index.
  /// `work` (tests, or elements) is added to the submit's account.
  template <class Push>
  void dispatch(const Kernel& kernel, uint64_t count, const Push& push, std::initializer_list<Argument> arguments,
                uint64_t work = 0) {
    dispatch(kernel, count, push, Arguments(arguments.begin(), arguments.size()), work);
  }
  template <class Push>
  void dispatch(const Kernel& kernel, uint64_t count, const Push& push, Arguments arguments, uint64_t work = 0) {
    static_assert(std::is_trivially_copyable_v<Push>);
    dispatch_bytes(kernel, count, bytes_of(push), arguments, work);
  }

  /// Builds the device's own hierarchy over `corners`, three vec4 a triangle.
  void build(AccelerationStructure& structure, const Buffer& corners);

  /// Draws `count` vertices from vertex `first` on into the attachments.
  template <class Push>
  void draw(const DrawProgram& program, const Attachments& attachments, uint32_t first, uint32_t count,
            const Push& push, std::initializer_list<Argument> arguments) {
    static_assert(std::is_trivially_copyable_v<Push>);
    draw_bytes(program, attachments, first, count, bytes_of(push), {arguments.begin(), arguments.size()});
  }

  /// Fills words of a buffer; `words` counts 32-bit words from word `first` on.
  void fill(const Buffer& buffer, uint32_t value, uint64_t words, uint64_t first = 0);
  void copy(const Buffer& source, uint64_t source_offset, const Buffer& target, uint64_t target_offset, uint64_t bytes);
  /// A colour image's pixels, row by row, to the start of `target`.
  void copy(const Image& source, const Buffer& target);

  /// Called before every submit from here on; may throw to leave what is under way: then what is
  /// recorded is dropped. Empty: nothing is called.
  void on_submit(std::function<void()> call) { before_submit_ = std::move(call); }
  /// Submits what is recorded, if anything, and waits. Timestamps go to the profiler. Device lost throws a UserError.
  void submit();
  /// Submits when the recorded work has reached `bound` (--submit-work).
  void submit_past(uint64_t bound);

  /// Words of a buffer after all recorded work is done: submits, then reads.
  template <class T>
  [[nodiscard]] std::vector<T> read(const Buffer& buffer, uint64_t count, uint64_t first = 0) {
    static_assert(std::is_trivially_copyable_v<T>);
    std::vector<T> values(count);
    read_bytes(buffer, first * sizeof(T), values.data(), count * sizeof(T));
    return values;
  }

 private:
  using Bytes = std::span<const std::byte>;

  template <class Push>
  [[nodiscard]] static Bytes bytes_of(const Push& push) {
    if constexpr (std::is_empty_v<Push>) return {};
    else return std::as_bytes(std::span(&push, 1));
  }

  void dispatch_bytes(const Kernel& kernel, uint64_t count, Bytes push, Arguments arguments, uint64_t work);
  void draw_bytes(const DrawProgram& program, const Attachments& attachments, uint32_t first, uint32_t count,
                  Bytes push, Arguments arguments);
  void read_bytes(const Buffer& buffer, uint64_t offset, void* data, uint64_t bytes);
  void begin();
  void ask_before_submit();
  /// Binds pipeline, arguments and push constants, asserting that they are what the shader declares.
  void bind(VkPipelineBindPoint point, VkPipeline pipeline, const PipelineLayout& layout, const Reflection& reflection,
            Bytes push, Arguments arguments, std::string_view name);
  /// Binds the tables among the arguments, asserting that they are the shader's.
  void bind_tables(VkPipelineBindPoint point, const PipelineLayout& layout, const Reflection& reflection,
                   Arguments arguments, std::string_view name);
  void begin_rendering(const Attachments& attachments);
  void draw_nothing(const DrawProgram& program, const Attachments& attachments, uint32_t first, Bytes push,
                    Arguments arguments);
  void make_room_for_spans();

  Device& device_;
  Submission submission_;
  Profiler profiler_;
  Descriptors descriptors_;
  Buffer staging_;  ///< host-visible, for read_bytes
  std::function<void()> before_submit_;
  uint64_t work_ = 0;
};

}  // namespace crsh::gpu
