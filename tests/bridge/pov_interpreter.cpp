// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "pov_interpreter.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>

#include <fmt/format.h>

namespace balcony::bridge::test {

namespace {

constexpr std::size_t max_parameters = 56;    // MAX_FUNCTION_PARAMETER_LIST
constexpr std::size_t max_call_depth = 1024;  // MAX_CALL_STACK_SIZE

struct Token {
    enum class Kind { name, number, symbol, end };
    Kind kind = Kind::end;
    std::string text{};
    std::size_t line = 1;
};

bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '_'; }
bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

std::vector<Token> tokens_of(std::string_view text) {
    std::vector<Token> made;
    std::size_t line = 1;
    std::size_t i = 0;
    const auto at = [&](std::size_t k) { return k < text.size() ? text[k] : '\0'; };
    while (i < text.size()) {
        const std::size_t begin = i;
        if (text[i] == '\n') {
            ++line;
            ++i;
        } else if (std::isspace(static_cast<unsigned char>(text[i])) != 0) {
            ++i;
        } else if (text.substr(i).starts_with("//")) {
            i = std::min(text.find('\n', i), text.size());
        } else if (is_letter(text[i]) || (text[i] == '#' && is_letter(at(i + 1)))) {
            for (++i; is_letter(at(i)) || is_digit(at(i)); ++i) {
            }
            made.push_back({Token::Kind::name, std::string(text.substr(begin, i - begin)), line});
        } else if (is_digit(text[i])) {
            for (; is_digit(at(i)) || at(i) == '.'; ++i) {
            }
            if (at(i) == 'e') {
                for (i += 2; is_digit(at(i)); ++i) {
                }
            }
            made.push_back({Token::Kind::number, std::string(text.substr(begin, i - begin)), line});
        } else {
            const std::string_view two = text.substr(i, 2);
            i += two == "<=" || two == ">=" || two == "!=" ? 2 : 1;
            made.push_back({Token::Kind::symbol, std::string(text.substr(begin, i - begin)), line});
        }
    }
    made.push_back({Token::Kind::end, "the end", line});
    return made;
}

struct BuiltIn {
    std::size_t arity;
    double (*value)(const double* a);
};

const std::map<std::string, BuiltIn>& built_in() {
    static const std::map<std::string, BuiltIn> all{
        {"sin", {1, [](const double* a) { return std::sin(a[0]); }}},
        {"cos", {1, [](const double* a) { return std::cos(a[0]); }}},
        {"tan", {1, [](const double* a) { return std::tan(a[0]); }}},
        {"asin", {1, [](const double* a) { return std::asin(a[0]); }}},
        {"acos", {1, [](const double* a) { return std::acos(a[0]); }}},
        {"atan", {1, [](const double* a) { return std::atan(a[0]); }}},
        {"atan2", {2, [](const double* a) { return std::atan2(a[0], a[1]); }}},
        {"sinh", {1, [](const double* a) { return std::sinh(a[0]); }}},
        {"cosh", {1, [](const double* a) { return std::cosh(a[0]); }}},
        {"tanh", {1, [](const double* a) { return std::tanh(a[0]); }}},
        {"asinh", {1, [](const double* a) { return std::asinh(a[0]); }}},
        {"acosh", {1, [](const double* a) { return std::acosh(a[0]); }}},
        {"atanh", {1, [](const double* a) { return std::atanh(a[0]); }}},
        {"abs", {1, [](const double* a) { return std::fabs(a[0]); }}},
        {"floor", {1, [](const double* a) { return std::floor(a[0]); }}},
        {"sqrt", {1, [](const double* a) { return std::sqrt(a[0]); }}},
        {"exp", {1, [](const double* a) { return std::exp(a[0]); }}},
        {"ln", {1, [](const double* a) { return std::log(a[0]); }}},
        {"min", {2, [](const double* a) { return !(a[1] >= a[0]) ? a[1] : a[0]; }}},
        {"max", {2, [](const double* a) { return a[1] > a[0] ? a[1] : a[0]; }}},
        {"pow", {2, [](const double* a) { return std::pow(a[0], a[1]); }}},
    };
    return all;
}

double interpolated(const PovSpline& spline, std::size_t member, double at) {
    const auto after = spline.upper_bound(at);
    if (after == spline.begin() || after == spline.end()) {
        return (after == spline.begin() ? after : std::prev(after))->second[member];
    }
    const auto& [first, from] = *std::prev(after);
    const auto& [last, to] = *after;
    return (at - first) * (to[member] - from[member]) / (last - first) + from[member];
}

}  // namespace

/// Reads a text into a scene.
class PovReader {
public:
    PovReader(PovScene& scene, std::string_view text, double clock)
        : scene_(scene), tokens_(tokens_of(text)), clock_(clock) {}

    void read() {
        while (peek().kind != Token::Kind::end) {
            statement();
        }
    }

private:
    using Kind = PovExpression::Kind;

    [[noreturn]] void refuse(const std::string& message) const {
        throw PovError(fmt::format("line {}: {}, at '{}'", peek().line, message, peek().text));
    }
    [[nodiscard]] const Token& peek() const { return tokens_[next_]; }
    Token take() { return tokens_[next_ + 1 < tokens_.size() ? next_++ : next_]; }
    bool accept(std::string_view text) {
        if (peek().kind == Token::Kind::end || peek().text != text) {
            return false;
        }
        take();
        return true;
    }
    void expect(std::string_view text) {
        if (!accept(text)) {
            refuse(fmt::format("expected '{}'", text));
        }
    }
    std::string name() {
        if (peek().kind != Token::Kind::name) {
            refuse("expected a name");
        }
        return take().text;
    }

    [[nodiscard]] bool declared(const std::string& name) const {
        return scene_.numbers_.contains(name) || scene_.functions_.contains(name) ||
               scene_.splines_.contains(name) || scene_.cameras_.contains(name);
    }

    void statement() {
        if (accept("#ifndef")) {
            expect("(");
            const bool known = declared(name());
            expect(")");
            while (known && peek().text != "#end") {
                take();
            }
        } else if (!accept("#end")) {
            declaration();
        }
    }

    void declaration() {
        expect("#declare");
        const std::string declared_name = name();
        // POV-Ray has many words of its own, all without capital letters.
        if (std::isupper(static_cast<unsigned char>(declared_name.front())) == 0) {
            refuse("a name that POV-Ray may have for itself");
        }
        if (declared(declared_name)) {
            refuse("declared twice");
        }
        expect("=");
        if (accept("function")) {
            if (peek().text == "{") {
                scene_.splines_[declared_name] = spline();
                return;
            }
            auto function = std::make_shared<PovFunction>();
            function->name = declared_name;
            function->parameters = parameters();
            function->body = body(function->parameters);
            scene_.functions_[declared_name] = std::move(function);
        } else if (accept("camera")) {
            scene_.cameras_[declared_name] = camera();
        } else {
            in_function_ = false;
            const PovExpression value = sum({});
            in_function_ = true;
            scene_.numbers_[declared_name] = scene_.evaluate(value, {}, 0);
            expect(";");
        }
    }

    std::shared_ptr<const PovSpline> spline() {
        auto made = std::make_shared<PovSpline>();
        for (const char* word : {"{", "spline", "{", "linear_spline"}) {
            expect(word);
        }
        do {
            const PovExpression key = sum({});
            expect(",");
            expect("<");
            std::array<double, 4>& vector = (*made)[scene_.evaluate(key, {}, 0)];
            for (std::size_t i = 0; i < vector.size(); ++i) {
                vector[i] = scene_.evaluate(sum({}), {}, 0);
                expect(i + 1 < vector.size() ? "," : ">");
            }
        } while (accept(","));
        expect("}");
        expect("}");
        if (made->size() < 2) {
            refuse("a spline of one point");
        }
        return made;
    }

    std::vector<std::string> parameters() {
        static const std::vector<std::string> keywords{"x", "y", "z", "u", "v"};
        std::vector<std::string> made;
        expect("(");
        do {
            const bool usable =
                std::find(keywords.begin(), keywords.end(), peek().text) != keywords.end() ||
                (!declared(peek().text) && !built_in().contains(peek().text) &&
                 peek().text != "t" && peek().text != "clock" && peek().text != "pi");
            if (!usable) {
                refuse("expected the name of a parameter");
            }
            made.push_back(name());
        } while (accept(","));
        expect(")");
        const auto has = [&made](const char* one) {
            return std::find(made.begin(), made.end(), one) != made.end();
        };
        // They share a register of POV-Ray's processor.
        if ((has("x") && has("u")) || (has("y") && has("v"))) {
            refuse("x and u, or y and v, are parameters of one function");
        }
        if (made.size() > max_parameters) {
            refuse("too many parameters");
        }
        return made;
    }

    PovExpression body(const std::vector<std::string>& parameters) {
        expect("{");
        PovExpression made = disjunction(parameters);
        expect("}");
        return made;
    }

    PovScene::Camera camera() {
        static const std::vector<std::string> point{"x", "y", "z"};
        PovScene::Camera made;
        expect("{");
        expect("user_defined");
        for (auto* part : {&made.location, &made.direction}) {
            expect(part == &made.location ? "location" : "direction");
            expect("{");
            for (PovExpression& function : *part) {
                expect("function");
                function = body(point);
            }
            expect("}");
        }
        expect("}");
        return made;
    }

    using Parameters = std::vector<std::string>;
    using Level = PovExpression (PovReader::*)(const Parameters&);

    // Operands of one level, from left to right.
    PovExpression chain(const Parameters& parameters, Level operand,
                        const std::vector<std::string_view>& symbols) {
        PovExpression made = (this->*operand)(parameters);
        for (;;) {
            const auto found = std::find(symbols.begin(), symbols.end(), peek().text);
            if (found == symbols.end() || peek().kind != Token::Kind::symbol) {
                return made;
            }
            take();
            PovExpression right = (this->*operand)(parameters);
            if (*found == "/" && right.kind == Kind::number && right.number == 0.0) {
                refuse("division by zero");
            }
            made = {Kind::operation, 0.0, 0, std::string(*found), {}, {made, std::move(right)}};
        }
    }
    PovExpression disjunction(const Parameters& p) {
        return chain(p, &PovReader::conjunction, {"|"});
    }
    PovExpression conjunction(const Parameters& p) {
        return chain(p, &PovReader::comparison, {"&"});
    }
    PovExpression comparison(const Parameters& p) {
        return chain(p, &PovReader::sum, {"=", "!=", "<", "<=", ">", ">="});
    }
    PovExpression sum(const Parameters& p) { return chain(p, &PovReader::product, {"+", "-"}); }
    PovExpression product(const Parameters& p) { return chain(p, &PovReader::prefix, {"*", "/"}); }
    PovExpression prefix(const Parameters& p) {
        if (accept("-")) {
            return {Kind::operation, 0.0, 0, "negate", {}, {atom(p)}};
        }
        return atom(p);
    }

    PovExpression atom(const Parameters& parameters) {
        if (accept("(")) {
            PovExpression made = disjunction(parameters);
            expect(")");
            return made;
        }
        if (peek().kind == Token::Kind::number) {
            return {Kind::number, std::stod(take().text)};
        }
        const std::string word = name();
        const auto parameter = std::find(parameters.begin(), parameters.end(), word);
        if (parameter != parameters.end()) {
            return {Kind::parameter, 0.0, static_cast<std::size_t>(parameter - parameters.begin())};
        }
        if (scene_.numbers_.contains(word)) {
            return {Kind::number, scene_.numbers_.at(word)};
        }
        if (word == "clock") {
            return {Kind::number, clock_};
        }
        if (!in_function_ && (word == "image_width" || word == "image_height")) {
            return {Kind::number, word == "image_width" ? scene_.columns_ : scene_.rows_};
        }
        return call(word, parameters);
    }

    PovExpression call(const std::string& word, const Parameters& parameters) {
        PovExpression made{Kind::operation, 0.0, 0, word};
        const auto declared = scene_.functions_.find(word);
        if (declared != scene_.functions_.end()) {
            made.kind = Kind::call;
            made.function = declared->second;
        }
        expect("(");
        do {
            made.operands.push_back(disjunction(parameters));
        } while (accept(","));
        expect(")");
        const std::size_t count = made.operands.size();
        const auto spline = scene_.splines_.find(word);
        if (spline != scene_.splines_.end()) {
            static constexpr std::string_view members = "xyzt";
            expect(".");
            made.member = members.find(name());
            if (count != 1 || made.member == std::string_view::npos) {
                refuse("a spline has one argument and a vector of four numbers");
            }
            made.kind = Kind::spline;
            made.spline = spline->second;
            return made;
        }
        const auto known = built_in().find(word);
        const bool right = made.function               ? count == made.function->parameters.size()
                           : word == "select"          ? count == 3 || count == 4
                           : known != built_in().end() ? count == known->second.arity
                                                       : false;
        if (!right) {
            refuse(fmt::format("no function {} of {} arguments", word, count));
        }
        return made;
    }

    PovScene& scene_;
    const std::vector<Token> tokens_;
    const double clock_;
    std::size_t next_ = 0;
    bool in_function_ = true;
};

PovScene::PovScene(std::string_view text, double columns, double rows, double clock,
                   std::map<std::string, double> declared)
    : columns_(columns), rows_(rows), numbers_(std::move(declared)) {
    PovReader(*this, text, clock).read();
}

std::size_t PovScene::max_parameters() const {
    std::size_t most = 0;
    for (const auto& [name, function] : functions_) {
        most = std::max(most, function->parameters.size());
    }
    return most;
}

double PovScene::evaluate(const PovExpression& expression, const std::vector<double>& parameters,
                          std::size_t depth) const {
    switch (expression.kind) {
        case PovExpression::Kind::number: return expression.number;
        case PovExpression::Kind::parameter: return parameters[expression.parameter];
        case PovExpression::Kind::operation: return operation(expression, parameters, depth);
        case PovExpression::Kind::spline: {
            ++cost_.operations;
            return interpolated(*expression.spline, expression.member,
                                evaluate(expression.operands[0], parameters, depth));
        }
        case PovExpression::Kind::call: break;
    }
    if (depth >= max_call_depth) {
        throw PovError("too many calls inside each other");
    }
    ++cost_.calls;
    cost_.deepest = std::max(cost_.deepest, depth + 1);
    std::vector<double> arguments;
    for (const PovExpression& operand : expression.operands) {
        arguments.push_back(evaluate(operand, parameters, depth));
    }
    return evaluate(expression.function->body, arguments, depth + 1);
}

// Conditions are 1 or 0. Comparisons with NaN are as POV-Ray's processor makes them: from "less"
// and "equal" alone, so that > and >= hold.
double PovScene::operation(const PovExpression& expression, const std::vector<double>& parameters,
                           std::size_t depth) const {
    ++cost_.operations;
    const auto value = [&](std::size_t i) {
        return evaluate(expression.operands[i], parameters, depth);
    };
    const std::string& name = expression.name;
    const double a = value(0);
    if (name == "negate") {
        return -a;
    }
    if (name == "select") {
        const bool four = expression.operands.size() == 4;
        return a < 0.0 ? value(1) : !four || a == 0.0 ? value(2) : value(3);
    }
    const auto known = built_in().find(name);
    if (known != built_in().end()) {
        const std::array<double, 2> arguments{a, known->second.arity == 2 ? value(1) : 0.0};
        return known->second.value(arguments.data());
    }
    const double b = value(1);
    const auto truth = [](bool condition) { return condition ? 1.0 : 0.0; };
    return name == "+"    ? a + b
           : name == "-"  ? a - b
           : name == "*"  ? a * b
           : name == "/"  ? a / b
           : name == "="  ? truth(a == b)
           : name == "!=" ? truth(a != b)
           : name == "<"  ? truth(a < b)
           : name == "<=" ? truth(a <= b)
           : name == ">"  ? truth(!(a <= b))
           : name == ">=" ? truth(!(a < b))
           : name == "&"  ? truth(a != 0.0 && b != 0.0)
                          : truth(a != 0.0 || b != 0.0);
}

PovScene::Ray PovScene::ray(const std::string& camera, double x, double y) const {
    constexpr double null = 1e-10;  // EPSILON
    const Camera& made = cameras_.at(camera);
    const std::vector<double> point{x / columns_ - 0.5, 0.5 - y / rows_, 0.0};
    Ray ray;
    ray.valid = true;
    bool direction = false;
    for (std::size_t i = 0; i < 3; ++i) {
        ray.location[i] = evaluate(made.location[i], point, 0);
        ray.direction[i] = evaluate(made.direction[i], point, 0);
        ray.valid = ray.valid && std::isfinite(ray.location[i]) && std::isfinite(ray.direction[i]);
        direction = direction || std::fabs(ray.direction[i]) >= null;
    }
    ray.valid = ray.valid && direction;
    return ray;
}

}  // namespace balcony::bridge::test
