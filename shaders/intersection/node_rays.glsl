// The rays of a node that is walked: a lane's own in registers, or, in the "-no-shuffle" build, all of them in memory.

uvec2 node_rays;  // sorted positions, first and end

/// Whether no further triangle can change the ray's hit.
bool is_done(Ray ray, uvec4 hit) { return takes_any_hit(ray) && all(equal(hit.xyz, uvec3(blocked))); }

/// What lies beyond this t cannot change the hit.
float limit_of(Ray ray, uvec4 hit) {
  float end = use_interval == 1u ? ray.origin.w : 3e38;
  return takes_any_hit(ray) ? end : min(end, uintBitsToFloat(hit.x));
}

/// Whether the ray is to be tested against a triangle in a box where no ray is before `enter`.
bool is_wanted(Ray ray, uvec4 hit, float enter) {
  return !is_done(ray, hit) && enter <= limit_of(ray, hit) * (1.0 + 8.0 * bound_pad);
}

#ifdef CRSH_NO_SHUFFLE

void take_rays(uint node) {
  node_rays = rays_of[node];
  for (uint i = node_rays.x; i < node_rays.y; ++i) hits[order[i]] = no_hit(rays[i]);
}

/// How many turns a loop over the rays takes.
uint turns_of_rays() { return node_rays.y - node_rays.x; }

/// Tests the triangle against all rays for which it matters.
void meet_rays(Loaded triangle, float enter) {
  for (uint i = node_rays.x; i < node_rays.y; ++i) {
    Ray ray = rays[i];
    uint id = order[i];
    uvec4 hit = hits[id];
    if (is_wanted(ray, hit, enter)) {
      hits[id] = meet(hit, ray, shear_of(ray.direction.xyz), triangle);
      ++ray_tests;
      ACCOUNT(tests_triangle, triangle_account + id, 1u)
    }
  }
}

/// The distance beyond which nothing matters to any ray of the node; below 0: nothing matters at all.
float reach_of_rays() {
  float reach = -1.0;
  for (uint i = node_rays.x; i < node_rays.y; ++i) {
    Ray ray = rays[i];
    uvec4 hit = hits[order[i]];
    reach = max(reach, is_done(ray, hit) ? -1.0 : limit_of(ray, hit));
  }
  return reach;
}

/// Ends the node: writes the hits of its rays, or, where it is not done, lists the rays and leaves their hits as they
/// were.
void give_rays(bool done) {
  for (uint i = done ? node_rays.y : node_rays.x; i < node_rays.y; ++i) {
    uint id = order[i];
    unfinished[atomicAdd(unfinished_count, 1u)] = id - first_ray;
  }
}

#else

// A lane has the rays `row * cluster + lane` of the node; rows past the node's last ray are never tested. Each row is a
// variable of its own, without a loop over them: lavapipe would run a loop's body once more than there are rows, and
// keep an array in memory.
struct OwnRay {
  uint id;
  Ray ray;
  Shear shear;
  uvec4 hit;
  uint tests;
};
OwnRay own_0, own_1, own_2, own_3, own_4, own_5, own_6, own_7;
#define EACH_ROW(DO)           \
  DO(own_0, 0u)                \
  if (rows > 1u) DO(own_1, 1u) \
  if (rows > 2u) DO(own_2, 2u) \
  if (rows > 3u) DO(own_3, 3u) \
  if (rows > 4u) DO(own_4, 4u) \
  if (rows > 5u) DO(own_5, 5u) \
  if (rows > 6u) DO(own_6, 6u) \
  if (rows > 7u) DO(own_7, 7u)

bool has_ray(uint row) { return row * cluster + lane_in_cluster() < node_rays.y - node_rays.x; }

OwnRay taken_ray(uint row) {
  OwnRay own = OwnRay(0u, Ray(vec4(0.0), vec4(1.0)), Shear(false, false, 0.0, vec2(0.0)), uvec4(0u), 0u);
  if (has_ray(row)) {  // on a CPU each lane's load takes time
    uint position = node_rays.x + row * cluster + lane_in_cluster();
    own.id = order[position];
    own.ray = rays[position];
  }
  own.shear = shear_of(own.ray.direction.xyz);
  own.hit = no_hit(own.ray);
  return own;
}

void take_rays(uint node) {
  node_rays = rays_of[node];
#define TAKE(own, row) own = taken_ray(row);
  EACH_ROW(TAKE)
}

uint turns_of_rays() { return rows; }

void meet_own(inout OwnRay own, uint row, Loaded triangle, float enter) {
  bool wanted = has_ray(row) && is_wanted(own.ray, own.hit, enter);
  if (wanted) {
    own.hit = meet(own.hit, own.ray, own.shear, triangle);
    ++own.tests;
  }
}

void meet_rays(Loaded triangle, float enter) {
#define MEET(own, row) meet_own(own, row, triangle, enter);
  EACH_ROW(MEET)
}

float reach_of(OwnRay own, uint row) {
  return has_ray(row) && !is_done(own.ray, own.hit) ? limit_of(own.ray, own.hit) : -1.0;
}

float reach_of_rays() {
  float reach = -1.0;
#define REACH(own, row) reach = max(reach, reach_of(own, row));
  EACH_ROW(REACH)
  return largest_of_lanes(reach);
}

void give_own(OwnRay own, uint row, bool done) {
  if (done && has_ray(row)) hits[own.id] = own.hit;
  ray_tests += own.tests;
  ACCOUNT(tests_triangle, triangle_account + own.id, own.tests)
}

/// `base`: where the list has room for all rays of the node.
void leave_own(OwnRay own, uint row, uint base) {
  if (has_ray(row)) unfinished[base + row * cluster + lane_in_cluster()] = own.id - first_ray;
}

void give_rays(bool done) {
#define GIVE(own, row) give_own(own, row, done);
  EACH_ROW(GIVE)
  if (!done) {
    uint base = 0u;
    if (lane_in_cluster() == 0u) base = atomicAdd(unfinished_count, node_rays.y - node_rays.x);
    base = FROM_LANE(base, first_of_cluster());
#define LEAVE(own, row) leave_own(own, row, base);
    EACH_ROW(LEAVE)
  }
}

#endif
