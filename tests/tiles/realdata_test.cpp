// SPDX-License-Identifier: GPL-3.0-or-later
// Two ways to lay tiles on the cells of a texture: painted tiles at the centres of cells, as covers
// by texture are, and tiles bent through maps of the texture square.
#include "core/files/read_model.h"
#include "core/tiles/texture_cells.h"
#include "tests/support/fixtures.h"
#include "tests/tiles/bases.h"
#include "tests/tiles/surface_maps.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace trivar::testing {
namespace {

constexpr int layout_columns = 40;

struct Layout {
    std::vector<TilePatch> patches;
    std::vector<char> cut; // whether a seam cuts it
};

// LayoutFlaws counts the flaws of a layout.
struct LayoutFlaws {
    int tiles = 0, cut = 0;
    double bare = 0;      // share of the surface on which no tile is
    double collapsed = 0; // share of points of tiles whose area is below a tenth of what is usual
    double blown_up = 0;  // above four times that
    double median_off = 0, most_off = 0; // distance from the surface, in sides; the worst twentieth
};

double distance_to(const TileBase& base, const glm::dvec3& p)
{
    double least = 1e300;
    for (std::uint32_t t = 0; t < base.triangle_count(); ++t) {
        const auto c = base.corners(t);
        const glm::dvec3 w = base.place(t, p).weights;
        if (std::min({w.x, w.y, w.z}) >= 0)
            least = std::min(least, std::abs(glm::dot(p - c[0], base.face_normal(t))));
        for (std::size_t k = 0; k < 3; ++k) {
            const glm::dvec3 &a = c[k], ab = c[(k + 1) % 3] - a;
            const double along = std::clamp(glm::dot(p - a, ab) / glm::dot(ab, ab), 0.0, 1.0);
            least = std::min(least, glm::distance(p, a + along * ab));
        }
    }
    return least;
}

LayoutFlaws flaws_of(const Layout& layout, const TileBase& base)
{
    LayoutFlaws out;
    out.tiles = static_cast<int>(layout.patches.size());
    out.cut = static_cast<int>(std::ranges::count(layout.cut, 1));
    std::vector<double> areas, off;
    struct Standing {
        glm::dvec3 p, x, y, n;
        double side;
    };
    std::vector<Standing> standing;
    for (const TilePatch& patch : layout.patches) {
        const TilePoint middle = tile_point(patch, {0.5, 0.5, 0});
        const glm::dvec3 n = glm::cross(middle.x, middle.y);
        const double area = glm::length(n), side = std::sqrt(area);
        standing.push_back({middle.p, middle.x / glm::dot(middle.x, middle.x),
                            middle.y / glm::dot(middle.y, middle.y), n / area, side});
        for (int j = 0; j < 5; ++j)
            for (int i = 0; i < 5; ++i) {
                const TilePoint at = tile_point(patch, {0.25 * i, 0.25 * j, 0});
                areas.push_back(glm::length(glm::cross(at.x, at.y)) / area);
                if (i % 2 == 0 && j % 2 == 0) off.push_back(distance_to(base, at.p) / side);
            }
    }
    const auto share = [&](auto test) {
        return double(std::ranges::count_if(areas, test)) / double(areas.size());
    };
    out.collapsed = share([](double a) { return a < 0.1; });
    out.blown_up = share([](double a) { return a > 4; });
    std::ranges::sort(off);
    out.median_off = off[off.size() / 2];
    out.most_off = off[off.size() * 19 / 20];
    std::mt19937 random(7);
    double all = 0, bare = 0;
    for (int k = 0; k < 20'000; ++k) {
        const SurfacePlace at = random_place(base, random);
        const glm::dvec3 p = base.position(at), n = base.normal(at);
        const bool covered = std::ranges::any_of(standing, [&](const Standing& s) {
            const glm::dvec3 d = p - s.p;
            return std::abs(glm::dot(d, s.x)) <= 0.5 && std::abs(glm::dot(d, s.y)) <= 0.5 &&
                   std::abs(glm::dot(d, s.n)) < 0.5 * s.side && glm::dot(n, s.n) > 0;
        });
        all += base.area(at.triangle);
        bare += covered ? 0 : base.area(at.triangle);
    }
    out.bare = bare / all;
    return out;
}

Layout painted_layout(const Mesh& mesh, const TileBase& base)
{
    Layout out;
    const std::optional<TextureSpots> cells =
        texture_spots(mesh, glm::dmat4(1), layout_columns, layout_columns, 100'000);
    for (const TextureSpot& spot : cells->spots) {
        Tile tile;
        tile.at = {spot.triangle, spot.weights};
        const glm::dvec3 n = base.normal(tile.at);
        tile.x = glm::normalize(spot.along_u - glm::dot(spot.along_u, n) * n);
        tile.size = spot.side;
        const TileChart chart = chart_of(base, tile, 0, 1);
        out.patches.push_back(patch_of(base, at_rest(base), chart));
        out.cut.push_back(chart.cut > 0);
    }
    return out;
}

Layout mapped_layout(const Mesh& mesh, int texels, Extension how)
{
    Layout out;
    const SurfaceMaps inside = surface_maps(mesh, texels), maps = extended(inside, how);
    const std::vector<double> shares = valid_shares(inside, layout_columns);
    for (int j = 0; j < layout_columns; ++j)
        for (int i = 0; i < layout_columns; ++i) {
            const double share = shares[std::size_t(j * layout_columns + i)];
            const int x = (2 * i + 1) * texels / (2 * layout_columns),
                      y = (2 * j + 1) * texels / (2 * layout_columns);
            if (share < 0.5 || !inside.inside[std::size_t(y * texels + x)]) continue;
            out.patches.push_back(cell_patch(maps, layout_columns, i, j));
            out.cut.push_back(share < 1);
        }
    return out;
}

void record(const std::string& name, const LayoutFlaws& flaws)
{
    ::testing::Test::RecordProperty(
        name, fmt::format("{} tiles, {} cut, {:.1f} % bare, {:.1f} % collapsed, {:.1f} % blown up, "
                          "off by {:.3f} and {:.3f} sides",
                          flaws.tiles, flaws.cut, 100 * flaws.bare, 100 * flaws.collapsed,
                          100 * flaws.blown_up, flaws.median_off, flaws.most_off));
}

} // namespace

TEST(RealDataTextureLayouts, OfPaintedTilesAreNotCutAndNotCollapsed)
{
    if (real_data_folder().empty()) GTEST_SKIP() << "no folder of real models";
    const Ref<Mesh> mesh = read_model(real_data_folder() + "/meshes/spot.obj").meshes.front();
    const TileBase base = base_of(*mesh);
    const LayoutFlaws painted = flaws_of(painted_layout(*mesh, base), base),
                      first = flaws_of(mapped_layout(*mesh, 256, Extension::first_order), base),
                      nearest = flaws_of(mapped_layout(*mesh, 256, Extension::nearest), base);
    record("painted", painted);
    record("first_order", first);
    record("nearest", nearest);
    EXPECT_EQ(painted.cut, 0);
    EXPECT_GT(first.cut, first.tiles / 10);
    EXPECT_LT(painted.collapsed, 0.1 * first.collapsed);
    EXPECT_LT(first.collapsed, 0.5 * nearest.collapsed);
    EXPECT_LT(painted.bare, 0.2);
    EXPECT_LT(painted.most_off, first.most_off);
}

} // namespace trivar::testing
