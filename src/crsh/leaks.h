#pragma once
// For programs under the address sanitiser: leaks that are not ours.

#ifdef __SANITIZE_ADDRESS__
#include <dlfcn.h>

// The validation layer, Mesa's layer that sorts devices, and lavapipe never free some of their tables. The leak checker
// recognises them by the library's name, as long as the library is in memory.
extern "C" const char* __lsan_default_suppressions() {
  return "leak:libVkLayer_khronos_validation.so\nleak:libVkLayer_MESA_device_select.so\nleak:libvulkan_lvp.so\n";
}
extern "C" const char* __lsan_default_options() { return "print_suppressions=0"; }
// How much freed memory the sanitiser keeps from being used again: lavapipe frees megabytes at every timestamp, and
// with the default that came to 7 GB.
extern "C" const char* __asan_default_options() { return "quarantine_size_mb=32"; }
static const void* const kept[] = {dlopen("libVkLayer_khronos_validation.so", RTLD_LAZY | RTLD_NODELETE),
                                   dlopen("libVkLayer_MESA_device_select.so", RTLD_LAZY | RTLD_NODELETE),
                                   dlopen("libvulkan_lvp.so", RTLD_LAZY | RTLD_NODELETE)};
#endif
