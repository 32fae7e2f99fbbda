// SPDX-License-Identifier: GPL-3.0-or-later
#include "assets/make/models/models.h"

#include "assets/make/kit.h"

#include <algorithm>
#include <cmath>

namespace make {

Model bars()
{
    Model m;
    int a = m.material("bar", srgb(0x7d868e), .35f, .8f);
    for (int i = 0; i < 3; i++) {
        int n = m.node("bar_" + std::to_string(i), i ? 0 : -1, {i ? .3f * i : 0, 0, 0});
        m.nodes[n].parts.push_back(cylinder(.045f, .045f, 1.f, .010f, 32, 24).mat(a));
    }
    return m;
}

} // namespace make
