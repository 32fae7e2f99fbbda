// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fuzz/hands/hands_campaign.h"

#include "core/base/text.h"
#include "tests/fuzz/hands/gesture_dice.h"
#include "tests/fuzz/hands/hand_laws.h"
#include "tests/support/fixtures.h"

#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <fmt/format.h>
#include <sstream>

namespace trivar::testing {
namespace {

namespace fs = std::filesystem;

std::vector<Gesture> gestures_in(const std::string& text)
{
    std::vector<Gesture> out;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);)
        if (!line.empty()) out.push_back(gesture_from(line));
    return out;
}

double processor_seconds_used() // of all threads
{
    return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

struct Taken {
    double all_s = 0, longest_frame_s = 0; // of the processor
};

Taken make_gesture(Hand& hand, HandLaws& laws, const Gesture& gesture, bool thoroughly,
                   const HandsOptions& options)
{
    const double begin_s = processor_seconds_used();
    hand.make(gesture);
    const Taken taken{processor_seconds_used() - begin_s, hand.longest_frame_s()};
    if (options.longest_frame_s > 0 && taken.longest_frame_s > options.longest_frame_s)
        throw Broken(fmt::format("a frame takes {:.1f} s of the processor", taken.longest_frame_s));
    if (!gesture.hasty) laws.check(thoroughly);
    hand.longest_frame_s(); // what the laws take is nothing that a hand waits for
    return taken;
}

// Prints the result of a gesture.
void tell(const Editor& editor, std::size_t steps_before, const Taken& taken)
{
    const History& history = editor.session.scene().history();
    fmt::print(stderr, "    {:.1f} s, a frame {:.2f} s; {}, step {}", taken.all_s,
               taken.longest_frame_s, editor.active_tool().name(), history.position());
    for (std::size_t i = steps_before; i < history.position(); ++i)
        fmt::print(stderr, " {}", verb(history.steps()[i].command));
    for (const ui::Notices::Notice& each : editor.session.notices.all())
        fmt::print(stderr, "; {}", each.title);
    fmt::print(stderr, "\n");
}

// A process that dies says in its output how far it was.
void use_gestures(const std::string& path, const HandsOptions& options)
{
    const std::vector<Gesture> gestures = gestures_in(read_text_file(path));
    const fs::path folder = fs::path(path).parent_path(), scene = folder / "open.trivar";
    fs::copy_file(folder / "start.trivar", scene); // which is kept as it was
    ::setenv("HOME", folder.c_str(), 1);           // where dialogs begin
    Hand hand(scene);
    HandLaws laws(hand);
    hand.longest_frame_s(); // shaders are compiled in the first
    for (std::size_t i = 0; i < gestures.size(); ++i) {
        fmt::print(stderr, "{}: {}\n", i + 1, text_of(gestures[i]));
        const std::size_t before = hand.editor().session.scene().history().position();
        Taken taken;
        try {
            taken = make_gesture(hand, laws, gestures[i], i % 4 == 3 || i + 1 == gestures.size(),
                                 options);
        } catch (const Broken& broken) {
            throw Broken(fmt::format("{}, after gesture {}: {}", broken.what(), i + 1,
                                     text_of(gestures[i])));
        }
        tell(hand.editor(), before, taken);
    }
}

Campaign hands_of(const std::string& kind, const HandsOptions& options)
{
    const auto drawn = [scenes = start_scenes(kind), words = all_words(),
                        count = options.gestures](std::uint64_t seed, int number) {
        Dice dice(seed, number);
        FileSet out{{"case.hands", {}}};
        if (scenes.empty()) return out;
        const StartScene& scene = dice.one_of(scenes);
        for (const Gesture& each : drawn_gestures(words, scene, dice, count))
            out.front().bytes += text_of(each) + '\n';
        out.insert(out.end(), scene.files.begin(), scene.files.end());
        return out;
    };
    return {drawn, [options](const std::string& path) { use_gestures(path, options); }};
}

} // namespace

std::vector<CampaignEntry> hands_campaigns(const HandsOptions& options)
{
    std::vector<CampaignEntry> out;
    for (const char* kind : {"bodies", "models", "volumes", "real"}) {
        if (kind == std::string("real") && real_data_folder().empty()) continue;
        out.push_back({"hands", kind, [kind, options] { return hands_of(kind, options); }});
        CaseLimits& limits = out.back().limits;
        limits.processor_s = 60.0 * options.gestures;
        limits.wall_s = 10 * limits.processor_s;
        limits.memory_bytes = std::size_t{2} << 30;
    }
    return out;
}

} // namespace trivar::testing
