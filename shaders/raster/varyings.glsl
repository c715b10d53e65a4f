// What the raster pass's vertices hand to its fragments. The includer defines VARYING as `out` or `in`.

layout(location = 0) flat VARYING uint drawn_triangle;
layout(location = 1) flat VARYING vec3 front;  // unit normal of the triangle's front
layout(location = 2) VARYING vec3 position;
layout(location = 3) VARYING vec3 normal;  // zero: flat shading
layout(location = 4) VARYING vec4 colour;
layout(location = 5) VARYING vec4 texcoords;  // the first two sets
layout(location = 6) VARYING vec2 more_texcoords;
layout(location = 7) flat VARYING float area;  // twice the triangle's, m2
