// SPDX-License-Identifier: GPL-3.0-or-later
#include "gpu/ffd/lattice_mirror.h"

#include "core/base/rejected.h"

#include <algorithm>
#include <epoxy/gl.h>

namespace trivar::gpu {

PointTexture::PointTexture(const std::vector<glm::vec4>& points, const glm::ivec3& count)
{
    GLint most = 0;
    glGetIntegerv(GL_MAX_3D_TEXTURE_SIZE, &most);
    if (std::max({count.x, count.y, count.z}) > most)
        throw Rejected("The lattice is larger than the textures of this graphics card.");
    glGenTextures(1, &name_);
    glBindTexture(GL_TEXTURE_3D, name_);
    glTexStorage3D(GL_TEXTURE_3D, 1, GL_RGBA32F, count.z, count.y, count.x);
    glTexSubImage3D(GL_TEXTURE_3D, 0, 0, 0, 0, count.z, count.y, count.x, GL_RGBA, GL_FLOAT,
                    points.data());
    glTexParameteri(GL_TEXTURE_3D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_3D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    for (const GLenum edge : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R})
        glTexParameteri(GL_TEXTURE_3D, edge, GL_CLAMP_TO_EDGE);
    glBindTexture(GL_TEXTURE_3D, 0);
}

PointTexture::~PointTexture()
{
    glDeleteTextures(1, &name_);
}

void PointTexture::bind(unsigned unit) const
{
    glActiveTexture(GL_TEXTURE0 + unit);
    glBindTexture(GL_TEXTURE_3D, name_);
}

std::shared_ptr<const DeviceAxes> LatticeMirror::axes(const std::array<Knots, 3>& knots)
{
    return axes_(knots, [&] {
        auto made = std::make_shared<DeviceAxes>();
        made->packed = packed_axes(knots);
        made->cells.write(std::as_bytes(std::span(made->packed.cells)));
        return std::shared_ptr<const DeviceAxes>(std::move(made));
    });
}

LatticeMirror::Entry& LatticeMirror::entry(const Ref<Lattice>& lattice)
{
    Entry& found = lattices_[lattice.get()];
    // A dead lattice's address may have been taken by another one.
    if (found.alive.lock() != lattice) {
        found = {};
        found.lattice.axes = axes(lattice->displacement.axes);
        const std::vector<glm::vec4> points = packed_points(lattice->displacement);
        found.lattice.points.write(std::as_bytes(std::span(points)));
        found.alive = lattice;
        ++uploads_;
    }
    return found;
}

const DeviceLattice& LatticeMirror::lattice(const Ref<Lattice>& lattice)
{
    return entry(lattice).lattice;
}

const PointTexture& LatticeMirror::texture(const Ref<Lattice>& lattice)
{
    Entry& found = entry(lattice);
    if (!found.lattice.texture) {
        const std::array<Knots, 3>& axes = lattice->displacement.axes;
        found.lattice.texture = std::make_unique<PointTexture>(
            packed_points(lattice->displacement),
            glm::ivec3(axes[0].unwrapped_count(), axes[1].unwrapped_count(),
                       axes[2].unwrapped_count()));
    }
    return *found.lattice.texture;
}

void LatticeMirror::drop_dead()
{
    std::erase_if(lattices_, [](const auto& item) { return item.second.alive.expired(); });
}

} // namespace trivar::gpu
