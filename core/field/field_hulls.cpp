// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/field/field_hulls.h"

#include "core/base/parallel.h"

namespace trivar {

FieldHulls::FieldHulls(const ScalarField<float>& field)
    : bricks_((field.size() - 1 + brick - 1) / brick),
      first_layer_(field.first_slice() / brick)
{
    const int end_slice = field.first_slice() + field.slice_count();
    const auto across = static_cast<std::size_t>(bricks_.x),
               down = static_cast<std::size_t>(bricks_.y),
               layers =
                   static_cast<std::size_t>((end_slice - 1 + brick - 1) / brick - first_layer_);
    ranges_.resize(across * down * layers);
    const std::size_t row = field.row();
    parallel_blocks(layers, 1, [&](std::size_t layer, std::size_t) {
        std::vector<float> least(row), greatest(row);
        const int from = (first_layer_ + static_cast<int>(layer)) * brick - 1,
                  k_first = std::max(from, field.first_slice() - 1),
                  k_last = std::min(from + brick + 2, end_slice);
        for (std::size_t b = 0; b < down; ++b) {
            const int j_first = static_cast<int>(b) * brick - 1,
                      j_last = std::min(j_first + brick + 2, field.size().y);
            const float* const begin = &field.coefficient(-1, j_first, k_first);
            std::copy_n(begin, row, least.begin());
            std::copy_n(begin, row, greatest.begin());
            for (int k = k_first; k <= k_last; ++k)
                for (int j = j_first; j <= j_last; ++j) {
                    const float* const c = &field.coefficient(-1, j, k);
                    for (std::size_t i = 0; i < row; ++i) {
                        least[i] = c[i] < least[i] ? c[i] : least[i];
                        greatest[i] = c[i] > greatest[i] ? c[i] : greatest[i];
                    }
                }
            for (std::size_t a = 0; a < across; ++a) {
                const auto first = static_cast<std::ptrdiff_t>(a * brick),
                           end = std::min(first + brick + 3, static_cast<std::ptrdiff_t>(row));
                ranges_[a + across * (b + down * layer)] = {
                    *std::min_element(least.begin() + first, least.begin() + end),
                    *std::max_element(greatest.begin() + first, greatest.begin() + end)};
            }
        }
    });
}

FieldHulls::Range FieldHulls::whole() const
{
    Range out = ranges_.front();
    for (const Range& each : ranges_)
        out = {std::min(out.least, each.least), std::max(out.greatest, each.greatest)};
    return out;
}

} // namespace trivar
