// SPDX-License-Identifier: GPL-3.0-or-later
// manual_silhouette_views COUNT SEED [FOLDER]: finds the silhouettes of sampled functions, and of
// volumes in a folder, in as many random views, and counts branches and loose ends within the grid.
// manual_silhouette_views turn STEPS [FOLDER]: turns views by 0.1 degree a step and tells how far
// the points of curves move in an image of 1024 pixels, and what share of the length of the lines
// that are seen keeps its id.
// manual_silhouette_views recall VIEWS [FOLDER]: compares certified silhouettes with boxes of 1/16
// voxel with what an exhaustive search finds, and points that are hidden with a march in small
// steps.
#include "core/level/voxel_field.h"
#include "core/lines/level_drawing.h"
#include "core/silhouette/certified.h"
#include "core/silhouette/silhouette_curves.h"
#include "core/silhouette/silhouette_finder.h"
#include "core/voxels/read_volume.h"
#include "core/voxels/usual_level.h"
#include "tests/silhouette/scenes.h"
#include "tests/silhouette/true_silhouette.h"

#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <glm/gtc/matrix_transform.hpp>
#include <map>
#include <random>
#include <set>
#include <unordered_map>

using namespace trivar;

namespace {

struct Subject {
    std::string name;
    Ref<VoxelField> field;
    LevelMesh mesh;
};

Subject subject_of(std::string name, VoxelGrid grid, double level)
{
    auto field = make_ref(VoxelField(make_ref(std::move(grid)), {}));
    LevelMesh mesh = field->level(level);
    return {std::move(name), field, std::move(mesh)};
}

// Returns the part of a volume in a box whose faces cut its body.
Subject part_of(const Subject& whole, double level)
{
    const glm::ivec3 size = whole.field->grid().size;
    auto field = make_ref(VoxelField(
        *whole.field, sample_box(size, glm::vec3(0.3f, 0.1f, 0.2f), glm::vec3(0.8f, 0.7f, 0.75f))));
    LevelMesh mesh = field->level(level);
    return {"part of " + whole.name, field, std::move(mesh)};
}

std::vector<Subject> subjects(const std::string& folder, int n)
{
    std::vector<Subject> out;
    for (const char* function : {"gauss", "waves", "torus", "noise"}) {
        const testing::SampledField from = testing::sampled(function, n);
        VoxelGrid grid;
        grid.size = from.size;
        grid.samples = testing::in_single_precision(from.samples);
        out.push_back(subject_of(function, std::move(grid), from.level));
    }
    if (folder.empty()) return out;
    for (const char* file : {"ironProt.vtk", "tooth.nrrd", "headsq/quarter.nhdr"}) {
        VoxelGrid grid = read_volume(folder + "/" + file).grid;
        const double level = usual_level(summary_of(grid), grid);
        out.push_back(subject_of(file, std::move(grid), level));
        out.push_back(part_of(out.back(), level));
    }
    return out;
}

// Edges in more than two places of curves, and ends of curves within the grid.
struct Faults {
    std::size_t branches = 0, loose_ends = 0, points = 0;
};

Faults faults_of(const Silhouettes& curves, const LevelMesh& mesh, const glm::ivec3& size)
{
    Faults out;
    out.points = curves.points.size();
    std::vector<std::uint64_t> edges;
    for (const SilhouettePoint& point : curves.points) edges.push_back(point.edge);
    std::ranges::sort(edges);
    for (std::size_t i = 1; i < edges.size(); ++i) out.branches += edges[i] == edges[i - 1];
    for (std::size_t c = 0; c < curves.count(); ++c) {
        if (curves.closed[c]) continue;
        for (const std::size_t i :
             {std::size_t{curves.first[c]}, std::size_t{curves.first[c + 1] - 1}}) {
            const std::uint64_t edge = curves.points[i].edge;
            out.loose_ends += !are_in_a_face(
                mesh.positions[edge >> 32], mesh.positions[edge & 0xFFFFFFFF], glm::vec3(size - 1));
        }
    }
    return out;
}

ViewPoint random_view(std::mt19937& random, const glm::ivec3& size)
{
    std::normal_distribution<double> normal;
    glm::dvec3 way(0);
    while (!(glm::length(way) > 1e-6)) way = {normal(random), normal(random), normal(random)};
    way = glm::normalize(way);
    if (random() % 2) return {{way, 0}};
    const double far = std::uniform_real_distribution<double>(0.2, 3)(random);
    return {{glm::dvec3(size) * 0.5 - way * far * glm::length(glm::dvec3(size)), 1}};
}

int find_faults(int count, unsigned seed, const std::string& folder)
{
    std::mt19937 random(seed);
    Faults total;
    const std::vector<Subject> all = subjects(folder, 64);
    std::vector<SilhouetteFinder> finders(all.size());
    for (int i = 0; i < count; ++i) {
        const std::size_t k = random() % all.size();
        const glm::ivec3 size = all[k].field->field().size();
        const ViewPoint view = random_view(random, size);
        const Faults faults =
            faults_of(finders[k](all[k].field->field(), all[k].mesh, view), all[k].mesh, size);
        if (faults.branches + faults.loose_ends > 0)
            fmt::print("view {} of {}: {} branches, {} loose ends\n", i, all[k].name,
                       faults.branches, faults.loose_ends);
        total.branches += faults.branches;
        total.loose_ends += faults.loose_ends;
        total.points += faults.points;
    }
    fmt::print("{} views of {} volumes, {} points: {} branches, {} loose ends within the grid\n",
               count, all.size(), total.points, total.branches, total.loose_ends);
    return total.branches + total.loose_ends == 0 ? 0 : 1;
}

// The view of a step, filling an image of 1024 pixels.
DrawingView turned_view(int step, const glm::ivec3& size)
{
    const double angle = glm::radians(0.1) * step;
    const glm::dvec3 way = glm::normalize(
        glm::dvec3(std::cos(angle + 0.5), std::sin(angle + 0.5), 0.3 + 0.1 * std::sin(angle)));
    const double across = glm::length(glm::dvec3(size));
    const glm::dvec3 middle = glm::dvec3(size - 1) / 2.0;
    glm::dmat4 to_pixels(1);
    to_pixels[0][0] = to_pixels[1][1] = 1024 / across;
    to_pixels[2][2] = -0.5 / across;
    return {to_pixels * glm::lookAt(middle - way * across, middle, glm::dvec3(0, 0, 1)),
            {{way, 0}}};
}

// The least distances of points from curves, in pixels, found by a grid of cells.
class PointsBefore {
public:
    explicit PointsBefore(const std::vector<glm::dvec2>& points)
    {
        for (const glm::dvec2& p : points) cells_[cell(p)].push_back(p);
    }
    double distance(const glm::dvec2& p) const // at most `reach`
    {
        double out = reach;
        const std::int64_t at = cell(p);
        for (const std::int64_t row : {-rows, std::int64_t{0}, rows})
            for (std::int64_t i = -1; i <= 1; ++i)
                if (const auto found = cells_.find(at + row + i); found != cells_.end())
                    for (const glm::dvec2& q : found->second)
                        out = std::min(out, glm::distance(p, q));
        return out;
    }
    static constexpr double reach = 8;

private:
    static constexpr std::int64_t rows = 1 << 20;
    static std::int64_t cell(const glm::dvec2& p)
    {
        return static_cast<std::int64_t>(std::floor(p.x / reach)) +
               rows * static_cast<std::int64_t>(std::floor(p.y / reach));
    }
    std::unordered_map<std::int64_t, std::vector<glm::dvec2>> cells_;
};

// The points of curves in an image, with points between them at most a quarter pixel apart.
std::vector<glm::dvec2> in_pixels(const Silhouettes& curves, const glm::dmat4& to_image, bool dense)
{
    std::vector<glm::dvec2> out;
    for (std::size_t c = 0; c < curves.count(); ++c)
        for (std::size_t i = curves.first[c]; i < curves.first[c + 1]; ++i) {
            const auto at = [&](std::size_t k) {
                return glm::dvec2(to_image * glm::dvec4(glm::dvec3(curves.points[k].p), 1));
            };
            const glm::dvec2 p = at(i);
            out.push_back(p);
            if (!dense) continue;
            const bool last = i + 1 == curves.first[c + 1];
            if (last && !curves.closed[c]) continue;
            const glm::dvec2 q = at(last ? curves.first[c] : i + 1);
            const int steps = static_cast<int>(std::ceil(glm::distance(p, q) * 4));
            for (int k = 1; k < steps; ++k) out.push_back(glm::mix(p, q, double(k) / steps));
        }
    return out;
}

void turn(int steps, const std::string& folder)
{
    for (const Subject& subject : subjects(folder, 128)) {
        if (subject.name == "noise") continue; // it is nothing that anybody draws
        const ScalarField<float>& field = subject.field->field();
        SilhouetteFinder find;
        LineIds ids;
        std::set<std::uint64_t> before;
        std::vector<glm::dvec2> old;
        std::vector<double> moved;
        double length = 0, kept = 0, known = 0;
        std::set<std::uint64_t> ever;
        for (int step = 0; step < steps; ++step) {
            const DrawingView view = turned_view(step, field.size());
            const Silhouettes curves = find(field, subject.mesh, view.from);
            const PointsBefore now(in_pixels(curves, view.to_image, true));
            for (const glm::dvec2& p : old) moved.push_back(now.distance(p));
            old = in_pixels(curves, view.to_image, false);
            const LevelSide side = subject.name == "torus" ? LevelSide::below : LevelSide::above;
            const DrawnLevel level{subject.name, subject.mesh, side, {}};
            const LevelDrawing drawing =
                draw_levels(field, subject.field->hulls(), std::span(&level, 1), view,
                            {.ids = [&](const std::string&) -> LineIds& { return ids; }});
            std::set<std::uint64_t> after;
            for (const InkedLine& line : drawing.layers[0].lines) {
                double own = 0;
                for (std::size_t i = 1; i < line.points.size(); ++i)
                    own += double{glm::distance(line.points[i].at, line.points[i - 1].at)};
                if (step > 0) {
                    length += own;
                    if (before.contains(line.id)) kept += own;
                    if (ever.contains(line.id)) known += own;
                }
                after.insert(line.id);
            }
            ever.insert(after.begin(), after.end());
            before = std::move(after);
        }
        std::ranges::sort(moved);
        const auto share = [&](double most) {
            return static_cast<double>(std::ranges::upper_bound(moved, most) - moved.begin()) /
                   static_cast<double>(moved.size());
        };
        fmt::print("{}: of {} points {:.4f} % move at most 1 px, {:.4f} % at most 2 px; {:.3f} % "
                   "of the length keeps its id, {:.3f} % has one of a view before\n",
                   subject.name, moved.size(), 100 * share(1), 100 * share(2), 100 * kept / length,
                   100 * known / length);
        std::fflush(stdout);
    }
}

// Whether a march in steps of a fiftieth of a voxel says that a body hides a point.
bool is_hidden_by_steps(const LevelBody& body, const glm::dvec3& p, const glm::dvec3& to_eye)
{
    const double sign = body.side == LevelSide::above ? 1 : -1;
    const glm::dvec3 end(body.field.end());
    for (double way = 0.1;; way += 0.02) {
        const glm::dvec3 at = p + way * to_eye;
        if (glm::any(glm::lessThan(at, glm::dvec3(0))) || glm::any(glm::greaterThan(at, end)))
            return false;
        if (sign * double{body.field.at<0>(glm::vec3(at)).value - body.level} > 0) return true;
    }
}

void recall(int views, const std::string& folder)
{
    constexpr int depth = 4;
    constexpr double near = 0.15; // voxels
    std::mt19937 random(5);
    for (const Subject& subject : subjects(folder, 40)) {
        if (subject.name == "noise" || subject.name == "tooth.nrrd") continue;
        const ScalarField<float>& field = subject.field->field();
        const VoxelGrid& grid = subject.field->grid();
        std::vector<double> samples;
        std::visit([&](const auto& all) { samples.assign(all.begin(), all.end()); }, grid.samples);
        const ScalarField<double> exact(std::span<const double>(samples), grid.size);
        std::size_t places = 0, open = 0, points = 0, wrong = 0;
        double found = 0;
        for (int i = 0; i < views; ++i) {
            const ViewPoint view = random_view(random, grid.size);
            const CertifiedSilhouettes certified = certified_silhouettes(
                field, subject.field->hulls(), subject.mesh.level, view, depth);
            const std::vector<glm::dvec3> truth =
                testing::true_silhouette(exact, double{subject.mesh.level}, view);
            found += testing::share_near(truth, certified.curves, near) *
                     static_cast<double>(truth.size());
            places += truth.size();
            open += certified.open;
            if (view.at.w != 0) continue;
            const Silhouettes quick = SilhouetteFinder()(field, subject.mesh, view);
            const LevelBody body{field, subject.field->hulls(), subject.mesh.level};
            const std::vector<char> hidden = hidden_points(quick, view, body);
            for (std::size_t k = 0; k < quick.points.size(); k += 7) {
                const SilhouettePoint& point = quick.points[k];
                const bool hollow = point.bend > 0;
                const bool by_steps = hollow || is_hidden_by_steps(body, glm::dvec3(point.p),
                                                                   -glm::normalize(view.sight({})));
                ++points;
                wrong += by_steps != static_cast<bool>(hidden[k]);
            }
        }
        fmt::print("{}: {:.6f} of {} places are within {} voxel, {} boxes open; {:.3f} % of {} "
                   "points are hidden where steps say they are seen, or the other way round\n",
                   subject.name, found / static_cast<double>(places), places, near, open,
                   100 * static_cast<double>(wrong) / static_cast<double>(points), points);
        std::fflush(stdout);
    }
}

} // namespace

int main(int argc, char** argv)
{
    const std::string first = argc > 1 ? argv[1] : "1000";
    if (first == "turn") {
        turn(argc > 2 ? std::atoi(argv[2]) : 100, argc > 3 ? argv[3] : "");
        return 0;
    }
    if (first == "recall") {
        recall(argc > 2 ? std::atoi(argv[2]) : 20, argc > 3 ? argv[3] : "");
        return 0;
    }
    return find_faults(std::atoi(first.c_str()),
                       argc > 2 ? static_cast<unsigned>(std::atoi(argv[2])) : 1,
                       argc > 3 ? argv[3] : "");
}
