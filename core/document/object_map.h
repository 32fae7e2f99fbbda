// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/ref.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

namespace trivar {

struct Object;

// An ObjectMap holds objects by ascending id and reads like a std::map. Copies share blocks of 64
// ids, so that a copy with one changed object costs a pointer per 64 objects and one block.
class ObjectMap {
public:
    using Entry = std::pair<int, Ref<Object>>;
    class Iterator {
    public:
        using value_type = Entry;
        using difference_type = std::ptrdiff_t;
        using iterator_category = std::forward_iterator_tag;
        using pointer = const Entry*;
        using reference = const Entry&;
        Iterator() = default;
        reference operator*() const { return (*(*blocks_)[block_])[entry_]; }
        pointer operator->() const { return &**this; }
        Iterator& operator++()
        {
            ++entry_;
            skip_to_entry();
            return *this;
        }
        Iterator operator++(int)
        {
            Iterator old = *this;
            ++*this;
            return old;
        }
        bool operator==(const Iterator&) const = default;

    private:
        friend class ObjectMap;
        using Blocks = std::vector<Ref<std::vector<Entry>>>;
        Iterator(const Blocks& blocks, std::size_t block, std::size_t entry)
            : blocks_(&blocks),
              block_(block),
              entry_(entry)
        {
            skip_to_entry();
        }
        void skip_to_entry();
        const Blocks* blocks_ = nullptr;
        std::size_t block_ = 0, entry_ = 0;
    };
    using const_iterator = Iterator;
    using value_type = Entry;

    Iterator begin() const { return {blocks_, 0, 0}; }
    Iterator end() const { return {blocks_, blocks_.size(), 0}; }
    std::size_t size() const { return size_; }
    bool empty() const { return size_ == 0; }
    Iterator find(int id) const;
    bool contains(int id) const { return find(id) != end(); }
    std::size_t count(int id) const { return contains(id) ? 1 : 0; }
    const Ref<Object>& at(int id) const; // the object must exist

    // whether both have the same objects under the same ids
    bool operator==(const ObjectMap& other) const
    {
        return blocks_ == other.blocks_ ||
               (size_ == other.size_ && std::equal(begin(), end(), other.begin()));
    }

    void set(int id, Ref<Object> object); // adds or replaces; id >= 0
    void erase(int id);

private:
    std::vector<Ref<std::vector<Entry>>> blocks_; // ids 64 i .. 64 i + 63; null: an empty block
    std::size_t size_ = 0;
};

} // namespace trivar
