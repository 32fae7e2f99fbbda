// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/words/markdown.h"

#include <md4c.h>

namespace trivar {
namespace {

std::string text_of(const MD_ATTRIBUTE& attribute)
{
    return {attribute.text, attribute.size};
}

// A Reader collects the parser's events in their order.
struct Reader {
    std::vector<Block> blocks;
    std::vector<int> next_numbers; // of the lists we are in; 0: dots
    Block block;
    int strong = 0;
    bool code = false, in_item = false;
    std::string link, picture;

    void begin(Block::Kind kind)
    {
        block = {};
        block.kind = kind;
    }
    void end()
    {
        const bool empty = block.runs.empty() && block.cells.empty() && block.text.empty();
        if (!empty) blocks.push_back(std::move(block));
        block = {};
    }

    void enter(MD_BLOCKTYPE type, void* detail)
    {
        switch (type) {
        case MD_BLOCK_H:
            begin(Block::Kind::heading);
            block.level = static_cast<int>(static_cast<MD_BLOCK_H_DETAIL*>(detail)->level);
            break;
        case MD_BLOCK_UL:
        case MD_BLOCK_OL:
            end(); // the item that the list stands in
            next_numbers.push_back(
                type == MD_BLOCK_UL
                    ? 0
                    : static_cast<int>(static_cast<MD_BLOCK_OL_DETAIL*>(detail)->start));
            break;
        case MD_BLOCK_LI:
            begin(Block::Kind::item);
            block.level = static_cast<int>(next_numbers.size());
            if (next_numbers.back() > 0) block.number = next_numbers.back()++;
            in_item = true;
            break;
        case MD_BLOCK_P:
            if (!in_item) begin(Block::Kind::paragraph);
            break;
        case MD_BLOCK_CODE: begin(Block::Kind::code); break;
        case MD_BLOCK_TR: begin(Block::Kind::row); break;
        case MD_BLOCK_TH: block.header = true; [[fallthrough]];
        case MD_BLOCK_TD: block.cells.emplace_back(); break;
        default: break;
        }
    }

    void leave(MD_BLOCKTYPE type)
    {
        switch (type) {
        case MD_BLOCK_UL:
        case MD_BLOCK_OL: next_numbers.pop_back(); break;
        case MD_BLOCK_LI: in_item = false; [[fallthrough]];
        case MD_BLOCK_H:
        case MD_BLOCK_CODE:
        case MD_BLOCK_TR: end(); break;
        case MD_BLOCK_P:
            if (!in_item) end();
            break;
        default: break;
        }
    }

    void enter(MD_SPANTYPE type, void* detail)
    {
        if (type == MD_SPAN_STRONG || type == MD_SPAN_EM) ++strong;
        if (type == MD_SPAN_CODE) code = true;
        if (type == MD_SPAN_A) link = text_of(static_cast<MD_SPAN_A_DETAIL*>(detail)->href);
        if (type == MD_SPAN_IMG) {
            block.kind = Block::Kind::picture;
            block.text = picture = text_of(static_cast<MD_SPAN_IMG_DETAIL*>(detail)->src);
        }
    }

    void leave(MD_SPANTYPE type)
    {
        if (type == MD_SPAN_STRONG || type == MD_SPAN_EM) --strong;
        if (type == MD_SPAN_CODE) code = false;
        if (type == MD_SPAN_A) link.clear();
        if (type == MD_SPAN_IMG) picture.clear();
    }

    void add(std::string_view text)
    {
        if (block.kind == Block::Kind::code) {
            block.text += text;
            return;
        }
        std::vector<ui::Run>& runs = block.cells.empty() ? block.runs : block.cells.back();
        const ui::Run::Kind kind = code            ? ui::Run::Kind::key
                                   : !link.empty() ? ui::Run::Kind::link
                                   : strong > 0    ? ui::Run::Kind::strong
                                                   : ui::Run::Kind::plain;
        if (!runs.empty() && runs.back().kind == kind && runs.back().target == link)
            runs.back().text += text;
        else
            runs.push_back({kind, std::string(text), link});
    }
};

Reader& reader(void* user)
{
    return *static_cast<Reader*>(user);
}

} // namespace

std::vector<Block> blocks_of(std::string_view markdown)
{
    Reader read;
    MD_PARSER parser{};
    parser.flags = MD_FLAG_TABLES | MD_FLAG_NOHTML;
    parser.enter_block = [](MD_BLOCKTYPE type, void* detail, void* user) {
        reader(user).enter(type, detail);
        return 0;
    };
    parser.leave_block = [](MD_BLOCKTYPE type, void*, void* user) {
        reader(user).leave(type);
        return 0;
    };
    parser.enter_span = [](MD_SPANTYPE type, void* detail, void* user) {
        reader(user).enter(type, detail);
        return 0;
    };
    parser.leave_span = [](MD_SPANTYPE type, void*, void* user) {
        reader(user).leave(type);
        return 0;
    };
    parser.text = [](MD_TEXTTYPE type, const MD_CHAR* text, MD_SIZE size, void* user) {
        const bool line_break = type == MD_TEXT_BR || type == MD_TEXT_SOFTBR;
        reader(user).add(line_break ? std::string_view(" ") : std::string_view(text, size));
        return 0;
    };
    md_parse(markdown.data(), static_cast<MD_SIZE>(markdown.size()), &parser, &read);
    return std::move(read.blocks);
}

std::string plain_text(const std::vector<ui::Run>& runs)
{
    std::string words;
    for (const ui::Run& run : runs) words += run.text;
    return words;
}

} // namespace trivar
