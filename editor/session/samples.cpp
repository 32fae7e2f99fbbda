// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/session/samples.h"

#include "editor/session/recent_scenes.h"

#include <algorithm>
#include <array>
#include <filesystem>

namespace trivar {
namespace {

constexpr std::size_t most_samples = 4;

// The samples that are shown first.
struct KnownSample {
    const char *file, *title, *words;
};
constexpr std::array<KnownSample, 5> known_samples{{
    {"first_placement", "Snake on a landscape", "One stroke"},
    {"ants_moebius", "Ants round a band", "Play: they walk on and on"},
    {"crocodile_on_horse", "Crocodile on a horse", "Laid on a body"},
    {"stacked", "Snakes on a crocodile", "One on another"},
    {"snake_bridge", "Snake over jars", "Springs bridge gaps"},
}};

} // namespace

std::vector<Sample> samples_among(const std::vector<std::string>& paths)
{
    std::vector<Sample> samples;
    const auto stem = [](const std::string& path) {
        return std::filesystem::path(path).stem().string();
    };
    for (const KnownSample& each : known_samples)
        for (const std::string& path : paths)
            if (stem(path) == each.file) samples.push_back({path, each.title, each.words});
    for (const std::string& path : paths)
        if (!std::ranges::count(samples, path, &Sample::path))
            samples.push_back({path, scene_title(path), {}});
    if (samples.size() > most_samples) samples.resize(most_samples);
    return samples;
}

std::string sample_title(const std::string& path)
{
    const std::filesystem::path file(path);
    if (file.parent_path().filename() == "tutorials") return scene_title(path);
    if (file.parent_path().filename() != "scenes") return {};
    const auto found = std::ranges::find(known_samples, file.stem(), &KnownSample::file);
    return found == known_samples.end() ? std::string() : found->title;
}

} // namespace trivar
