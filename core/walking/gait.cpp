// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/walking/gait.h"

#include "core/base/parallel.h"
#include "core/base/smooth_step.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <set>

namespace trivar {
namespace {

constexpr std::size_t poses = 96;
constexpr double near_ground = 0.05; // relative to the height of the model
constexpr double foot_size = 0.25;   // relative to the diagonal of the box, from the lowest vertex
constexpr std::size_t followed = 4096; // vertices; more do not help
constexpr std::size_t most_points = 32;
constexpr std::size_t most_feet = 64;

// A Track follows a vertex that comes near the ground, through the period.
struct Track {
    ModelVertex vertex;
    std::vector<glm::dvec3> at;
};

struct Ground {
    glm::dvec3 up;
    double level = 0, near = 0; // heights
    glm::dvec3 velocity{0};     // of the ground relative to the model, per period
    double height(const glm::dvec3& p) const { return glm::dot(p, up); }
    glm::dvec3 along(const glm::dvec3& p) const { return p - height(p) * up; }
};

std::vector<Stance> stances(const Model& model, const Clip& clip)
{
    const std::vector<double> moments = moments_of(clip);
    std::vector<Stance> out(poses);
    parallel_blocks(poses, 4, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) out[i] = stance_at(model, &clip, moments[i]);
    });
    return out;
}

std::vector<Track> tracks_of(const Model& model, const std::vector<Stance>& all,
                             const std::vector<ModelVertex>& vertices)
{
    std::vector<Track> out;
    for (const ModelVertex& each : vertices)
        out.push_back({each, std::vector<glm::dvec3>(all.size())});
    parallel_blocks(all.size(), 8, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const std::vector<glm::dvec3> now = positions_of(model, vertices, all[i]);
            for (std::size_t v = 0; v < now.size(); ++v) out[v].at[i] = now[v];
        }
    });
    return out;
}

template <class T> const T& cyclic(const std::vector<T>& values, std::size_t i)
{
    return values[i % values.size()];
}

// Returns the velocity at a moment, as the distance per period.
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

// Finds the velocity of most of the low vertices.
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

// Says whether two vertices move rigidly together, or nearly, and are near each other.
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

// A Path is the way of a foot: its lowest height in each pose, and the step to the next pose of the
// vertices that touch the ground, or would if the foot were lower. While a sole rolls these are
// first its heel and last its toes.
struct Path {
    std::vector<double> height;
    std::vector<glm::dvec3> step;
};
Path path_of(const std::vector<const Track*>& tracks, const Ground& ground)
{
    constexpr double thick = 1.0 / 25; // relative to the height that counts as near the ground
    Path out{std::vector<double>(poses, std::numeric_limits<double>::infinity()),
             std::vector<glm::dvec3>(poses, glm::dvec3(0))};
    for (std::size_t i = 0; i < poses; ++i)
        for (const Track* track : tracks)
            out.height[i] = std::min(out.height[i], ground.height(track->at[i]));
    for (std::size_t i = 0; i < poses; ++i) {
        double sum = 0;
        const auto touches = [&](const Track& track, std::size_t pose) {
            const double over = ground.height(track.at[pose]) - out.height[pose];
            return std::max(0.0, 1 - over / (thick * ground.near));
        };
        const std::size_t next = (i + 1) % poses;
        for (const Track* track : tracks) {
            const double share = touches(*track, i) + touches(*track, next);
            sum += share;
            out.step[i] += share * ground.along(track->at[next] - track->at[i]);
        }
        out.step[i] /= sum;
    }
    return out;
}

// A Run is a range of poses, which may continue past the last one.
struct Run {
    std::size_t begin = 0, count = 0;
};

// Finds the longest run in which the foot is near the ground and moves with it; short interruptions
// count, if the foot stays near.
Run stance_of(const Path& path, const Ground& ground)
{
    constexpr double dips = 0.2; // of the period: toes dip below the ground as they push off
    std::vector<double> heights = path.height;
    const auto level = heights.begin() + static_cast<std::ptrdiff_t>(dips * poses);
    std::nth_element(heights.begin(), level, heights.end());
    const double speed = glm::length(ground.velocity);
    constexpr double along = 0.4; // relative to the speed of the ground
    constexpr std::size_t short_while = poses / 8;
    const auto low = [&](std::size_t i) {
        return path.height[i % poses] < std::max(*level, ground.level) + 0.75 * ground.near;
    };
    const auto near = [&](std::size_t i) { return low(i) && low(i + 1); };
    const auto goes = [&](std::size_t i) { // from this pose to the next
        return near(i) &&
               glm::dot(path.step[i % poses], ground.velocity) * poses > along * speed * speed;
    };
    Run best;
    for (std::size_t i = 0; i < poses; ++i) {
        std::size_t n = 0;
        for (std::size_t k = 0; k < poses && near(i + k) && k - n <= short_while; ++k)
            if (goes(i + k)) n = k + 1;
        if (goes(i) && n + 1 > best.count) best = {i, n + 1};
    }
    return best;
}

// Says whether one of two nodes is an ancestor of the other.
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
        const int mover = mover_of(model, track.vertex);
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

// Finds the sole of a foot: its lowest vertices during the stance.
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

// Removes the ends of a run in which the foot is lifted more than it rises in the middle.
Run without_lifted_ends(Run run, const Path& path, const Ground& ground)
{
    std::vector<double> heights, off;
    for (std::size_t i = 0; i < run.count; ++i)
        heights.push_back(std::max(cyclic(path.height, run.begin + i), ground.level));
    const double level = median(heights);
    for (double& height : heights) off.push_back(height = std::abs(height - level));
    constexpr double flat = 1.0 / 50; // of the height that counts as near the ground
    const double most = std::max(flat * ground.near, 2 * median(std::move(off)));
    while (run.count > 0 && heights[run.count - 1] > most) --run.count;
    std::size_t first = 0;
    while (first < run.count && heights[first] > most) ++first;
    return {(run.begin + first) % poses, run.count - first};
}

// A SeenFoot is a foot as the clip has it, before it is locked: its path and its stance.
struct SeenFoot {
    Path path;
    Run stance;
    glm::dvec3 velocity{0}; // median over the stance
};

std::optional<SeenFoot> seen_foot(const Cluster& cluster, const Ground& ground)
{
    constexpr std::size_t shortest = poses / 24;
    SeenFoot out;
    out.path = path_of(cluster.tracks, ground);
    out.stance = stance_of(out.path, ground);
    if (out.stance.count == 0) return {};
    out.stance = without_lifted_ends(out.stance, out.path, ground);
    if (out.stance.count < shortest || out.stance.count >= poses) return {};
    for (int axis = 0; axis < 3; ++axis) {
        std::vector<double> values;
        for (std::size_t i = 0; i + 1 < out.stance.count; ++i)
            values.push_back(cyclic(out.path.step, out.stance.begin + i)[axis] * poses);
        out.velocity[axis] = median(std::move(values));
    }
    return out;
}

// Lists the leg of each foot: from the node below the last fork to another foot down to the node of
// the foot.
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

// Computes the shift of a foot. In the stance the part that touches the ground moves with it, by
// the least shift. In the air the shift fades from one stance to the next, with the velocities of
// both ends. The foot is lifted so that it does not sink into the ground, and in the air soon well
// above it.
void settle(Foot& foot, const SeenFoot& seen, const Gait& gait, const Ground& ground)
{
    constexpr double soon = poses / 16.0; // steps
    constexpr double clear = 1.0 / 4;     // of the height that counts as near the ground
    const std::size_t steps = seen.stance.count - 1;
    foot.begin = static_cast<double>(seen.stance.begin) / poses;
    foot.end = foot.begin + static_cast<double>(steps) / poses;
    const auto lacks = [&](std::size_t i) {
        return -gait.stride / poses * gait.forward - cyclic(seen.path.step, seen.stance.begin + i);
    };
    foot.shift.assign(poses, glm::dvec3(0));
    glm::dvec3 mean(0);
    for (std::size_t i = 1; i <= steps; ++i) {
        foot.shift[i] = foot.shift[i - 1] + lacks(i - 1);
        mean += foot.shift[i] / static_cast<double>(steps + 1);
    }
    for (std::size_t i = 0; i <= steps; ++i) foot.shift[i] -= mean;
    for (std::size_t i = 0; i < poses; ++i) {
        double least = ground.level;
        if (i > steps) {
            const double since = static_cast<double>(i - steps),
                         until = static_cast<double>(poses - i);
            const double x = since / (since + until);
            const auto left = [&](double n) { return std::pow(std::max(0.0, 1 - n / soon), 2); };
            foot.shift[i] = glm::mix(foot.shift[steps], foot.shift[0], smooth_step(x)) +
                            since * left(since) * lacks(steps - 1) - until * left(until) * lacks(0);
            least += (1 - left(std::min(since, until))) * clear * ground.near;
        }
        foot.shift[i] +=
            std::max(0.0, least - cyclic(seen.path.height, seen.stance.begin + i)) * ground.up;
    }
}

// Returns the direction of a way, snapped to an axis of the model if it is nearly along one: models
// are built along axes, and lie along a stroke by them.
glm::dvec3 direction_of(const glm::dvec3& way, const glm::dvec3& up)
{
    constexpr double off_deg = 3, level = 1e-9;
    const glm::dvec3 out = glm::normalize(way);
    for (int axis = 0; axis < 3; ++axis) {
        glm::dvec3 along(0);
        along[axis] = out[axis] < 0 ? -1 : 1;
        if (std::abs(up[axis]) < level && out[axis] * along[axis] > std::cos(glm::radians(off_deg)))
            return along;
    }
    return out;
}

} // namespace

std::vector<double> moments_of(const Clip& clip)
{
    std::vector<double> out;
    for (std::size_t i = 0; i < poses; ++i)
        out.push_back(clip.begin_s + static_cast<double>(i) / poses * (clip.end_s - clip.begin_s));
    return out;
}

Gait gait_of(const Model& model, const Clip& clip, const glm::dvec3& up, double floor)
{
    Gait gait;
    gait.begin_s = clip.begin_s;
    gait.period_s = clip.end_s - clip.begin_s;
    gait.up = up;
    gait.trouble = "moves no foot along the ground";
    if (!(gait.period_s > 0)) {
        gait.trouble = "lasts no time";
        return gait;
    }
    const Box box = bounding_box(model, &clip, clip.begin_s);
    if (box.empty()) return gait;
    const double size = glm::length(box.size());
    Ground ground{.up = up, .near = near_ground * glm::dot(glm::abs(up), box.size())};
    const std::vector<Stance> all = stances(model, clip);
    const LowVertices low = low_vertices(model, all, up, ground.near, floor, followed);
    ground.level = low.ground;
    const std::vector<Track> tracks = tracks_of(model, all, low.vertices);
    ground.velocity = ground_velocity(tracks, ground);
    constexpr double least_stride = 1e-3; // relative to the diagonal of the box; less is noise
    if (glm::length(ground.velocity) < least_stride * size) return gait;

    std::vector<SeenFoot> seen;
    glm::dvec3 way(0);
    double poses_seen = 0;
    for (const Cluster& cluster :
         clusters(model, tracks, foot_size * size, glm::length(ground.velocity))) {
        std::optional<SeenFoot> each = seen_foot(cluster, ground);
        if (!each) continue;
        Foot foot;
        for (const Track* track : sole_of(cluster.tracks, each->stance, ground))
            foot.sole.push_back(track->vertex);
        foot.node = cluster.mover;
        gait.feet.push_back(std::move(foot));
        way -= each->velocity * static_cast<double>(each->stance.count);
        poses_seen += static_cast<double>(each->stance.count);
        seen.push_back(std::move(*each));
    }
    if (gait.feet.empty()) return gait;
    gait.forward = direction_of(way, up);
    gait.stride = glm::dot(way, gait.forward) / poses_seen;
    gait.trouble.clear();
    find_legs(model, gait.feet);
    for (std::size_t f = 0; f < seen.size(); ++f) settle(gait.feet[f], seen[f], gait, ground);
    return gait;
}

} // namespace trivar
