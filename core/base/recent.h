// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace trivar {

// A Recent keeps the last few values of a function by their keys, so that undo and redo of a step
// or two compute nothing. Keys are compared by ==. Not thread-safe.
template <class Key, class Value> class Recent {
public:
    explicit Recent(std::size_t most = 3) : most_(most) {}

    // The value of a key, which becomes the latest one. If the key is not kept, make() gives the
    // value; if make() throws, the exception is passed on and nothing changes. O(#values).
    template <class Make> const Value& operator()(const Key& key, Make&& make)
    {
        const auto found =
            std::ranges::find_if(all_, [&](const auto& known) { return known.first == key; });
        if (found != all_.end())
            std::rotate(all_.begin(), found, found + 1);
        else {
            all_.insert(all_.begin(), {key, make()});
            keep(most_);
        }
        return all_.front().second;
    }
    // Keeps at most that number of values from now on; the oldest are removed.
    void keep(std::size_t most)
    {
        most_ = most;
        if (all_.size() > most_) all_.erase(all_.begin() + static_cast<long>(most_), all_.end());
    }

private:
    std::size_t most_;
    std::vector<std::pair<Key, Value>> all_; // the latest first
};

} // namespace trivar
