#include <embree3/rtcore.h>

#include <limits>
#include <stdexcept>

#include "tests/bench/tracer/peers.h"

namespace tribunal::bench {
namespace {

/// Embree's memory monitor: called for each allocation and, with negative bytes, each release.
bool count_bytes(void* total, ssize_t bytes, bool) {
  *static_cast<std::int64_t*>(total) += bytes;
  return true;
}

class EmbreeCaster : public Caster {
 public:
  explicit EmbreeCaster(const Mesh& mesh) : device_(rtcNewDevice("threads=1,user_threads=1")) {
    if (!device_) throw std::runtime_error("Embree gives no device");
    rtcSetDeviceMemoryMonitorFunction(device_, count_bytes, &bytes_);
    scene_ = rtcNewScene(device_);
    rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_ROBUST);
    add(mesh);
    rtcCommitScene(scene_);
    rtcInitIntersectContext(&context_);
  }
  EmbreeCaster(const EmbreeCaster&) = delete;
  ~EmbreeCaster() override {
    rtcReleaseScene(scene_);
    rtcReleaseDevice(device_);
  }

  void first_hits(std::span<const Ray> rays, std::span<std::int64_t> hits) override {
    for (std::size_t i = 0; i < rays.size(); ++i) hits[i] = first_hit(rays[i]);
  }

  std::size_t bytes() const override { return static_cast<std::size_t>(bytes_); }

 private:
  std::int64_t first_hit(const Ray& r) {
    RTCRayHit hit;
    hit.ray.org_x = static_cast<float>(r.o.x);
    hit.ray.org_y = static_cast<float>(r.o.y);
    hit.ray.org_z = static_cast<float>(r.o.z);
    hit.ray.dir_x = static_cast<float>(r.d.v.x);
    hit.ray.dir_y = static_cast<float>(r.d.v.y);
    hit.ray.dir_z = static_cast<float>(r.d.v.z);
    hit.ray.tnear = 0;
    hit.ray.tfar = std::numeric_limits<float>::infinity();
    hit.ray.time = 0;
    hit.ray.mask = ~0U;
    hit.ray.flags = 0;
    hit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    hit.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(scene_, &context_, &hit);
    return hit.hit.geomID == RTC_INVALID_GEOMETRY_ID ? -1 : std::int64_t{hit.hit.primID};
  }

  void add(const Mesh& mesh) {
    RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* vertex = static_cast<float*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                                               3 * sizeof(float), mesh.vertices.size()));
    for (const Point3& v : mesh.vertices) {
      for (int i = 0; i < 3; ++i) *vertex++ = static_cast<float>(v[i]);
    }
    auto* index = static_cast<unsigned*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                                                 3 * sizeof(unsigned), mesh.triangles.size()));
    for (const auto& t : mesh.triangles) {
      for (const std::uint32_t v : t) *index++ = v;
    }
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene_, geometry);
    rtcReleaseGeometry(geometry);
  }

  std::int64_t bytes_ = 0;  ///< declared first, since the device still uses it when it is destroyed
  RTCDevice device_;
  RTCScene scene_ = nullptr;
  RTCIntersectContext context_{};
};

}  // namespace

std::unique_ptr<Caster> make_embree(const Mesh& mesh) { return std::make_unique<EmbreeCaster>(mesh); }

}  // namespace tribunal::bench
