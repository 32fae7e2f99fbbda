// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/ffd/overlap.h"

#include "core/base/index.h"
#include "core/ffd/guard.h"
#include "core/ffd/overlap_map.h"

#include <algorithm>
#include <cmath>

namespace trivar {
namespace {

bool meet(const ParameterBox& a, const ParameterBox& b, double slack)
{
    return glm::all(glm::lessThanEqual(a.lo, b.hi + slack)) &&
           glm::all(glm::lessThanEqual(b.lo, a.hi + slack));
}

bool meet(const Box& a, const Box& b)
{
    return glm::all(glm::lessThanEqual(a.lo, b.hi)) && glm::all(glm::lessThanEqual(b.lo, a.hi));
}

// Says whether a plane normal to the direction separates two sets of points.
bool apart(const std::vector<glm::dvec3>& a, const std::vector<glm::dvec3>& b,
           const glm::dvec3& direction)
{
    double a_lo = 1e300, a_hi = -1e300, b_lo = 1e300, b_hi = -1e300;
    for (const glm::dvec3& p : a) {
        a_lo = std::min(a_lo, glm::dot(p, direction));
        a_hi = std::max(a_hi, glm::dot(p, direction));
    }
    for (const glm::dvec3& p : b) {
        b_lo = std::min(b_lo, glm::dot(p, direction));
        b_hi = std::max(b_hi, glm::dot(p, direction));
    }
    const double rounding =
        1e-13 * std::max({std::abs(a_lo), std::abs(a_hi), std::abs(b_lo), std::abs(b_hi)});
    return a_hi + rounding < b_lo || b_hi + rounding < a_lo;
}

// A PieceTree holds pieces of a volume, which are halved on demand.
class PieceTree {
public:
    PieceTree(const UnrolledMap& map, int halvings) : map_(map), halvings_(halvings) {}

    struct Piece {
        ParameterBox box;
        Box bounds;                    // world
        std::vector<glm::dvec3> hull;  // world; empty for many cells
        std::array<int, 2> halves{-1}; // -1: not yet made; -2: small enough
    };
    const Piece& operator[](int i) const { return pieces_[at(i)]; }

    int add(const ParameterBox& box)
    {
        Piece piece{box, map_.bounds(box), map_.hull(box), {-1, -1}};
        // The margin bounds the rounding error.
        const glm::dvec3 slack =
            1e-13 * glm::max(glm::abs(piece.bounds.lo), glm::abs(piece.bounds.hi));
        piece.bounds.lo -= slack;
        piece.bounds.hi += slack;
        pieces_.push_back(std::move(piece));
        return static_cast<int>(pieces_.size()) - 1;
    }
    std::optional<std::array<int, 2>> halves(int i)
    {
        if (pieces_[at(i)].halves[0] == -1) {
            const ParameterBox box = pieces_[at(i)].box;
            std::array<int, 2> made{-2, -2};
            if (const auto cut = map_.cut(box, halvings_)) {
                ParameterBox low = box, high = box;
                low.hi[cut->axis] = high.lo[cut->axis] = cut->t;
                made[0] = add(low);
                made[1] = add(high);
            }
            pieces_[at(i)].halves = made;
        }
        if (pieces_[at(i)].halves[0] < 0) return {};
        return pieces_[at(i)].halves;
    }

private:
    const UnrolledMap& map_;
    int halvings_;
    std::vector<Piece> pieces_;
};

class OverlapSearch {
public:
    OverlapSearch(const UnrolledMap& map, const OverlapOptions& options)
        : map_(map),
          options_(options),
          tree_(map, options.halvings)
    {
    }

    Overlap run(const Progress& progress)
    {
        const ParameterBox domain = map_.domain();
        const int closed = map_.closed(0) + map_.closed(1) + map_.closed(2);
        std::vector<int> roots;
        for (int axis = 0; axis < 3 && closed < 2; ++axis)
            for (const bool high : {false, true})
                if (!map_.closed(axis)) {
                    ParameterBox face = domain;
                    (high ? face.lo : face.hi)[axis] = high ? domain.hi[axis] : domain.lo[axis];
                    roots.push_back(tree_.add(face));
                }
        if (closed >= 2) roots.push_back(tree_.add(domain));
        for (std::size_t i = 0; i < roots.size(); ++i)
            for (std::size_t j = i; j < roots.size(); ++j) open_.push_back({roots[i], roots[j]});

        Overlap out{Verdict::proven_good};
        while (!open_.empty()) {
            const auto [a, b] = open_.back();
            open_.pop_back();
            if (++out.pairs % 256 == 0) report(progress, -1, "overlap");
            if (clear(a, b)) continue;
            if (a != b && find_witness(a, b, out)) return out;
            if (out.pairs >= options_.pairs || !split(a, b)) {
                // Other pairs may still have a witness.
                out.verdict = Verdict::unknown;
                out.one = middle(a);
                out.other = middle(b);
                if (out.pairs >= options_.pairs || ++unclear_ > 2000) return out;
            }
        }
        return out;
    }

private:
    glm::dvec3 middle(int i) const { return (tree_[i].box.lo + tree_[i].box.hi) / 2.0; }

    // Returns the boxes round both pieces, also across seams, in each of which they touch.
    std::vector<ParameterBox> boxes_round(const ParameterBox& a, const ParameterBox& b) const
    {
        std::vector<ParameterBox> out;
        const double slack = 1e-12 * glm::length(map_.domain().hi - map_.domain().lo);
        for (int turns = 0; turns < 27; ++turns) {
            ParameterBox one = a, other = b;
            bool possible = true;
            const std::array<int, 3> turn{turns % 3, turns / 3 % 3, turns / 9};
            for (int axis = 0; axis < 3; ++axis) {
                if (turn[at(axis)] == 0) continue;
                if (!map_.closed(axis)) possible = false;
                (turn[at(axis)] == 1 ? one : other) =
                    map_.turned(turn[at(axis)] == 1 ? one : other, axis);
            }
            if (possible && meet(one, other, slack))
                out.push_back({glm::min(one.lo, other.lo), glm::max(one.hi, other.hi)});
        }
        return out;
    }

    // Says whether it is proven that no point of one piece coincides with a point of the other.
    bool clear(int i, int j) const
    {
        const auto &a = tree_[i], &b = tree_[j];
        if (i != j && !meet(a.bounds, b.bounds)) return true;
        const std::vector<ParameterBox> boxes = boxes_round(a.box, b.box);
        if (!boxes.empty())
            return std::any_of(boxes.begin(), boxes.end(),
                               [&](const ParameterBox& box) { return map_.nearly_affine(box); });
        if (a.hull.empty() || b.hull.empty()) return false;
        const glm::dvec3 between = b.bounds.center() - a.bounds.center();
        if (apart(a.hull, b.hull, between)) return true;
        for (const int piece : {i, j}) {
            const Jet<glm::dvec3> f = map_.jet(middle(piece));
            for (std::size_t axis = 0; axis < 3; ++axis)
                if (apart(a.hull, b.hull, glm::cross(f.first[axis], f.first[(axis + 1) % 3])))
                    return true;
        }
        return map_.nearly_affine({glm::min(a.box.lo, b.box.lo), glm::max(a.box.hi, b.box.hi)});
    }

    // Looks for a witness by Newton's method, from one piece to a point with the same image as the
    // middle of the other.
    bool find_witness(int i, int j, Overlap& out) const
    {
        if (tree_[i].hull.empty() || tree_[j].hull.empty() ||
            !boxes_round(tree_[i].box, tree_[j].box).empty())
            return false;
        return met_from(middle(i), middle(j), out) || met_from(middle(j), middle(i), out) ||
               met_from(inward(i), inward(j), out);
    }
    // Returns a point inside the volume behind a face: faces that coincide may share the space
    // behind them.
    glm::dvec3 inward(int i) const
    {
        glm::dvec3 out = middle(i);
        const ParameterBox &box = tree_[i].box, &all = map_.domain();
        for (int axis = 0; axis < 3; ++axis)
            if (box.lo[axis] == box.hi[axis])
                out[axis] = (out[axis] + (all.lo[axis] + all.hi[axis]) / 2) / 2;
        return out;
    }
    bool met_from(const glm::dvec3& one, glm::dvec3 other, Overlap& out) const
    {
        const glm::dvec3 lo = map_.domain().lo, hi = map_.domain().hi, size = hi - lo,
                         target = map_.jet(one).value;
        const double extent = glm::length(tree_[0].bounds.size());
        for (int round = 0; round < 12; ++round) {
            const Jet<glm::dvec3> f = map_.jet(other);
            const glm::dmat3 j(f.first[0], f.first[1], f.first[2]);
            if (!(std::abs(glm::determinant(j)) > 0)) return false;
            const glm::dvec3 step = glm::inverse(j) * (target - f.value);
            if (glm::distance(f.value, target) < 1e-12 * extent) {
                const glm::dvec3 inside = glm::min(other - lo, hi - other) / size;
                // The point must be inside and differ from the first one; a step this small is only
                // rounding.
                if (!(std::min({inside.x, inside.y, inside.z}) > 1e-6) ||
                    !(glm::length(step / size) < 1e-9) || same(one, other))
                    return false;
                out.verdict = Verdict::proven_bad;
                out.one = one;
                out.other = other;
                return true;
            }
            other += step;
            const glm::dvec3 beyond = glm::max(lo - other, other - hi) / size;
            if (!(std::max({beyond.x, beyond.y, beyond.z}) < 0.1)) return false;
            other = glm::clamp(other, lo, hi);
        }
        return false;
    }
    bool same(const glm::dvec3& one, const glm::dvec3& other) const
    {
        const glm::dvec3 size = map_.domain().hi - map_.domain().lo;
        const ParameterBox round{one - 1e-5 * size, one + 1e-5 * size};
        return !boxes_round(round, {other, other}).empty();
    }

    // Replaces a pair by pairs with the halves of the larger piece; false if both are small enough.
    bool split(int i, int j)
    {
        if (i == j) {
            const auto halves = tree_.halves(i);
            if (!halves) return false;
            const auto [a, b] = *halves;
            open_.insert(open_.end(), {{a, a}, {b, b}, {a, b}});
            return true;
        }
        if (glm::length(tree_[i].bounds.size()) < glm::length(tree_[j].bounds.size()))
            std::swap(i, j);
        auto halves = tree_.halves(i);
        if (!halves) {
            std::swap(i, j);
            halves = tree_.halves(i);
        }
        if (!halves) return false;
        for (const int half : *halves) open_.push_back({half, j});
        return true;
    }

    const UnrolledMap& map_;
    OverlapOptions options_;
    PieceTree tree_;
    std::vector<std::array<int, 2>> open_;
    int unclear_ = 0;
};

} // namespace

Overlap overlap(const Lattice& lattice, const OverlapOptions& options, const Progress& progress)
{
    const auto map = UnrolledMap::of(lattice);
    if (!map) return {};
    Overlap out = OverlapSearch(*map, options).run(progress);
    if (out.verdict == Verdict::proven_good && !judge(lattice).good())
        out.verdict = Verdict::unknown;
    return out;
}

} // namespace trivar
