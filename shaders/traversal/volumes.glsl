// What the bound in use tests of a triangle: its smallest sphere (section 3.2.5), or its corners. Before this file the
// includer includes the bound and declares the bindings TriangleSpheres and CornersA to CornersC.

#ifdef BOUND_TESTS_CORNERS
struct Volume {
  vec3 a;
  vec3 b;
  vec3 c;
};
Volume load_volume(uint triangle) {
  return Volume(corner_a[triangle].xyz, corner_b[triangle].xyz, corner_c[triangle].xyz);
}
bool may_hit(BOUND node, Interval interval, Volume volume, bool use_interval) {
  return bound_may_hit_corners(node, interval, volume.a, volume.b, volume.c, use_interval);
}
Volume passed_round(Volume mine, uint lane) {
  return Volume(FROM_LANE(mine.a, lane), FROM_LANE(mine.b, lane), FROM_LANE(mine.c, lane));
}
#else
struct Volume {
  vec4 sphere;
};
Volume load_volume(uint triangle) { return Volume(triangle_spheres[triangle]); }
bool may_hit(BOUND node, Interval interval, Volume volume, bool use_interval) {
  return bound_may_hit_sphere(node, interval, volume.sphere, use_interval);
}
Volume passed_round(Volume mine, uint lane) { return Volume(FROM_LANE(mine.sphere, lane)); }
#endif
