// Binding 0: an array of rising numbers, and the search in it.

layout(scalar, binding = 0) readonly buffer Rising { uint rising[]; };

/// Of the first `count` elements the index of the last that is not above `value`. The first element must not be above
/// it.
uint last_not_above(uint value, uint count) {
  uint low = 0, high = count;
  while (low + 1 < high) {
    const uint middle = (low + high) / 2;
    const bool above = rising[middle] > value;
    low = above ? low : middle;
    high = above ? middle : high;
  }
  return low;
}
