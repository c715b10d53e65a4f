#include "scene/gltf/parallel.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <system_error>
#include <thread>
#include <vector>

namespace crsh::scene {

unsigned threads_here() { return std::max(std::thread::hardware_concurrency(), 1u); }

void in_parallel(size_t count, unsigned threads, const std::function<void(size_t)>& work) {
  std::atomic<size_t> next = 0;
  std::vector<std::exception_ptr> thrown(count);
  const auto run = [&] {
    for (size_t i = next++; i < count; i = next++) try {
        work(i);
      } catch (...) {
        thrown[i] = std::current_exception();
      }
  };
  {
    std::vector<std::jthread> others;
    try {
      while (others.size() + 1 < std::min<size_t>(threads, count)) others.emplace_back(run);
    } catch (const std::system_error&) {  // no more threads are to be had: those there are do it
    }
    run();
  }
  for (const std::exception_ptr& exception : thrown)
    if (exception) std::rethrow_exception(exception);
}

}  // namespace crsh::scene
