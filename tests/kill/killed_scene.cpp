// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/kill/killed_scene.h"

#include "core/base/rejected.h"
#include "core/base/text.h"
#include "core/commands/objects/primitives.h"
#include "core/scene/scene_file.h"
#include "tests/kill/left_file.h"

#include <algorithm>
#include <filesystem>
#include <fmt/format.h>

namespace trivar::testing {

void KillFindings::fault(int& kind, const std::string& sentence)
{
    ++kind;
    faults.push_back(sentence);
}

KilledScene::KilledScene(Screen& screen, Dice& dice, bool named) : screen_(screen), dice_(dice)
{
    if (!named) return;
    path_ = home_.file("scene.trivar");
    SceneFile scene;
    scene.run(AddBox{});
    scene.save_as(path_);
}

// Till the moment of the kill.
void KilledScene::work(WatchedProgram& window)
{
    enum Manner : unsigned { a_frame_later, a_moment_later, saving, at_once, in_haste, amid_many };
    const unsigned manner = dice_.below(amid_many + 1);
    Hand hand(screen_, window, dice_);
    for (unsigned left = 1 + dice_.below(5); left > 0; --left) hand.make_step(manner < in_haste);
    if (manner == a_frame_later) window.wait_for_frames(3);
    if (manner == a_moment_later) dice_.pause(20'000);
    if (manner == amid_many) hand.hide_and_show(dice_.below(30));
    if (manner != saving) return;
    naming_ = path_.empty();
    naming_ ? hand.give_name() : hand.save_copy();
    dice_.pause(60'000);
}

void KilledScene::look_at_first_frame(KillFindings& found) const
{
    const auto& all = killed_->shown();
    const auto first = std::ranges::find_if(all, [&](const Shown& s) { return is_here(s); });
    if (first != all.end() && first->lines < last_.lines)
        found.fault(found.lost, fmt::format("{}: {} lines were shown, and {} when it was opened",
                                            round_, last_.lines, first->lines));
}

void KilledScene::remember(KillFindings& found)
{
    const std::size_t before = std::max(last_.lines, std::size_t{1});
    for (const Shown& shown : killed_->shown()) {
        if (naming_ && shown.path == given_) {
            path_ = given_;
            last_ = shown;
        }
        if (is_here(shown) && shown.lines >= last_.lines) last_ = shown;
        if (is_here(shown) || shown.lines <= 1) continue;
        found.fault(found.lost,
                    fmt::format("{}: {} steps were shown in another scene", round_, shown.steps));
        break;
    }
    found.lines += last_.lines - std::min(before, last_.lines);
}

void KilledScene::look_at_file(KillFindings& found)
{
    try {
        // Killed after it got its name and before that was shown: the file was written anew.
        const bool moved = naming_ && path_.empty() && std::filesystem::exists(given_);
        if (moved) path_ = given_;
        const std::string path =
            path_.empty() ? latest_kept(home_.file("state/trivar/unnamed")) : path_;
        if (path.empty() && last_.lines <= 1) return;
        const std::string text = path.empty() ? std::string() : read_text_file(path);
        if (moved) last_.lines = static_cast<std::size_t>(std::ranges::count(text, '\n'));
        if (text.empty() || !holds(text, last_))
            found.fault(found.lost,
                        fmt::format("{}: {} of {} steps and {} lines were shown, {} lines are left",
                                    round_, last_.steps, last_.of, last_.lines,
                                    std::ranges::count(text, '\n')));
    } catch (const Rejected& why) {
        found.fault(found.torn, fmt::format("{}: {}", round_, why.what()));
    }
}

void KilledScene::settle(KillFindings& found)
{
    if (!killed_) return;
    killed_->wait_till_gone();
    look_at_first_frame(found);
    remember(found);
    look_at_file(found);
    killed_.reset();
    naming_ = false;
}

void KilledScene::round(KillFindings& found)
{
    found.named += path_.empty() ? 0 : 1;
    found.reopened_at_once += killed_ ? 1 : 0;
    std::vector<std::string> files;
    if (!path_.empty()) files.push_back(path_);
    auto window = std::make_unique<WatchedProgram>(files, home_.path().string(), screen_.name());
    settle(found);
    round_ =
        fmt::format("round {}, {}", ++found.rounds, path_.empty() ? "without a name" : "named");
    if (dice_.below(6) == 0) {
        dice_.pause(600'000); // while it opens
    } else {
        const auto any = [](const Shown&) { return true; };
        const bool hasty = dice_.below(2) == 0; // before the scene is there
        if (hasty && window->wait_for(any)) Hand(screen_, *window, dice_).make_step(false);
        if (!window->wait_for([&](const Shown& shown) { return is_here(shown); }))
            found.fault(found.unopened, round_ + ": it was not opened");
        work(*window);
    }
    window->kill();
    killed_ = std::move(window);
    if (naming_ || dice_.below(2) == 0) settle(found); // which name it has is to be known
}

KillFindings kill_windows(Screen& screen, int rounds, unsigned seed)
{
    constexpr int a_scene = 4;
    Dice dice(seed);
    KillFindings found;
    for (bool named = true; found.rounds < rounds; named = !named) {
        const std::size_t faults = found.faults.size();
        KilledScene scene(screen, dice, named);
        for (int i = 0; i < a_scene && found.rounds < rounds && found.faults.size() == faults; ++i)
            scene.round(found);
        scene.settle(found);
    }
    return found;
}

} // namespace trivar::testing
