#include "output/unfinished.h"

#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <climits>
#include <csignal>
#include <cstring>

#include "crsh/error.h"

namespace crsh::output::unfinished {
namespace {

struct Slot {
  std::atomic<bool> taken = false;
  std::atomic<bool> named = false;  ///< the handler may read `name`
  char name[PATH_MAX];
};
std::array<Slot, slot_count> slots;
std::atomic<unsigned> names_given = 0;

/// Makes only async-signal-safe calls. SA_RESETHAND has restored the default action, so the signal, raised again, ends
/// the program as usual.
void remove_all(int signal) {
  for (const Slot& slot : slots)
    if (slot.named) ::unlink(slot.name);
  ::raise(signal);
}

}  // namespace

size_t claim(const std::filesystem::path& folder) {
  const std::string path = (folder / fmt::format(".crsh-{}-{}", ::getpid(), names_given++)).string();
  if (path.size() >= PATH_MAX) throw UserError(fmt::format("{}: the path is too long", folder.string()));
  for (size_t index = 0; index < slot_count; ++index) {
    if (slots[index].taken.exchange(true)) continue;
    std::memcpy(slots[index].name, path.c_str(), path.size() + 1);
    slots[index].named = true;
    return index;
  }
  throw UserError(fmt::format("more than {} files are being written at once", slot_count));
}

const char* name(size_t slot) { return slots[slot].name; }

void release(size_t slot) {
  slots[slot].named = false;
  slots[slot].taken = false;
}

void remove_on_signals() {
  struct sigaction action = {};
  action.sa_handler = remove_all;
  action.sa_flags = static_cast<int>(SA_RESETHAND);
  for (const int signal : {SIGTERM, SIGINT, SIGHUP, SIGPIPE}) {
    struct sigaction before = {};
    ::sigaction(signal, nullptr, &before);
    if (before.sa_handler != SIG_IGN) ::sigaction(signal, &action, nullptr);  // nohup stays in force
  }
}

}  // namespace crsh::output::unfinished
