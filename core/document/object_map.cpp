// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/object_map.h"

#include "core/base/mistake.h"

#include <algorithm>

namespace trivar {
namespace {

constexpr int block_length = 64;

std::size_t block_of(int id)
{
    return static_cast<std::size_t>(id / block_length);
}

bool before(const ObjectMap::Entry& entry, int id)
{
    return entry.first < id;
}

} // namespace

void ObjectMap::Iterator::skip_to_entry()
{
    while (block_ < blocks_->size() &&
           (!(*blocks_)[block_] || entry_ >= (*blocks_)[block_]->size())) {
        ++block_;
        entry_ = 0;
    }
}

ObjectMap::Iterator ObjectMap::find(int id) const
{
    if (id < 0 || block_of(id) >= blocks_.size() || !blocks_[block_of(id)]) return end();
    const std::vector<Entry>& block = *blocks_[block_of(id)];
    const auto entry = std::lower_bound(block.begin(), block.end(), id, before);
    if (entry == block.end() || entry->first != id) return end();
    return {blocks_, block_of(id), static_cast<std::size_t>(entry - block.begin())};
}

const Ref<Object>& ObjectMap::at(int id) const
{
    const Iterator found = find(id);
    ensure(found != end(), "there is no object of this number");
    return found->second;
}

void ObjectMap::set(int id, Ref<Object> object)
{
    ensure(id >= 0 && object, "what is put into a document is no object");
    if (block_of(id) >= blocks_.size()) blocks_.resize(block_of(id) + 1);
    Ref<std::vector<Entry>>& shared = blocks_[block_of(id)];
    std::vector<Entry> block = shared ? *shared : std::vector<Entry>{};
    const auto entry = std::lower_bound(block.begin(), block.end(), id, before);
    if (entry != block.end() && entry->first == id)
        entry->second = std::move(object);
    else {
        block.emplace(entry, id, std::move(object));
        ++size_;
    }
    shared = make_ref(std::move(block));
}

void ObjectMap::erase(int id)
{
    if (!contains(id)) return;
    Ref<std::vector<Entry>>& shared = blocks_[block_of(id)];
    std::vector<Entry> block = *shared;
    block.erase(std::lower_bound(block.begin(), block.end(), id, before));
    shared = block.empty() ? nullptr : make_ref(std::move(block));
    --size_;
}

} // namespace trivar
