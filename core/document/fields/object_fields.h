// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/fields/import_fields.h"
#include "core/document/fields/placement_fields.h"
#include "core/document/fields/playing_fields.h"
#include "core/document/fields/primitive_fields.h"
#include "core/document/fields/refining_fields.h"
#include "core/document/fields/shaping_fields.h"
#include "core/document/fields/surfacing_fields.h"
#include "core/document/fields/text_fields.h"
#include "core/document/fields/track_fields.h"
#include "core/document/fields/travel_fields.h"
#include "core/document/fields/view_fields.h"

// The fields of all that an object or a scene holds. Whoever walks through a whole object includes
// this: a value whose fields nobody listed would be passed over in silence.
