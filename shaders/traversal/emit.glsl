// Test-only mutation: every so many-th pair is replaced by one with triangle 0.
layout(constant_id = 0) const uint drop_every = 0u;

HitPair emitted(uint place, uint node, uint triangle) {
  bool dropped = drop_every != 0u && place % drop_every == drop_every - 1u;
  return HitPair(node, dropped ? 0u : triangle);
}
