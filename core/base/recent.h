// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace trivar {

// The last few values of a function by what they came from, so that undo and redo of a step or two
// compute nothing. Keys are compared by ==. Not thread-safe.
template <class Key, class Value> class Recent {
public:
    explicit Recent(std::size_t most = 3) : most_(most) {}

    // The value of the key, which becomes the latest. Where it is not among them make() gives it;
    // what that throws is thrown, and nothing changes. O(number of values).
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
    // Forgets the oldest beyond that number, now and from now on.
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
