// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/step_title.h"

#include "core/commands/changes.h"
#include "core/commands/keying.h"
#include "core/commands/number_words.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <fmt/format.h>
#include <set>

namespace trivar {
namespace {

std::string name_in(const Document& document, Id id)
{
    const auto found = document.objects.find(id);
    return found == document.objects.end() ? "object " + std::to_string(id) : found->second->name;
}

std::string names_in(const Document& document, const std::vector<Id>& ids)
{
    if (ids.size() == 1) return name_in(document, ids[0]);
    if (ids.size() == 2) return name_in(document, ids[0]) + " and " + name_in(document, ids[1]);
    return fmt::format("{} objects", ids.size());
}

std::string shape_size(const PlaneShape& s)
{
    return fmt::format("{} × {} m", brief_number(s.size.x), brief_number(s.size.y));
}
std::string shape_size(const BoxShape& s)
{
    return fmt::format("{} × {} × {} m", brief_number(s.size.x), brief_number(s.size.y),
                       brief_number(s.size.z));
}
std::string shape_size(const TeapotShape& s)
{
    return in_metres(s.height);
}
// What a row has room for of a text, in quotes.
std::string shape_size(const TextShape& s)
{
    constexpr std::size_t most = 24; // bytes
    std::size_t end = std::min({s.text.find('\n'), s.text.size(), most});
    while (end < s.text.size() && end > 0 && (s.text[end] & '\xC0') == '\x80') --end;
    return "“" + s.text.substr(0, end) + (end < s.text.size() ? "…" : "") + "”";
}
std::string shape_size(const auto& round)
{
    return "radius " + in_metres(round.radius);
}

// About one axis where only that number changed, else about whichever it is.
std::string turn(const glm::dvec3& before, const glm::dvec3& after)
{
    int axes = 0, axis = 0;
    for (int i = 0; i < 3; ++i)
        if (before[i] != after[i]) {
            ++axes;
            axis = i;
        }
    if (axes == 1) return in_degrees(after[axis] - before[axis]) + " about " + "XYZ"[axis];
    const glm::dmat3 a(Transform{{}, before, glm::dvec3(1)}.matrix());
    const glm::dmat3 b(Transform{{}, after, glm::dvec3(1)}.matrix());
    const glm::dmat3 between = glm::transpose(a) * b;
    const double cosine = (between[0][0] + between[1][1] + between[2][2] - 1) / 2;
    return in_degrees(std::acos(std::clamp(cosine, -1.0, 1.0)) * 57.29577951308232);
}

std::string growth(const glm::dvec3& before, const glm::dvec3& after)
{
    const glm::dvec3 ratio = after / before;
    const auto same = [](double a, double b) { return std::abs(a - b) <= 1e-6 * std::abs(b); };
    if (same(ratio.x, ratio.y) && same(ratio.y, ratio.z)) return "× " + brief_number(ratio.x);
    int axes = 0, axis = 0;
    for (int i = 0; i < 3; ++i)
        if (before[i] != after[i]) {
            ++axes;
            axis = i;
        }
    if (axes == 1) return fmt::format("× {} along {}", brief_number(ratio[axis]), "XYZ"[axis]);
    return fmt::format("× {}, {}, {}", brief_number(ratio.x), brief_number(ratio.y),
                       brief_number(ratio.z));
}

StepTitle transform_title(const Transform& before, const Transform& after, const std::string& name)
{
    const bool moved = before.translation != after.translation;
    const bool turned = before.rotation_deg != after.rotation_deg;
    const bool scaled = before.scale != after.scale;
    const std::string distance = in_metres(glm::length(after.translation - before.translation));
    if (moved && turned && scaled) return {"Move, rotate and scale " + name, distance};
    if (moved && turned) return {"Move and rotate " + name, distance};
    if (moved && scaled) return {"Move and scale " + name, distance};
    if (turned && scaled)
        return {"Rotate and scale " + name, turn(before.rotation_deg, after.rotation_deg)};
    if (turned) return {"Rotate " + name, turn(before.rotation_deg, after.rotation_deg)};
    if (scaled) return {"Scale " + name, growth(before.scale, after.scale)};
    return {"Move " + name, distance};
}

// Several objects keep their places to one another: where they turn or grow about a point, that
// they move as well is not worth a word.
StepTitle arranged_title(const Document& before, const Arrange& c)
{
    const auto was = [&](std::size_t i) -> Transform {
        const auto found = before.objects.find(c.objects[i]);
        return found == before.objects.end() ? Transform{} : found->second->transform;
    };
    const std::size_t count = std::min(c.objects.size(), c.transforms.size());
    const std::string names = names_in(before, c.objects);
    if (count == 0) return {"Arrange " + names, {}};
    if (count == 1) return transform_title(was(0), c.transforms[0], names);
    bool turned = false, scaled = false;
    for (std::size_t i = 0; i < count; ++i) {
        turned = turned || was(i).rotation_deg != c.transforms[i].rotation_deg;
        scaled = scaled || was(i).scale != c.transforms[i].scale;
    }
    const Transform first = was(0), &now = c.transforms[0];
    if (turned && scaled) return {"Rotate and scale " + names, {}};
    if (turned) return {"Rotate " + names, turn(first.rotation_deg, now.rotation_deg)};
    if (scaled) return {"Scale " + names, growth(first.scale, now.scale)};
    return {"Move " + names, in_metres(glm::length(now.translation - first.translation))};
}

// "Position Z" and, of several, what they have in common: "Position".
std::string numbers_in(const Animate& c)
{
    std::set<std::string> names, rows;
    for (const auto& [id, tracks] : c.of)
        for (const Track& track : tracks) {
            const std::string& name = track.parameter;
            names.insert(name);
            const bool axis = name.size() > 2 && name[name.size() - 2] == '.' &&
                              std::isdigit(static_cast<unsigned char>(name.back())) == 0;
            rows.insert(axis ? name.substr(0, name.size() - 2) : name);
        }
    if (names.size() == 1) return words_of_number(*names.begin()).label;
    if (rows.size() == 1) return words_of_number(*rows.begin()).label;
    return fmt::format("{} values", names.size());
}

// The one key that is not as it was, where there is just one: what it is and when.
std::string key_in(const Document& before, const Animate& c)
{
    if (c.of.size() != 1 || c.of[0].tracks.size() != 1) return {};
    const auto& [id, tracks] = c.of[0];
    const bool known = id == 0 || before.objects.contains(id);
    const Track* had = known ? track_of(before, id, tracks[0].parameter) : nullptr;
    std::vector<Key> others = had ? had->keys : std::vector<Key>{}, changed;
    for (const Key& key : tracks[0].keys)
        if (std::erase(others, key) == 0) changed.push_back(key);
    if (changed.size() != 1 || others.size() > 1) return {};
    const std::vector<Parameter> all = id == 0 ? scene_parameters(before)
                                       : known ? parameters(*before.objects.at(id))
                                               : std::vector<Parameter>{};
    const auto number = std::ranges::find(all, tracks[0].parameter, &Parameter::name);
    if (number == all.end()) return {};
    return fmt::format("{} in frame {}", words_of_value(*number, changed[0].value),
                       brief_number(changed[0].frame));
}

StepTitle animated_title(const Document& before, const Animate& c)
{
    std::vector<Id> ids;
    bool clears = true;
    for (const auto& [id, tracks] : c.of) {
        ids.push_back(id);
        for (const Track& track : tracks) clears = clears && track.keys.empty();
    }
    const bool scene = ids.size() == 1 && ids.front() == 0;
    std::string what = numbers_in(c) + " of " + (scene ? "the scene" : names_in(before, ids));
    what[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(what[0])));
    return {(clears ? "Clear keys of " : "Animate ") + what, key_in(before, c)};
}

const char* axis_name(VolumeAxis axis)
{
    static constexpr std::array<const char*, 3> names{"along", "across", "up"};
    return names[static_cast<std::size_t>(axis)];
}

// A title for each command; a new command gets one here or does not compile.
struct Titles {
    const Document& before;
    const Document& after;

    std::string made() const { return name_in(after, before.next_id); } // what the command added
    const Object* was(Id id) const
    {
        const auto found = before.objects.find(id);
        return found == before.objects.end() ? nullptr : &*found->second;
    }
    const Object* is(Id id) const
    {
        const auto found = after.objects.find(id);
        return found == after.objects.end() ? nullptr : &*found->second;
    }
    std::string support_of(Id id) const
    {
        const Object* laid = is(id);
        if (!laid || !laid->placement || laid->placement->onto.empty()) return {};
        return " on " + names_in(after, laid->placement->onto);
    }

    StepTitle operator()(const ImportModel& c) const
    {
        const std::filesystem::path file(c.file.path);
        if (made() == file.stem().string()) return {"Import " + file.filename().string(), {}};
        return {"Import " + made(), "from " + file.filename().string()};
    }
    StepTitle operator()(const EditImport& c) const
    {
        const std::string name = name_in(before, c.object);
        const Object* object = was(c.object);
        const auto* file = object ? std::get_if<ImportedFile>(&object->source) : nullptr;
        if (!file || file->path != c.file.path)
            return {"File of " + name, std::filesystem::path(c.file.path).filename().string()};
        if (file->subdivisions != c.file.subdivisions)
            return {"Subdivision of " + name, fmt::format("{} levels", c.file.subdivisions)};
        return {"Read " + name + (file->hash != c.file.hash ? " anew" : " otherwise"), {}};
    }
    StepTitle operator()(const Relink& c) const
    {
        if (c.objects.size() == 1 && c.files.size() == 1)
            return (*this)(EditImport{c.objects.front(), c.files.front()});
        return {"Files of " + names_in(before, c.objects), {}};
    }
    template <class Shape> StepTitle operator()(const AddShape<Shape>& c) const
    {
        return {"Add " + made(), shape_size(c.shape)};
    }
    StepTitle operator()(const SetText& c) const
    {
        const std::string name = name_in(before, c.object);
        const Object* object = was(c.object);
        const auto* old = object ? std::get_if<TextShape>(&object->source) : nullptr;
        if (!old) return {"Text of " + name, {}};
        if (old->text != c.shape.text) return {"Letters of " + name, shape_size(c.shape)};
        if (old->font != c.shape.font) return {"Font of " + name, c.shape.font};
        return {"Shape of the letters of " + name, {}};
    }
    StepTitle operator()(const SetTransform& c) const
    {
        const Object* object = was(c.object);
        return transform_title(object ? object->transform : Transform{}, c.transform,
                               name_in(before, c.object));
    }
    StepTitle operator()(const Arrange& c) const { return arranged_title(before, c); }
    StepTitle operator()(const SetMaterial& c) const
    {
        const Object* object = c.objects.empty() ? nullptr : was(c.objects.front());
        const std::string names = names_in(before, c.objects);
        if (!object || !object->surfacing) return {"Give " + names + " a plain material", {}};
        return title_of_changes(changes(*object->surfacing, c.surfacing), "Material", names);
    }
    StepTitle operator()(const ClearMaterial& c) const
    {
        const bool one = c.objects.size() == 1;
        return {fmt::format("Give {} {} own material back", names_in(before, c.objects),
                            one ? "its" : "their"),
                {}};
    }
    StepTitle operator()(const Rename& c) const
    {
        return {"Rename " + name_in(before, c.object) + " to " + c.name, {}};
    }
    StepTitle operator()(const Hide& c) const
    {
        return {"Hide " + names_in(before, c.objects), {}};
    }
    StepTitle operator()(const Show& c) const
    {
        return {(c.only ? "Show only " : "Show ") + names_in(before, c.objects), {}};
    }
    StepTitle operator()(const Lock& c) const
    {
        return {"Lock " + names_in(before, c.objects), {}};
    }
    StepTitle operator()(const Unlock& c) const
    {
        return {"Unlock " + names_in(before, c.objects), {}};
    }
    StepTitle operator()(const Delete& c) const
    {
        return {"Delete " + names_in(before, c.objects), {}};
    }
    StepTitle operator()(const Duplicate& c) const
    {
        const double distance = glm::length(c.offset);
        return {"Duplicate " + names_in(before, c.objects),
                distance > 0 ? in_metres(distance) : std::string()};
    }
    StepTitle operator()(const Group& c) const
    {
        return {"Group " + names_in(before, c.objects), c.name == "Group" ? "" : "as " + c.name};
    }
    StepTitle operator()(const Ungroup& c) const
    {
        return {"Ungroup " + name_in(before, c.object), {}};
    }
    StepTitle operator()(const Reorder& c) const
    {
        const std::string names = names_in(before, c.objects);
        const Object* first = c.objects.empty() ? nullptr : was(c.objects.front());
        if (!first || first->parent == c.parent) return {"Reorder " + names, {}};
        if (c.parent == 0)
            return {"Take " + names + " out of " + name_in(before, first->parent), {}};
        return {"Put " + names + " into " + name_in(before, c.parent), {}};
    }
    StepTitle operator()(const Place& c) const
    {
        const Object* object = was(c.object);
        const bool again = object && object->placement;
        return {"Place " + name_in(before, c.object) + (again ? " again" : "") +
                    support_of(c.object),
                c.parameters.width > 0 ? in_metres(c.parameters.width) : std::string()};
    }
    StepTitle operator()(const PlaceRound& c) const
    {
        return {"Lay " + name_in(before, c.object) + " round " + name_in(before, c.around), {}};
    }
    StepTitle operator()(const EditPlacement& c) const
    {
        const std::string name = name_in(before, c.object);
        const Object *a = was(c.object), *b = is(c.object);
        if (!a || !b || !a->placement || !b->placement) return {"Placement of " + name, {}};
        const Changes found = changes(a->placement->parameters, b->placement->parameters);
        if (!(a->placement->sketch == b->placement->sketch)) return {"Stroke of " + name, {}};
        if (found.empty() && a->placement->onto != b->placement->onto)
            return {"Lay " + name + support_of(c.object), {}};
        return title_of_changes(found, "Placement", name);
    }
    StepTitle operator()(const Unplace& c) const
    {
        return {"Take " + name_in(before, c.object) + " off its stroke", {}};
    }
    StepTitle operator()(const SetTravel& c) const
    {
        const std::string names = names_in(before, c.objects);
        const Object* object = c.objects.empty() ? nullptr : was(c.objects.front());
        const Travel old = object ? object->travel : Travel{};
        const Travel& now = c.travels.empty() ? c.travel : c.travels.front();
        const std::string speed = brief_number(now.speed) + " m/s";
        if (old.speed == 0 && now.speed != 0) return {"Let " + names + " travel", speed};
        if (old.speed != 0 && now.speed == 0) return {"Let " + names + " rest", {}};
        return title_of_changes(changes(old, now), "Travel", names);
    }
    StepTitle operator()(const PlayClip& c) const
    {
        const std::string names = names_in(before, c.objects);
        const Object* object = c.objects.empty() ? nullptr : was(c.objects.front());
        const Playing old = object ? object->playing : Playing{};
        const Playing& now = c.playings.empty() ? c.playing : c.playings.front();
        if (now.clip.empty()) return {"Let " + names + " stand", {}};
        if (old.clip != now.clip) return {"Let " + names + " play", now.clip};
        return title_of_changes(changes(old, now), "Clip", names);
    }
    StepTitle operator()(const Animate& c) const { return animated_title(before, c); }
    StepTitle operator()(const Refine& c) const
    {
        const Refining& now = c.refinings.empty() ? c.refining : c.refinings.front();
        return {"Refine " + names_in(before, c.objects), in_metres(now.tolerance)};
    }
    StepTitle operator()(const ClearRefine& c) const
    {
        return {"Give " + names_in(before, c.objects) + " its own triangles back", {}};
    }
    StepTitle operator()(const PressVolume& c) const
    {
        double amount = 0;
        for (const glm::dvec4& sample : c.press.samples) amount += sample.w;
        static constexpr std::array<const char*, 4> decays{"Gaussian", "Hat", "Box", "Smooth"};
        return {(amount < 0 ? "Pull " : "Press ") + name_in(before, c.object),
                fmt::format("{} {}", decays[static_cast<std::size_t>(c.press.decay)],
                            in_metres(c.press.radius))};
    }
    StepTitle operator()(const MovePoints& c) const
    {
        const std::size_t count = c.shift.points.size();
        const std::string points =
            count == 1 ? "a control point" : fmt::format("{} control points", count);
        return {"Move " + points + " of " + name_in(before, c.object),
                in_metres(glm::length(c.shift.by))};
    }
    StepTitle operator()(const InsertKnots& c) const
    {
        const std::size_t more =
            c.insertion.along.size() + c.insertion.across.size() + c.insertion.up.size();
        return {"Refine the volume of " + name_in(before, c.object),
                fmt::format("{} {}", more, more == 1 ? "knot" : "knots")};
    }
    StepTitle operator()(const CoarsenVolume& c) const
    {
        return {"Coarsen the volume of " + name_in(before, c.object),
                fmt::format("{} {}", c.coarsening.count, axis_name(c.coarsening.axis))};
    }
    StepTitle operator()(const MendVolume& c) const
    {
        return {"Mend the volume of " + name_in(before, c.object), {}};
    }
    StepTitle operator()(const AllowFolds& c) const
    {
        const std::string name = name_in(before, c.object);
        if (c.allowance.boxes.empty()) return {"Let " + name + " fold nowhere", {}};
        return {"Let " + name + " fold in places", {}};
    }
    StepTitle operator()(const WarpVolume& c) const
    {
        const Changes found = changes(Warp{.axis = c.warp.axis}, c.warp);
        const std::string name = name_in(before, c.object);
        if (found.size() != 1) return title_of_changes(found, "Bend", name);
        return {found[0].name + " " + name, found[0].value};
    }
    StepTitle operator()(const Unshape& c) const
    {
        return {"Take back the shaping of " + name_in(before, c.object), {}};
    }
    StepTitle operator()(const Paste&) const
    {
        std::vector<Id> ids;
        for (const auto& [id, each] : after.objects)
            if (id >= before.next_id && each->parent < before.next_id) ids.push_back(id);
        return {"Paste " + names_in(after, ids), {}};
    }
    StepTitle operator()(const SaveCamera& c) const
    {
        if (c.name == "picture") return {"Use this view for pictures", {}};
        return {(before.bookmarks.contains(c.name) ? "Aim " : "Keep ") + c.name, {}};
    }
    StepTitle operator()(const DeleteCamera& c) const { return {"Forget " + c.name, {}}; }
    StepTitle operator()(const SetRender& c) const
    {
        return title_of_changes(changes(*before.render, c.settings), "Picture settings", {});
    }
    StepTitle operator()(const AddLattice& c) const
    {
        return {"Put a lattice round " + names_in(before, c.objects),
                value_words(c.shape.grid, any_value)};
    }
    StepTitle operator()(const SetLattice& c) const
    {
        const Object* object = was(c.object);
        const auto* old = object ? std::get_if<LatticeShape>(&object->source) : nullptr;
        return title_of_changes(old ? changes(*old, c.shape) : Changes{}, "Lattice",
                                name_in(before, c.object));
    }
    StepTitle operator()(const SetTime& c) const
    {
        return title_of_changes(changes(before.time, c.time), "Frames", {});
    }
};

} // namespace

StepTitle step_title(const Command& command, const Document& before, const Document& after)
{
    return std::visit(Titles{before, after}, command);
}

} // namespace trivar
