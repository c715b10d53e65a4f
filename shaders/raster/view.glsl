// The camera, as the raster pass's two shaders push it (C++: raster.cpp).

layout(push_constant, scalar) uniform Push {
  vec3 eye;
  float orthographic;  // 1, or 0: perspective
  vec3 right;
  float scale_x;  // image half widths a metre, at distance 1 from a perspective eye
  vec3 up;
  float scale_y;
  vec3 forward;
  float near_plane;
  vec2 shift;         // of the image, in half widths and half heights: where in its pixel the sample lies
  float far_plane;    // 0: a perspective eye sees without end
  float cone_spread;  // how much wider a pixel's cone gets in a metre
  float cone_width;   // and how wide it is at the eye, metres
};

/// How wide the pixel's cone is at `point`.
float cone_at(vec3 point) { return cone_width + cone_spread * length(point - eye); }

/// Unit direction of the ray that the eye sends through `point`.
vec3 eye_ray(vec3 point) { return orthographic == 1.0 ? forward : exact_normalize(point - eye); }
