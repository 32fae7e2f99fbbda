// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/session/outline.h"

#include "core/base/rejected.h"
#include "editor/session/selection.h"
#include "editor/words/letters_in_order.h"
#include "ui/icons.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>

namespace trivar {
namespace {

std::string in_small_letters(std::string text)
{
    for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return text;
}

// A Filter is the text that a person typed: words that begin with "type:", and letters.
struct Filter {
    std::vector<std::string> types;
    std::string letters;

    explicit Filter(const std::string& text)
    {
        constexpr std::string_view key = "type:";
        for (std::size_t at = 0; at < text.size();) {
            const std::size_t end = std::min(text.find(' ', at), text.size());
            const std::string word = text.substr(at, end - at);
            if (in_small_letters(word).starts_with(key))
                types.push_back(in_small_letters(word.substr(key.size())));
            else
                letters += word;
            at = end + 1;
        }
    }
    bool empty() const { return types.empty() && letters.empty(); }
    bool takes(const Object& object) const
    {
        const std::string type = in_small_letters(type_of(object));
        for (const std::string& each : types)
            if (!type.starts_with(each)) return false;
        return letters_in_order(letters, object.name).has_value();
    }
};

// Children lists the contents of each group in the order of rows, linked through all ids: the
// outliner is built anew in each frame.
struct Children {
    explicit Children(const Document& document)
        : first(static_cast<std::size_t>(document.next_id), 0),
          next(first)
    {
        std::vector<Id> last = first;
        for (const Id id : in_row_order(document)) {
            const auto parent = static_cast<std::size_t>(object(document, id).parent);
            (last[parent] == 0 ? first[parent] : next[static_cast<std::size_t>(last[parent])]) = id;
            last[parent] = id;
        }
    }
    Id first_in(Id parent) const { return first[static_cast<std::size_t>(parent)]; }
    Id after(Id id) const { return next[static_cast<std::size_t>(id)]; }
    std::vector<Id> first, next; // by id; 0: none
};

class Rows {
public:
    Rows(const Document& document, const Filter& filter, const std::set<Id>& closed)
        : document_(document),
          filter_(filter),
          closed_(closed),
          children_(document)
    {
    }
    // Whether anything of it was added.
    bool add(Id parent, int depth)
    {
        const std::size_t before = rows_.size();
        for (Id id = children_.first_in(parent); id != 0; id = children_.after(id)) {
            const Object& each = object(document_, id);
            const bool group = kind_of(each).holds_others || children_.first_in(id) != 0;
            const bool found = filter_.empty() || filter_.takes(each);
            const bool open = !filter_.empty() || !closed_.contains(id);
            const std::size_t row = rows_.size();
            rows_.push_back({id, depth, group, open, found});
            const bool more = group && open && add(id, depth + 1);
            if (!found && !more) rows_.erase(rows_.begin() + static_cast<std::ptrdiff_t>(row));
        }
        return rows_.size() > before;
    }
    std::vector<OutlineRow> take() { return std::move(rows_); }

private:
    const Document& document_;
    const Filter& filter_;
    const std::set<Id>& closed_;
    Children children_;
    std::vector<OutlineRow> rows_;
};

// The next one in the group that does not move itself; 0: none.
Id follower(const Document& document, Id parent, Id after, const std::vector<Id>& moved)
{
    bool past = after == 0;
    for (const Id id : in_row_order(document)) {
        if (object(document, id).parent != parent) continue;
        if (past && std::ranges::find(moved, id) == moved.end()) return id;
        past = past || id == after;
    }
    return 0;
}

bool as_before(const Document& before, const Document& after, const std::vector<Id>& moved)
{
    for (const Id id : moved)
        if (object(before, id).parent != object(after, id).parent) return false;
    return in_row_order(before) == in_row_order(after);
}

} // namespace

std::string type_of(const Object& object)
{
    const ObjectKind& kind = kind_of(object);
    if (kind.bends_others || (!object.tiles && !object.stroke)) return std::string(kind.type);
    return object.tiles ? "Tiles" : "Placed";
}

const char* icon_of(const Object& object)
{
    static constexpr std::array icons{ui::icon::mesh, ui::icon::volume, ui::icon::tetrahedra,
                                      ui::icon::group}; // by KindIcon
    const ObjectKind& kind = kind_of(object);
    if (kind.bends_others || (!object.tiles && !object.stroke))
        return icons.at(static_cast<std::size_t>(kind.icon));
    return object.tiles ? ui::icon::tiles : ui::icon::place;
}

std::vector<OutlineRow> outline(const Document& document, const std::string& filter,
                                const std::set<Id>& closed)
{
    const Filter wanted(filter);
    Rows rows(document, wanted, closed);
    rows.add(0, 0);
    return rows.take();
}

RowDrop row_drop(const Document& document, const std::vector<OutlineRow>& rows,
                 const std::vector<Id>& dragged, double at)
{
    constexpr double edge = 0.3; // of a row: between it and the next
    RowDrop drop;
    std::vector<Id> moved = topmost(document, dragged); // as they stand below each other
    std::ranges::sort(moved, {}, [&](Id id) {
        return std::ranges::find(rows, id, &OutlineRow::id) - rows.begin();
    });
    const int count = static_cast<int>(rows.size());
    const int row = static_cast<int>(std::floor(std::max(0.0, at)));
    Reorder wanted{.objects = moved};
    if (row >= count) {
        drop.line = count;
    } else {
        const OutlineRow& under = rows[static_cast<std::size_t>(row)];
        const double within = at - row;
        wanted.parent = object(document, under.id).parent;
        if (within >= edge && within <= 1 - edge) {
            drop.onto = row;
            wanted.parent = under.id;
            if (!kind_of(document, under.id).holds_others)
                drop.refused =
                    "Only a group can hold it. Drop it between two rows, or group both first.";
        } else if (within < edge) {
            drop.line = row;
            wanted.before = under.id;
            if (std::ranges::find(moved, under.id) != moved.end())
                wanted.before = follower(document, wanted.parent, under.id, moved);
        } else {
            drop.line = row + 1;
            const bool first_inside = under.group && under.open && row + 1 < count &&
                                      rows[static_cast<std::size_t>(row) + 1].depth > under.depth;
            if (first_inside) wanted.parent = under.id;
            wanted.before = follower(document, wanted.parent, first_inside ? 0 : under.id, moved);
        }
    }
    if (!drop.refused.empty() || moved.empty()) return drop;
    try {
        if (!as_before(document, after(document, wanted), moved)) drop.command = wanted;
    } catch (const Rejected&) {
        drop.refused = "A group cannot be put into itself.";
    }
    return drop;
}

} // namespace trivar
