// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/drawing/drawn_svg.h"

#include <algorithm>
#include <array>
#include <set>
#include <span>

namespace trivar {
namespace {

bool is_one_of(std::string_view name, std::span<const std::string_view> names)
{
    return std::ranges::find(names, name) != names.end();
}

// The shapes that programs write for a path of straight pieces.
constexpr std::array<std::string_view, 4> shapes{"path", "polyline", "polygon", "line"};
// Elements of which nothing is drawn where they stand.
constexpr std::array<std::string_view, 12> not_drawn{"defs",   "clipPath", "mask",      "pattern",
                                                     "symbol", "marker",   "style",     "metadata",
                                                     "title",  "desc",     "namedview", "script"};

class DrawnReader {
public:
    explicit DrawnReader(std::string_view text) : text_(text) {}
    std::optional<DrawnSvg> operator()()
    {
        out_.elements = svg_elements(text_);
        out_.classes = svg_classes(text_, out_.elements);
        const std::size_t count = out_.elements.size();
        for (std::size_t i = 0; i < count; ++i) ids_.push_back(attribute_of(tag(i), "id"));
        for (std::size_t i = 0; i < count && !out_.list; ++i)
            if (ids_[i] == line_list_id) out_.list = i;
        if (out_.list) {
            const SvgElement& list = out_.elements[*out_.list];
            const std::string words =
                unescaped(text_.substr(list.tag_end, list.inner_end - list.tag_end));
            out_.listed = listed_lines(words);
            out_.sheet = listed_sheet(words);
        }
        look();
        if (!out_.list && out_.paths.empty()) return std::nullopt;
        return std::move(out_);
    }

private:
    enum class Whose { ours, own, own_inside, undrawn };

    std::string_view tag(std::size_t i) const
    {
        const SvgElement& e = out_.elements[i];
        return text_.substr(e.begin, e.tag_end - e.begin);
    }
    void look()
    {
        std::vector<Whose> whose;
        for (std::size_t i = 0; i < out_.elements.size(); ++i) {
            const SvgElement& e = out_.elements[i];
            out_.off.push_back((e.parent && out_.off[*e.parent]) ||
                               look_of(tag(i), "display", out_.classes) == "none" ||
                               look_of(tag(i), "visibility", out_.classes) == "hidden");
            const Whose around = e.parent ? whose[*e.parent] : Whose::ours;
            Whose own = around == Whose::undrawn || is_one_of(e.name, not_drawn) ? Whose::undrawn
                        : around == Whose::ours                                  ? Whose::own
                                                : Whose::own_inside;
            if (own != Whose::undrawn && is_ours(i)) own = Whose::ours;
            if (own == Whose::own) ++out_.own;
            if (own == Whose::own) own = Whose::own_inside;
            whose.push_back(own);
        }
    }
    bool is_ours(std::size_t i)
    {
        const SvgElement& e = out_.elements[i];
        if (!e.parent) return true;
        if (is_paper(i)) {
            out_.paper = i;
            return true;
        }
        if (is_one_of(e.name, shapes) && is_line(i))
            return out_.paths.emplace(ids_[i], i).second; // of a copy with the same id, the first
        return e.name == "g" && is_group(ids_[i]);
    }
    bool is_paper(std::size_t i) const
    {
        if (out_.paper || out_.elements[i].name != "rect") return false;
        if (ids_[i] == paper_id) return true;
        return out_.list && !out_.sheet && out_.elements[i].parent == 0 && // of earlier versions
               attribute_of(tag(i), "width") == "100%" && attribute_of(tag(i), "height") == "100%";
    }
    bool is_line(std::size_t i) const
    {
        const std::string id = without_number(ids_[i]);
        if (out_.list) return out_.listed.contains(id);
        const std::optional<std::string> layer = layer_of_line(id);
        for (auto at = out_.elements[i].parent; layer && at; at = out_.elements[*at].parent)
            if (out_.elements[*at].name == "g" && ids_[*at] == *layer) return true;
        return false;
    }
    // Whether an id is that of a layer's group, or of the hidden or seen lines in it.
    bool is_group(const std::string& id)
    {
        if (layers_.empty())
            for (const auto& [line, listed] : out_.listed) layers_.insert(listed.layer);
        const std::size_t dash = id.rfind('_');
        return layers_.contains(id) || (dash != id.npos && layers_.contains(id.substr(0, dash)));
    }

    std::string_view text_;
    std::vector<std::string> ids_;
    std::set<std::string> layers_;
    DrawnSvg out_;
};

} // namespace

std::optional<DrawnSvg> drawn_svg(std::string_view text)
{
    return DrawnReader(text)();
}

std::string without_number(const std::string& id)
{
    const std::size_t at = id.rfind('_');
    const bool numbered = at != id.npos && at + 1 < id.size() &&
                          std::all_of(id.begin() + static_cast<std::ptrdiff_t>(at) + 1, id.end(),
                                      [](char c) { return c >= '0' && c <= '9'; });
    return numbered ? id.substr(0, at) : id;
}

} // namespace trivar
