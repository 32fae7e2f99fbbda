// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/fields/shaping_fields.h"
#include "editor/panels/inspector/field_rows.h"

namespace trivar {

// The rows of the amounts of a warp, for lattices and tetrahedra alike.
inline void warp_rows(FieldRows<Warp>& fields)
{
    fields(&Warp::twist_deg);
    fields(&Warp::bend_deg);
    fields(&Warp::toward_deg);
    fields(&Warp::fixed);
    fields(&Warp::taper);
    fields(&Warp::shear);
    fields(&Warp::bulge);
}

} // namespace trivar
