// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/camera.h"
#include "core/base/ref.h"
#include "core/mesh/mesh.h"

#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace trivar {

// A RayMesh is one mesh made ready for rays: a bounding-volume hierarchy over its triangles, in
// object space. Building costs about 0.4 microseconds per triangle; all scenes that hold the mesh
// share it.
class RayMesh {
public:
    explicit RayMesh(Ref<Mesh> mesh);
    ~RayMesh();
    RayMesh(const RayMesh&) = delete;
    RayMesh& operator=(const RayMesh&) = delete;

    const Mesh& mesh() const;
    const std::vector<glm::uvec3>& triangles() const; // #T by 3 vertex indices
    // Boxes round `block` consecutive triangles each: most meshes keep neighbours together.
    static constexpr std::size_t block = 64;
    const std::vector<Box>& block_boxes() const;

    struct State;
    const State& state() const { return *state_; }

private:
    std::unique_ptr<State> state_;
};

struct Hit {
    double distance = 0; // along the ray, world units
    glm::dvec3 p_world{0};
    glm::dvec3 normal{0, 0, 1}; // unit, of the triangle, world space, toward the outside
    int object = -1;            // the id given with the mesh
    int entry = -1;             // of the scene, of which it is
    int face = -1;              // index of the mesh's face
    int triangle = -1;          // of the RayMesh's
    bool back_face = false;     // the ray came from inside
};

// A RayScene is the scene as rays see it. No ray slips through a shared edge. The hit is computed
// again in double precision; where several triangles meet in the hit, the first entry and the first
// face win.
class RayScene {
public:
    struct Entry {
        Ref<RayMesh> mesh;
        glm::dmat4 to_world{1};
        int object = -1;
    };
    // Throws Rejected for a matrix that is not finite.
    explicit RayScene(std::vector<Entry> entries);
    ~RayScene();
    RayScene(RayScene&&) noexcept;
    RayScene& operator=(RayScene&&) noexcept;

    // The nearest hit between the two distances. Thread-safe. About 0.6 microseconds.
    std::optional<Hit> hit(const Ray& ray, double from = 0, double to = 1e300,
                           bool skip_back_faces = false) const;
    // The same for many rays, in parallel; `to` may give each ray a distance of its own. A short
    // ray that meets nothing costs a fifth of the others.
    std::vector<std::optional<Hit>> hits(std::span<const Ray> rays, bool skip_back_faces = false,
                                         std::span<const double> to = {}) const;
    Box bounds() const; // world; a little larger than the scene where an object is turned
    const std::vector<Entry>& entries() const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace trivar
