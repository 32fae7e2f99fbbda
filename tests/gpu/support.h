// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/primitives.h"
#include "gpu/context.h"
#include "gpu/renderer.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>
#include <string>

namespace trivar::gpu::testing {

// A context for every test of a suite, whose debug output fails the test it comes in.
class WithContext : public ::testing::Test {
protected:
    WithContext();
    ~WithContext() override;

private:
    HeadlessContext context_;
};

// Looks along +Y at the origin: x to the right, z up, 6 m from the top of the picture to its
// bottom. Nothing is behind what a test draws.
inline void look_along_y(Picture& picture)
{
    picture.camera.eye = {0, -10, 0};
    picture.camera.target = {0, 0, 0};
    picture.camera.perspective = false;
    picture.camera.height_world = 6;
    picture.settings.ground = false;
    picture.backdrop = Backdrop{};
}

inline Instance instance_of(Mesh mesh, const glm::dmat4& to_world = glm::dmat4(1),
                            Material material = {})
{
    Instance instance;
    instance.mesh = make_ref(std::move(mesh));
    instance.to_world = to_world;
    instance.materials = make_ref(std::vector<Material>{std::move(material)});
    return instance;
}

inline glm::dmat4 moved(double x, double y, double z)
{
    return glm::translate(glm::dmat4(1), glm::dvec3(x, y, z));
}

inline glm::ivec3 rgb_at(const Image& image, glm::ivec2 p_px)
{
    const std::size_t at = 4 * (static_cast<std::size_t>(p_px.y) * image.size_px.x + p_px.x);
    return {image.rgba[at], image.rgba[at + 1], image.rgba[at + 2]};
}

} // namespace trivar::gpu::testing
