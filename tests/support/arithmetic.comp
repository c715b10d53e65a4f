#version 460
// A division, a square root, a product and sum, and a product below the normal numbers, to see how they are rounded.
#extension GL_EXT_scalar_block_layout : require
layout(local_size_x = 64) in;
layout(binding = 0, scalar) readonly buffer Operands { vec4 operands[]; };
layout(binding = 1, scalar) writeonly buffer Results { vec4 results[]; };
layout(push_constant, scalar) uniform Push { uint count; };

void main() {
  uint i = gl_GlobalInvocationID.x;
  if (i >= count) return;
  vec4 operand = operands[i];
  precise float quotient = operand.x / operand.y;
  precise float root = sqrt(operand.x);
  precise float product = operand.x * operand.y;
  precise float sum = product + operand.z;
  precise float tiny = operand.x * operand.w;
  results[i] = vec4(quotient, root, sum, tiny);
}
