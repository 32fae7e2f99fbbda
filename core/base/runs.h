// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/ref.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

namespace trivar {

// Runs are a sequence in pieces, which copies share until one of them changes: a copy costs
// O(#runs), and equal pointers of runs mean equal elements, by which others see which stayed. Runs
// are never empty. The place at which one ends has no meaning: sequences with the same elements are
// equal.
template <class T> class Runs {
public:
    using Run = Ref<std::vector<T>>;
    static constexpr std::size_t usual = 128; // elements of a run that is made here

    Runs() = default;
    explicit Runs(std::vector<T> all) { add(make_ref(std::move(all))); }
    explicit Runs(const Run& all) { add(all); }
    // Cuts a list into runs of the usual length.
    static Runs cut(const std::vector<T>& all)
    {
        Runs out;
        for (std::size_t i = 0; i < all.size(); i += usual)
            out.add(make_ref(std::vector<T>(
                all.begin() + static_cast<std::ptrdiff_t>(i),
                all.begin() + static_cast<std::ptrdiff_t>(std::min(i + usual, all.size())))));
        return out;
    }

    std::size_t size() const { return begins_.back(); }
    bool empty() const { return size() == 0; }
    const std::vector<Run>& runs() const { return runs_; }
    // The number of the first element of a run; for #runs: size().
    std::size_t begin_of(std::size_t run) const { return begins_[run]; }
    // The number of the run that holds an element. O(1) where runs are usual, or else O(log #runs).
    std::size_t run_of(std::size_t i) const
    {
        const std::size_t guess = std::min(i / usual, runs_.size() - 1);
        if (begins_[guess] <= i && i < begins_[guess + 1]) return guess;
        return static_cast<std::size_t>(std::ranges::upper_bound(begins_, i) - begins_.begin()) - 1;
    }
    const T& operator[](std::size_t i) const
    {
        const std::size_t run = run_of(i);
        return (*runs_[run])[i - begins_[run]];
    }

    std::vector<T> all() const { return {begin(), end()}; }

    void add(const Run& run) // behind the others
    {
        if (run->empty()) return;
        begins_.push_back(size() + run->size());
        runs_.push_back(run);
    }
    // Both copy one run, and leave it as it is to others: O(usual).
    void push_back(const T& value)
    {
        if (runs_.empty() || runs_.back()->size() >= usual)
            return add(make_ref(std::vector{value}));
        std::vector<T> longer;
        longer.reserve(runs_.back()->size() + 1);
        longer = *runs_.back();
        longer.push_back(value);
        runs_.back() = make_ref(std::move(longer));
        ++begins_.back();
    }
    void replace(std::size_t i, const T& value)
    {
        const std::size_t run = run_of(i);
        std::vector<T> other = *runs_[run];
        other[i - begins_[run]] = value;
        runs_[run] = make_ref(std::move(other));
    }

    // Goes through the elements.
    class Iterator {
    public:
        using iterator_category = std::forward_iterator_tag;
        using value_type = T;
        using difference_type = std::ptrdiff_t;
        using pointer = const T*;
        using reference = const T&;
        Iterator() = default;
        Iterator(const Run* run, std::size_t i) : run_(run), i_(i) {}
        reference operator*() const { return (**run_)[i_]; }
        pointer operator->() const { return &**this; }
        Iterator& operator++()
        {
            if (++i_ == (*run_)->size()) ++run_, i_ = 0;
            return *this;
        }
        Iterator operator++(int)
        {
            const Iterator before = *this;
            ++*this;
            return before;
        }
        bool operator==(const Iterator&) const = default;

    private:
        const Run* run_ = nullptr;
        std::size_t i_ = 0;
    };
    Iterator begin() const { return {runs_.data(), 0}; }
    Iterator end() const { return {runs_.data() + runs_.size(), 0}; }

    bool operator==(const Runs& other) const
    {
        if (runs_ == other.runs_) return true;
        return size() == other.size() && std::equal(begin(), end(), other.begin());
    }

private:
    std::vector<Run> runs_;
    std::vector<std::size_t> begins_{0}; // of each run; one more at the end
};

} // namespace trivar
