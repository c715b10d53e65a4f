// crsh-view: shows a scene in a window; turns every error into one line and an exit status.

#include <fmt/format.h>

#include <cstdio>
#include <exception>
#include <new>

#include "cli/mend.h"
#include "crsh/error.h"
#include "crsh/leaks.h"
#include "crsh/version.h"
#include "output/whole_file.h"
#include "viewer/args.h"
#include "viewer/viewer.h"

namespace {

using namespace crsh;

void run(const std::vector<std::string>& words) {
  if (words.size() == 1 && words[0] == "--version")
    return output::write_stdout(fmt::format("crsh-view {} ({})\n", version, commit));
  const std::optional<viewer::Arguments> arguments = viewer::parse_arguments(words);
  if (!arguments) return;
  const viewer::WindowSystem system;
  gpu::DeviceRequest request = arguments->render.device;
  request.window_extensions = system.extensions();
  gpu::Device device(request);
  const gpu::DeviceInfo& info = device.info();
  if (!arguments->render.quiet)
    fmt::print(stderr, "device: {} ({} {}), {}\n", info.name, info.driver, info.driver_version, info.type);
  viewer::Viewer(device, *arguments).run();
  if (device.validation_messages())
    throw UserError(fmt::format("{} validation messages", device.validation_messages()));
}

[[nodiscard]] int report(const std::string& message, Exit status) {
  if (!message.empty()) fmt::print(stderr, "crsh-view: {}\n", message);
  return static_cast<int>(status);
}

}  // namespace

int main(int count, char** arguments) {
  try {
    output::remove_unfinished_files_on_signals();
    run(std::vector<std::string>(arguments + 1, arguments + count));
    return static_cast<int>(Exit::done);
  } catch (const UserError& error) {
    return report(cli::line_of(error), error.status());
  } catch (const gpu::OutOfMemory& shortage) {
    return report(fmt::format("out of memory ({}): make the window or the scene smaller", shortage.name), Exit::failed);
  } catch (const std::bad_alloc&) {
    return report("out of memory: make the window or the scene smaller", Exit::failed);
  } catch (const std::exception& error) {
    return report(fmt::format("internal error: {}", error.what()), Exit::failed);
  }
}
