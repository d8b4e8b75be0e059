// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The types of CLI11 that headers mention. CLI11 itself takes three seconds to compile, so only the
// files that use it include it.

namespace CLI {

class App;
class FormatterBase;
class Option;
class ParseError;

}  // namespace CLI
