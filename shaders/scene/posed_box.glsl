// The box around all triangles' spheres of an instance that deforms: six words, the low corner's and the high corner's
// coordinates as whole numbers in the same order, so that lanes widen it by atomics, whoever comes first.

uint ordered(float x) {
  uint bits = floatBitsToUint(x);
  return (bits >> 31) != 0u ? ~bits : bits | 0x80000000u;
}

float unordered(uint word) { return uintBitsToFloat((word >> 31) != 0u ? word & 0x7FFFFFFFu : ~word); }
