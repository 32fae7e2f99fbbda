// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/recent.h"
#include "core/ffd/packed_volume.h"
#include "gpu/buffer.h"

#include <map>
#include <memory>

namespace trivar::gpu {

// DeviceAxes are the axes of lattices on the device.
struct DeviceAxes {
    PackedAxes packed;
    Buffer cells;
};

// A PointTexture holds control points in a filtered texture; its destructor frees the texture.
class PointTexture {
public:
    // The points are by unwrapped index, w fastest. Throws Rejected where the device's textures are
    // too small.
    PointTexture(const std::vector<glm::vec4>& points, const glm::ivec3& count);
    ~PointTexture();
    PointTexture(const PointTexture&) = delete;
    PointTexture& operator=(const PointTexture&) = delete;
    void bind(unsigned unit) const;

private:
    unsigned name_ = 0;
};

struct DeviceLattice {
    Buffer points;
    std::shared_ptr<const DeviceAxes> axes;
    std::unique_ptr<PointTexture> texture; // made when it is first wanted
};

// A LatticeMirror uploads lattices by Ref identity, as Mirror uploads meshes: a changed lattice
// uploads its control points and, where its knots are new, its axes.
class LatticeMirror {
public:
    const DeviceLattice& lattice(const Ref<Lattice>& lattice); // throws Rejected for orders above 4
    const PointTexture& texture(const Ref<Lattice>& lattice);
    void drop_dead();
    // number of uploads of control points since this was made
    std::size_t uploads() const { return uploads_; }

private:
    struct Entry {
        std::weak_ptr<const Lattice> alive;
        DeviceLattice lattice;
    };
    std::shared_ptr<const DeviceAxes> axes(const std::array<Knots, 3>& knots);
    Entry& entry(const Ref<Lattice>& lattice);
    std::map<const Lattice*, Entry> lattices_;
    // The last few, the newest at the end.
    Recent<std::array<Knots, 3>, std::shared_ptr<const DeviceAxes>> axes_{
        16}; // a document has few kinds
    std::size_t uploads_ = 0;
};

} // namespace trivar::gpu
