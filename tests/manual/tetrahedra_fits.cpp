// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/rejected.h"
#include "core/level/fitted_volume.h"
#include "core/voxels/coarsened.h"
#include "core/voxels/read_volume.h"

#include <Eigen/Dense>

#include <chrono>
#include <cmath>
#include <fmt/format.h>

// Fits volume data by splines over tetrahedra and by a tensor-product spline of as many
// coefficients, and tells how far both are from the samples: near the boundary, which is within two
// samples of one on its other side, and away from it.

namespace {

using namespace trivar;

constexpr int near_by = 2; // samples

struct Data {
    std::string name;
    VoxelGrid grid;
    double boundary;
};

VoxelGrid grid_of(const glm::ivec3& size, const auto& function)
{
    std::vector<float> samples;
    for (int k = 0; k < size.z; ++k)
        for (int j = 0; j < size.y; ++j)
            for (int i = 0; i < size.x; ++i)
                samples.push_back(static_cast<float>(function(glm::dvec3(i, j, k))));
    VoxelGrid out;
    out.size = size;
    out.samples = std::move(samples);
    return out;
}

// Dense and uneven within, thin and uneven outside.
double density(bool inside, const glm::dvec3& p)
{
    const double wave = std::sin(p.x / 9) * std::cos(p.y / 11) + std::sin(p.z / 13);
    return inside ? 1000 + 100 * wave : 50 * wave;
}

Data ball(int n)
{
    return {"ball",
            grid_of(glm::ivec3(n),
                    [&](const glm::dvec3& p) {
                        return density(glm::distance(p, glm::dvec3((n - 1) / 2.0)) < 0.33 * n, p);
                    }),
            500};
}

Data ring(int n)
{
    return {"ring",
            grid_of(glm::ivec3(n),
                    [&](const glm::dvec3& p) {
                        const glm::dvec3 d = p - glm::dvec3((n - 1) / 2.0);
                        const double around = std::hypot(d.x, d.y) - 0.29 * n;
                        return density(std::hypot(around, d.z) < 0.15 * n, p);
                    }),
            500};
}

// The least-squares cubic spline on a coarser grid: the same operator along each axis.
Eigen::MatrixXd onto_spline(int samples, int coefficients)
{
    Eigen::MatrixXd basis = Eigen::MatrixXd::Zero(samples, coefficients);
    const int spans = coefficients - 3;
    for (int s = 0; s < samples; ++s) {
        const double x = static_cast<double>(s) * spans / (samples - 1);
        const int first = std::min(static_cast<int>(x), spans - 1);
        const double t = x - first, u = 1 - t;
        basis(s, first) = u * u * u / 6;
        basis(s, first + 1) = (3 * t * t * t - 6 * t * t + 4) / 6;
        basis(s, first + 2) = (3 * u * u * u - 6 * u * u + 4) / 6;
        basis(s, first + 3) = t * t * t / 6;
    }
    return basis * basis.completeOrthogonalDecomposition().pseudoInverse();
}

std::size_t number(const glm::ivec3& size, const glm::ivec3& at)
{
    return static_cast<std::size_t>(at.x) +
           static_cast<std::size_t>(size.x) *
               (static_cast<std::size_t>(at.y) +
                static_cast<std::size_t>(size.y) * static_cast<std::size_t>(at.z));
}

void each(const glm::ivec3& size, const auto& body)
{
    for (int k = 0; k < size.z; ++k)
        for (int j = 0; j < size.y; ++j)
            for (int i = 0; i < size.x; ++i) body(glm::ivec3(i, j, k));
}

std::vector<double> tensor_fit(std::vector<double> values, const glm::ivec3& size, std::size_t most,
                               std::size_t& used)
{
    const double share =
        std::cbrt(static_cast<double>(most) / (static_cast<double>(size.x) * size.y * size.z));
    used = 1;
    for (int axis = 0; axis < 3; ++axis) {
        const int n = std::max(4, static_cast<int>(size[axis] * share));
        used *= static_cast<std::size_t>(n);
        const Eigen::MatrixXd projected = onto_spline(size[axis], n);
        glm::ivec3 lines = size;
        lines[axis] = 1;
        each(lines, [&](const glm::ivec3& from) {
            Eigen::VectorXd line(size[axis]);
            glm::ivec3 at = from;
            for (at[axis] = 0; at[axis] < size[axis]; ++at[axis])
                line[at[axis]] = values[number(size, at)];
            line = projected * line;
            for (at[axis] = 0; at[axis] < size[axis]; ++at[axis])
                values[number(size, at)] = line[at[axis]];
        });
    }
    return values;
}

struct Errors {
    double square = 0, most = 0;
    std::size_t count = 0;
    void add(double e)
    {
        square += e * e;
        most = std::max(most, std::abs(e));
        ++count;
    }
    std::string words() const
    {
        return fmt::format("{:9.1f} {:9.1f}",
                           std::sqrt(square / static_cast<double>(std::max<std::size_t>(1, count))),
                           most);
    }
};

void compare(const Data& data, int degree, int coefficients)
{
    const glm::ivec3 size = data.grid.size;
    const VoxelField field(make_ref(data.grid), {});
    const auto begin = std::chrono::steady_clock::now();
    const FittedVolume fitted = fitted_volume(field, {coefficients, degree, data.boundary});
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
    std::vector<double> values, by_cells;
    each(size, [&](const glm::ivec3& at) {
        values.push_back(static_cast<double>(field.field().at<0>(glm::vec3(at)).value));
        by_cells.push_back(evaluate(fitted.field, glm::dvec3(at)).value);
    });
    std::size_t used = 0;
    const std::vector<double> by_tensor = tensor_fit(values, size, fitted.coefficients, used);
    const double level = data.grid.sample(data.boundary);
    std::array<Errors, 2> cells, tensor; // away, near
    each(size, [&](const glm::ivec3& at) {
        const std::size_t i = number(size, at);
        bool near = false;
        each(glm::ivec3(2 * near_by + 1), [&](const glm::ivec3& d) {
            const glm::ivec3 q = glm::clamp(at + d - near_by, glm::ivec3(0), size - 1);
            near = near || (values[number(size, q)] >= level) != (values[i] >= level);
        });
        cells[near ? 1 : 0].add((by_cells[i] - values[i]) * data.grid.slope);
        tensor[near ? 1 : 0].add((by_tensor[i] - values[i]) * data.grid.slope);
    });
    fmt::print("{:8} {} {:6} {:6} {:6} | {} | {} | {} | {} | {:.1f} s, {} left out\n", data.name,
               degree, fitted.inside.size(), fitted.coefficients, used, cells[1].words(),
               tensor[1].words(), cells[0].words(), tensor[0].words(), seconds.count(),
               fitted.left_out);
    std::fflush(stdout);
}

} // namespace

int main(int argc, char** argv)
{
    std::vector<Data> all{ball(64), ring(64)};
    for (int i = 1; i + 2 < argc; i += 3) { // FILE COARSEN BOUNDARY
        all.push_back({std::string(argv[i]).substr(std::string(argv[i]).find_last_of('/') + 1, 8),
                       coarsened(read_volume(argv[i]).grid, glm::ivec3(std::atoi(argv[i + 1]))),
                       std::atof(argv[i + 2])});
    }
    fmt::print(
        "                                | near: tetrahedra    | near: tensor        | away: "
        "tetrahedra    | away: tensor\n"
        "data     n  cells  coeff  tensor |   rms       most    |\n");
    for (const Data& data : all)
        for (const int degree : {1, 2, 3})
            for (const int coefficients : {1000, 4000}) try {
                    compare(data, degree, coefficients);
                } catch (const Rejected& why) {
                    fmt::print("{:8} {} {:6}: {}\n", data.name, degree, coefficients, why.what());
                }
}
