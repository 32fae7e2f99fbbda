// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/gait.h"

#include "core/base/parallel.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <set>

namespace trivar {
namespace {

constexpr std::size_t poses = 96;
constexpr double near_ground = 0.05;   // of the model's height: near the ground
constexpr double foot_size = 0.25;     // of the box's diagonal, from its lowest vertex
constexpr std::size_t followed = 4096; // vertices: more say no more
constexpr std::size_t most_points = 32;
constexpr std::size_t most_feet = 64;

// A vertex that comes near the ground, through the period.
struct Track {
    Foot::Point point;
    std::vector<glm::dvec3> at;
    double lowest = std::numeric_limits<double>::infinity();
};

struct Ground {
    glm::dvec3 up;
    double level = 0, near = 0; // heights
    glm::dvec3 velocity{0};     // of what stands on it, a period
    double height(const glm::dvec3& p) const { return glm::dot(p, up); }
    glm::dvec3 along(const glm::dvec3& p) const { return p - height(p) * up; }
};

double time_of(const Clip& clip, double share)
{
    return clip.begin_s + share * (clip.end_s - clip.begin_s);
}

std::vector<Stance> stances(const Model& model, const Clip& clip)
{
    std::vector<Stance> out(poses);
    parallel_blocks(poses, 4, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            out[i] = stance_at(model, &clip, time_of(clip, static_cast<double>(i) / poses));
    });
    return out;
}

// The lowest height of every vertex of the mesh on a node, in the poses.
std::vector<double> lowest_heights(const Model& model, int node, const std::vector<Stance>& all,
                                   const glm::dvec3& up)
{
    const Mesh& mesh =
        *model.meshes[static_cast<std::size_t>(model.nodes[static_cast<std::size_t>(node)].mesh)];
    constexpr std::size_t block = 8;
    std::vector<std::vector<double>> of_block((all.size() + block - 1) / block);
    parallel_blocks(all.size(), block, [&](std::size_t begin, std::size_t end) {
        std::vector<double>& lowest = of_block[begin / block];
        lowest.assign(mesh.vertex_count(), std::numeric_limits<double>::infinity());
        for (std::size_t i = begin; i < end; ++i) {
            const Pose pose = pose_of(model, node, all[i]);
            const glm::dmat4 to_model = mesh_to_model(model, node, all[i]);
            for (std::size_t v = 0; v < lowest.size(); ++v) {
                const glm::dvec3 p = posed_point(mesh, pose, static_cast<std::uint32_t>(v));
                lowest[v] =
                    std::min(lowest[v], glm::dot(up, glm::dvec3(to_model * glm::dvec4(p, 1))));
            }
        }
    });
    std::vector<double> out = std::move(of_block.front());
    for (const std::vector<double>& other : of_block)
        if (!other.empty())
            for (std::size_t v = 0; v < out.size(); ++v) out[v] = std::min(out[v], other[v]);
    return out;
}

// Those that come near the ground, the lowest first.
std::vector<Track> low_vertices(const Model& model, const std::vector<Stance>& all, Ground& ground,
                                double height)
{
    std::vector<Track> out;
    std::vector<std::pair<int, std::vector<double>>> nodes;
    ground.level = std::numeric_limits<double>::infinity();
    for (std::size_t n = 0; n < model.nodes.size(); ++n) {
        if (model.nodes[n].mesh < 0) continue;
        const int node = static_cast<int>(n);
        nodes.emplace_back(node, lowest_heights(model, node, all, ground.up));
        for (const double each : nodes.back().second) ground.level = std::min(ground.level, each);
    }
    ground.near = near_ground * height;
    for (const auto& [node, lowest] : nodes)
        for (std::size_t v = 0; v < lowest.size(); ++v)
            if (lowest[v] < ground.level + ground.near)
                out.push_back({{node, static_cast<std::uint32_t>(v)}, {}, lowest[v]});
    std::ranges::stable_sort(out, {}, &Track::lowest);
    const std::size_t step = out.size() / followed + 1;
    std::vector<Track> thinned;
    for (std::size_t i = 0; i < out.size(); i += step) thinned.push_back(std::move(out[i]));
    return thinned;
}

glm::dvec3 where(const Model& model, const Foot::Point& point, const Stance& stance,
                 const Pose& pose)
{
    const Mesh& mesh = *model.meshes[static_cast<std::size_t>(
        model.nodes[static_cast<std::size_t>(point.node)].mesh)];
    return glm::dvec3(mesh_to_model(model, point.node, stance) *
                      glm::dvec4(posed_point(mesh, pose, point.vertex), 1));
}

void follow(const Model& model, const std::vector<Stance>& all, std::vector<Track>& tracks)
{
    for (Track& track : tracks) track.at.resize(all.size());
    parallel_blocks(all.size(), 8, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            std::map<int, Pose> known;
            for (Track& track : tracks) {
                const int node = track.point.node;
                if (!known.contains(node)) known[node] = pose_of(model, node, all[i]);
                track.at[i] = where(model, track.point, all[i], known[node]);
            }
        }
    });
}

template <class T> const T& cyclic(const std::vector<T>& values, std::size_t i)
{
    return values[i % values.size()];
}

// A period's way at the speed of that moment.
glm::dvec3 velocity(const std::vector<glm::dvec3>& at, std::size_t i)
{
    return (cyclic(at, i + 1) - cyclic(at, i + at.size() - 1)) * (at.size() / 2.0);
}

double median(std::vector<double> values)
{
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

// What most of the low vertices go with.
glm::dvec3 ground_velocity(const std::vector<Track>& tracks, const Ground& ground)
{
    std::array<std::vector<double>, 3> seen;
    for (const Track& track : tracks)
        for (std::size_t i = 0; i < track.at.size(); ++i) {
            if (ground.height(track.at[i]) > ground.level + ground.near / 2) continue;
            const glm::dvec3 v = ground.along(velocity(track.at, i));
            for (int axis = 0; axis < 3; ++axis)
                seen[static_cast<std::size_t>(axis)].push_back(v[axis]);
        }
    glm::dvec3 out(0);
    for (int axis = 0; axis < 3; ++axis)
        if (auto& values = seen[static_cast<std::size_t>(axis)]; !values.empty())
            out[axis] = median(std::move(values));
    return ground.along(out);
}

// Whether two vertices are of one rigid thing, or nearly, and near each other.
bool together(const Track& a, const Track& b, double size, double stride)
{
    double least = std::numeric_limits<double>::infinity(), most = 0;
    for (std::size_t i = 0; i < a.at.size(); ++i) {
        const double d = glm::distance(a.at[i], b.at[i]);
        least = std::min(least, d);
        most = std::max(most, d);
    }
    return least < size && most - least < stride / 4;
}

// The joint or node that moves a vertex most.
int mover_of(const Model& model, const Foot::Point& point)
{
    const Node& node = model.nodes[static_cast<std::size_t>(point.node)];
    const Mesh& mesh = *model.meshes[static_cast<std::size_t>(node.mesh)];
    if (node.skin < 0 || mesh.influences.empty()) return point.node;
    const Mesh::Influences& by = mesh.influences[point.vertex];
    int most = 0;
    for (int k = 1; k < 4; ++k)
        if (by.weights[k] > by.weights[most]) most = k;
    return model.skins[static_cast<std::size_t>(node.skin)]
        .joints[by.joints[static_cast<std::size_t>(most)]];
}

// The path of a foot: the middle of some of its vertices, and their lowest height.
struct Path {
    std::vector<glm::dvec3> centre;
    std::vector<double> height;
};
Path path_of(const std::vector<const Track*>& tracks, const Ground& ground)
{
    Path out{std::vector<glm::dvec3>(poses, glm::dvec3(0)),
             std::vector<double>(poses, std::numeric_limits<double>::infinity())};
    for (std::size_t i = 0; i < poses; ++i) {
        for (const Track* track : tracks) {
            out.centre[i] += track->at[i];
            out.height[i] = std::min(out.height[i], ground.height(track->at[i]));
        }
        out.centre[i] /= static_cast<double>(tracks.size());
    }
    return out;
}

// Poses from `begin` on, perhaps past the last one.
struct Run {
    std::size_t begin = 0, count = 0;
};

// The longest run in which the foot is low and goes with the ground.
Run stance_of(const Path& path, const Ground& ground)
{
    constexpr double dips = 0.2; // of the time: toes may dip below the ground as they push off
    std::vector<double> heights = path.height;
    const auto level = heights.begin() + static_cast<std::ptrdiff_t>(dips * poses);
    std::nth_element(heights.begin(), level, heights.end());
    const double speed = glm::length(ground.velocity);
    constexpr double along = 0.4; // of the ground's speed
    const auto stands = [&](std::size_t i) {
        const double back = glm::dot(velocity(path.centre, i), ground.velocity) / speed;
        return path.height[i] < *level + ground.near / 2 && back > along * speed;
    };
    Run best;
    for (std::size_t i = 0; i < poses; ++i) {
        std::size_t n = 0;
        while (n < poses && stands((i + n) % poses)) ++n;
        if (n > best.count) best = {i, n};
    }
    return best;
}

// Whether one of two nodes hangs on the other.
bool of_one_limb(const Model& model, int a, int b)
{
    const auto below = [&](int lower, int upper) {
        while (lower > upper) lower = model.nodes[static_cast<std::size_t>(lower)].parent;
        return lower == upper;
    };
    return below(a, b) || below(b, a);
}

struct Cluster {
    std::vector<const Track*> tracks; // the lowest first
    int mover = 0;                    // of the lowest
};

std::vector<Cluster> clusters(const Model& model, const std::vector<Track>& tracks, double size,
                              double stride)
{
    std::vector<Cluster> out;
    for (const Track& track : tracks) {
        const int mover = mover_of(model, track.point);
        const auto found = std::ranges::find_if(out, [&](const Cluster& c) {
            return of_one_limb(model, mover, c.mover) &&
                   together(*c.tracks.front(), track, size, stride);
        });
        if (found != out.end())
            found->tracks.push_back(&track);
        else if (out.size() < most_feet)
            out.push_back({{&track}, mover});
    }
    return out;
}

// What a foot stands on: its vertices that are lowest through the stance.
std::vector<const Track*> sole_of(const std::vector<const Track*>& tracks, const Run& stance,
                                  const Ground& ground)
{
    std::vector<std::pair<double, const Track*>> by_height;
    for (const Track* track : tracks) {
        double sum = 0;
        for (std::size_t i = 0; i < stance.count; ++i)
            sum += ground.height(cyclic(track->at, stance.begin + i));
        by_height.emplace_back(sum / static_cast<double>(stance.count), track);
    }
    std::ranges::stable_sort(by_height, {}, [](const auto& each) { return each.first; });
    std::erase_if(by_height, [top = by_height.front().first + ground.near / 4](const auto& each) {
        return each.first > top;
    });
    const std::size_t step = (by_height.size() + most_points - 1) / most_points;
    std::vector<const Track*> out;
    for (std::size_t i = 0; i < by_height.size(); i += step) out.push_back(by_height[i].second);
    return out;
}

// Without the ends in which the sole is lifted already: more than it rolls in the middle.
Run without_lifted_ends(Run run, const Path& path, const Ground& ground)
{
    std::vector<double> heights, off;
    for (std::size_t i = 0; i < run.count; ++i)
        heights.push_back(ground.height(cyclic(path.centre, run.begin + i)));
    const double level = median(heights);
    for (double& height : heights) off.push_back(height = std::abs(height - level));
    constexpr double flat = 1.0 / 50; // of what is near the ground: a thousandth of the height
    const double most = std::max(flat * ground.near, 2 * median(std::move(off)));
    while (run.count > 0 && heights[run.count - 1] > most) --run.count;
    std::size_t first = 0;
    while (first < run.count && heights[first] > most) ++first;
    return {(run.begin + first) % poses, run.count - first};
}

// A foot in a gait that is not settled yet: as it goes through its stance.
struct Seen {
    Path path;
    Run stance;
    glm::dvec3 velocity{0}; // in the stance, mostly
};

std::optional<Seen> seen_foot(const Cluster& cluster, const Ground& ground,
                              std::vector<const Track*>& sole)
{
    constexpr std::size_t shortest = poses / 24;
    Seen out;
    out.stance = stance_of(path_of(cluster.tracks, ground), ground);
    if (out.stance.count < shortest) return {};
    sole = sole_of(cluster.tracks, out.stance, ground);
    out.path = path_of(sole, ground);
    out.stance = stance_of(out.path, ground);
    if (out.stance.count == 0) return {};
    out.stance = without_lifted_ends(out.stance, out.path, ground);
    if (out.stance.count < shortest || out.stance.count >= poses) return {};
    for (int axis = 0; axis < 3; ++axis) {
        std::vector<double> values;
        for (std::size_t i = 0; i < out.stance.count; ++i)
            values.push_back(ground.along(velocity(out.path.centre, out.stance.begin + i))[axis]);
        out.velocity[axis] = median(std::move(values));
    }
    return out;
}

// Nodes from below the first fork to another foot down to the foot's own.
void find_legs(const Model& model, std::vector<Foot>& feet)
{
    std::vector<std::set<std::size_t>> below(model.nodes.size()); // feet
    for (std::size_t f = 0; f < feet.size(); ++f)
        for (int n = feet[f].node; n >= 0; n = model.nodes[static_cast<std::size_t>(n)].parent)
            below[static_cast<std::size_t>(n)].insert(f);
    for (Foot& foot : feet) {
        for (int n = foot.node; n >= 0; n = model.nodes[static_cast<std::size_t>(n)].parent) {
            if (below[static_cast<std::size_t>(n)].size() > 1) break;
            foot.leg.insert(foot.leg.begin(), n);
        }
    }
}

// Where the foot would have to be: on the mean through its stance.
void settle(Foot& foot, const Seen& seen, const Gait& gait, const Ground& ground)
{
    const std::size_t count = seen.stance.count;
    foot.begin = static_cast<double>(seen.stance.begin) / poses;
    foot.end = foot.begin + static_cast<double>(count - 1) / poses;
    const double length = foot.end - foot.begin;
    const auto lacks = [&](std::size_t i) { // but for the middle
        const double t = length * (static_cast<double>(i) / static_cast<double>(count - 1) - 0.5);
        return ground.along(-t * gait.stride * gait.forward -
                            cyclic(seen.path.centre, seen.stance.begin + i));
    };
    for (std::size_t i = 0; i < count; ++i) foot.middle -= lacks(i) / static_cast<double>(count);
    foot.first = foot.middle + lacks(0);
    foot.last = foot.middle + lacks(count - 1);
}

} // namespace

glm::dvec3 sole_at(const Model& model, const Foot& foot, const Stance& stance)
{
    glm::dvec3 sum(0);
    std::map<int, Pose> known;
    for (const Foot::Point& point : foot.sole) {
        if (!known.contains(point.node)) known[point.node] = pose_of(model, point.node, stance);
        sum += where(model, point, stance, known[point.node]);
    }
    return sum / static_cast<double>(foot.sole.size());
}

Gait gait_of(const Model& model, const Clip& clip, const glm::dvec3& up)
{
    Gait gait;
    gait.begin_s = clip.begin_s;
    gait.period_s = clip.end_s - clip.begin_s;
    gait.up = up;
    gait.trouble = "it moves no foot along the ground";
    if (!(gait.period_s > 0)) {
        gait.trouble = "it has no length";
        return gait;
    }
    const Box box = bounding_box(model, &clip, clip.begin_s);
    if (box.empty()) return gait;
    const double size = glm::length(box.size());
    Ground ground{.up = up};
    const std::vector<Stance> all = stances(model, clip);
    std::vector<Track> tracks =
        low_vertices(model, all, ground, glm::dot(glm::abs(up), box.size()));
    follow(model, all, tracks);
    ground.velocity = ground_velocity(tracks, ground);
    constexpr double least_stride = 1e-3; // of the box's diagonal: less is trembling
    if (glm::length(ground.velocity) < least_stride * size) return gait;

    std::vector<Seen> seen;
    glm::dvec3 way(0);
    double poses_seen = 0;
    for (const Cluster& cluster :
         clusters(model, tracks, foot_size * size, glm::length(ground.velocity))) {
        std::vector<const Track*> sole;
        std::optional<Seen> each = seen_foot(cluster, ground, sole);
        if (!each) continue;
        Foot foot;
        for (const Track* track : sole) foot.sole.push_back(track->point);
        foot.node = cluster.mover;
        gait.feet.push_back(std::move(foot));
        way -= each->velocity * static_cast<double>(each->stance.count);
        poses_seen += static_cast<double>(each->stance.count);
        seen.push_back(std::move(*each));
    }
    if (gait.feet.empty()) return gait;
    gait.stride = glm::length(way) / poses_seen;
    gait.forward = glm::normalize(way);
    gait.trouble.clear();
    find_legs(model, gait.feet);
    for (std::size_t f = 0; f < seen.size(); ++f) settle(gait.feet[f], seen[f], gait, ground);
    return gait;
}

} // namespace trivar
