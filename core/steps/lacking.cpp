// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/steps/lacking.h"

#include "core/base/finite.h"

#include <algorithm>
#include <fmt/format.h>
#include <functional>
#include <utility>

namespace trivar {
namespace {

bool displaces_within_reach(const Lattice& volume)
{
    Box displacements;
    for (const glm::dvec3& by : volume.displacement.points) {
        if (!finite(by)) return false;
        displacements.add(by);
    }
    return within_reach(displacements);
}

class IsOutOfReach {
public:
    bool operator()(const Part& part)
    {
        if (!part.bent) return !within_reach(part.bounds, part.to_world);
        // A vertex is at its rest position plus a mean of displacements.
        const auto [known, fresh] = volumes_.try_emplace(part.bent->volume);
        if (fresh) known->second = displaces_within_reach(*part.bent->volume);
        return !known->second || !within_reach(part.bounds, part.bent->embedding.to_rest);
    }
    bool operator()(const CurvePart& curve) { return (*this)(curve.points); }

private:
    std::map<Ref<Lattice>, bool> volumes_; // whether they do
};

} // namespace

bool is_within_reach(const Stage& stage)
{
    IsOutOfReach is_out;
    return std::ranges::none_of(stage.curves, std::ref(is_out)) &&
           std::ranges::none_of(stage.parts, std::ref(is_out));
}

void leave_out_what_is_out_of_reach(Stage& stage)
{
    IsOutOfReach is_out;
    if (std::erase_if(stage.curves, std::ref(is_out)) > 0) {
        stage.lacks.push_back(fmt::format(
            "curves are left out: where they lie their coordinates are {}", too_large_words));
        stage.notices.push_back(stage.lacks.back());
    }
    const std::size_t all = stage.parts.size(), gone = std::erase_if(stage.parts, std::ref(is_out));
    if (gone == 0) return;
    stage.lacks.push_back(
        gone == all ? fmt::format("where it lies its coordinates are {}", too_large_words)
                    : fmt::format("{} of its {} meshes are left out: where they lie their numbers "
                                  "are {}",
                                  gone, all, too_large_words));
    stage.notices.push_back(stage.lacks.back());
}

std::vector<std::string> lacks(const Evaluation& evaluated, const Document& document)
{
    std::vector<std::string> out;
    for (const auto& [id, ref] : evaluated.objects)
        for (const std::string& why : ref->lacks)
            out.push_back(fmt::format("{}: {}", object(document, id).name, why));
    for (const FailedStep& failed : evaluated.failed) // of what is hidden and carries others
        if (!evaluated.objects.contains(failed.object))
            out.push_back(
                fmt::format("{}: {}", object(document, failed.object).name, failed.words));
    return out;
}

IncompleteScene::IncompleteScene(std::vector<std::string> all)
    : Rejected(all.size() == 1 ? all.front()
                               : fmt::format("{} (and {} more)", all.front(), all.size() - 1)),
      sentences(std::move(all))
{
}

void check_whole(std::vector<std::string> lacks)
{
    if (!lacks.empty()) throw IncompleteScene(std::move(lacks));
}

} // namespace trivar
