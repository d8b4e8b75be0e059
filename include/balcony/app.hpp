// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// App: what a program that renders does besides words: a request becomes a film and a report.

#include "balcony/request.hpp"
