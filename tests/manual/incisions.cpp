// SPDX-License-Identifier: GPL-3.0-or-later
// Makes random incisions, single ones and sets that cross in ten ways, and counts what is open,
// doubled, pinched or lost, what was refused, and how often the guard narrowed an opening.
// Arguments: sets, a seed, the share of single ones, the number of a set to look at alone (-1:
// all), a folder of real models, where there is one, and the share of those that are to go through.
#include "core/base/rejected.h"
#include "core/files/read_model.h"
#include "tests/incise/bodies.h"
#include "tests/incise/soundness.h"
#include "tests/incise/strokes.h"

#include <chrono>
#include <cstdlib>
#include <deque>
#include <filesystem>
#include <fmt/format.h>
#include <map>

namespace trivar::testing {
namespace {

struct Counts {
    long sets = 0, incisions = 0, refused = 0, faulty = 0, off = 0, narrowed = 0, narrowed_sets = 0,
         held = 0, drawn = 0, shut = 0, apart = 0, thrown = 0, pierced = 0, asked_through = 0,
         through = 0;
    double volume = 0, least = 1;
    std::map<std::string, long> refusals;
};

// Adds random demands to incisions beyond their strokes.
void ask_more(const SlitSkin& skin, RandomHand& hand, double share_through,
              std::vector<Incision>& incisions)
{
    if (!(share_through > 0)) return;
    for (Incision& each : incisions) {
        if (hand.number() < share_through) each.floor = Incision::Floor::through;
        if (hand.number() < 0.4) each.lean_deg = hand.number(-60, 60);
        if (hand.number() < 0.4) each.bevel = skin.usual_edge() * hand.number(0, 1);
        each.roundness = hand.number() < 0.5 ? hand.number() : 0;
    }
}

void make(const SlitSkin& skin, const std::string& body, const std::string& kind, long number,
          const std::vector<Incision>& incisions, Counts& counts)
{
    ++counts.sets;
    counts.incisions += static_cast<long>(incisions.size());
    try {
        const IncisedMesh made = incise(skin, incisions);
        bool cut = false;
        double widest = 1;
        long through = 0, crossed = 0; // each crossing twice
        for (std::size_t k = 0; k < incisions.size(); ++k) {
            const IncisedMesh::Outcome& outcome = made.outcomes[k];
            if (incisions[k].floor == Incision::Floor::through) {
                ++counts.asked_through;
                through += outcome.shortfall.empty() && outcome.refusal.empty();
                if (!outcome.shortfall.empty()) ++counts.refusals["(floor) " + outcome.shortfall];
            }
            if (!outcome.refusal.empty()) {
                ++counts.refused;
                ++counts.refusals[outcome.refusal];
                continue;
            }
            cut = true;
            crossed += outcome.crossed_through;
            widest = std::min(widest, outcome.widest);
            counts.narrowed += outcome.widest < 1;
            counts.held += outcome.least < 1 && !(outcome.widest < 1);
            counts.drawn += outcome.least_below < 1 && !(outcome.least < 1);
            counts.shut += outcome.widest < 0.02;
        }
        if (!cut) return;
        if (widest < 1) {
            fmt::print("NARROWED {} {} #{}:", body, kind, number);
            for (const IncisedMesh::Outcome& each : made.outcomes)
                fmt::print(" {:.2f}", each.widest);
            fmt::print("\n");
        }
        counts.narrowed_sets += widest < 1;
        counts.least = std::min(counts.least, widest);
        counts.through += through;
        SlitFaults faults = faults_of(made);
        faults.euler += 2 * through - crossed;
        counts.volume = std::max(counts.volume, std::abs(faults.volume));
        if (!faults.none()) {
            ++counts.faulty;
            fmt::print("FAULTY {} {} #{}: open {} twice {} pinched {} euler {} lost {}\n", body,
                       kind, number, faults.open, faults.twice, faults.pinched, faults.euler,
                       faults.lost);
        }
        const Ref<Mesh> open = opened(made, std::vector<IncisionOpening>(incisions.size()));
        counts.apart += copies_apart(*open) > 0 || copies_apart(*made.rest) > 0;
        counts.off += opened(made, std::vector<IncisionOpening>(
                                       incisions.size(), IncisionOpening{0, 0, 1})) != skin.mesh();
        for (const double share : {1.0, 0.75, 0.5, 0.25, 0.1}) {
            const std::size_t pairs =
                piercings_at(made, std::vector(incisions.size(), IncisionOpening{share, 0, 1}));
            if (pairs == 0) continue;
            ++counts.pierced;
            fmt::print("PIERCED {} {} #{} at {}: {} pairs\n", body, kind, number, share, pairs);
        }
    } catch (const std::exception& e) {
        ++counts.thrown;
        fmt::print("THROWN {} {} #{}: {}\n", body, kind, number, e.what());
    }
}

void print(const std::string& kind, const Counts& c)
{
    fmt::print(
        "{}: {} sets, {} incisions; refused {}; faulty {}, thrown {}, copies apart {}, "
        "opening 0 not the original {}; volume at rest off by at most {:.1e}\n"
        "  narrowed by the guard {} ({:.1f} %), in {} sets, least share {:.2f}, shut {}; held "
        "at a place without that {}, drawn together below the skin alone {}; "
        "openings at which something pierces {}\n",
        kind, c.sets, c.incisions, c.refused, c.faulty, c.thrown, c.apart, c.off, c.volume,
        c.narrowed, 100.0 * static_cast<double>(c.narrowed) / static_cast<double>(c.incisions),
        c.narrowed_sets, c.least, c.shut, c.held, c.drawn, c.pierced);
    if (c.asked_through > 0) fmt::print("  {} of {} go through\n", c.through, c.asked_through);
    for (const auto& [why, count] : c.refusals) fmt::print("  {} {}\n", count, why);
}

struct Body {
    std::string name;
    SlitSkin skin;
};

std::deque<Body> bodies(const std::string& folder)
{
    std::deque<Body> out;
    const std::array names{"sphere", "torus", "box", "cylinder", "icosphere"};
    for (std::size_t i = 0; i < names.size(); ++i)
        out.push_back({names[i], skin_of(any_closed_primitive(i))});
    out.push_back({"icosphere 5", skin_of(icosphere(5))});
    if (folder.empty()) return out;
    for (const char* name : {"spot.obj", "camel.off", "stanford-bunny.obj", "face.obj"}) {
        const std::filesystem::path path = std::filesystem::path(folder) / name;
        if (!std::filesystem::exists(path)) continue;
        const Model model = read_model(path);
        out.push_back({name, skin_of(*model.meshes[0])});
    }
    return out;
}

} // namespace
} // namespace trivar::testing

int main(int count, char** arguments)
{
    using namespace trivar::testing;
    const auto number = [&](int i, double otherwise) {
        return count > i ? std::atof(arguments[i]) : otherwise;
    };
    const long sets = static_cast<long>(number(1, 1000));
    const auto seed = static_cast<std::uint64_t>(number(2, 7));
    const double single = number(3, 0.75);
    const long only = static_cast<long>(number(4, -1));
    const double through = number(6, 0);
    const std::deque<Body> all = bodies(count > 5 ? arguments[5] : "");
    const auto begin = std::chrono::steady_clock::now();
    std::map<std::string, Counts> counts;
    for (long i = 0; i < sets; ++i) {
        if (only >= 0 && i != only) continue;
        const Body& body = all[static_cast<std::size_t>(i) % all.size()];
        RandomHand hand(body.skin, seed * 1000003 + static_cast<std::uint64_t>(i));
        if (hand.number() < single) {
            const bool loop = hand.number() < 0.1;
            std::vector<trivar::Incision> cut{random_single(body.skin, hand, loop)};
            ask_more(body.skin, hand, through, cut);
            make(body.skin, body.name, loop ? "loop" : "single", i, cut,
                 counts[loop ? "loop" : "single"]);
            continue;
        }
        const std::size_t kind = static_cast<std::size_t>(hand.number(0, cut_kinds.size() - 1e-9));
        std::vector<trivar::Incision> set = random_set(body.skin, hand, kind);
        ask_more(body.skin, hand, through, set);
        make(body.skin, body.name, cut_kinds[kind], i, set, counts[cut_kinds[kind]]);
    }
    for (const auto& [kind, each] : counts) print(kind, each);
    fmt::print("{:.1f} s\n",
               std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
    return 0;
}
