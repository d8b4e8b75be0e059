// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// keys((0, 1), (2, 5), ease = smooth): values between keyframes.

#include "lang/names/key_calls.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "balcony/keyframes.hpp"
#include "lang/names/evaluate.hpp"

namespace balcony::lang {

namespace {

constexpr std::string_view example = "for example keys((0, 1), (2, 5), ease = smooth)";

struct Number {
    Value value;
    SourceSpan place;
};

/// A time and the numbers at that time.
struct Key {
    SourceSpan place;
    std::vector<Number> numbers;

    [[nodiscard]] const Number& time() const { return numbers.front(); }
};

class KeyCall {
public:
    KeyCall(const SyntaxTree& tree, const Expression& call, Scope& scope, const Context& context)
        : tree_(tree),
          call_(call),
          scope_(scope),
          context_(context),
          at_{{context.graph.time()}, tree.at(call.name.span)} {}

    Value run() {
        for (const Argument& argument : call_.arguments) {
            if (argument.name) {
                named(*argument.name, argument.value);
            } else {
                positional(argument.value);
            }
        }
        if (good_ && read_.empty()) {
            error(call_.span, "'keys' has no keys", std::string(example));
        }
        if (good_ && is_consistent() && has_times() && has_units()) {
            return value();
        }
        return {};
    }

private:
    void error(const SourceSpan& span, std::string message, std::string remedy) {
        good_ = false;
        context_.reporter.error(span, std::move(message), std::move(remedy));
    }
    void error(Span span, std::string message, std::string remedy) {
        error(tree_.at(span), std::move(message), std::move(remedy));
    }

    // ------------------------------------------------------------------------- named arguments

    void named(const Identifier& name, ExpressionId value) {
        const auto [earlier, is_new] = named_.emplace(name.text, name.span);
        if (!is_new) {
            report_given_twice(name, tree_.at(name.span), tree_.at(earlier->second),
                               context_.reporter);
            good_ = false;
        } else if (name.text == "at") {
            const Value at = evaluate(tree_, value, scope_, context_);
            good_ = good_ && !at.failed();
            at_ = {at, tree_.at(tree_[value].span)};
        } else if (name.text == "ease") {
            keys_.ease = word(name, value, camera::eases()).value_or(keys_.ease);
        } else if (name.text == "beyond") {
            keys_.beyond = word(name, value, camera::beyond_keys()).value_or(keys_.beyond);
        } else {
            error(name.span, fmt::format("'keys' has no argument named '{}'", name.text),
                  suggestion(name.text, {"ease", "at", "beyond"}, "its named arguments are"));
        }
    }

    template <class Found>
    std::optional<Found> word(const Identifier& name, ExpressionId id, const Names<Found>& known) {
        const Expression& node = tree_[id];
        const std::optional<Found> found =
            node.kind == ExpressionKind::name ? known.find(node.name.text) : std::nullopt;
        if (!found) {
            error(node.span, fmt::format("'{}' cannot be '{}'", name.text, tree_.text(node.span)),
                  suggestion(node.name.text, known.all(), "the choices are"));
        }
        return found;
    }

    // ------------------------------------------------------------------------------------- keys

    void positional(ExpressionId id) {
        const Expression& node = tree_[id];
        const SourceSpan place = tree_.at(node.span);
        if (node.kind == ExpressionKind::text) {
            table(node.name);
        } else if (node.kind == ExpressionKind::tuple) {
            Key key{place, {}};
            for (const Argument& element : node.arguments) {
                add(evaluate_any(tree_, element.value, scope_, context_),
                    tree_.at(tree_[element.value].span), key);
            }
            read_.push_back(std::move(key));
        } else {
            const Value value = evaluate_any(tree_, id, scope_, context_);
            good_ = good_ && !value.failed();
            if (value.form == Value::Form::list) {
                for (const Element& element : *value.elements) {
                    add_key(element.value, element.place);
                }
            } else if (!value.failed()) {
                add_key(value, place);
            }
        }
    }

    void add_key(const Value& value, const SourceSpan& place) {
        if (value.form != Value::Form::tuple) {
            error(place, fmt::format("expected a key, but found {}", form_of(value)),
                  "write a time and a value in parentheses: (2, 5)");
            return;
        }
        Key key{place, {}};
        add(value, place, key);
        read_.push_back(std::move(key));
    }

    // A number, or the numbers of a tuple.
    void add(const Value& value, const SourceSpan& place, Key& key) {
        if (value.failed()) {
            good_ = false;
        } else if (value.form == Value::Form::list) {
            error(place, "a key has numbers or tuples, but this is a list",
                  "write a key in parentheses: (2, 5), or (2, x, y, z)");
        } else if (value.form == Value::Form::tuple) {
            for (const Element& element : *value.elements) {
                add(element.value, element.place, key);
            }
        } else {
            key.numbers.push_back({value, place});
        }
    }

    void table(const Identifier& file) {
        const data::NumberTable* table = context_.tables.table(tree_, file);
        good_ = good_ && table != nullptr;
        if (table == nullptr) {
            return;
        }
        for (const auto& row : table->rows) {
            Key key{join(table->at(row.front()), table->at(row.back())), {}};
            for (const data::NumberTable::Number& number : row) {
                key.numbers.push_back({{context_.graph.constant(number.value),
                                        number.angle ? Unit::angle : Unit::number},
                                       table->at(number)});
            }
            read_.push_back(std::move(key));
        }
    }

    // ------------------------------------------------------------------------------------ checks

    bool is_consistent() {
        const std::size_t count = read_.front().numbers.size();
        for (const Key& key : read_) {
            if (key.numbers.size() < 2) {
                error(key.place, "this key has a time, but no value", std::string(example));
                return false;
            }
            if (key.numbers.size() != count) {
                Diagnostic diagnostic = balcony::error(
                    fmt::format("this key has {} number{} after its time, but the first has {}",
                                key.numbers.size() - 1, key.numbers.size() == 2 ? "" : "s",
                                count - 1),
                    key.place, "give all keys values of one form");
                diagnostic.notes.push_back({read_.front().place, "the first key is here"});
                context_.reporter.add(std::move(diagnostic));
                return false;
            }
        }
        return true;
    }

    bool has_times() {
        for (const Key& key : read_) {
            const auto& [time, place] = key.time();
            if (!time.is_constant()) {
                error(place, "the time of a key must be constant, but this changes",
                      "move what changes into 'at': keys(..., at = t/duration)");
                return false;
            }
            if (!keys_.times.empty() && !(keys_.times.back() < time.constant())) {
                error(place,
                      fmt::format("the times of keys must increase, but {:.6g} follows {:.6g}",
                                  time.constant(), keys_.times.back()),
                      "sort the keys by their times; let a value jump with ease = hold");
                return false;
            }
            keys_.times.push_back(time.constant());
        }
        return true;
    }

    // Returns whether numbers have one unit, which `common` gets.
    bool agree(const std::vector<const Number*>& numbers, std::string_view what, Unit& common) {
        const Number* known = nullptr;
        for (const Number* number : numbers) {
            const Value& value = number->value;
            if (!value.is_angle() && !value.is_plain_number()) {
                continue;
            }
            if (known != nullptr && known->value.unit != value.unit) {
                Diagnostic diagnostic = balcony::error(
                    fmt::format("{} are angles and plain numbers", what), number->place,
                    "write all as angles (30deg, 0.5rad) or all as plain numbers");
                diagnostic.notes.push_back({known->place, known->value.is_angle()
                                                              ? "this is an angle"
                                                              : "this is a plain number"});
                context_.reporter.add(std::move(diagnostic));
                return false;
            }
            known = number;
        }
        common = known != nullptr ? known->value.unit : numbers.front()->value.unit;
        return true;
    }

    bool has_units() {
        Unit unused{};
        std::vector<const Number*> times{&at_};
        for (const Key& key : read_) {
            times.push_back(&key.time());
        }
        bool good = agree(times, "the times of the keys and 'at'", unused);
        units_.resize(read_.front().numbers.size() - 1);
        for (std::size_t k = 0; k < units_.size(); ++k) {
            std::vector<const Number*> numbers;
            for (const Key& key : read_) {
                numbers.push_back(&key.numbers[k + 1]);
            }
            good = good && agree(numbers, "the values of the keys", units_[k]);
        }
        return good;
    }

    // ------------------------------------------------------------------------------------- value

    Value value() {
        for (std::size_t k = 0; k < units_.size(); ++k) {
            std::vector<expr::Expr> numbers;
            for (const Key& key : read_) {
                numbers.push_back(key.numbers[k + 1].value.expr);
            }
            keys_.values.push_back(std::move(numbers));
        }
        const std::vector<expr::Expr> made = camera::between_keys(keys_, at_.value.expr);
        if (made.size() == 1) {
            return {made.front(), units_.front()};
        }
        auto elements = std::make_shared<std::vector<Element>>();
        for (std::size_t k = 0; k < made.size(); ++k) {
            elements->push_back({{made[k], units_[k]}, tree_.at(call_.span)});
        }
        Value tuple;
        tuple.form = Value::Form::tuple;
        tuple.elements = std::move(elements);
        return tuple;
    }

    const SyntaxTree& tree_;
    const Expression& call_;
    Scope& scope_;
    const Context& context_;
    bool good_ = true;
    std::map<std::string_view, Span> named_;
    Number at_;  ///< The time, or what stands in its place.
    camera::Keyframes keys_;
    std::vector<Key> read_;
    std::vector<Unit> units_;
};

}  // namespace

Value evaluate_keys(const SyntaxTree& tree, const Expression& call, Scope& scope,
                    const Context& context) {
    return KeyCall(tree, call, scope, context).run();
}

}  // namespace balcony::lang
