#pragma once

// Main header: includes the whole library. AngioPose registers a 3-D vessel tree to a 2-D angiogram.

#include "angiopose/angiogram.h"
#include "angiopose/case.h"
#include "angiopose/deformation.h"
#include "angiopose/error.h"
#include "angiopose/geometry.h"
#include "angiopose/observer.h"
#include "angiopose/options.h"
#include "angiopose/registration.h"
#include "angiopose/version.h"
#include "angiopose/vessel_tree.h"
#include "angiopose/volume.h"
