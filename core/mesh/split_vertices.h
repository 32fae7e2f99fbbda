// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/parallel.h"
#include "core/mesh/mesh.h"
#include "core/mesh/vertex_corners.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace trivar {

// Tells for each of the numbers below a count the first one that is alike; `less` is an order in
// which no other lies between two that are alike. O(count log count).
template <class Alike, class Less>
void find_first_alike(std::size_t count, Alike alike, Less less, std::vector<std::uint32_t>& first)
{
    constexpr std::size_t few = 12;
    first.resize(count);
    if (count <= few) {
        for (std::uint32_t i = 0; i < count; ++i)
            for (first[i] = 0; first[i] < i && !alike(first[i], i);) ++first[i];
        return;
    }
    std::vector<std::uint32_t> order(count);
    std::iota(order.begin(), order.end(), 0u);
    std::ranges::stable_sort(order, less);
    for (std::size_t i = 0; i < count; ++i)
        first[order[i]] = i > 0 && alike(order[i - 1], order[i]) ? first[order[i - 1]] : order[i];
}

// Gives the corners of a mesh values. Where those of a vertex have several, it becomes one vertex
// for each value, which have all else in common and are one point; they follow each other in the
// order of their first corners. Returns the values of the new vertices.
//  - lists: of the corners; of a vertex all in one list, or none
//  - of_block(first, end): a function that gives the values of the corners of each of these lists
//  - otherwise(v): the value of a vertex whose corners are in no list
// O(#C log valence); the same bits for any number of threads.
template <class T, class OfBlock, class Otherwise>
std::vector<T> split_vertices(Mesh& mesh, const VertexCorners& lists, OfBlock of_block,
                              Otherwise otherwise)
{
    constexpr std::size_t per_block = 1 << 13;
    struct Found {
        std::uint32_t corner;
        T value;
    };
    std::vector<T> out(mesh.vertex_count());
    if (lists.empty()) {
        for (std::uint32_t v = 0; v < out.size(); ++v) out[v] = otherwise(v);
        return out;
    }
    std::vector<std::vector<Found>> found(lists.size() / per_block + 1);
    std::vector<std::uint32_t> place(mesh.corners.size());    // among the values of its vertex
    std::vector<std::uint32_t> begin(mesh.vertex_count(), 0); // first how many values there are
    parallel_blocks(lists.size(), per_block, [&](std::size_t first, std::size_t end) {
        auto values_of = of_block(first, end);
        std::vector<std::uint32_t> first_alike;
        for (std::size_t list = first; list < end; ++list) {
            const std::span<const std::uint32_t> corners = lists[list];
            const std::span<const T> values = values_of(list);
            const auto vertex = [&](std::uint32_t i) { return mesh.corners[corners[i]]; };
            const auto alike = [&](std::uint32_t a, std::uint32_t b) {
                return vertex(a) == vertex(b) && values[a] == values[b];
            };
            const auto less = [&](std::uint32_t a, std::uint32_t b) {
                for (int i = 0; i < T::length(); ++i)
                    if (values[a][i] != values[b][i]) return values[a][i] < values[b][i];
                return vertex(a) < vertex(b);
            };
            find_first_alike(corners.size(), alike, less, first_alike);
            for (std::uint32_t i = 0; i < corners.size(); ++i) {
                const bool is_first = first_alike[i] == i;
                place[corners[i]] = is_first ? begin[vertex(i)]++ : place[corners[first_alike[i]]];
                if (is_first) found[first / per_block].push_back({corners[i], values[i]});
            }
        }
    });
    std::vector<std::uint32_t> others;
    std::uint32_t count = 0;
    for (std::uint32_t v = 0; v < begin.size(); ++v) {
        if (begin[v] == 0) others.push_back(v);
        count += std::max(std::exchange(begin[v], count), 1u);
    }
    out.resize(count);
    std::vector<std::uint32_t> from(count);
    for (const std::uint32_t v : others) out[begin[v]] = otherwise(v), from[begin[v]] = v;
    parallel_blocks(found.size(), 1, [&](std::size_t block, std::size_t) {
        for (const Found& one : found[block]) {
            const std::uint32_t v = mesh.corners[one.corner], now = begin[v] + place[one.corner];
            out[now] = one.value;
            from[now] = v;
        }
    });
    parallel_blocks(place.size(), 1 << 16, [&](std::size_t first, std::size_t end) {
        for (std::size_t c = first; c < end; ++c)
            mesh.corners[c] = begin[mesh.corners[c]] + place[c];
    });
    if (count > mesh.vertex_count()) take_vertices(mesh, from);
    return out;
}

// The same with the values of all corners, #C.
template <class T>
std::vector<T> split_vertices(Mesh& mesh, const std::vector<T>& at_corners, const T& otherwise)
{
    const VertexCorners round(mesh.corners, mesh.vertex_count());
    const auto of_block = [&](std::size_t, std::size_t) {
        return [&, values = std::vector<T>()](std::size_t v) mutable {
            values.clear();
            for (const std::uint32_t c : round[v]) values.push_back(at_corners[c]);
            return std::span<const T>(values);
        };
    };
    return split_vertices<T>(mesh, round, of_block, [&](std::uint32_t) { return otherwise; });
}

} // namespace trivar
