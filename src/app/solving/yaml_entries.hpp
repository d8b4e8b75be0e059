// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Entries of a YAML file that are read strictly: what is not understood is an error.

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <Imath/ImathVec.h>
#include <yaml-cpp/yaml.h>

#include "balcony/solving.hpp"

namespace balcony::app {

/// A key with its value.
struct YamlEntry {
    std::string name;
    SourceSpan written;
    YAML::Node value;
};

class YamlEntries {
public:
    explicit YamlEntries(std::shared_ptr<const SourceText> source) : source_(std::move(source)) {}

    [[nodiscard]] SourceSpan at(const YAML::Node& node) const;
    void error(SourceSpan span, std::string message, std::string remedy);
    [[nodiscard]] Diagnostics& found() { return found_; }
    /// Whether reading goes on: not after many mistakes.
    [[nodiscard]] bool goes_on() const;

    /// The entries of a map, each once. `what` and `remedy` are for a node that is none.
    [[nodiscard]] std::vector<YamlEntry> map(const YAML::Node& node, std::string_view what,
                                             std::string_view remedy);
    /// The same with names that are known.
    [[nodiscard]] std::vector<YamlEntry> map(const YAML::Node& node, std::string_view what,
                                             std::string_view remedy,
                                             const std::vector<std::string>& known);
    /// The elements of a list, or a single value as a list.
    [[nodiscard]] std::vector<YAML::Node> list(const YAML::Node& node) const;

    [[nodiscard]] std::optional<std::string> word(const YAML::Node& node, std::string_view remedy);
    /// The index of a name among those that are known, each of which is a `what`.
    [[nodiscard]] std::optional<std::size_t> index_of(const YAML::Node& node,
                                                      const std::vector<std::string>& known,
                                                      std::string_view what);
    /// A number with or without a unit of angles.
    [[nodiscard]] std::optional<Marks::Number> number(const YAML::Node& node,
                                                      std::string_view remedy);
    [[nodiscard]] std::optional<double> plain_number(const YAML::Node& node,
                                                     std::string_view remedy);
    [[nodiscard]] std::optional<double> positive(const YamlEntry& entry);
    /// Whether a number that was read can be a standard deviation or a tolerance.
    bool is_in_deviation_range(
        const SourceSpan& written, std::string_view what, double value,
        std::string remedy = "write a number in this range, or leave it out");
    [[nodiscard]] std::optional<std::size_t> count(const YamlEntry& entry, std::size_t most);
    [[nodiscard]] std::optional<Imath::V2d> position(const YAML::Node& node);
    [[nodiscard]] std::optional<Imath::V3d> vector(const YAML::Node& node, std::string_view remedy);

private:
    template <std::size_t count>
    std::optional<std::array<double, count>> numbers(const YAML::Node& node,
                                                     std::string_view remedy);

    std::shared_ptr<const SourceText> source_;
    Diagnostics found_;
};

}  // namespace balcony::app
