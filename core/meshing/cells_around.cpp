// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/meshing/cells_around.h"

#include "core/base/finite.h"
#include "core/base/parallel.h"
#include "core/base/rejected.h"
#include "core/meshing/bcc_cells.h"
#include "core/meshing/border_fit.h"
#include "core/meshing/manifold_cells.h"
#include "core/simplex/cell_search.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace trivar {
namespace {

// Vertices of a cell with a point of the model are nearer to it than 0.683 edges in the mean, so
// that cell is chosen. And a face whose corners are that far from a point cannot reach it: the
// middle of an equilateral triangle is 0.577 edges from its corners.
constexpr double least_margin = 0.7; // edges
constexpr double cells_by_default = 2000;
constexpr int pinning_rounds = 4;

using Flags = std::vector<bool>;

class Filler {
public:
    Filler(std::span<const glm::dvec3> positions, std::span<const std::array<int, 3>> triangles,
           const CellFilling& filling)
        : positions_(positions),
          surface_(positions, triangles),
          filling_(filling)
    {
        for (const glm::dvec3& p : positions) model_.add(p);
    }

    FilledCells operator()(double edge)
    {
        bool longer = false;
        const double most = static_cast<double>(filling_.grading.cell_limit);
        for (;; longer = true) {
            // the lattice may have twice as many, for some are not chosen
            double count = bcc_cell_count(ground(edge), edge) / 2;
            if (count <= most) {
                prepare(edge);
                count = static_cast<double>(std::count(chosen_.begin(), chosen_.end(), true));
                if (count <= most) break;
            }
            edge *= 1.02 * std::cbrt(std::max(1.0, count / most));
        }
        FilledCells out = fitted();
        out.edge = edge;
        out.capped = longer || capped_;
        return out;
    }

private:
    // So large that vertices around the border of it are all outside.
    Box ground(double edge) const
    {
        const double wider = filling_.margin + (least_margin + 2) * edge;
        return {model_.lo - wider, model_.hi + wider};
    }

    void prepare(double edge)
    {
        Grading grading = filling_.grading;
        grading.edge = edge;
        grading.cell_limit *= 2;
        GradedCells cells = refined(bcc_cells(ground(edge), edge), grading);
        mesh_ = std::move(cells.mesh);
        capped_ = cells.capped;
        measure();
        choose();
    }

    void measure()
    {
        distance_.assign(mesh_.vertices.size(), 0);
        longest_.assign(mesh_.vertices.size(), 0);
        parallel_blocks(distance_.size(), 1024, [&](std::size_t begin, std::size_t end) {
            for (std::size_t v = begin; v < end; ++v)
                distance_[v] =
                    glm::distance(surface_.nearest(mesh_.vertices[v]), mesh_.vertices[v]);
        });
        for (const auto& cell : mesh_.cells)
            for (const int a : cell)
                for (const int b : cell) {
                    double& longest = longest_[static_cast<std::size_t>(a)];
                    longest = std::max(longest, glm::distance(at(a), at(b)));
                }
        wanted_ = longest_;
        for (double& w : wanted_) w = filling_.margin + least_margin * w;
    }

    const glm::dvec3& at(int v) const { return mesh_.vertices[static_cast<std::size_t>(v)]; }

    // The vertices that can be reached from far away along edges with ends that are not near.
    Flags outside() const
    {
        const auto stars = vertex_stars(mesh_);
        const double away =
            filling_.margin + least_margin * (*std::max_element(longest_.begin(), longest_.end()));
        Flags out(mesh_.vertices.size(), false);
        std::vector<std::size_t> open;
        const auto reach = [&](std::size_t v) {
            if (out[v]) return;
            out[v] = true;
            open.push_back(v);
        };
        for (std::size_t v = 0; v < out.size(); ++v)
            if (model_.distance(mesh_.vertices[v]) > away) reach(v);
        while (!open.empty()) {
            const std::size_t v = open.back();
            open.pop_back();
            for (const int c : stars[v])
                for (const int other : mesh_.cells[static_cast<std::size_t>(c)]) {
                    const auto o = static_cast<std::size_t>(other);
                    if (distance_[o] > wanted_[o]) reach(o);
                }
        }
        return out;
    }

    void choose()
    {
        const Flags out = outside();
        chosen_.assign(mesh_.cells.size(), false);
        for (std::size_t c = 0; c < chosen_.size(); ++c) {
            double sum = 0;
            for (const int corner : mesh_.cells[c]) {
                const auto v = static_cast<std::size_t>(corner);
                const bool enclosed = !out[v] && distance_[v] > wanted_[v];
                sum += enclosed ? -distance_[v] : distance_[v] - wanted_[v];
            }
            chosen_[c] = sum < 0;
        }
        chosen_ = with_manifold_border(mesh_, std::move(chosen_));
    }

    // Where the border was drawn over a vertex of the model, it stays as it was in the lattice.
    FilledCells fitted() const
    {
        std::vector<int> numbers;
        for (std::size_t c = 0; c < chosen_.size(); ++c)
            if (chosen_[c]) numbers.push_back(static_cast<int>(c));
        Flags pinned(mesh_.vertices.size(), false);
        for (int round = 0;; ++round) {
            const SimplexMesh<3> all = with_fitted_border(
                mesh_, chosen_, pinned, {surface_, wanted_, filling_.least_angle});
            FilledCells out{.mesh = part_of(all, numbers), .smooth = smoothness(all)};
            const std::vector<std::size_t> lost = not_held(out.mesh);
            if (lost.empty() || round > pinning_rounds) return out;
            for (std::size_t v = 0; v < pinned.size(); ++v)
                for (const std::size_t p : lost)
                    if (round == pinning_rounds ||
                        glm::distance(positions_[p], mesh_.vertices[v]) < 2 * longest_[v])
                        pinned[v] = true;
        }
    }

    std::vector<std::size_t> not_held(const SimplexMesh<3>& mesh) const
    {
        const CellSearch search(mesh);
        std::vector<unsigned char> held(positions_.size(), 0);
        parallel_blocks(held.size(), 4096, [&](std::size_t begin, std::size_t end) {
            for (std::size_t p = begin; p < end; ++p)
                held[p] = search.cell_at(positions_[p]) >= 0 ? 1 : 0;
        });
        std::vector<std::size_t> out;
        for (std::size_t p = 0; p < held.size(); ++p)
            if (held[p] == 0) out.push_back(p);
        return out;
    }

    double smoothness(const SimplexMesh<3>& all) const
    {
        Flags border(all.vertices.size(), false);
        for (const auto& face : border_faces(all, chosen_))
            for (const int v : face) border[static_cast<std::size_t>(v)] = true;
        double count = 0, smooth = 0;
        for (std::size_t v = 0; v < border.size(); ++v) {
            if (!border[v]) continue;
            const glm::dvec3& x = all.vertices[v];
            ++count;
            if (std::abs(glm::distance(surface_.nearest(x), x) - wanted_[v]) <= 0.05 * longest_[v])
                ++smooth;
        }
        return smooth / count;
    }

    std::span<const glm::dvec3> positions_;
    SurfaceDistance surface_;
    const CellFilling& filling_;
    Box model_;
    SimplexMesh<3> mesh_; // the lattice, where it was
    bool capped_ = false;
    std::vector<double> distance_, longest_, wanted_; // per vertex: from the model, of its edges,
                                                      // and where the border would be
    Flags chosen_;
};

double usual_edge(const Box& box)
{
    const glm::dvec3 size = box.size();
    const double longest = std::max({size.x, size.y, size.z});
    if (longest == 0) return 1;
    double volume = 1;
    for (int i = 0; i < 3; ++i) volume *= std::max(size[i], 0.1 * longest);
    return std::cbrt(12 * volume / cells_by_default);
}

} // namespace

FilledCells cells_around(std::span<const glm::dvec3> positions,
                         std::span<const std::array<int, 3>> triangles, const CellFilling& filling)
{
    if (positions.empty()) throw Rejected("There is no model to put cells around.");
    Box box;
    for (const glm::dvec3& p : positions) {
        if (!finite(p) || glm::length(p) > 1e30)
            throw Rejected("A vertex of the model is not a number, or too far away.");
        box.add(p);
    }
    const int count = static_cast<int>(positions.size());
    for (const auto& t : triangles)
        for (const int v : t)
            if (v < 0 || v >= count)
                throw Rejected(fmt::format("A face names vertex {} of {}.", v, count));
    if (!(filling.margin >= 0 && filling.margin < infinite))
        throw Rejected("The margin around the model must be 0 or more.");
    if (!(filling.least_angle >= 0 && filling.least_angle <= 0.6))
        throw Rejected("The least angle of cells must be 0 to 0.6 radians.");
    const double edge = filling.grading.edge == 0 ? usual_edge(box) : filling.grading.edge;
    if (!(edge > 0 && edge < infinite)) throw Rejected("The length of edges must be more than 0.");
    Grading grading = filling.grading;
    grading.edge = edge;
    check(grading, glm::length(box.size()) * (grading.balls.empty() ? 0 : 1));
    if (filling.grading.cell_limit < 1000)
        throw Rejected("The limit of cells must be 1,000 or more.");
    // loose vertices count as points
    std::vector<std::array<int, 3>> all(triangles.begin(), triangles.end());
    std::vector<bool> used(positions.size(), false);
    for (const auto& t : triangles)
        for (const int v : t) used[static_cast<std::size_t>(v)] = true;
    for (int v = 0; v < count; ++v)
        if (!used[static_cast<std::size_t>(v)]) all.push_back({v, v, v});
    return Filler(positions, all, filling)(edge);
}

} // namespace trivar
