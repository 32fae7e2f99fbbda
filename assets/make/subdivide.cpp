// SPDX-License-Identifier: GPL-3.0-or-later
#include "assets/make/subdivide.h"

#include <algorithm>

namespace make {

Mesh catmull_clark(const Mesh& cage, const std::map<std::pair<int, int>, float>& crease0,
                   int levels)
{
    Mesh m = cage;
    auto crease = crease0;
    for (int L = 0; L < levels; L++) {
        auto key = [](int a, int b) { return std::make_pair(std::min(a, b), std::max(a, b)); };
        Mesh r;
        r.material = m.material;
        int V = int(m.points.size()), F = int(m.faces.size());
        std::map<std::pair<int, int>, std::vector<int>> ef;
        std::vector<vec3> fp(F);
        for (int i = 0; i < F; i++) {
            int n = m.faces[i][3] < 0 ? 3 : 4;
            vec3 s(0);
            for (int k = 0; k < n; k++) {
                s += m.points[m.faces[i][k]];
                ef[key(m.faces[i][k], m.faces[i][(k + 1) % n])].push_back(i);
            }
            fp[i] = s / float(n);
        }
        std::map<std::pair<int, int>, int> ei;
        std::vector<vec3> ep;
        std::map<std::pair<int, int>, float> nc;
        auto sharp = [&](std::pair<int, int> e) {
            auto it = crease.find(e);
            float s = it == crease.end() ? 0 : it->second;
            return ef[e].size() == 1 ? 10.f : s;
        };
        std::vector<vec3> sf(V, vec3(0)), se(V, vec3(0)), sc(V, vec3(0));
        std::vector<int> nf(V, 0), ne(V, 0), ns(V, 0);
        std::vector<float> ss(V, 0);
        for (auto& [e, fs] : ef) {
            vec3 mid = .5f * (m.points[e.first] + m.points[e.second]), sm = mid;
            float s = sharp(e);
            if (fs.size() == 2) sm = .5f * mid + .25f * (fp[fs[0]] + fp[fs[1]]);
            int id = V + F + int(ep.size());
            ei[e] = id;
            ep.push_back(glm::mix(sm, mid, std::min(s, 1.f)));
            if (s > 1) {
                nc[key(e.first, id)] = s - 1;
                nc[key(e.second, id)] = s - 1;
            }
            for (int v : {e.first, e.second}) {
                se[v] += mid;
                ne[v]++;
                if (s > 0) {
                    sc[v] += m.points[e.first + e.second - v];
                    ns[v]++;
                    ss[v] += s;
                }
            }
        }
        for (int i = 0; i < F; i++)
            for (int v : m.faces[i])
                if (v >= 0) {
                    sf[v] += fp[i];
                    nf[v]++;
                }
        for (int v = 0; v < V; v++) {
            float n = float(nf[v]);
            vec3 q = m.points[v];
            vec3 smooth = (sf[v] / n + 2.f * se[v] / float(ne[v]) + (n - 3) * q) / n;
            if (ns[v] == 2)
                smooth = glm::mix(smooth, .75f * q + .125f * sc[v], std::min(ss[v] / 2, 1.f));
            else if (ns[v] > 2)
                smooth = glm::mix(smooth, q, std::min(ss[v] / ns[v], 1.f));
            r.points.push_back(smooth);
        }
        r.points.insert(r.points.end(), fp.begin(), fp.end());
        r.points.insert(r.points.end(), ep.begin(), ep.end());
        for (int i = 0; i < F; i++) {
            int n = m.faces[i][3] < 0 ? 3 : 4;
            for (int k = 0; k < n; k++) {
                int a = m.faces[i][k], b = m.faces[i][(k + 1) % n], z = m.faces[i][(k + n - 1) % n];
                r.faces.push_back({a, ei[key(a, b)], V + i, ei[key(z, a)]});
            }
        }
        m = r;
        crease = nc;
    }
    return m;
}

} // namespace make
