// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/drawing/svg_update.h"

#include "core/drawing/drawn_svg.h"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <set>

namespace trivar {
namespace {

// Attributes of a line that go where a drawing does not give them: they were those of the line as
// it was, or put it somewhere else, or hide it. Its ends go only with dashes, which change them.
constexpr std::array<std::string_view, 12> outdated{"stroke-dasharray",
                                                    "stroke-dashoffset",
                                                    "stroke-linecap",
                                                    "opacity",
                                                    "transform",
                                                    "display",
                                                    "visibility",
                                                    "points",
                                                    "x1",
                                                    "y1",
                                                    "x2",
                                                    "y2"};

const std::string* value_in(const SvgAttributes& attributes, std::string_view name)
{
    const auto found = std::ranges::find(attributes, name, &SvgAttributes::value_type::first);
    return found == attributes.end() ? nullptr : &found->second;
}

// A style with the values that a line has, of what it tells and what `classes` tell of it.
std::string updated_style(std::string_view style, const std::string& classes,
                          const SvgAttributes& line)
{
    std::string out;
    std::set<std::string_view> told;
    const auto add = [&](std::string_view name, std::string_view value) {
        if (!told.insert(name).second) return;
        if (!out.empty()) out += ';';
        out.append(name).append(":").append(value);
    };
    for (const auto& [name, value] : style_properties(style)) {
        if (name == "display" || name == "visibility") continue;
        const std::string* own = value_in(line, name);
        add(name, own ? std::string_view(*own) : value);
    }
    for (const auto& [name, value] : style_properties(classes))
        if (const std::string* own = value_in(line, name)) add(name, *own);
    return out;
}

class SvgUpdate {
public:
    SvgUpdate(std::string_view text, DrawnSvg drawn, const SvgParts& parts)
        : text_(text),
          drawn_(std::move(drawn)),
          parts_(parts)
    {
        const std::string_view root = text_.substr(drawn_.elements[0].begin + 1);
        const std::size_t colon = root.find(':');
        if (colon < root.find_first_of(" \t\r\n/>")) prefix_ = root.substr(0, colon + 1);
        for (std::size_t i = 0; i < drawn_.elements.size(); ++i)
            if (drawn_.elements[i].name == "g")
                if (std::string id = attribute_of(tag(i), "id"); !id.empty())
                    groups_.emplace(std::move(id), i);
    }
    std::string operator()()
    {
        size();
        list();
        paper();
        for (const SvgLayer& layer : parts_.layers) put(layer);
        remove();
        return changed();
    }

private:
    struct Change {
        std::size_t begin, end;
        std::string text;
    };

    const SvgElement& element(std::size_t i) const { return drawn_.elements[i]; }
    std::string_view tag(std::size_t i) const
    {
        return text_.substr(element(i).begin, element(i).tag_end - element(i).begin);
    }
    void change(std::size_t begin, std::size_t end, std::string text)
    {
        if (text_.substr(begin, end - begin) != text)
            changes_.push_back({begin, end, std::move(text)});
    }
    // The beginning of the next line of text, where nothing else is in this one.
    std::size_t after(std::size_t end) const
    {
        const std::size_t at = text_.find_first_not_of(" \t\r", end);
        return at != text_.npos && text_[at] == '\n' ? at + 1 : end;
    }
    // The beginning of this line of text, where nothing else is before.
    std::size_t before(std::size_t begin) const
    {
        std::size_t at = begin;
        while (at > 0 && (text_[at - 1] == ' ' || text_[at - 1] == '\t')) --at;
        return at > 0 && text_[at - 1] == '\n' ? at : begin;
    }
    void remove(const SvgElement& e)
    {
        const std::size_t begin = before(e.begin), end = after(e.end);
        const bool alone = end > e.end && begin > 0 && text_[begin - 1] == '\n';
        change(alone ? begin : e.begin, alone ? end : e.end, {});
    }
    // Puts a text into a group, which may be one without an end.
    void put_into(std::size_t group, std::size_t at, const std::string& text)
    {
        if (element(group).is_empty())
            opened_[group] += text;
        else
            change(at, at, text);
    }
    std::size_t inside(std::size_t group) const { return after(element(group).tag_end); }
    std::optional<std::size_t> group(const std::string& id) const
    {
        const auto found = groups_.find(id);
        return found == groups_.end() ? std::nullopt : std::optional(found->second);
    }

    // The page follows the drawing unless a person gave it another size.
    void size()
    {
        const std::size_t begin = element(0).begin;
        const std::string width =
            drawn_.sheet ? drawn_.sheet->width : attribute_of(tag(0), "width");
        const std::string height =
            drawn_.sheet ? drawn_.sheet->height : attribute_of(tag(0), "height");
        const SvgAttributes old{{"width", width},
                                {"height", height},
                                {"viewBox", fmt::format("0 0 {} {}", width, height)}};
        for (const SvgAttribute& a : svg_attributes(tag(0))) {
            const std::string *was = value_in(old, a.name), *is = value_in(parts_.size, a.name);
            if (!was || !is) continue;
            const std::size_t at = begin + static_cast<std::size_t>(a.value.data() - tag(0).data());
            if (a.value == *was || a.value == *was + "px") change(at, at + was->size(), *is);
        }
    }
    void list()
    {
        if (!drawn_.list) {
            const std::size_t at = after(element(0).tag_end);
            return change(at, at, list_element());
        }
        const SvgElement& e = element(*drawn_.list);
        if (e.is_empty())
            change(e.begin, e.end, list_element());
        else
            change(e.tag_end, e.inner_end, parts_.list);
    }
    std::string list_element() const
    {
        return fmt::format("<{0}desc id=\"{1}\">{2}</{0}desc>\n", prefix_, line_list_id,
                           parts_.list);
    }
    // The paper has the colour of the drawing unless a person gave it another one or took it away.
    void paper()
    {
        const std::string was = drawn_.sheet ? drawn_.sheet->paper : "";
        if (!drawn_.paper) {
            if (!parts_.paper || (!was.empty() && was != "none")) return;
            const std::size_t at =
                after(drawn_.list ? element(*drawn_.list).end : element(0).tag_end);
            return change(at, at, paper_text(*parts_.paper, prefix_));
        }
        const SvgElement& e = element(*drawn_.paper);
        if (!was.empty() && look_of(tag(*drawn_.paper), "fill", drawn_.classes) != was) return;
        if (!parts_.paper) return remove(e);
        change(e.begin, e.tag_end, updated_tag(*drawn_.paper, {{"fill", *parts_.paper}}));
    }

    void put(const SvgLayer& layer)
    {
        const std::optional<std::size_t> own = group(layer.id);
        std::string left;
        for (const std::size_t which : {0u, 1u}) {
            const SvgGroup& part = layer.groups[which];
            const std::optional<std::size_t> there = group(part.id);
            SvgGroup rest{part.id, true};
            std::size_t at = there ? inside(*there) : 0;
            for (const SvgAttributes& path : part.paths) {
                const std::string& id = path.front().second;
                placed_.insert(id);
                const auto old = drawn_.paths.find(id);
                if (old != drawn_.paths.end()) {
                    update(old->second, path);
                    if (there && element(old->second).parent == *there)
                        at = after(element(old->second).end);
                } else if (there) {
                    put_into(*there, at, path_text(alone(path, *there), prefix_));
                } else {
                    rest.paths.push_back(path);
                }
            }
            if (part.is_needed) wanted_.insert(part.id);
            if (rest.paths.empty()) continue;
            if (own) {
                for (SvgAttributes& path : rest.paths) path = alone(path, *own);
                put_into(*own, which == 0 ? inside(*own) : element(*own).inner_end,
                         text_of(rest, prefix_));
            } else {
                left += text_of(rest, prefix_);
            }
        }
        wanted_.insert(layer.id);
        if (own) last_ = after(element(*own).end);
        if (own || left.empty()) return;
        SvgAttributes attributes = layer.attributes;
        if (attribute_of(tag(0), "xmlns:inkscape").empty())
            attributes.insert(attributes.begin(),
                              {"xmlns:inkscape", std::string(inkscape_namespace)});
        const std::size_t at = last_ ? *last_ : first_layer();
        change(at, at, fmt::format("<{0}g{1}>\n{2}</{0}g>\n", prefix_, text_of(attributes), left));
    }
    // A path for a group that may have lost what paths inherit from it.
    SvgAttributes alone(SvgAttributes path, std::size_t group) const
    {
        for (std::optional<std::size_t> at = group; at; at = element(*at).parent)
            if (const std::string fill = look_of(tag(*at), "fill", drawn_.classes); !fill.empty()) {
                if (fill == "none") return path;
                break;
            }
        for (const char* name : {"stroke-linejoin", "stroke-linecap"})
            if (!value_in(path, name)) path.insert(path.begin() + 1, {name, "round"});
        if (!value_in(path, "fill")) path.insert(path.begin() + 1, {"fill", "none"});
        return path;
    }
    std::size_t first_layer() const
    {
        std::size_t at = element(0).inner_end;
        for (const SvgLayer& layer : parts_.layers)
            if (const auto own = group(layer.id)) at = std::min(at, before(element(*own).begin));
        return at;
    }

    // The start tag of an element with other values of attributes, which may be new to it.
    std::string updated_tag(std::size_t i, const SvgAttributes& attributes) const
    {
        const std::string_view old = tag(i);
        const bool is_line = drawn_.paper != i, keeps_name = !is_line || element(i).name == "path";
        const bool is_dashed = !attribute_of(old, "stroke-dasharray").empty();
        const std::string classes = classes_of(i);
        std::string out = keeps_name ? "" : "<" + prefix_ + "path";
        std::size_t from = keeps_name ? 0 : old.find_first_of(" \t\r\n/>");
        std::set<std::string_view> told;
        bool styled = false;
        for (const SvgAttribute& a : svg_attributes(old)) {
            std::string value(a.value);
            bool goes = is_line && std::ranges::find(outdated, a.name) != outdated.end() &&
                        (is_dashed || a.name != "stroke-linecap");
            if (const std::string* own = value_in(attributes, a.name)) {
                told.insert(a.name);
                value = *own;
                goes = false;
            } else if (a.name == "style") {
                styled = true;
                const std::string style = unescaped(a.value);
                value = svg_escaped(updated_style(style, classes, attributes));
                goes = value.empty();
            }
            const std::size_t space = old.find_last_not_of(" \t\r\n", a.begin - 1) + 1;
            out += old.substr(from, (goes ? space : a.begin) - from);
            from = a.end;
            if (goes) continue;
            if (value == a.value)
                out += old.substr(a.begin, a.end - a.begin);
            else
                out.append(a.name).append("=\"").append(value).append("\"");
        }
        for (const auto& [name, value] : attributes)
            if (!told.contains(name)) out += text_of(SvgAttributes{{name, value}});
        if (const std::string style = updated_style({}, classes, attributes);
            !styled && !style.empty())
            out += text_of(SvgAttributes{{"style", svg_escaped(style)}});
        return out.append(old.substr(from));
    }
    // The properties that the classes of an element give to it.
    std::string classes_of(std::size_t i) const
    {
        std::string out;
        if (drawn_.classes.empty()) return out;
        const std::string names = " " + attribute_of(tag(i), "class") + " ";
        for (const auto& [name, style] : drawn_.classes)
            if (names.find(" " + name + " ") != names.npos) out += style;
        return out;
    }
    void update(std::size_t i, const SvgAttributes& line)
    {
        const SvgElement& e = element(i);
        change(e.begin, e.tag_end, updated_tag(i, line));
        if (e.name != "path" && !e.is_empty())
            change(e.inner_end, e.end, fmt::format("</{}path>", prefix_));
    }

    void remove()
    {
        std::set<std::size_t> gone;
        for (const auto& [id, i] : drawn_.paths)
            if (!placed_.contains(id) && !drawn_.off[i]) gone.insert(i);
        for (const std::size_t i : gone) remove(element(i));
        std::set<std::string> layers;
        for (const auto& [id, line] : drawn_.listed) layers.insert(line.layer);
        for (const std::string& layer : layers)
            for (const std::string& id : {layer, layer + "_hidden", layer + "_seen"})
                if (const auto own = group(id); own && !wanted_.contains(id) && empties(*own, gone))
                    remove(element(*own));
    }
    // Whether a group is as it was drawn and has only elements that are taken away, and groups
    // like it.
    bool empties(std::size_t i, const std::set<std::size_t>& gone) const
    {
        constexpr std::array<std::string_view, 6> drawn{
            "id",   "inkscape:groupmode", "inkscape:label",
            "fill", "stroke-linecap",     "stroke-linejoin"};
        for (const SvgAttribute& a : svg_attributes(tag(i)))
            if (std::ranges::find(drawn, a.name) == drawn.end()) return false;
        std::size_t at = element(i).tag_end;
        const auto only_spaces = [&](std::size_t end) {
            return std::min(text_.find_first_not_of(" \t\r\n", at), end) == end;
        };
        for (std::size_t k = i + 1; k < drawn_.elements.size() && element(k).begin < element(i).end;
             ++k) {
            if (element(k).parent != i) continue;
            const bool one_of_its =
                element(k).name == "g" && empties(k, gone) &&
                attribute_of(tag(k), "id").starts_with(attribute_of(tag(i), "id") + "_");
            if ((!gone.contains(k) && !one_of_its) || !only_spaces(element(k).begin)) return false;
            at = element(k).end;
        }
        return only_spaces(element(i).inner_end);
    }

    std::string changed()
    {
        for (const auto& [i, text] : opened_) {
            const std::string_view name = tag(i).substr(1, tag(i).find_first_of(" \t\r\n/>") - 1);
            change(element(i).tag_end - 2, element(i).tag_end,
                   fmt::format(">\n{}</{}>", text, name));
        }
        std::ranges::stable_sort(changes_, [](const Change& a, const Change& b) {
            if (a.begin != b.begin) return a.begin < b.begin;
            const bool puts_a = a.end == a.begin, puts_b = b.end == b.begin;
            return puts_a != puts_b ? puts_a : a.end > b.end;
        });
        std::string out;
        std::size_t at = 0;
        for (const Change& change : changes_) {
            if (change.begin < at) continue; // in what is taken away
            out.append(text_.substr(at, change.begin - at)).append(change.text);
            at = change.end;
        }
        return out.append(text_.substr(at));
    }

    std::string_view text_;
    DrawnSvg drawn_;
    const SvgParts& parts_;
    std::string prefix_;
    std::map<std::string, std::size_t> groups_; // by id
    std::vector<Change> changes_;
    std::map<std::size_t, std::string> opened_; // what comes into groups without an end
    std::set<std::string> placed_, wanted_;     // ids of paths and groups
    std::optional<std::size_t> last_;           // where the last layer ends
};

} // namespace

std::string updated_svg(std::string_view earlier, const SvgParts& parts)
{
    std::optional<DrawnSvg> drawn = drawn_svg(earlier);
    return drawn ? SvgUpdate(earlier, std::move(*drawn), parts)() : std::string();
}

} // namespace trivar
