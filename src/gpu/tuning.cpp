#include "gpu/tuning.h"

#include <cstdlib>
#include <string>

#include "crsh/error.h"

namespace crsh::gpu {

const Tuning& choose_tuning(bool software) {
  const char* set = std::getenv("CRSH_TUNING");
  const std::string wanted = set && *set ? set : software ? "cpu" : "gpu";
  if (wanted == "cpu") return cpu_tuning;
  if (wanted == "gpu") return gpu_tuning;
  throw UserError("CRSH_TUNING is '" + wanted + "': it may be cpu or gpu");
}

}  // namespace crsh::gpu
