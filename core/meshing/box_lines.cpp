// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/meshing/box_lines.h"

#include <array>
#include <cmath>
#include <map>
#include <set>

namespace trivar {
namespace {

constexpr int halvings = 20;
constexpr std::size_t least_squares = 3; // of a line

using Node = std::array<int, 4>; // a place of the grid, and the axis along which its edge goes

struct Joint {
    glm::dvec3 at{0};
    std::vector<Node> next = {}; // on the faces of the box
};

class Lines {
public:
    Lines(const Box& box, const std::function<bool(const glm::dvec3&)>& inside, double spacing)
        : box_(box),
          inside_(inside)
    {
        for (int k = 0; k < 3; ++k)
            count_[k] = std::max(1, static_cast<int>(std::ceil(box.size()[k] / spacing)));
    }

    BoxLines operator()()
    {
        for (int axis = 0; axis < 3; ++axis)
            for (const bool far : {false, true}) march(axis, far ? count_[axis] : 0);
        BoxLines out;
        for (const auto& [node, joint] : joints_)
            if (joint.next.size() == 1 || on_edge(node)) follow(node, out);
        for (const auto& [node, joint] : joints_) follow(node, out);
        for (int axis = 0; axis < 3; ++axis)
            for (const bool u : {false, true})
                for (const bool v : {false, true}) add_edge(axis, u, v, out);
        return out;
    }

private:
    glm::dvec3 place(const glm::ivec3& i) const
    {
        glm::dvec3 out;
        for (int k = 0; k < 3; ++k)
            out[k] =
                i[k] == count_[k] ? box_.hi[k] : box_.lo[k] + box_.size()[k] * i[k] / count_[k];
        return out;
    }
    bool at(const glm::ivec3& i)
    {
        const auto [found, added] = flags_.try_emplace({i.x, i.y, i.z}, false);
        if (added) found->second = inside_(place(i));
        return found->second;
    }

    Node crossing(const glm::ivec3& i, int axis)
    {
        const Node node{i.x, i.y, i.z, axis};
        const auto [found, added] = joints_.try_emplace(node);
        if (!added) return node;
        glm::ivec3 j = i;
        ++j[axis];
        const bool first = at(i);
        glm::dvec3 a = place(i), b = place(j);
        for (int k = 0; k < halvings; ++k) {
            const glm::dvec3 middle = (a + b) / 2.0;
            (inside_(middle) == first ? a : b) = middle;
        }
        found->second.at = (a + b) / 2.0;
        return node;
    }

    void join(const Node& a, const Node& b)
    {
        joints_[a].next.push_back(b);
        joints_[b].next.push_back(a);
    }

    void march(int axis, int layer)
    {
        const int u = (axis + 1) % 3, v = (axis + 2) % 3;
        for (int j = 0; j < count_[v]; ++j)
            for (int i = 0; i < count_[u]; ++i) {
                glm::ivec3 p(0);
                p[axis] = layer, p[u] = i, p[v] = j;
                glm::ivec3 q = p, r = p, s = p; // counterclockwise after p: q, r, s
                ++q[u], ++r[u], ++r[v], ++s[v];
                const std::array<bool, 4> in{at(p), at(q), at(r), at(s)};
                std::vector<Node> around; // one per side of the square that is crossed
                if (in[0] != in[1]) around.push_back(crossing(p, u));
                if (in[1] != in[2]) around.push_back(crossing(q, v));
                if (in[2] != in[3]) around.push_back(crossing(s, u));
                if (in[3] != in[0]) around.push_back(crossing(p, v));
                if (around.size() == 2) join(around[0], around[1]);
                if (around.size() != 4) continue;
                const bool apart = inside_((place(p) + place(r)) / 2.0) != in[0];
                join(around[0], around[apart ? 3 : 1]);
                join(around[2], around[apart ? 1 : 3]);
            }
    }

    bool on_edge(const Node& node) const
    {
        int sides = 0;
        for (int k = 0; k < 3; ++k)
            if (const int i = node[static_cast<std::size_t>(k)];
                k != node[3] && (i == 0 || i == count_[k]))
                ++sides;
        return sides == 2;
    }

    // Follows the lines from a joint along edges that were not followed yet.
    void follow(const Node& start, BoxLines& out)
    {
        for (const Node& first : joints_[start].next) {
            if (!used(start, first)) continue;
            BoxLines::Line line{joints_[start].at, joints_[first].at};
            Node last = start, here = first;
            while (here != start && !on_edge(here)) {
                const auto& next = joints_[here].next;
                if (next.size() != 2) break;
                const Node& on = next[0] == last ? next[1] : next[0];
                used(here, on);
                last = here;
                here = on;
                line.push_back(joints_[here].at);
            }
            if (line.size() <= least_squares) continue;
            for (const Node& end : {start, here})
                if (on_edge(end)) ends_.insert(end);
            out.boundary.push_back(std::move(line));
        }
    }
    // True for the first time.
    bool used(const Node& a, const Node& b) { return used_.insert(std::minmax(a, b)).second; }

    void add_edge(int axis, bool u, bool v, BoxLines& out) const
    {
        const int k = (axis + 1) % 3, l = (axis + 2) % 3;
        glm::ivec3 i(0);
        if (u) i[k] = count_[k];
        if (v) i[l] = count_[l];
        glm::dvec3 from = place(i);
        for (; i[axis] < count_[axis]; ++i[axis])
            if (const Node node{i.x, i.y, i.z, axis}; ends_.contains(node)) {
                const glm::dvec3& to = joints_.at(node).at;
                out.edges.push_back({from, to});
                from = to;
            }
        out.edges.push_back({from, place(i)});
    }

    const Box& box_;
    const std::function<bool(const glm::dvec3&)>& inside_;
    glm::ivec3 count_{0};
    std::map<std::array<int, 3>, bool> flags_;
    std::map<Node, Joint> joints_;
    std::set<std::pair<Node, Node>> used_;
    std::set<Node> ends_; // of lines, on edges of the box
};

} // namespace

BoxLines box_lines(const Box& box, const std::function<bool(const glm::dvec3&)>& inside,
                   double spacing)
{
    return Lines(box, inside, spacing)();
}

} // namespace trivar
