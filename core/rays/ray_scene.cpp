// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/rays/ray_scene.h"

#include "core/base/mistake.h"
#include "core/base/parallel.h"
#include "core/base/rejected.h"
#include "core/mesh/far_origin.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <embree3/rtcore.h>
#include <glm/gtc/matrix_transform.hpp>
#include <limits>

namespace trivar {
namespace {

// Instances and the scenes they show must belong to one device, so the process has one. It holds
// nothing that a result could depend on.
RTCDevice device()
{
    struct Device {
        RTCDevice handle = rtcNewDevice(nullptr);
        ~Device() { rtcReleaseDevice(handle); }
    };
    static const Device device;
    return device.handle;
}

struct SceneHandle {
    RTCScene scene = nullptr;
    SceneHandle()
    {
        scene = rtcNewScene(device());
        rtcSetSceneFlags(scene, static_cast<RTCSceneFlags>(RTC_SCENE_FLAG_ROBUST |
                                                           RTC_SCENE_FLAG_CONTEXT_FILTER_FUNCTION));
    }
    ~SceneHandle() { rtcReleaseScene(scene); }
    SceneHandle(const SceneHandle&) = delete;
    SceneHandle& operator=(const SceneHandle&) = delete;
};

// A Candidate is a triangle of an entry and the place where the ray meets it.
struct Candidate {
    unsigned entry = 0, triangle = 0;
    float distance = 0;
};

// A Query holds the data of our filter; Embree's own context must be its first member.
struct Query {
    RTCIntersectContext context;
    bool skip_back_faces = false;
    bool collect = false; // note every triangle and accept none
    std::array<Candidate, 32> found{};
    std::size_t count = 0;
};

void filter(const RTCFilterFunctionNArguments* args)
{
    auto* query = reinterpret_cast<Query*>(args->context);
    for (unsigned i = 0; i < args->N; ++i) {
        if (args->valid[i] != -1) continue;
        const glm::vec3 normal(RTCHitN_Ng_x(args->hit, args->N, i),
                               RTCHitN_Ng_y(args->hit, args->N, i),
                               RTCHitN_Ng_z(args->hit, args->N, i));
        const glm::vec3 direction(RTCRayN_dir_x(args->ray, args->N, i),
                                  RTCRayN_dir_y(args->ray, args->N, i),
                                  RTCRayN_dir_z(args->ray, args->N, i));
        const bool back = glm::dot(normal, direction) > 0;
        if (query->collect || (query->skip_back_faces && back)) args->valid[i] = 0;
        if (!query->collect || (query->skip_back_faces && back)) continue;
        if (query->count < query->found.size())
            query->found[query->count++] = {query->context.instID[0],
                                            RTCHitN_primID(args->hit, args->N, i),
                                            RTCRayN_tfar(args->ray, args->N, i)};
    }
}

RTCRayHit embree_ray(const Ray& ray, double from, double to)
{
    const double far = std::min(to, 3e38);
    RTCRayHit out{};
    out.ray.org_x = static_cast<float>(ray.origin.x);
    out.ray.org_y = static_cast<float>(ray.origin.y);
    out.ray.org_z = static_cast<float>(ray.origin.z);
    out.ray.dir_x = static_cast<float>(ray.direction.x);
    out.ray.dir_y = static_cast<float>(ray.direction.y);
    out.ray.dir_z = static_cast<float>(ray.direction.z);
    out.ray.tnear = static_cast<float>(from);
    out.ray.tfar = static_cast<float>(far);
    out.ray.mask = 0xffffffffu;
    out.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    out.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    return out;
}

void set_lane(RTCRayHit8& packet, std::size_t i, const RTCRayHit& one)
{
    packet.ray.org_x[i] = one.ray.org_x;
    packet.ray.org_y[i] = one.ray.org_y;
    packet.ray.org_z[i] = one.ray.org_z;
    packet.ray.dir_x[i] = one.ray.dir_x;
    packet.ray.dir_y[i] = one.ray.dir_y;
    packet.ray.dir_z[i] = one.ray.dir_z;
    packet.ray.tnear[i] = one.ray.tnear;
    packet.ray.tfar[i] = one.ray.tfar;
    packet.ray.mask[i] = one.ray.mask;
    packet.hit.geomID[i] = one.hit.geomID;
    packet.hit.instID[0][i] = one.hit.instID[0];
}

void intersect(RTCScene scene, Query& query, RTCRayHit& ray)
{
    rtcInitIntersectContext(&query.context);
    if (query.skip_back_faces || query.collect) query.context.filter = filter;
    rtcIntersect1(scene, &query.context, &ray);
}

// A PlaneHit is where a ray meets the plane of a triangle, and how far that is outside the
// triangle: the most negative barycentric coordinate, or 0. A plane seen edge-on is not met.
struct PlaneHit {
    double distance = 0;
    double outside = 0;
    glm::dvec3 normal{0}; // not unit
};

PlaneHit meet(const Ray& ray, const std::array<glm::dvec3, 3>& p)
{
    const glm::dvec3 e1 = p[1] - p[0], e2 = p[2] - p[0];
    const glm::dvec3 n = glm::cross(e1, e2);
    const double along = glm::dot(n, ray.direction);
    const glm::dvec3 to = p[0] - ray.origin;
    if (along == 0) return {glm::dot(to, ray.direction), -1, n};
    const glm::dvec3 q = glm::cross(to, ray.direction);
    const double b1 = glm::dot(e2, q) / along, b2 = -glm::dot(e1, q) / along;
    return {glm::dot(n, to) / along, std::min({0.0, b1, b2, 1 - b1 - b2}), n};
}

// Returns the box of a transformed box: cheap, and tight if the matrix keeps the axes.
Box box_of(const Box& box, const glm::dmat4& to_world)
{
    Box out;
    if (box.empty()) return out;
    for (const double x : {box.lo.x, box.hi.x})
        for (const double y : {box.lo.y, box.hi.y})
            for (const double z : {box.lo.z, box.hi.z})
                out.add(glm::dvec3(to_world * glm::dvec4(x, y, z, 1)));
    return out;
}

} // namespace

struct RayMesh::State {
    Ref<Mesh> mesh;
    std::vector<glm::uvec3> triangles;
    std::vector<std::uint32_t> face; // of each triangle
    Box box;
    std::vector<Box> block_boxes;
    SceneHandle handle;
};

RayMesh::RayMesh(Ref<Mesh> mesh) : state_(std::make_unique<State>())
{
    state_->triangles = trivar::triangles(*mesh);
    state_->box = bounding_box(*mesh);
    for (std::size_t f = 0; f < mesh->face_count(); ++f)
        for (std::uint32_t c = mesh->face_begin[f] + 2; c < mesh->face_begin[f + 1]; ++c)
            state_->face.push_back(static_cast<std::uint32_t>(f));
    ensure(state_->face.size() == state_->triangles.size(), "a triangle is of no face");

    state_->block_boxes.resize((state_->triangles.size() + block - 1) / block);
    for (std::size_t t = 0; t < state_->triangles.size(); ++t)
        for (int k = 0; k < 3; ++k)
            state_->block_boxes[t / block].add(
                glm::dvec3(mesh->positions[state_->triangles[t][k]]));

    if (!state_->triangles.empty()) {
        RTCGeometry geometry = rtcNewGeometry(device(), RTC_GEOMETRY_TYPE_TRIANGLE);
        // Embree reads 16 bytes a vertex, past the end of a plain array, so it gets its own copy.
        auto* points = static_cast<glm::vec3*>(
            rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                    sizeof(glm::vec3), mesh->positions.size()));
        std::copy(mesh->positions.begin(), mesh->positions.end(), points);
        auto* indices = static_cast<glm::uvec3*>(
            rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                    sizeof(glm::uvec3), state_->triangles.size()));
        std::copy(state_->triangles.begin(), state_->triangles.end(), indices);
        rtcCommitGeometry(geometry);
        rtcAttachGeometry(state_->handle.scene, geometry);
        rtcReleaseGeometry(geometry);
    }
    rtcCommitScene(state_->handle.scene);
    state_->mesh = std::move(mesh);
}

RayMesh::~RayMesh() = default;

const Mesh& RayMesh::mesh() const
{
    return *state_->mesh;
}

const std::vector<glm::uvec3>& RayMesh::triangles() const
{
    return state_->triangles;
}

const std::vector<Box>& RayMesh::block_boxes() const
{
    return state_->block_boxes;
}

struct RayScene::State {
    std::vector<Entry> entries;
    std::vector<glm::dmat3> normal_to_world;
    std::vector<Box> boxes; // of each entry, world
    Box bounds;
    glm::dvec3 origin{0}; // of Embree's scene in the world: single precision has its digits there
    SceneHandle handle;

    RTCRayHit near_ray(const Ray& ray, double from, double to) const
    {
        return embree_ray({ray.origin - origin, ray.direction}, from, to);
    }

    std::array<glm::dvec3, 3> corners(unsigned entry, unsigned triangle) const
    {
        const Entry& e = entries[entry];
        const glm::uvec3 t = e.mesh->triangles()[triangle];
        std::array<glm::dvec3, 3> out;
        for (int k = 0; k < 3; ++k)
            out[static_cast<std::size_t>(k)] =
                glm::dvec3(e.to_world * glm::dvec4(e.mesh->mesh().positions[t[k]], 1));
        return out;
    }

    Hit resolve(const Ray& ray, double from, double to, bool skip_back_faces, Candidate best,
                float u, float v) const;

    bool shared_by_entries(const glm::dvec3& p, double slack) const
    {
        int inside = 0;
        for (const Box& box : boxes)
            inside += glm::all(glm::greaterThanEqual(p, box.lo - slack)) &&
                      glm::all(glm::lessThanEqual(p, box.hi + slack));
        return inside > 1;
    }
};

RayScene::RayScene(std::vector<Entry> entries) : state_(std::make_unique<State>())
{
    State& s = *state_;
    s.entries = std::move(entries);
    for (std::size_t i = 0; i < s.entries.size(); ++i) {
        const Entry& e = s.entries[i];
        const glm::dmat4& m = e.to_world;
        for (int c = 0; c < 4; ++c)
            for (int r = 0; r < 4; ++r)
                if (!std::isfinite(m[c][r]))
                    throw Rejected("the transform of object " + std::to_string(e.object) +
                                   " is not finite");
        // A mesh squeezed flat keeps no outside; its hits are recomputed in world space anyway.
        const double volume = glm::determinant(glm::dmat3(m));
        s.normal_to_world.push_back(volume != 0 ? glm::transpose(glm::inverse(glm::dmat3(m)))
                                                : glm::dmat3(0));
        s.boxes.push_back(box_of(e.mesh->state().box, m));
        s.bounds.add(s.boxes.back());
    }
    s.origin = far_origin(s.bounds);
    for (std::size_t i = 0; i < s.entries.size(); ++i) {
        const Entry& e = s.entries[i];
        RTCGeometry instance = rtcNewGeometry(device(), RTC_GEOMETRY_TYPE_INSTANCE);
        rtcSetGeometryInstancedScene(instance, e.mesh->state().handle.scene);
        const glm::mat4x3 floats(glm::translate(glm::dmat4(1), -s.origin) * e.to_world);
        rtcSetGeometryTransform(instance, 0, RTC_FORMAT_FLOAT3X4_COLUMN_MAJOR, &floats[0][0]);
        rtcCommitGeometry(instance);
        rtcAttachGeometryByID(s.handle.scene, instance, static_cast<unsigned>(i));
        rtcReleaseGeometry(instance);
    }
    rtcCommitScene(s.handle.scene);
}

RayScene::~RayScene() = default;
RayScene::RayScene(RayScene&&) noexcept = default;
RayScene& RayScene::operator=(RayScene&&) noexcept = default;

// Finds the hit of a ray on the triangle that Embree found nearest, where u and v are its
// barycentric coordinates.
Hit RayScene::State::resolve(const Ray& ray, double from, double to, bool skip_back_faces,
                             Candidate best, float u, float v) const
{
    const float nearest = best.distance;
    PlaneHit plane = meet(ray, corners(best.entry, best.triangle));

    // Near an edge, or where objects touch, several triangles compete, and which one Embree returns
    // depends on single precision and on the order in which its tree was built. So all of them are
    // collected and the choice is made in double.
    const float nearest_edge = std::min({u, v, 1 - u - v});
    const double slack = 1e-5 * (std::abs(double{nearest}) + glm::length(ray.origin - origin));
    if (nearest_edge < 0.01f || plane.outside < 0 ||
        shared_by_entries(ray.origin + double{nearest} * ray.direction, slack)) {
        Query query;
        query.skip_back_faces = skip_back_faces;
        query.collect = true;
        RTCRayHit again =
            near_ray(ray, std::max(from, nearest - slack), std::min(to, nearest + slack));
        intersect(handle.scene, query, again);
        const double tie = 1e-9 * slack / 1e-5;
        for (std::size_t i = 0; i < query.count; ++i) {
            const Candidate& c = query.found[i];
            const PlaneHit p = meet(ray, corners(c.entry, c.triangle));
            const bool inside = p.outside > -1e-9, best_inside = plane.outside > -1e-9;
            const bool nearer = p.distance < plane.distance - tie;
            const bool tied = std::abs(p.distance - plane.distance) <= tie;
            const bool earlier =
                std::pair(c.entry, c.triangle) < std::pair(best.entry, best.triangle);
            if (inside == best_inside ? nearer || (tied && earlier) : inside) {
                best = c;
                plane = p;
            }
        }
    }

    Hit hit;
    // Far outside the triangle its plane is no guide, and the distance of Embree is better.
    hit.distance = plane.outside > -1e-3 ? plane.distance : double{nearest};
    hit.p_world = ray.origin + hit.distance * ray.direction;
    const Entry& e = entries[best.entry];
    const glm::uvec3 t = e.mesh->triangles()[best.triangle];
    const auto& p = e.mesh->mesh().positions;
    const glm::dvec3 a(p[t.x]), b(p[t.y]), c(p[t.z]);
    glm::dvec3 n = normal_to_world[best.entry] * glm::cross(b - a, c - a);
    if (!(glm::length(n) > 0)) n = plane.normal;
    hit.normal = glm::length(n) > 0 ? glm::normalize(n) : -ray.direction;
    hit.object = e.object;
    hit.entry = static_cast<int>(best.entry);
    hit.triangle = static_cast<int>(best.triangle);
    hit.face = static_cast<int>(e.mesh->state().face[best.triangle]);
    hit.back_face = glm::dot(hit.normal, ray.direction) > 0;
    return hit;
}

std::optional<Hit> RayScene::hit(const Ray& ray, double from, double to, bool skip_back_faces) const
{
    Query query;
    query.skip_back_faces = skip_back_faces;
    RTCRayHit found = state_->near_ray(ray, from, to);
    intersect(state_->handle.scene, query, found);
    if (found.hit.geomID == RTC_INVALID_GEOMETRY_ID) return {};
    return state_->resolve(ray, from, to, skip_back_faces,
                           {found.hit.instID[0], found.hit.primID, found.ray.tfar}, found.hit.u,
                           found.hit.v);
}

std::vector<std::optional<Hit>> RayScene::hits(std::span<const Ray> rays, bool skip_back_faces,
                                               std::span<const double> to) const
{
    const auto until = [&](std::size_t i) { return to.empty() ? 1e300 : to[i]; };
    constexpr std::size_t wide = 8;
    std::vector<std::optional<Hit>> out(rays.size());
    parallel_blocks(rays.size(), 16 * wide, [&](std::size_t begin, std::size_t end) {
        for (std::size_t first = begin; first < end; first += wide) {
            const std::size_t count = std::min(wide, end - first);
            RTCRayHit8 packet{};
            alignas(32) std::array<int, wide> valid{};
            for (std::size_t i = 0; i < count; ++i) {
                const RTCRayHit one = state_->near_ray(rays[first + i], 0, until(first + i));
                set_lane(packet, i, one);
                valid[i] = -1;
            }
            Query query;
            query.skip_back_faces = skip_back_faces;
            rtcInitIntersectContext(&query.context);
            query.context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
            if (skip_back_faces) query.context.filter = filter;
            rtcIntersect8(valid.data(), state_->handle.scene, &query.context, &packet);
            for (std::size_t i = 0; i < count; ++i) {
                if (packet.hit.geomID[i] == RTC_INVALID_GEOMETRY_ID) continue;
                out[first + i] = state_->resolve(
                    rays[first + i], 0, until(first + i), skip_back_faces,
                    {packet.hit.instID[0][i], packet.hit.primID[i], packet.ray.tfar[i]},
                    packet.hit.u[i], packet.hit.v[i]);
            }
        }
    });
    return out;
}

Box RayScene::bounds() const
{
    return state_->bounds;
}

const std::vector<RayScene::Entry>& RayScene::entries() const
{
    return state_->entries;
}

} // namespace trivar
