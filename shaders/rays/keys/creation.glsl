// No key: rays keep the order in which they were created.

layout(constant_id = 0) const uint shared_origin_key_bits = 0;
layout(constant_id = 1) const uint key_bits = 0;

uint ray_key(vec3 place, vec3 direction, bool shared_origin) { return 0; }
