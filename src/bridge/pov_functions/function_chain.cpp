// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "bridge/pov_functions/function_chain.hpp"

#include <algorithm>

namespace balcony::bridge {

namespace {

std::set<std::string> names_in(std::span<const ListedLine> results) {
    std::set<std::string> names;
    for (const ListedLine& result : results) {
        names.insert(result.uses.begin(), result.uses.end());
    }
    return names;
}

}  // namespace

std::size_t FunctionChain::max_parameters() const {
    std::size_t most = result_parameters.size();
    for (const ChainStep& step : steps) {
        most = std::max(most, step.parameters.size());
    }
    return most;
}

LineDependence::LineDependence(const Listing& listing) {
    for (std::size_t section = 0; section < listing.sections.size(); ++section) {
        for (const ListedLine& line : listing.sections[section].lines) {
            place(line, section);
        }
    }
}

void LineDependence::place(const ListedLine& line, std::size_t section) {
    Placed placed{&line, section};
    for (const std::string& name : line.uses) {
        const auto found = index_.find(name);
        if (found == index_.end()) {
            placed.uniform = placed.uniform && name != point_x && name != point_y;
            continue;
        }
        const Placed& used = lines_[found->second];
        placed.uniform = placed.uniform && used.uniform;
        if (!used.uniform && used.section == section) {
            placed.depth = std::max(placed.depth, used.depth + 1);
        }
    }
    index_[line.name] = lines_.size();
    lines_.push_back(placed);
}

std::vector<const ListedLine*> LineDependence::uniform() const {
    std::vector<const ListedLine*> made;
    for (const Placed& placed : lines_) {
        if (placed.uniform) {
            made.push_back(placed.line);
        }
    }
    return made;
}

std::vector<std::string> LineDependence::varying(const std::set<std::string>& names) const {
    std::vector<std::string> made;
    std::set<std::size_t> places;
    for (const std::string& name : names) {
        const auto found = index_.find(name);
        if (found == index_.end()) {
            if (name == point_x || name == point_y) {
                made.push_back(name);
            }
        } else if (!lines_[found->second].uniform) {
            places.insert(found->second);
        }
    }
    for (const std::size_t place : places) {
        made.push_back(lines_[place].line->name);
    }
    return made;
}

FunctionChain LineDependence::chain(std::span<const ListedLine> results) const {
    FunctionChain made;
    std::set<std::string> names = names_in(results);
    made.result_parameters = varying(names);

    std::map<std::pair<std::size_t, std::size_t>, std::vector<const ListedLine*>> steps;
    for (auto placed = lines_.rbegin(); placed != lines_.rend(); ++placed) {
        if (!placed->uniform && names.contains(placed->line->name)) {
            names.insert(placed->line->uses.begin(), placed->line->uses.end());
            steps[{placed->section, placed->depth}].push_back(placed->line);
        }
    }

    names = names_in(results);
    for (auto step = steps.rbegin(); step != steps.rend(); ++step) {
        auto& lines = step->second;
        std::reverse(lines.begin(), lines.end());
        for (const ListedLine* line : lines) {
            names.erase(line->name);
        }
        for (const ListedLine* line : lines) {
            names.insert(line->uses.begin(), line->uses.end());
        }
        made.steps.push_back({varying(names), std::move(lines)});
    }
    std::reverse(made.steps.begin(), made.steps.end());
    return made;
}

}  // namespace balcony::bridge
