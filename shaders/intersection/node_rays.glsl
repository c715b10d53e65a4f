// The rays of a node that is walked: a lane's own in registers, or, in the "-alone" build, all of them in memory.

uvec2 node_rays;  // sorted positions, first and end

/// Nothing can change what has become of the ray.
bool is_done(Ray ray, uvec4 hit) { return uint(ray.direction.w) == kind_shadow && all(equal(hit.xyz, uvec3(blocked))); }

/// Beyond this t nothing counts.
float limit_of(Ray ray, uvec4 hit) {
  float end = use_interval == 1u ? ray.origin.w : 3e38;
  return uint(ray.direction.w) == kind_shadow ? end : min(end, uintBitsToFloat(hit.x));
}

/// Whether the ray is to be tested against a triangle in a box where no ray is before `enter`.
bool is_wanted(Ray ray, uvec4 hit, float enter) {
  return !is_done(ray, hit) && enter <= limit_of(ray, hit) * (1.0 + 8.0 * bound_pad);
}

/// As intersection/clear.comp has left it.
uvec4 cleared_hit(Ray ray) {
  return uint(ray.direction.w) == kind_shadow ? uvec4(0u) : uvec4(0x7F800000u, none, 0u, 0u);
}

#ifdef CRSH_ALONE

void take_rays(uint node) {
  node_rays = rays_of[node];
}

/// Turns of a loop over the rays.
uint turns_of_rays() { return node_rays.y - node_rays.x; }

/// The triangle against all rays that want it.
void meet_rays(Loaded triangle, float enter) {
  for (uint i = node_rays.x; i < node_rays.y; ++i) {
    Ray ray = rays[i];
    uint id = order[i];
    uvec4 hit = hits[id];
    for (bool wanted = is_wanted(ray, hit, enter); wanted; wanted = false) {
      hits[id] = meet(hit, ray, shear_of(ray.direction.xyz), triangle);
      ++ray_tests;
      ACCOUNT(tests_triangle, triangle_account + id, 1u)
    }
  }
}

/// No ray of the node is interested in anything beyond; below 0: in anything.
float reach_of_rays() {
  float reach = -1.0;
  for (uint i = node_rays.x; i < node_rays.y; ++i) {
    Ray ray = rays[i];
    uvec4 hit = hits[order[i]];
    reach = max(reach, is_done(ray, hit) ? -1.0 : limit_of(ray, hit));
  }
  return reach;
}

/// The rays are finished; or they are left, as if nothing had been.
void give_rays(bool done) {
  for (uint i = done ? node_rays.y : node_rays.x; i < node_rays.y; ++i) {
    uint id = order[i];
    hits[id] = cleared_hit(rays[i]);
    left[id - first_ray] = 1u;
    atomicAdd(left_count[0], 1u);
  }
}

#else

// Ray `row * cluster + lane` of the node is lane's; those past the node's last one are never wanted.
uint own_id[rows];
Ray own_ray[rows];
Shear own_shear[rows];
uvec4 own_hit[rows];
uint own_tests[rows];

bool has_ray(uint row) { return row * cluster + lane_in_cluster() < node_rays.y - node_rays.x; }

void take_rays(uint node) {
  node_rays = rays_of[node];
  for (uint row = 0u; row < rows; ++row) {
    own_id[row] = 0u;
    own_ray[row] = Ray(vec4(0.0), vec4(1.0));
    if (has_ray(row)) {  // software pays by the lane
      uint position = node_rays.x + row * cluster + lane_in_cluster();
      own_id[row] = order[position];
      own_ray[row] = rays[position];
    }
    own_shear[row] = shear_of(own_ray[row].direction.xyz);
    own_hit[row] = cleared_hit(own_ray[row]);
    own_tests[row] = 0u;
  }
}

uint turns_of_rays() { return rows; }

void meet_rays(Loaded triangle, float enter) {
  for (uint row = 0u; row < rows; ++row) {
    bool wanted = has_ray(row) && is_wanted(own_ray[row], own_hit[row], enter);
    // Most nodes fill one row: a loop, because lavapipe 22.3 never skips an `if`.
    for (bool some = row == 0u || wanted; some; some = false) {
      uvec4 hit = meet(own_hit[row], own_ray[row], own_shear[row], triangle);
      own_hit[row] = wanted ? hit : own_hit[row];
      own_tests[row] += wanted ? 1u : 0u;
    }
  }
}

float reach_of_rays() {
  float reach = -1.0;
  for (uint row = 0u; row < rows; ++row)
    reach = has_ray(row) && !is_done(own_ray[row], own_hit[row]) ? max(reach, limit_of(own_ray[row], own_hit[row])) : reach;
  return largest_of_lanes(reach);
}

void give_rays(bool done) {
  for (uint row = 0u; row < rows; ++row) {
    if (done && has_ray(row)) hits[own_id[row]] = own_hit[row];
    ray_tests += own_tests[row];
    ACCOUNT(tests_triangle, triangle_account + own_id[row], own_tests[row])
  }
  for (bool later = !done; later; later = false) {
    for (uint row = 0u; row < rows; ++row)
      if (has_ray(row)) left[own_id[row] - first_ray] = 1u;
    if (lane_in_cluster() == 0u) atomicAdd(left_count[0], node_rays.y - node_rays.x);
  }
}

#endif
