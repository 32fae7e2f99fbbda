// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/life_sign.h"

#include "core/base/digest.h"
#include "core/base/rejected.h"

#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <sstream>

namespace trivar {

std::optional<LifeSign::State> LifeSign::read(const std::string& text)
{
    State state;
    std::istringstream numbers(text);
    if (numbers >> state.lines >> state.at_work >> state.deaths >> state.rounds) return state;
    return std::nullopt;
}

LifeSign::LifeSign(const std::string& folder, std::string scene, std::size_t lines, bool at_work)
    : scene_(std::move(scene))
{
    if (folder.empty()) return;
    Digest digest;
    digest.add_text(scene_);
    path_ = folder + "/" + life_sign_name + digest.hex();
    std::error_code ignored;
    std::filesystem::create_directories(folder, ignored);
    std::ofstream(path_, std::ios::app).close();
    try {
        LockedFile file(path_);
        if (file.access() != LockedFile::Access::locked) return;
        file_.emplace(std::move(file)); // from here on ours, and removed
        const std::optional<State> left = read(file_->read());
        if (left && left->lines == lines) {
            state_ = *left;
            state_.deaths += left->at_work ? 1 : 0;
        }
    } catch (const Rejected&) {
        return;
    }
    state_.lines = lines;
    state_.at_work = at_work;
    write(state_);
}

LifeSign::~LifeSign()
{
    std::error_code ignored;
    if (file_) std::filesystem::remove(path_, ignored);
}

void LifeSign::write(const State& state)
{
    state_ = state;
    if (file_)
        file_->write_at(0, fmt::format("{} {:d} {} {}\n{}\n", state.lines, state.at_work,
                                       state.deaths, state.rounds, scene_));
}

std::size_t LifeSign::steps_too_many() const
{
    constexpr int most_rounds = 30;
    return state_.deaths < deadly ? 0 : std::size_t{1} << std::min(state_.rounds, most_rounds);
}

void LifeSign::take_back(std::size_t lines)
{
    write({lines, state_.at_work, deadly - 1, state_.rounds + 1});
}

void LifeSign::follow(std::size_t lines, bool at_work)
{
    State now = lines == state_.lines ? state_ : State{.lines = lines};
    now.at_work = at_work;
    if (now != state_) write(now);
}

} // namespace trivar
