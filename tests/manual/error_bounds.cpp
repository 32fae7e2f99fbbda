// SPDX-License-Identifier: GPL-3.0-or-later
// Refines what lies in volumes in the sample scenes, and real models in volumes that bend and
// ripple, and compares the bound of every triangle with its error at 153 points. Prints how many
// times the error the bound is: it is nowhere to be less than once.
#include "core/base/parallel.h"
#include "core/base/text.h"
#include "core/evaluation/evaluate.h"
#include "core/files/read_model.h"
#include "core/scene/log.h"
#include "core/steps/bending/refining.h"
#include "tests/refinement/bent.h"
#include "tests/refinement/truth.h"
#include "tests/support/fixtures.h"

#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <glm/gtc/matrix_transform.hpp>
#include <map>

namespace trivar {
namespace {

using namespace testing;

constexpr int levels = 16;
constexpr std::size_t samples_each = (levels + 1) * (levels + 2) / 2;

std::vector<std::string> sorted_files(const std::filesystem::path& folder,
                                      const std::vector<std::string>& extensions)
{
    std::vector<std::string> out;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        if (std::ranges::count(extensions, entry.path().extension().string()))
            out.push_back(entry.path().string());
    std::ranges::sort(out);
    return out;
}

// The models that scenes name, as this build made them.
std::map<std::string, std::string> made_models()
{
    std::map<std::string, std::string> out;
    for (const std::string& path : sorted_files(TRIVAR_BINARY_DIR "/assets/models", {".glb"}))
        out[std::filesystem::path(path).filename()] = path;
    return out;
}

// Bound over error by triangles, those whose error is above rounding's share of the volume.
std::vector<double> ratios(const Lattice& lattice, const RefinedPart& part,
                           const Embedding& embedding)
{
    const auto cells = std::make_shared<const DisplacementCells>(lattice.displacement);
    const std::vector<glm::uvec3> faces = triangles(*part.mesh);
    const double rounding = 1e-12 * diagonal(lattice);
    std::vector<double> out(faces.size());
    parallel_blocks(faces.size(), 256, [&](std::size_t from, std::size_t to) {
        ErrorBounds bounds(cells);
        for (std::size_t i = from; i < to; ++i) {
            Corners3 corners;
            for (int k = 0; k < 3; ++k)
                corners[static_cast<std::size_t>(k)] =
                    embedding.to_uvw * glm::dvec4(part.mesh->positions[faces[i][k]], 1);
            const double error = sampled_error(lattice.displacement, corners, levels);
            if (error > rounding)
                out[i] =
                    bounds.triangle(corners_of(bounds, corners), BoundMethod::composed_net) / error;
        }
    });
    std::erase(out, 0.0);
    return out;
}

class Report {
public:
    void add(const std::string& name, const Lattice& lattice, const std::vector<RefinePart>& parts)
    {
        const RefinementResult out =
            refine(parts, lattice, {.tolerance_world = 1e-3 * diagonal(lattice)});
        std::vector<double> all;
        for (std::size_t p = 0; p < parts.size(); ++p)
            for (const double r : ratios(lattice, out.parts[p], parts[p].embedding))
                all.push_back(r);
        if (all.empty()) return;
        print(name, all);
        all_.insert(all_.end(), all.begin(), all.end());
    }
    void print_all() { print("all", all_); }

private:
    static void print(const std::string& name, std::vector<double>& r)
    {
        std::ranges::sort(r);
        fmt::print("{}: {} triangles, {} samples; bound over error below 1: {}, least 1 + {:.1e}, "
                   "median {:.4f}, 99 of 100 below {:.3f}\n",
                   name, r.size(), r.size() * samples_each,
                   std::ranges::count_if(r, [](double x) { return x < 1; }), r.front() - 1,
                   r[r.size() / 2], r[r.size() * 99 / 100]);
        std::fflush(stdout);
    }
    std::vector<double> all_;
};

void scene(Report& report, const std::string& path)
{
    const Document document = replay(read_log(read_text_file(path), path)).document();
    Evaluator evaluator(
        std::make_shared<const AssetStore>(TRIVAR_SOURCE_DIR "/assets/scenes", made_models()));
    const Evaluation evaluated = evaluator(document);
    for (const auto& [id, object] : evaluated.objects) {
        std::vector<RefinePart> parts;
        for (const Part& part : object->parts)
            if (part.bent) parts.push_back({part.before_volume(), part.bent->embedding});
        if (!parts.empty())
            report.add(std::filesystem::path(path).stem().string() + ", object " +
                           std::to_string(id),
                       *object->parts.front().bent->volume, parts);
    }
}

void real_model(Report& report, const std::string& path)
{
    const Model model = read_model(path);
    const Ref<Mesh> mesh = model.meshes.front();
    const Box box = bounding_box(*mesh);
    Embedding embedding;
    embedding.to_uvw = glm::scale(glm::dmat4(1), 1.0 / glm::max(box.size(), glm::dvec3(1e-9))) *
                       glm::translate(glm::dmat4(1), -box.lo);
    for (const int order : {3, 4}) {
        const Knots knots = Knots::uniform(order, 7);
        const Lattice lattice{
            random_volume({knots, Knots::uniform(3, 6), knots}, 7, 0.1 * glm::length(box.size())),
            glm::inverse(embedding.to_uvw)};
        report.add(fmt::format("{}, order {}", std::filesystem::path(path).stem().string(), order),
                   lattice, {{mesh, embedding}});
    }
}

} // namespace
} // namespace trivar

int main()
{
    trivar::Report report;
    for (const std::string& path :
         trivar::sorted_files(TRIVAR_SOURCE_DIR "/assets/scenes", {".trivar"}))
        trivar::scene(report, path);
    const std::string data = trivar::testing::real_data_folder();
    if (data.empty())
        fmt::print("no folder of real models\n");
    else
        for (const std::string& path :
             trivar::sorted_files(data + "/meshes", {".obj", ".off", ".ply", ".stl"}))
            trivar::real_model(report, path);
    report.print_all();
}
