#include "trace/in.h"

namespace crsh::trace {

/// The mutation "dropped-pairs" (tests/README.md) drops every so many-th.
constexpr uint32_t dropped_pairs = 10000;

intersection::In intersection_in(const In& in, uint32_t kind) {
  return {.scene = in.scene,
          .batch = in.batch,
          .hits = in.workspace.hits,
          .counters = in.counters.buffer(),
          .counter_row = Counters::row(in.bounce, kind),
          .submit_work = in.options.submit_work,
          .account = in.workspace.account};
}

traversal::In traversal_in(const In& in, uint32_t kind) {
  return {.hierarchy = in.workspace.bundle.hierarchy,
          .scene = in.scene,
          .options = in.options.algorithm,
          .counters = in.counters.buffer(),
          .counter_row = Counters::row(in.bounce, kind),
          .submit_work = in.options.submit_work,
          .max_pairs = in.max_pairs,
          .drop_every = in.options.mutation == "dropped-pairs" ? dropped_pairs : 0u,
          .account = in.workspace.account};
}

}  // namespace crsh::trace
