// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simplex/clouds.h"

#include "core/base/rejected.h"
#include "core/simplex/cell_faces.h"
#include "core/simplex/multi_index.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace trivar {
namespace {

// Knots of a cell keep at least this share of its volume, so that no two clouds come near.
constexpr double least_share = 0.2;
constexpr double least_outside = 0.05; // sine of the angle of a direction to a face on the border

// Numbers that look random, the same on every machine. [Steele et al., SplitMix, 2014]
class Scatter {
public:
    explicit Scatter(std::uint64_t seed) : state_(seed) {}
    double operator()() // in [-1, 1)
    {
        std::uint64_t z = state_ += 0x9e3779b97f4a7c15U;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9U;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebU;
        return static_cast<double>((z ^ (z >> 31)) >> 11) * 0x1p-52 - 1;
    }

private:
    std::uint64_t state_;
};

template <int S> using Vec = glm::vec<S, double>;

template <int S> Vec<S> scattered_direction(Scatter& scatter)
{
    for (;;) {
        Vec<S> d;
        for (int i = 0; i < S; ++i) d[i] = scatter();
        const double length = glm::length(d);
        if (length > 0.1 && length <= 1) return d / length;
    }
}

glm::dvec2 normal_of(const std::array<glm::dvec2, 2>& c)
{
    return glm::normalize(glm::dvec2(c[1].y - c[0].y, c[0].x - c[1].x));
}
glm::dvec3 normal_of(const std::array<glm::dvec3, 3>& c)
{
    return glm::normalize(glm::cross(c[1] - c[0], c[2] - c[0]));
}

// A Star collects the faces at one vertex, as unit normals.
template <int S> struct Star {
    std::vector<Vec<S>> outward; // of the border
    std::vector<Vec<S>> faces;   // of all faces
    std::vector<std::pair<int, Vec<S>>> creases;
    double shortest = 1e300; // edge
    bool on_rim = false;
};

// The part of d that lies in all planes of the orthonormal normals.
template <int S> Vec<S> within(Vec<S> d, const std::vector<Vec<S>>& planes)
{
    for (const Vec<S>& n : planes) d -= n * glm::dot(n, d);
    return d;
}

// Whether a cloud knot lies in the plane of a crease, so that no function has more than `depth`
// such knots, and some have as many: a function may take the first knots of several corners, but
// the second knot of one alone.
bool lies_in(int number, int depth, int degree)
{
    return depth == degree || (number >= 2 && number < 2 + depth);
}

template <int S> std::vector<Vec<S>> planes_of(const Star<S>& star, int number, int degree)
{
    std::vector<Vec<S>> out;
    if (star.on_rim) return out;
    for (const auto& [depth, normal] : star.creases) {
        if (!lies_in(number, depth, degree)) continue;
        const Vec<S> rest = within(normal, out);
        if (glm::length(rest) > 1e-6) out.push_back(glm::normalize(rest));
    }
    return out;
}

// The direction in the planes that goes most to the outside of the worst face; null: none does.
template <int S>
Vec<S> most_outside(const std::vector<Vec<S>>& outward, const std::vector<Vec<S>>& planes)
{
    Vec<S> d(0), best(0);
    for (const Vec<S>& n : outward) d += n;
    d = within(d, planes);
    double best_share = least_outside;
    for (int step = 1; step <= 100; ++step) {
        const double length = glm::length(d);
        if (length < 1e-9)
            d = within(outward.front(), planes);
        else
            d /= length;
        const Vec<S>* worst = &outward.front();
        for (const Vec<S>& n : outward)
            if (glm::dot(n, d) < glm::dot(*worst, d)) worst = &n;
        if (glm::dot(*worst, d) > best_share) {
            best_share = glm::dot(*worst, d);
            best = d;
        }
        d += within(*worst, planes) * (1.0 / step);
    }
    return best;
}

template <int S> double nearest_face(const Vec<S>& d, const Star<S>& star)
{
    double out = 1;
    for (const Vec<S>& n : star.faces) out = std::min(out, std::abs(glm::dot(n, d)));
    return out;
}

// The offset of one cloud knot as a share of the shortest edge.
template <int S>
Vec<S> offset(const Star<S>& star, int number, int degree, double spread, Scatter& scatter)
{
    const std::vector<Vec<S>> planes = planes_of(star, number, degree);
    if (static_cast<int>(planes.size()) >= S) return Vec<S>(0);
    Vec<S> outside(0);
    if (!star.outward.empty()) {
        outside = most_outside(star.outward, planes);
        if (outside == Vec<S>(0)) return outside;
    }
    Vec<S> best(0);
    double best_distance = -1;
    for (int attempt = 0; attempt < 16; ++attempt) {
        Vec<S> d = within(scattered_direction<S>(scatter), planes);
        if (!star.outward.empty()) d = outside + d * 0.5;
        if (glm::length(d) < 1e-3) continue;
        d = glm::normalize(d);
        bool out = true;
        for (const Vec<S>& n : star.outward) out = out && glm::dot(n, d) > least_outside / 2;
        // the nearer to none of the faces, the less steep the functions
        const double distance = planes.empty() ? nearest_face(d, star) : 0;
        if (out && distance > best_distance) {
            best_distance = distance;
            best = d;
        }
    }
    if (best == Vec<S>(0)) best = outside;
    return best * (spread * (0.6 + 0.4 * number / degree));
}

template <int S> class Maker {
public:
    Maker(std::vector<Vec<S>> vertices, std::vector<std::array<int, S + 1>> cells, int degree)
    {
        out_.degree = degree;
        out_.cells = std::move(cells);
        if (degree < 1 || degree > max_simplex_degree) check(out_); // which says so
        for (const Vec<S>& v : vertices)
            for (int j = 0; j <= degree; ++j) out_.knots.push_back(v);
        check(out_);
        faces_ = sorted_faces(out_);
        for (std::size_t f = 0; f + 2 < faces_.size(); ++f)
            if (faces_[f].vertices == faces_[f + 2].vertices)
                throw Rejected("Three cells of the domain share one face.");
    }

    SimplexDomain<S> operator()(const CloudStyle& style, const std::vector<Crease<S>>& creases,
                                const std::vector<CloudShift<S>>& shifts)
    {
        stars_.resize(out_.vertex_count());
        look_at_faces(creases);
        for (const auto& cell : out_.cells)
            for (const int a : cell)
                for (const int b : cell)
                    if (a != b)
                        star(a).shortest = std::min(star(a).shortest,
                                                    glm::distance(out_.vertex(a), out_.vertex(b)));
        scale_.assign(stars_.size(), 1);
        for (std::size_t v = 0; v < stars_.size(); ++v) {
            if (style.border == CloudBorder::free) stars_[v].outward.clear();
            Scatter scatter(v);
            for (int j = 1; j <= out_.degree; ++j)
                offsets_.push_back(style.border == CloudBorder::stacked &&
                                           !stars_[v].outward.empty()
                                       ? Vec<S>(0)
                                       : offset(stars_[v], j, out_.degree, style.spread, scatter) *
                                             stars_[v].shortest);
        }
        put_knots();
        // 0.7^40: nothing is left
        for (int round = 0; round < 40 && draw_nearer(); ++round) put_knots();
        for (const CloudShift<S>& each : shifts) shift(each);
        if (!shifts.empty()) check(out_);
        return std::move(out_);
    }

private:
    Star<S>& star(int vertex) { return stars_[static_cast<std::size_t>(vertex)]; }

    void look_at_faces(const std::vector<Crease<S>>& creases)
    {
        std::map<std::array<int, S>, Crease<S>> creased;
        for (Crease<S> crease : creases) {
            std::sort(crease.face.begin(), crease.face.end());
            crease.depth = std::clamp(crease.depth, 0, out_.degree);
            creased[crease.face] = crease;
        }
        std::map<std::array<int, S - 1>, int> around; // creased faces at an edge or vertex
        std::vector<std::array<int, S - 1>> border;   // such edges or vertices, sorted
        for (std::size_t f = 0; f < faces_.size(); ++f) {
            const CellFace<S>& face = faces_[f];
            const bool inner = f + 1 < faces_.size() && faces_[f + 1].vertices == face.vertices;
            std::array<Vec<S>, S> at;
            for (std::size_t i = 0; i < S; ++i) at[i] = out_.vertex(face.vertices[i]);
            Vec<S> normal = normal_of(at);
            const Vec<S> off = out_.vertex(out_.cells[face.cell][face.opposite]) - at[0];
            if (glm::dot(normal, off) > 0) normal = -normal;
            const auto found = creased.find(face.vertices);
            const int depth = inner && found != creased.end() ? found->second.depth : 0;
            for (const int v : face.vertices) {
                star(v).faces.push_back(normal);
                if (!inner) star(v).outward.push_back(normal);
                if (depth > 0) star(v).creases.push_back({depth, normal});
            }
            for (std::size_t left_out = 0; left_out < S; ++left_out) {
                std::array<int, S - 1> part;
                for (std::size_t i = 0, n = 0; i < S; ++i)
                    if (i != left_out) part[n++] = face.vertices[i];
                if (depth > 0) ++around[part];
                if (!inner) border.push_back(part);
            }
            if (depth == out_.degree)
                (found->second.seam ? out_.seams : out_.cuts).push_back(face.vertices);
            if (inner) ++f;
        }
        std::sort(border.begin(), border.end());
        for (const auto& [part, count] : around)
            if (count % 2 == 1 && !std::binary_search(border.begin(), border.end(), part))
                for (const int v : part) star(v).on_rim = true;
    }

    void put_knots()
    {
        const int n = out_.degree;
        for (std::size_t v = 0; v < stars_.size(); ++v)
            for (int j = 1; j <= n; ++j)
                out_.knots[v * static_cast<std::size_t>(n + 1) + static_cast<std::size_t>(j)] =
                    out_.vertex(static_cast<int>(v)) +
                    offsets_[v * static_cast<std::size_t>(n) + static_cast<std::size_t>(j - 1)] *
                        scale_[v];
    }

    void shift(const CloudShift<S>& by)
    {
        const int n = out_.degree;
        if (by.vertex < 0 || by.vertex >= static_cast<int>(stars_.size())) return;
        const Vec<S>& vertex = out_.vertex(by.vertex);
        for (int j = 1; j <= n; ++j) {
            if (by.knot != 0 && by.knot != j) continue;
            Vec<S>& knot = out_.knots[static_cast<std::size_t>(by.vertex * (n + 1) + j)];
            const std::vector<Vec<S>> planes = planes_of(star(by.vertex), j, n);
            if (planes.size() >= static_cast<std::size_t>(S)) continue;
            knot += within(by.factor * (knot - vertex) + by.by - (knot - vertex), planes);
        }
    }

    bool draw_nearer() // returns whether a cloud moved
    {
        std::vector<bool> nearer(stars_.size(), false);
        bool any = false;
        for (std::size_t c = 0; c < out_.cells.size(); ++c) {
            const double whole = orientation(corners(out_, c));
            for (const MultiIndex<S>& index : multi_indices<S>(out_.degree)) {
                auto x = corners(out_, c);
                for (std::size_t k = 0; k < x.size(); ++k)
                    x[k] = out_.knot(out_.cells[c][k], index[k]);
                if (orientation(x) >= least_share * whole) continue;
                for (const int v : out_.cells[c]) nearer[static_cast<std::size_t>(v)] = true;
                any = true;
            }
        }
        for (std::size_t v = 0; v < nearer.size(); ++v)
            if (nearer[v]) scale_[v] *= 0.7;
        return any;
    }

    SimplexDomain<S> out_;
    std::vector<CellFace<S>> faces_;
    std::vector<Star<S>> stars_;
    std::vector<Vec<S>> offsets_; // degree per vertex
    std::vector<double> scale_;   // per vertex
};

} // namespace

template <int S>
SimplexDomain<S> with_clouds(std::vector<glm::vec<S, double>> vertices,
                             std::vector<std::array<int, S + 1>> cells, int degree,
                             const CloudStyle& style, const std::vector<Crease<S>>& creases,
                             const std::vector<CloudShift<S>>& shifts)
{
    return Maker<S>(std::move(vertices), std::move(cells), degree)(style, creases, shifts);
}

template SimplexDomain<2> with_clouds(std::vector<glm::dvec2>, std::vector<std::array<int, 3>>, int,
                                      const CloudStyle&, const std::vector<Crease<2>>&,
                                      const std::vector<CloudShift<2>>&);
template SimplexDomain<3> with_clouds(std::vector<glm::dvec3>, std::vector<std::array<int, 4>>, int,
                                      const CloudStyle&, const std::vector<Crease<3>>&,
                                      const std::vector<CloudShift<3>>&);

} // namespace trivar
