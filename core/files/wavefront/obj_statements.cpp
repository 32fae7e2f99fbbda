// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/wavefront/obj_statements.h"

#include "core/base/rejected.h"
#include "core/files/file_bytes.h"
#include "core/files/file_sentences.h"
#include "core/files/text_scan.h"
#include "core/files/wavefront/wavefront_names.h"

#include <algorithm>
#include <fmt/format.h>
#include <map>
#include <optional>
#include <set>

namespace trivar {
namespace {

class ObjStatements {
public:
    ObjStatements(Model& model, Mesh& mesh, const std::vector<std::uint32_t>& first_of,
                  const FileText& file, const PlainText& plain)
        : model_(model),
          mesh_(mesh),
          first_of_(first_of),
          file_(file),
          plain_(plain),
          files_(file.folder)
    {
    }

    // Reads the libraries first, because some files name them after their use.
    void read_libraries(const std::vector<ObjBlock>& blocks)
    {
        NameList missing, other_case;
        for (const ObjBlock& block : blocks)
            for (const ObjEvent& event : block.events) {
                if (event.kind != ObjEvent::Kind::library) continue;
                const NamedLibraries named = libraries_named(event.text, files_);
                for (const NamedFile& library : named.found) {
                    if (!libraries_.insert(library.path).second) continue;
                    if (library.in_other_case) other_case.add(library.name);
                    read_library(library);
                }
                for (const std::string_view name : named.missing)
                    if (missing_.emplace(name).second) missing.add(name);
            }
        if (missing.count() > 0)
            say(fmt::format(
                "{} not in its folder: {}",
                counted(missing.count(), "material library is", "material libraries are"),
                missing.text()));
        if (other_case.count() > 0)
            say(fmt::format(
                "{} named with other capitals than in the folder: {}",
                counted(other_case.count(), "material library is", "material libraries are"),
                other_case.text()));
    }

    void apply(const ObjBlock& block)
    {
        GapCursor faces{block.left_out}, lines{block.lines_left_out};
        const auto count = [](const auto& all) { return static_cast<std::uint32_t>(all.size()); };
        for (const ObjEvent& event : block.events) {
            go_on(faces, event.face, lines, event.line);
            handle(event);
        }
        go_on(faces, count(block.face_end), lines, count(block.line_end));
    }

    ObjAttributes finish() // completes the mesh

    {
        const auto unset = [](std::uint32_t i) { return i == none; };
        const auto plain = static_cast<std::uint32_t>(model_.materials.size());
        bool plain_used = false;
        for (auto* materials : {&mesh_.face_material, &line_material_}) {
            if (plain == 0) materials->clear();
            plain_used = plain_used || std::ranges::any_of(*materials, unset);
            std::ranges::replace(*materials, none, plain);
        }
        if (plain_used) // vertex colours are used unchanged
            model_.materials.push_back(mesh_.colors.empty() ? unpainted() : Material());
        auto& groups = mesh_.face_group;
        if (mesh_.group_names.empty()) {
            groups.clear();
        } else if (std::any_of(groups.begin(), groups.end(), unset)) {
            std::replace(groups.begin(), groups.end(), none,
                         static_cast<std::uint32_t>(mesh_.group_names.size()));
            mesh_.group_names.emplace_back("default");
        }
        if (undefined_.count() > 0)
            say(fmt::format("{} used and not defined: {}",
                            counted(undefined_.count(), "material is", "materials are"),
                            undefined_.text()));
        if (bad_tags_ > 0)
            say(fmt::format(
                "{} left out; the first, on line {}, {}",
                counted(bad_tags_, "crease or corner tag was", "crease and corner tags were"),
                first_bad_line_, first_bad_tag_));
        return {std::move(line_material_), std::move(smoothing_of_)};
    }

private:
    static constexpr std::uint32_t none = ~0u;

    // A GapCursor walks over the faces, or lines, of a block and knows which ones were left out.
    struct GapCursor {
        const std::vector<std::uint32_t>& out;
        std::size_t gone = 0;
        std::uint32_t at = 0;
        bool next_is_there() // advances by one
        {
            const bool there = gone == out.size() || out[gone] != at;
            if (!there) ++gone;
            ++at;
            return there;
        }
    };

    // Applies the current state to all elements before the next statement.
    void go_on(GapCursor& faces, std::uint32_t face_end, GapCursor& lines, std::uint32_t line_end)
    {
        while (faces.at < face_end) {
            if (!faces.next_is_there()) continue;
            if (group_ == none && group_named_) group_ = group(group_name_);
            mesh_.face_material.push_back(material_);
            mesh_.face_group.push_back(group_);
        }
        if (smoothing_) smoothing_of_.resize(mesh_.face_material.size(), *smoothing_);
        while (lines.at < line_end)
            if (lines.next_is_there()) line_material_.push_back(material_);
    }

    void say(const std::string& what)
    {
        model_.notices.push_back(fmt::format("{}: {}", file_.name, what));
    }

    void read_library(const NamedFile& library)
    {
        Mtl mtl;
        try {
            const std::string bytes = read_bytes(library.path, max_mtl_bytes);
            mtl = read_mtl({bytes, library.name, file_.folder});
        } catch (const Rejected& rejected) {
            model_.notices.push_back(
                fmt::format("{}; its materials were left out", rejected.what()));
        }
        for (Material& material : mtl.materials) {
            const auto index = static_cast<std::uint32_t>(model_.materials.size());
            if (materials_.emplace(material.name, index).second)
                model_.materials.push_back(std::move(material));
        }
        model_.notices.insert(model_.notices.end(), mtl.notices.begin(), mtl.notices.end());
    }

    void handle(const ObjEvent& event)
    {
        using Kind = ObjEvent::Kind;
        if (event.kind == Kind::material) material_ = material(std::string(event.text));
        if (event.kind == Kind::group || event.kind == Kind::object) {
            // A group is listed when it gets a face: the name of an object is often followed at
            // once by that of a group.
            group_name_ = event.text;
            group_named_ = true;
            group_ = none;
        }
        if (event.kind == Kind::tag) add_tag(event.text);
        if (event.kind == Kind::smoothing) {
            smoothing_of_.resize(mesh_.face_material.size(), 0);
            const double number = TextScan(event.text).number().value_or(0); // none: "off"
            smoothing_ = static_cast<std::uint32_t>(std::clamp(number, 0.0, 4294967295.0));
        }
    }

    std::uint32_t material(const std::string& name)
    {
        const auto next = static_cast<std::uint32_t>(model_.materials.size());
        const auto [at, added] = materials_.emplace(name, next);
        if (added) {
            undefined_.add(name);
            model_.materials.push_back(unpainted());
            model_.materials.back().name = name;
        }
        return at->second;
    }

    std::uint32_t group(const std::string& name)
    {
        const auto next = static_cast<std::uint32_t>(mesh_.group_names.size());
        const auto [at, added] = groups_.emplace(name, next);
        if (added) mesh_.group_names.push_back(name);
        return at->second;
    }

    // Reads the tags of OpenSubdiv: crease 2/1/0 A B SHARPNESS and corner 1/1/0 A SHARPNESS,
    // vertices from 0.
    void add_tag(std::string_view text)
    {
        TextScan scan(text);
        const std::string_view kind = scan.word();
        if (kind != "crease" && kind != "corner") return;
        scan.word();
        std::uint32_t ends[2]{};
        bool used = true;
        for (int i = 0; i < (kind == "crease" ? 2 : 1); ++i) {
            scan.skip_blanks();
            const auto v = scan.integer();
            if (!v || *v < 0 || static_cast<std::size_t>(*v) + 1 >= first_of_.size())
                return leave_out(text, "names a vertex that is not there; tags count from 0");
            const auto at = static_cast<std::size_t>(*v);
            used &= first_of_[at] != first_of_[at + 1]; // by a face
            ends[i] = first_of_[at];
            if (kind == "corner") ends[1] = ends[0];
        }
        const auto sharpness = scan.number();
        if (!sharpness || *sharpness < 0)
            return leave_out(text, "has no sharpness, a number from 0 up");
        if (used) mesh_.creases.push_back({ends[0], ends[1], static_cast<float>(*sharpness)});
    }

    void leave_out(std::string_view tag, const char* why)
    {
        if (bad_tags_++ > 0) return;
        first_bad_line_ = plain_.line_of(tag.data());
        first_bad_tag_ = why;
    }

    static constexpr std::uintmax_t max_mtl_bytes = 64 << 20;
    Model& model_;
    Mesh& mesh_;
    std::vector<std::uint32_t> line_material_, smoothing_of_; // by line, by face
    const std::vector<std::uint32_t>& first_of_;
    const FileText& file_;
    const PlainText& plain_;
    FolderFiles files_;
    std::map<std::string, std::uint32_t> materials_, groups_;
    std::set<std::string> libraries_, missing_;
    NameList undefined_;
    std::uint32_t material_ = none, group_ = none;
    std::string group_name_;
    std::optional<std::uint32_t> smoothing_; // group; before the first one faces have none: 0
    bool group_named_ = false;
    std::size_t bad_tags_ = 0, first_bad_line_ = 0;
    const char* first_bad_tag_ = "";
};

} // namespace

ObjAttributes add_obj_statements(Model& model, Mesh& mesh, const std::vector<ObjBlock>& blocks,
                                 const std::vector<std::uint32_t>& first_of, const FileText& file,
                                 const PlainText& plain)
{
    ObjStatements statements(model, mesh, first_of, file, plain);
    statements.read_libraries(blocks);
    for (const ObjBlock& block : blocks) statements.apply(block);
    return statements.finish();
}

} // namespace trivar
