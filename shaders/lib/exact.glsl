#ifndef CRSH_LIB_EXACT_GLSL
#define CRSH_LIB_EXACT_GLSL
// Arithmetic that rounds in the same way in every shader. `precise` forbids to fuse or reorder operations, but does not
// reach into built-in functions: so they are written out here.

float exact_dot(vec3 a, vec3 b) {
  precise float x = a.x * b.x;
  precise float y = a.y * b.y;
  precise float z = a.z * b.z;
  precise float sum = (x + y) + z;
  return sum;
}

vec3 exact_cross(vec3 a, vec3 b) {
  precise vec3 left = vec3(a.y * b.z, a.z * b.x, a.x * b.y);
  precise vec3 right = vec3(a.z * b.y, a.x * b.z, a.y * b.x);
  precise vec3 result = left - right;
  return result;
}

float exact_length(vec3 v) {
  precise float result = sqrt(exact_dot(v, v));
  return result;
}

/// The unit vector along v; v itself where its length is 0.
vec3 exact_normalize(vec3 v) {
  precise float squared = exact_dot(v, v);
  precise vec3 result = squared > 0.0 ? v / sqrt(squared) : v;
  return result;
}

float largest(vec3 v) { return max(max(abs(v.x), abs(v.y)), abs(v.z)); }

#endif
