// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/placement/surface_table.h"
#include "core/placement/view.h"

#include <optional>
#include <vector>

namespace trivar {

// A StripIndex finds, for a pixel position, the parameters of the contact surface seen there. The
// surface is cut into steps x steps quads, which a grid of buckets finds.
class StripIndex {
public:
    StripIndex(const SurfaceTable& surface, const View& view, glm::ivec2 steps);

    // False only where the strip certainly is not; for a rectangle, where it meets no bucket of the
    // strip.
    bool may_cover(glm::dvec2 p_px) const;
    bool may_touch(glm::dvec2 lo_px, glm::dvec2 hi_px) const { return meets(begin_, lo_px, hi_px); }

    // Surroundings are the strip and everything within `px` pixels of it; the index must outlive
    // them.
    class Surroundings {
    public:
        Surroundings(const StripIndex& strip, double px);
        // False only where the strip certainly is further away than that.
        bool may_touch(glm::dvec2 lo_px, glm::dvec2 hi_px) const;

    private:
        const StripIndex& strip_;
        double px_;
        std::vector<int> near_; // number of buckets before each
    };

    // Marks the corners of quads (steps + 1 along each axis, v fastest) at which the surface has
    // changed; changed() then tells whether a rectangle meets a change. Before the first call
    // everything has changed.
    void mark_changed(const std::vector<char>& corners);
    bool changed(glm::dvec2 lo_px, glm::dvec2 hi_px) const
    {
        if (changed_.empty()) return may_touch(lo_px, hi_px);
        // Usually little has changed, and all of it in one place.
        return lo_px.x <= changed_hi_.x && lo_px.y <= changed_hi_.y && hi_px.x >= changed_lo_.x &&
               hi_px.y >= changed_lo_.y && meets(changed_, lo_px, hi_px);
    }

    // A Bend says how much the surface bends between the parameters: the largest second derivatives
    // of its distance in front, in metres along the line of sight, per quad along u and along v,
    // and the least and the largest mixed one. `quad_px2` is the squared length of the shortest
    // quad in the picture.
    struct Bend {
        glm::dvec2 along{-1e300}, mixed{1e300, -1e300}, quad_px2{1e300};

        void add(const Bend& other)
        {
            along = glm::max(along, other.along);
            mixed = {std::min(mixed.x, other.mixed.x), std::max(mixed.y, other.mixed.y)};
            quad_px2 = glm::min(quad_px2, other.quad_px2);
        }
        // The second derivative along a chord, which is given in quads. At the chord's middle the
        // surface is behind the chord by an eighth of it.
        double across(glm::dvec2 chord) const
        {
            const double twist = chord.x * chord.y;
            return along.x * chord.x * chord.x + along.y * chord.y * chord.y +
                   2 * twist * (twist > 0 ? mixed.y : mixed.x);
        }
    };
    Bend bend(glm::dvec2 lo, glm::dvec2 hi) const;
    const glm::ivec2& steps() const { return steps_; }

    // Calls visit(uv) for parameters near which the strip is seen at the pixel: several where the
    // strip crosses itself, and two on the line between two quads. Pixels outside of the rim by up
    // to the size of a quad are found too.
    template <class Visit> void find(glm::dvec2 p_px, const Visit& visit) const
    {
        if (!may_cover(p_px)) return;
        const std::size_t b = bucket(p_px);
        if (plain_[b] >= 0) {
            visit(along_quad(plain_[b], p_px));
            return;
        }
        for (int e = begin_[b]; e < begin_[b + 1]; ++e)
            if (const auto uv = in_quad(quads_[static_cast<std::size_t>(e)], p_px)) visit(*uv);
    }

    // The typical size of a quad, pixels.
    double quad_px() const { return quad_px_; }

private:
    bool meets(const std::vector<int>& before, glm::dvec2 lo_px, glm::dvec2 hi_px) const;
    void widen_rim();
    std::size_t bucket(glm::dvec2 p_px) const;
    std::optional<glm::dvec2> in_quad(int first_corner, glm::dvec2 p_px) const;
    glm::dvec2 along_quad(int first_corner, glm::dvec2 p_px) const;
    struct SeenQuad;
    int plain_quad(std::size_t bucket, const std::vector<SeenQuad>& quads) const;

    glm::ivec2 steps_;
    std::vector<glm::dvec2> corners_px_; // (steps.x + 1) x (steps.y + 1)
    glm::dvec2 lo_, hi_;
    double quad_px_ = 1;
    glm::ivec2 buckets_{1};
    glm::dvec2 buckets_per_px_{1};
    std::vector<int> begin_, quads_; // for each bucket: the first corners of its quads
    std::vector<int> changed_;       // number of changed buckets before each
    glm::dvec2 changed_lo_{1e300}, changed_hi_{-1e300}; // round all changed corners
    std::vector<Bend> bend_; // the largest of each quad, by its first corner
    Bend most_bend_;         // the largest of all quads
    // The first corner of the quad nearest to a bucket's middle, if a few neighbouring quads lie
    // side by side in that bucket; -1 for all other buckets.
    std::vector<int> plain_;
};

} // namespace trivar
