// Adds tests of rays to their pixels, as 64-bit fixed point (shared/account.h). The includer binds `slots`, `pixels`,
// `account` and `tests`.

#include "shared/account.h"

uint pixel_of(uint ray, uint surfaces, uint first_surface) {
  return floatBitsToUint(pixels[first_surface + slots[ray] % surfaces].w);
}

void add_to_pixel(uint pixel, uvec2 amount) {
  uint before = atomicAdd(tests[pixel].x, amount.x);
  uint high = amount.y + (before + amount.x < before ? 1u : 0u);
  if (high > 0u) atomicAdd(tests[pixel].y, high);
}

/// A sum of two words plus one word.
uvec2 plus(uvec2 sum, uint amount) {
  uint low = sum.x + amount;
  return uvec2(low, sum.y + (low < sum.x ? 1u : 0u));
}

uvec2 fixed_point(uint whole) { return uvec2(whole << tests_fraction_bits, whole >> (32u - tests_fraction_bits)); }

/// The share of the `rank`-th of `count` rays in a node's tests. Shares differ by one unit at most, and their sum is
/// exactly `whole`. A long division, ten bits at a time, as `count` is below 2^22 (max_batch_rays).
uvec2 share_of(uint whole, uint count, uint rank) {
  uint rest = (whole % count) << 10;
  uint upper = rest / count;
  rest = (rest % count) << 10;
  uint lower = rest / count;
  return plus(fixed_point(whole / count), (upper << 10 | lower) + (rank < rest % count ? 1u : 0u));
}
