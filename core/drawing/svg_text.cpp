// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/drawing/svg_text.h"

#include "core/base/rejected.h"

#include <charconv>
#include <utility>

namespace trivar {
namespace {

constexpr std::size_t deepest = 1000, most_elements = 4'000'000, longest_entity = 1000;
constexpr std::string_view spaces = " \t\r\n";

[[noreturn]] void broken(const char* why)
{
    throw Rejected(std::string("it is no .svg: ") + why);
}

std::string_view trimmed(std::string_view s)
{
    const std::size_t first = s.find_first_not_of(spaces);
    if (first == s.npos) return {};
    return s.substr(first, s.find_last_not_of(spaces) + 1 - first);
}

std::string_view local_name(std::string_view name)
{
    return name.substr(name.find(':') + 1); // of npos: all of it
}

// SvgReader goes through a text once, from `at_`.
class SvgReader {
public:
    explicit SvgReader(std::string_view text) : text_(text) {}
    std::vector<SvgElement> operator()()
    {
        if (text_.find('\0') != text_.npos) broken("it is not in UTF-8");
        while ((at_ = text_.find('<', at_)) != text_.npos) {
            if (here("<!--"))
                pass("-->");
            else if (here("<![CDATA["))
                pass("]]>");
            else if (here("<?"))
                pass("?>");
            else if (here("<!"))
                pass_doctype();
            else if (here("</"))
                close();
            else
                open();
        }
        if (out_.empty()) broken("it has no elements");
        if (!open_.empty()) broken("an element has no end");
        if (out_.front().name != "svg") broken("its outermost element is no <svg>");
        return std::move(out_);
    }

private:
    bool here(std::string_view words) const { return text_.substr(at_).starts_with(words); }
    void pass(std::string_view words)
    {
        at_ = text_.find(words, at_ + 2);
        if (at_ == text_.npos) broken("it ends too early");
        at_ += words.size();
    }
    // The quoted text that begins here.
    std::string_view quoted()
    {
        const std::size_t begin = at_ + 1, end = text_.find(text_[at_], begin);
        if (end == text_.npos) broken("a quotation has no end");
        at_ = end + 1;
        return text_.substr(begin, end - begin);
    }
    void pass_doctype()
    {
        int inside = 0; // of declarations
        bool of_entity = false;
        do {
            if (at_ >= text_.size()) broken("it ends too early");
            const char c = text_[at_];
            if (here("<!--")) {
                pass("-->");
                continue;
            }
            if (here("<!ENTITY")) of_entity = true;
            if (c == '"' || c == '\'') {
                const std::string_view value = quoted();
                if (of_entity &&
                    (value.size() > longest_entity || value.find_first_of("&%<") != value.npos))
                    throw Rejected("it defines entities by other entities, which are not read");
                continue;
            }
            if (of_entity && (c == '%' || here("SYSTEM") || here("PUBLIC")))
                throw Rejected("it defines entities by files, which are not read");
            if (c == '<') ++inside;
            if (c == '>') {
                --inside;
                of_entity = false;
            }
            ++at_;
        } while (inside > 0);
    }
    void close()
    {
        const std::size_t begin = at_;
        pass(">");
        if (open_.empty()) broken("an end stands before its beginning");
        const std::string_view name = trimmed(text_.substr(begin + 2, at_ - begin - 3));
        SvgElement& element = out_[open_.back()];
        if (name != full_name(element)) broken("its elements overlap");
        element.inner_end = begin;
        element.end = at_;
        open_.pop_back();
    }
    std::string_view full_name(const SvgElement& element) const
    {
        const std::size_t begin = element.begin + 1;
        return text_.substr(begin, text_.find_first_of(" \t\r\n/>", begin) - begin);
    }
    void open()
    {
        if (open_.empty() && !out_.empty()) broken("it has several outermost elements");
        if (open_.size() == deepest) throw Rejected("its elements are nested more than 1,000 deep");
        if (out_.size() == most_elements) throw Rejected("it has more than 4 million elements");
        SvgElement element;
        element.begin = at_;
        if (!open_.empty()) element.parent = open_.back();
        element.name = local_name(full_name(element));
        if (element.name.empty()) broken("a bracket stands in its text");
        for (++at_;; ++at_) {
            at_ = text_.find_first_of("\"'>", at_);
            if (at_ == text_.npos) broken("it ends too early");
            if (text_[at_] == '>') break;
            quoted();
            --at_;
        }
        const bool is_empty = text_[at_ - 1] == '/';
        ++at_;
        element.tag_end = element.inner_end = element.end = at_;
        check_attributes(text_.substr(element.begin, at_ - element.begin));
        if (!is_empty) open_.push_back(out_.size());
        out_.push_back(element);
    }
    static void check_attributes(std::string_view tag)
    {
        for (const SvgAttribute& attribute : svg_attributes(tag))
            if (attribute.value.find('<') != attribute.value.npos)
                broken("a bracket stands in a value");
    }

    std::string_view text_;
    std::size_t at_ = 0;
    std::vector<SvgElement> out_;
    std::vector<std::size_t> open_; // their numbers
};

} // namespace

std::vector<SvgElement> svg_elements(std::string_view text)
{
    return SvgReader(text)();
}

std::vector<SvgAttribute> svg_attributes(std::string_view tag)
{
    std::vector<SvgAttribute> out;
    std::size_t at = tag.find_first_of(" \t\r\n/>");
    while ((at = tag.find_first_not_of(spaces, at)) != tag.npos) {
        if (tag[at] == '>' || tag.substr(at) == "/>") return out;
        SvgAttribute one;
        one.begin = at;
        const std::size_t equals = tag.find('=', at), quote = tag.find_first_of("\"'", at);
        if (equals == tag.npos || quote == tag.npos || quote < equals ||
            !trimmed(tag.substr(equals + 1, quote - equals - 1)).empty())
            broken("an attribute has no value");
        one.name = trimmed(tag.substr(at, equals - at));
        if (one.name.empty() || one.name.find_first_of(spaces) != one.name.npos)
            broken("an attribute has no value");
        if (one.name.find_first_of("\"'#,;()/&<>") != one.name.npos)
            broken("an attribute has no name");
        const std::size_t end = tag.find(tag[quote], quote + 1);
        if (end == tag.npos) broken("a quotation has no end");
        one.value = tag.substr(quote + 1, end - quote - 1);
        at = one.end = end + 1;
        out.push_back(one);
    }
    broken("it ends too early");
}

std::string unescaped(std::string_view raw)
{
    constexpr std::pair<std::string_view, char> named[] = {
        {"&lt;", '<'}, {"&gt;", '>'}, {"&amp;", '&'}, {"&quot;", '"'}, {"&apos;", '\''}};
    std::string out;
    while (!raw.empty()) {
        std::size_t length = 1;
        char letter = raw.front();
        for (const auto& [words, c] : named)
            if (raw.starts_with(words)) {
                letter = c;
                length = words.size();
            }
        if (raw.starts_with("&#")) {
            const bool hex = raw.substr(2).starts_with('x');
            unsigned number = 0;
            const char* begin = raw.data() + (hex ? 3 : 2);
            const auto [at, trouble] =
                std::from_chars(begin, raw.data() + raw.size(), number, hex ? 16 : 10);
            if (trouble == std::errc() && at < raw.data() + raw.size() && *at == ';' &&
                number < 0x80) { // others stay as they are: no id or style here has them
                letter = static_cast<char>(number);
                length = static_cast<std::size_t>(at + 1 - raw.data());
            }
        }
        out += letter;
        raw.remove_prefix(length);
    }
    return out;
}

std::vector<std::pair<std::string_view, std::string_view>> style_properties(std::string_view style)
{
    std::vector<std::pair<std::string_view, std::string_view>> out;
    for (std::size_t at = 0; at < style.size();) {
        const std::size_t end = std::min(style.find(';', at), style.size());
        const std::string_view one = style.substr(at, end - at);
        at = end + 1;
        const std::size_t colon = one.find(':');
        if (colon != one.npos)
            out.emplace_back(trimmed(one.substr(0, colon)), trimmed(one.substr(colon + 1)));
    }
    return out;
}

SvgClasses svg_classes(std::string_view text, const std::vector<SvgElement>& elements)
{
    SvgClasses out;
    for (const SvgElement& element : elements) {
        if (element.name != "style") continue;
        std::string_view rules = text.substr(element.tag_end, element.inner_end - element.tag_end);
        if (const std::size_t data = rules.find("<![CDATA["); data != rules.npos)
            rules = rules.substr(data + 9, rules.find("]]>") - data - 9);
        for (std::size_t at = 0; at < rules.size();) {
            const std::size_t open = rules.find('{', at), end = rules.find('}', at);
            if (open == rules.npos || end == rules.npos || end < open) break;
            std::string_view names = rules.substr(at, open - at);
            while (!names.empty()) {
                const std::size_t comma = std::min(names.find(','), names.size());
                const std::string_view name = trimmed(names.substr(0, comma));
                if (name.starts_with('.') && name.find_first_of(" \t\r\n.:>[#", 1) == name.npos)
                    out[std::string(name.substr(1))]
                        .append(rules.substr(open + 1, end - open - 1))
                        .append(";");
                names.remove_prefix(std::min(comma + 1, names.size()));
            }
            at = end + 1;
        }
    }
    return out;
}

std::string attribute_of(std::string_view tag, std::string_view name)
{
    for (const SvgAttribute& attribute : svg_attributes(tag))
        if (attribute.name == name) return unescaped(attribute.value);
    return {};
}

std::string look_of(std::string_view tag, std::string_view property, const SvgClasses& classes)
{
    std::string out;
    const auto take = [&](std::string_view style) { // the last one counts
        for (const auto& [name, value] : style_properties(style))
            if (name == property) out = value;
    };
    take(attribute_of(tag, "style"));
    if (!out.empty()) return out;
    if (!classes.empty()) {
        std::string names = attribute_of(tag, "class") + " ";
        for (std::size_t at = 0; at < names.size();) {
            const std::size_t end = names.find_first_of(spaces, at);
            const auto found = classes.find(std::string_view(names).substr(at, end - at));
            if (found != classes.end()) take(found->second);
            at = end + 1;
        }
    }
    return out.empty() ? attribute_of(tag, property) : out;
}

} // namespace trivar
