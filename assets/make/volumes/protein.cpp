// SPDX-License-Identifier: GPL-3.0-or-later
#include "assets/make/volumes/density.h"

// A chain that folds into a sheet of eight twisted strands with nine helices on both sides of it,
// and carries a cube of iron and sulphur: built residue by residue, by the geometry of proteins.
// Angstrom; strands and helices run along z, the sheet lies across y.
namespace make {
namespace {

constexpr int strand_count = 8;
constexpr float between_strands = 4.8f, sheet_to_helix = 10, twist_deg = -17;

vec3 twisted(vec3 p) // the frame at x turns about x
{
    const float a = glm::radians(twist_deg) * p.x / between_strands, c = std::cos(a),
                s = std::sin(a);
    return {p.x, c * p.y - s * p.z, s * p.y + c * p.z};
}

float strand_x(int strand)
{
    return between_strands * (float(strand) - .5f * float(strand_count - 1));
}

void add_strand(std::vector<vec3>& out, int strand)
{
    constexpr float rise = 3.35f, pleat = .9f;
    constexpr int residues = 6;
    for (int i = 0; i < residues; ++i)
        out.push_back(twisted({strand_x(strand), i % 2 == 0 ? pleat : -pleat,
                               rise * (float(i) - .5f * float(residues - 1))}));
}

void add_helix(std::vector<vec3>& out, float x, float side, int residues)
{
    constexpr float rise = 1.5f, radius = 2.3f, turn_deg = 100;
    for (int i = 0; i < residues; ++i) { // right-handed, and down, against the strands
        const float a = glm::radians(turn_deg * float(i) + 37 * x),
                    along = rise * (.5f * float(residues - 1) - float(i));
        out.push_back(twisted(
            {x + radius * std::cos(a), side * sheet_to_helix - radius * std::sin(a), along}));
    }
}

// Residues from where the chain is to where it goes on, in a bow away from the middle.
void add_turn(std::vector<vec3>& out, const std::vector<vec3>& next)
{
    const vec3 a = out.back(), b = next.front();
    const vec3 from = glm::normalize(a - out[out.size() - 2]), to = glm::normalize(next[1] - b);
    const int residues = std::max(2, int(std::lround(glm::distance(a, b) * 1.25f / 3.8f)));
    const float pull = 1.1f * glm::distance(a, b);
    for (int i = 1; i <= residues; ++i) {
        const float t = float(i) / float(residues + 1), s = 1 - t;
        out.push_back(s * s * (1 + 2 * t) * a + t * t * (3 - 2 * t) * b +
                      pull * (t * s * s * from - t * t * s * to));
    }
}

std::vector<vec3> chain()
{
    std::vector<vec3> out;
    const auto go_on = [&](const std::vector<vec3>& next) {
        if (!out.empty()) add_turn(out, next);
        out.insert(out.end(), next.begin(), next.end());
    };
    for (int strand = 0; strand <= strand_count; ++strand) {
        std::vector<vec3> helix;
        add_helix(helix, between_strands * (float(strand) - .5f * float(strand_count)),
                  strand % 2 == 0 ? 1.f : -1.f, 11 + strand * 5 % 4);
        go_on(helix);
        if (strand == strand_count) break;
        std::vector<vec3> straight;
        add_strand(straight, strand);
        go_on(straight);
    }
    return out;
}

struct Electrons {
    static constexpr float carbon = 6, nitrogen = 7, oxygen = 8, sulphur = 16, iron = 26;
};

void add_residue(Density& out, vec3 before, vec3 at, vec3 after, int number)
{
    constexpr float spread = .95f;
    const vec3 along = glm::normalize(after - at),
               away = glm::normalize(2.f * at - before - after + .01f);
    const vec3 across = glm::normalize(glm::cross(along, away));
    const vec3 carbonyl = at + 1.45f * along + .35f * across;
    out.add(at, Electrons::carbon, spread);
    out.add(carbonyl, Electrons::carbon, spread);
    out.add(carbonyl + 1.15f * across, Electrons::oxygen, spread);
    out.add(at + 2.5f * along - .3f * across, Electrons::nitrogen, spread);
    // Side chains of one to four atoms that bend as they go.
    const int length = 1 + (number * 7 + number / 3) % 4;
    vec3 p = at, d = away;
    for (int i = 0; i < length; ++i) {
        p += 1.5f * d;
        out.add(p, i == length - 1 && number % 3 == 0 ? Electrons::oxygen : Electrons::carbon,
                spread + .05f * float(i));
        const float n = float(number), k = float(i);
        d = glm::normalize(d + .7f * vec3(std::sin(2.3f * n + k), std::sin(3.1f * n + 2 * k),
                                          std::sin(4.7f * n + 3 * k)));
    }
}

} // namespace

Volume protein()
{
    Density out({128, 92, 92}, {-32, -23, -23}, .5f);
    const std::vector<vec3> residues = chain();
    for (std::size_t i = 1; i + 1 < residues.size(); ++i)
        add_residue(out, residues[i - 1], residues[i], residues[i + 1], int(i));
    const vec3 cluster = twisted({2.4f, -1, 13.5f});
    for (int i = 0; i < 8; ++i) { // iron and sulphur by turns at the corners of a cube
        const vec3 corner(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
        const bool iron = corner.x * corner.y * corner.z > 0;
        out.add(cluster + 1.2f * corner, iron ? Electrons::iron : Electrons::sulphur, .72f);
    }
    return out.scaled(1000);
}

} // namespace make
