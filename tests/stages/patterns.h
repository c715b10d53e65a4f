#pragma once
// Lengths and contents of arrays that scans, sorts and compactions are tried on.

#include <array>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

namespace crsh::test {

inline constexpr std::array<uint32_t, 9> lengths = {0, 1, 7, 8, 255, 256, 257, 65'537, 1'000'003};

enum class Pattern { all_equal, sorted, reversed, random };
inline constexpr std::array<Pattern, 4> patterns = {Pattern::all_equal, Pattern::sorted, Pattern::reversed,
                                                    Pattern::random};

inline std::string name_of(Pattern pattern) {
  constexpr std::array names = {"all equal", "sorted", "reversed", "random"};
  return names[size_t(pattern)];
}

/// `n` numbers below 2^bits.
inline std::vector<uint32_t> numbers(Pattern pattern, uint32_t n, uint32_t bits, uint32_t seed = 1) {
  const uint32_t mask = bits == 0 ? 0 : UINT32_MAX >> (32 - bits);
  std::mt19937 random(seed);
  std::vector<uint32_t> values(n);
  for (uint32_t i = 0; i < n; ++i) {
    const uint32_t rising = uint32_t((uint64_t(i) << bits) / n) & mask;
    switch (pattern) {
      case Pattern::all_equal: values[i] = 0x5A5A5A5A & mask; break;
      case Pattern::sorted: values[i] = rising; break;
      case Pattern::reversed: values[i] = mask - rising; break;
      case Pattern::random: values[i] = uint32_t(random()) & mask; break;
    }
  }
  return values;
}

}  // namespace crsh::test
