// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/help/manual.h"

#include "core/base/rejected.h"
#include "core/base/text.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>

namespace trivar {
namespace {

constexpr std::array<std::string_view, 13> order{
    "start",    "place",       "select", "move-rotate-scale", "outliner",
    "timeline", "animate",     "record", "history-and-log",   "files",
    "picture",  "preferences", keys_page};

std::string lowered(std::string_view text)
{
    std::string result(text);
    for (char& c : result) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return result;
}

std::string words_in(const Block& block)
{
    std::string words = plain_text(block.runs) + block.text;
    for (const auto& cell : block.cells) words += plain_text(cell) + "  ";
    return words;
}

bool holds_all(const std::string& text, std::string_view words)
{
    const std::string in = lowered(text);
    while (!words.empty()) {
        const std::size_t end = std::min(words.find(' '), words.size());
        if (in.find(lowered(words.substr(0, end))) == in.npos) return false;
        words.remove_prefix(std::min(end + 1, words.size()));
    }
    return true;
}

} // namespace

std::vector<ManualPage> manual_in(const std::string& folder)
{
    std::vector<ManualPage> pages;
    std::error_code ignored;
    for (const auto& each : std::filesystem::directory_iterator(folder, ignored)) {
        if (each.path().extension() != ".md") continue;
        ManualPage page{each.path().stem().string(), {}, {}};
        try {
            page.blocks = blocks_of(read_text_file(each.path().string()));
        } catch (const Rejected&) { // one page less
            continue;
        }
        page.title = page.name;
        if (!page.blocks.empty() && page.blocks.front().kind == Block::Kind::heading) {
            page.title = plain_text(page.blocks.front().runs);
            page.blocks.erase(page.blocks.begin());
        }
        for (Block& block : page.blocks)
            if (block.kind == Block::Kind::picture)
                block.text =
                    (std::filesystem::path(folder) / block.text).lexically_normal().string();
        pages.push_back(std::move(page));
    }
    const auto rank = [](const ManualPage& page) {
        const auto at = std::ranges::find(order, page.name);
        // Pages without a stated order come before the keys.
        return at == order.end() ? std::ssize(order) * 2 - 3 : 2 * (at - order.begin());
    };
    std::ranges::sort(pages, [&](const ManualPage& a, const ManualPage& b) {
        return rank(a) != rank(b) ? rank(a) < rank(b) : a.name < b.name;
    });
    return pages;
}

const ManualPage* page_of(const std::vector<ManualPage>& pages, std::string_view name)
{
    const auto found = std::ranges::find(pages, name, &ManualPage::name);
    return found == pages.end() ? nullptr : &*found;
}

std::string linked_page(std::string_view target)
{
    target = target.substr(0, target.find('#'));
    if (!target.ends_with(".md") || target.find('/') != target.npos) return {};
    return std::string(target.substr(0, target.size() - 3));
}

std::vector<FoundPassage> found_in(const std::vector<ManualPage>& pages, std::string_view words)
{
    std::vector<FoundPassage> found;
    for (const ManualPage& page : pages) {
        if (holds_all(page.title, words)) {
            found.push_back({page.name, page.title, 0});
            continue;
        }
        std::optional<FoundPassage> best;
        for (std::size_t i = 0; i < page.blocks.size(); ++i) {
            const std::string text = words_in(page.blocks[i]);
            if (!holds_all(text, words)) continue;
            const bool heading = page.blocks[i].kind == Block::Kind::heading;
            if (!best || heading) best = FoundPassage{page.name, text, i};
            if (heading) break;
        }
        if (best) found.push_back(*best);
    }
    return found;
}

} // namespace trivar
