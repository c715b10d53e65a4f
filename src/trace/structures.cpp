#include "trace/structures.h"

namespace crsh::trace {

void place(gpu::Recorder& recorder, const objects::In& in, const Needs& needs, Structures& structures) {
  if (needs.object_hierarchy) objects::update(recorder, in, structures.objects);
  if (needs.device_hierarchy) objects::update(recorder, in, structures.device_objects);
}

}  // namespace crsh::trace
