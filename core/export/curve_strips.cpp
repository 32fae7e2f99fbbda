// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/export/curve_strips.h"

#include "core/files/file_sentences.h"

#include <algorithm>
#include <fmt/format.h>

namespace trivar {
namespace {

template <class Is> bool whenever_shown(const CurveStrip& strip, const Is& is)
{
    return std::ranges::all_of(strip.shown,
                               [&](const CurvePart* part) { return !part || is(*part); });
}

} // namespace

const CurvePart& CurveStrip::first() const
{
    return **std::ranges::find_if(shown, [](const CurvePart* part) { return part != nullptr; });
}

bool CurveStrip::rests() const
{
    return whenever_shown(*this, [&](const CurvePart& part) { return part == first(); });
}

bool CurveStrip::is_rigid() const
{
    return whenever_shown(*this, [](const CurvePart& part) { return !part.points.bent; });
}

bool CurveStrip::always_shown() const
{
    return std::ranges::none_of(shown, [](const CurvePart* part) { return part == nullptr; });
}

std::vector<CurveStrip> curve_strips(const Film& film, const Document& document)
{
    std::map<std::pair<Id, PartKey>, CurveStrip> strips;
    for (std::size_t i = 0; i < film.moments.size(); ++i)
        for (const auto& [id, ref] : film.evaluated[i].objects)
            for (const CurvePart& part : ref->curves) {
                CurveStrip& strip = strips[{id, part.points.key}];
                if (strip.shown.empty())
                    strip = {id, object(document, id).name,
                             std::vector<const CurvePart*>(film.moments.size()), ref->materials};
                strip.shown[i] = &part;
            }
    std::vector<CurveStrip> out;
    for (auto& [key, strip] : strips) out.push_back(std::move(strip));
    return out;
}

std::string which_curves_are_left_out(const std::vector<std::string>& names, const std::string& why)
{
    if (names.empty()) return {};
    NameList list;
    for (const std::string& name : names) list.add(name);
    return fmt::format("the curves of {} are left out: {}", list.text(), why);
}

} // namespace trivar
