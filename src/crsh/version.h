#pragma once
// What `crsh --version` and the statistics say of this build.

namespace crsh {

/// The version in CMakeLists.txt, such as "0.1.0".
extern const char* const version;
/// Twelve hex digits of the git commit, or "unknown" where the source is no git checkout.
extern const char* const commit;

}  // namespace crsh
