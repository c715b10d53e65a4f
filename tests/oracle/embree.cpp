#include "oracle/embree.h"

#if CRSH_EMBREE == 4
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

#include <algorithm>

namespace crsh::test {

struct Embree::State {
  RTCDevice device = nullptr;
  RTCScene scene = nullptr;
};

namespace {

#if CRSH_EMBREE == 4
using Context = RTCRayQueryContext;
#else
using Context = RTCIntersectContext;
#endif

/// What a query wants of the filter. Embree hands back the pointer to the first member.
struct Query {
  Context context;
  std::vector<Crossing>* all = nullptr;  ///< none: the closest is wanted
};

bool meets_back(const OracleTriangle& triangle, const glm::dvec3& direction) {
  const glm::dvec3 a(triangle.a), normal = glm::cross(glm::dvec3(triangle.b) - a, glm::dvec3(triangle.c) - a);
  return glm::dot(normal, direction) > 0;
}

bool passed(const OracleTriangle& triangle, const glm::dvec3& direction, const glm::dvec2& weights) {
  return (triangle.single_sided && meets_back(triangle, direction)) ||
         (triangle.alpha && triangle.alpha->at(weights) < triangle.alpha->least);
}

/// Takes note of a hit and goes on, or passes the back of a single-sided triangle, or where alpha has cut it away.
void filter(const RTCFilterFunctionNArguments* arguments) {
  const auto* triangles = static_cast<const OracleTriangle*>(arguments->geometryUserPtr);
  const Query& query = *reinterpret_cast<const Query*>(arguments->context);
  const uint32_t id = RTCHitN_primID(arguments->hit, arguments->N, 0);
  const glm::dvec3 direction(RTCRayN_dir_x(arguments->ray, arguments->N, 0),
                             RTCRayN_dir_y(arguments->ray, arguments->N, 0),
                             RTCRayN_dir_z(arguments->ray, arguments->N, 0));
  const glm::dvec2 weights(RTCHitN_u(arguments->hit, arguments->N, 0), RTCHitN_v(arguments->hit, arguments->N, 0));
  if (query.all) query.all->push_back({id, RTCRayN_tfar(arguments->ray, arguments->N, 0), weights});
  if (query.all || passed(triangles[id], direction, weights)) arguments->valid[0] = 0;
}

RTCRayHit traced(RTCScene scene, const OracleRay& ray, std::vector<Crossing>* all) {
  RTCRayHit found{};
  found.ray.org_x = ray.origin.x, found.ray.org_y = ray.origin.y, found.ray.org_z = ray.origin.z;
  found.ray.dir_x = ray.direction.x, found.ray.dir_y = ray.direction.y, found.ray.dir_z = ray.direction.z;
  found.ray.tfar = ray.tmax;
  found.ray.mask = ~0u;
  found.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  Query query{{}, all};
#if CRSH_EMBREE == 4
  rtcInitRayQueryContext(&query.context);
  RTCIntersectArguments arguments;
  rtcInitIntersectArguments(&arguments);
  arguments.context = &query.context;
  rtcIntersect1(scene, &found, &arguments);
#else
  rtcInitIntersectContext(&query.context);
  rtcIntersect1(scene, &query.context, &found);
#endif
  return found;
}

}  // namespace

Embree::Embree(std::span<const OracleTriangle> triangles) : state_(std::make_unique<State>()) {
  state_->device = rtcNewDevice("threads=1");
  state_->scene = rtcNewScene(state_->device);
  rtcSetSceneFlags(state_->scene, RTC_SCENE_FLAG_ROBUST);
  RTCGeometry geometry = rtcNewGeometry(state_->device, RTC_GEOMETRY_TYPE_TRIANGLE);
  auto* corners = static_cast<glm::vec3*>(rtcSetNewGeometryBuffer(
      geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(glm::vec3), triangles.size() * 3));
  auto* indices = static_cast<glm::uvec3*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                                                   sizeof(glm::uvec3), triangles.size()));
  for (uint32_t i = 0; i < triangles.size(); ++i) {
    corners[3 * i] = triangles[i].a, corners[3 * i + 1] = triangles[i].b, corners[3 * i + 2] = triangles[i].c;
    indices[i] = glm::uvec3(3 * i) + glm::uvec3(0, 1, 2);
  }
  rtcSetGeometryUserData(geometry, const_cast<OracleTriangle*>(triangles.data()));
  rtcSetGeometryIntersectFilterFunction(geometry, filter);
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(state_->scene, geometry);
  rtcReleaseGeometry(geometry);
  rtcCommitScene(state_->scene);
}

Embree::~Embree() {
  rtcReleaseScene(state_->scene);
  rtcReleaseDevice(state_->device);
}

std::optional<Crossing> Embree::closest(const OracleRay& ray) const {
  const RTCRayHit found = traced(state_->scene, ray, nullptr);
  if (found.hit.geomID == RTC_INVALID_GEOMETRY_ID) return {};
  return Crossing{found.hit.primID, found.ray.tfar, {found.hit.u, found.hit.v}};
}

std::vector<Crossing> Embree::all(const OracleRay& ray) const {
  std::vector<Crossing> crossings;
  (void)traced(state_->scene, ray, &crossings);
  std::ranges::sort(crossings, {}, &Crossing::triangle);
  const auto [first, last] = std::ranges::unique(crossings, {}, &Crossing::triangle);
  crossings.erase(first, last);
  return crossings;
}

}  // namespace crsh::test
