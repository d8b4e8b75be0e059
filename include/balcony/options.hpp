// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Options as rows: what an option is called, what its value means, and where the value goes. Every
// front end reads, writes and describes options by these rows alone.

#include <algorithm>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <iterator>
#include <limits>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include <Imath/ImathColor.h>
#include <Imath/ImathVec.h>

#include "balcony/base.hpp"
#include "balcony/names.hpp"

namespace balcony::app {

/// What the value of an option is: a front end chooses its widget by it.
enum class OptionType : std::uint8_t {
    flag,     ///< Without a word: it is given or not.
    count,    ///< A whole number.
    number,   ///< A finite number.
    angle,    ///< Degrees.
    color,    ///< A grey level, or red,green,blue.
    choice,   ///< One of several names.
    size,     ///< Pixels, or a part of a picture.
    text,     ///< A word with a syntax of its own, which the meaning describes.
    file,     ///< Any file.
    folder,   ///< A folder.
    scene,    ///< A file of a scene.
    camera,   ///< A file of cameras, with or without a name, or a built-in camera.
    setting,  ///< NAME=VALUE for a parameter of a camera.
};
[[nodiscard]] Names<OptionType> option_types();

/// What an option changes. A picture is continued only with the same options of its film.
enum class Effect : std::uint8_t {
    film,     ///< The light or the layers of a picture.
    display,  ///< What is made of a film: the pixels of a file for displays.
    run,      ///< How a command works and reports.
};

struct OptionChoice {
    std::string name;
    std::string meaning{};
};

/// What an option is, apart from where its value goes.
struct OptionInfo {
    std::string name;      ///< "--samples", or "SCENE" for an argument without hyphens.
    std::string letter{};  ///< "-s"; empty if it has none.
    /// What others call it: "--spp"; "--transparent=transparent" for a value, or "--fov=fov={}" for
    /// one that has the word that follows; "--frame?" is not taken, but answered with this option.
    std::vector<std::string> others{};
    std::string placeholder{};  ///< What stands for the value in help texts: "COUNT".
    std::string meaning{};      ///< One line, without the default.
    std::string fallback{};     ///< The default as a word; empty if there is none to show.
    bool shows_fallback = true;
    bool required = false;
    bool repeated = false;
    std::size_t words = 1;  ///< Of a value.
    Effect effect = Effect::film;
    OptionType type = OptionType::text;
    std::string unit{};  ///< Of numbers: "s", "deg", "px"; empty if they have none.
    double minimum = -std::numeric_limits<double>::infinity();
    double maximum = std::numeric_limits<double>::infinity();
    std::vector<OptionChoice> choices{};
};

/// The error of a value that an option cannot have.
[[nodiscard]] Diagnostic refused(std::string_view option, std::string_view word,
                                 std::string remedy);

/// The words that were given for options, by name, in the order of the rows.
using GivenWords = std::map<std::string, std::vector<std::string>, std::less<>>;

/// An option whose value is in a Target.
template <class Target>
struct Option : OptionInfo {
    /// Reads the words of an option that was given; what is wrong is added to the diagnostics.
    std::function<void(std::span<const std::string>, Target&, Diagnostics&)> read;
    /// The words that read as the value of the target; none where nothing is given.
    std::function<std::vector<std::string>(const Target&)> write;
};

/// Options that belong together.
template <class Target>
struct Options {
    std::vector<Option<Target>> rows{};
    /// What options mean together, called in this order when all rows have been read.
    std::vector<std::function<void(Target&, const GivenWords&, Diagnostics&)>> checks{};

    Options& add(Options more) {
        std::move(more.rows.begin(), more.rows.end(), std::back_inserter(rows));
        std::move(more.checks.begin(), more.checks.end(), std::back_inserter(checks));
        return *this;
    }
    /// Options of a part of the target.
    template <class Part>
    Options& add(Part Target::*part, Options<Part> more) {
        for (Option<Part>& row : more.rows) {
            rows.push_back({OptionInfo(row),
                            [part, read = std::move(row.read)](auto words, Target& target,
                                                               Diagnostics& found) {
                                read(words, target.*part, found);
                            },
                            [part, write = std::move(row.write)](const Target& target) {
                                return write(target.*part);
                            }});
        }
        for (auto& check : more.checks) {
            checks.push_back([part, check = std::move(check)](
                                 Target& target, const GivenWords& given, Diagnostics& found) {
                check(target.*part, given, found);
            });
        }
        return *this;
    }

    Options& leave_out(std::initializer_list<std::string_view> names) {
        std::erase_if(rows, [&](const OptionInfo& row) {
            return std::find(names.begin(), names.end(), row.name) != names.end();
        });
        return *this;
    }

    /// Reads the words that were given. A target that an error is said of is of no use. No value
    /// is an empty word.
    void read(const GivenWords& given, Target& target, Diagnostics& found) const {
        for (const Option<Target>& row : rows) {
            const auto words = given.find(row.name);
            if (words == given.end()) {
                continue;
            }
            if (words->second.empty() || words->second.size() % row.words != 0) {
                found.push_back(error(Kind::internal, row.name + " has too few words"));
            } else if (std::find(words->second.begin(), words->second.end(), "") !=
                       words->second.end()) {
                found.push_back(refused(row.name, "", "give it a value, or leave it out"));
            } else {
                row.read(words->second, target, found);
            }
        }
        for (const auto& check : checks) {
            check(target, given, found);
        }
    }
};

// ------------------------------------------------------------------------------------- values

/// How one word becomes a value, and a value a word.
template <class T>
struct Value {
    OptionInfo info{};  ///< Its type, unit, range and choices.
    std::function<std::optional<T>(std::string_view)> read{};
    std::function<std::string(const T&)> write{};
    /// How to correct a word that cannot be read.
    std::function<std::string(std::string_view)> remedy{};
};

/// The whole word as a finite number: a double, a float or a std::size_t. It may have a sign.
template <class Number>
[[nodiscard]] std::optional<Number> number_of(std::string_view word);
/// X,Y,Z
[[nodiscard]] std::optional<Imath::V3d> point_of(std::string_view word);

[[nodiscard]] Value<std::size_t> count(std::size_t minimum, std::size_t maximum);
/// A double or a float.
template <class Number>
[[nodiscard]] Value<Number> number(Number minimum, Number maximum, std::string remedy,
                                   std::string unit = {});
/// Radians, of which the word has degrees, with or without their unit.
[[nodiscard]] Value<double> degrees(double minimum, double maximum);
/// A grey level, or red,green,blue, each of at least 0 and at most `maximum`.
[[nodiscard]] Value<Imath::Color3f> color(float maximum, std::string remedy);
[[nodiscard]] Value<std::string> text(OptionType type = OptionType::text);
/// A choice among names. The remedy for another word is the nearest name, or all of them, unless
/// it is given.
[[nodiscard]] Value<std::string> choice(std::vector<OptionChoice> choices, std::string remedy = {});

template <class T>
[[nodiscard]] std::vector<OptionChoice> choices_of(const Names<T>& names) {
    std::vector<OptionChoice> made;
    for (const Named<T>& row : names) {
        made.push_back({std::string(row.name), std::string(row.meaning)});
    }
    return made;
}

/// "a (its meaning) or b (its meaning)"
[[nodiscard]] std::string described(const std::vector<OptionChoice>& choices,
                                    std::string_view join = " or ");

/// A value that is made of another one and back.
template <class T, class From, class To, class Back>
[[nodiscard]] Value<T> converted(Value<From> value, To to, Back back) {
    return {std::move(value.info),
            [read = std::move(value.read), to](std::string_view word) -> std::optional<T> {
                const std::optional<From> from = read(word);
                return from ? std::optional<T>(to(*from)) : std::nullopt;
            },
            [write = std::move(value.write), back](const T& made) { return write(back(made)); },
            std::move(value.remedy)};
}

template <class T>
[[nodiscard]] Value<T> choice(const Names<T>& names) {
    return converted<T>(
        choice(choices_of(names)), [names](const std::string& name) { return *names.find(name); },
        [names](T value) { return std::string(names[value].name); });
}

/// A value, or a word that stands for none, such as auto. If that is empty, there is no such word.
template <class T>
[[nodiscard]] Value<std::optional<T>> or_word(std::string none, Value<T> value) {
    if (!none.empty()) {
        value.info.choices.push_back({none});
    }
    return {std::move(value.info),
            [none, read = std::move(value.read)](std::string_view word) {
                using Maybe = std::optional<T>;
                if (word == none && !none.empty()) {
                    return std::optional<Maybe>(std::in_place);
                }
                std::optional<T> made = read(word);
                return made ? std::optional<Maybe>(std::move(made)) : std::nullopt;
            },
            [none, write = std::move(value.write)](const std::optional<T>& made) {
                return made ? write(*made) : none;
            },
            std::move(value.remedy)};
}

/// A value that is optional, with nothing as its default.
template <class T>
[[nodiscard]] Value<std::optional<T>> maybe(Value<T> value) {
    return or_word({}, std::move(value));
}

// ------------------------------------------------------------------------------------- rows

/// What is at the end of a path of members of a target.
template <class Target>
[[nodiscard]] Target& member_of(Target& target) {
    return target;
}
template <class Target, class Member, class... More>
[[nodiscard]] auto& member_of(Target& target, Member member, More... more) {
    return member_of(target.*member, more...);
}

/// An option from how its words are read and written, with its default written.
template <class Target>
[[nodiscard]] Option<Target> custom_option(
    OptionInfo info, std::function<void(std::span<const std::string>, Target&, Diagnostics&)> read,
    std::function<std::vector<std::string>(const Target&)> write) {
    const std::vector<std::string> words = write(Target{});
    info.fallback = info.shows_fallback && !words.empty() ? words.front() : "";
    return {std::move(info), std::move(read), std::move(write)};
}

/// An option with one value, at the end of a path of members: the last word counts.
template <class T, class Target, class First, class... More>
[[nodiscard]] Option<Target> option(OptionInfo info, Value<T> value, First Target::*first,
                                    More... more) {
    info.type = value.info.type;
    info.unit = value.info.unit;
    info.minimum = value.info.minimum;
    info.maximum = value.info.maximum;
    info.choices = value.info.choices;
    return custom_option<Target>(
        info,
        [name = info.name, read = value.read, remedy = value.remedy, first, more...](
            std::span<const std::string> words, Target& target, Diagnostics& found) {
            std::optional<T> made = read(words.back());
            if (made) {
                member_of(target, first, more...) = std::move(*made);
            } else {
                found.push_back(refused(name, words.back(), remedy(words.back())));
            }
        },
        [write = value.write, first, more...](const Target& target) {
            std::string word = write(member_of(target, first, more...));
            return word.empty() ? std::vector<std::string>{} : std::vector{std::move(word)};
        });
}

/// An option that sets a truth.
template <class Target, class First, class... More>
[[nodiscard]] Option<Target> flag(OptionInfo info, bool set_to, First Target::*first,
                                  More... more) {
    info.type = OptionType::flag;
    info.shows_fallback = false;
    return custom_option<Target>(
        std::move(info),
        [set_to, first, more...](std::span<const std::string>, Target& target, Diagnostics&) {
            member_of(target, first, more...) = set_to;
        },
        [set_to, first, more...](const Target& target) {
            return member_of(target, first, more...) == set_to ? std::vector<std::string>{"true"}
                                                               : std::vector<std::string>{};
        });
}

/// A repeated option whose words are kept as they are.
template <class Target, class First, class... More>
[[nodiscard]] Option<Target> words(OptionInfo info, First Target::*first, More... more) {
    info.repeated = true;
    return custom_option<Target>(
        std::move(info),
        [first, more...](std::span<const std::string> given, Target& target, Diagnostics&) {
            member_of(target, first, more...).assign(given.begin(), given.end());
        },
        [first, more...](const Target& target) {
            const auto& all = member_of(target, first, more...);
            return std::vector<std::string>(all.begin(), all.end());
        });
}

}  // namespace balcony::app
