// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Tables of numbers as spreadsheets and scripts write them: CSV and its variants.

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "data/files.hpp"
#include "data/table_rows.hpp"

namespace balcony::data {

namespace {

constexpr std::size_t max_errors = 10;
constexpr std::string_view blanks = " \t\r";

bool begins_number(std::string_view field) {
    return !field.empty() && (std::string_view("+-.").find(field.front()) != field.npos ||
                              (field.front() >= '0' && field.front() <= '9'));
}

class TableReader {
public:
    TableReader(std::shared_ptr<const SourceText> source, bool may_have_header)
        : text_(source->text()), first_line_(may_have_header) {
        table_.source = std::move(source);
    }

    Result<NumberTable> run() {
        for (std::size_t begin = 0; begin < text_.size() && !stopped();) {
            const std::size_t end = std::min(text_.find_first_of("\n\r", begin), text_.size());
            line(begin, begin + std::min(text_.substr(begin, end - begin).find('#'), end - begin));
            begin = end + 1;
        }
        return diagnostics_.empty() ? Result<NumberTable>(std::move(table_))
                                    : Result<NumberTable>(std::move(diagnostics_));
    }

private:
    struct Field {
        std::size_t begin, end;
    };

    void error(SourceSpan span, std::string message, std::string remedy = {}) {
        diagnostics_.push_back(
            balcony::error(std::move(message), std::move(span), std::move(remedy)));
    }
    [[nodiscard]] SourceSpan at(Field field) const {
        return {table_.source, field.begin, field.end};
    }
    [[nodiscard]] std::string_view text(Field field) const {
        return text_.substr(field.begin, field.end - field.begin);
    }
    [[nodiscard]] bool stopped() const {
        return diagnostics_.size() >= max_errors || numbers_ > max_numbers;
    }

    [[nodiscard]] Field unquoted(Field field) const {
        const std::string_view all = text(field);
        const bool quoted = all.size() >= 2 && all.front() == '"' && all.back() == '"';
        return quoted ? trimmed({field.begin + 1, field.end - 1}) : field;
    }

    [[nodiscard]] Field trimmed(Field field) const {
        const std::string_view all = text(field);
        const std::size_t first = all.find_first_not_of(blanks);
        if (first == all.npos) {
            return {field.begin, field.begin};
        }
        return {field.begin + first, field.begin + all.find_last_not_of(blanks) + 1};
    }

    void line(std::size_t begin, std::size_t end) {
        const Field all = trimmed({begin, end});
        // A row of empty cells, as spreadsheets write it, is treated like a blank line.
        if (text(all).find_first_not_of(",; \t\"") == std::string_view::npos) {
            return;
        }
        const std::vector<Field> fields = split(all);
        const bool header = first_line_ && std::none_of(fields.begin(), fields.end(), [&](Field f) {
                                return begins_number(text(f));
                            });
        first_line_ = false;
        if (!header) {
            row(fields);
        }
    }

    // A line must use a single separator: with two kinds, one of them is probably a decimal comma.
    std::vector<Field> split(Field all) {
        const std::string_view line = text(all);
        char separator = ' ';
        for (const char candidate : {',', ';', '\t'}) {
            const std::size_t place = line.find(candidate);
            if (place == line.npos) {
                continue;
            }
            if (separator != ' ') {
                const std::size_t begin = all.begin + place;
                error(at({begin, begin + 1}), "this line has two kinds of separators",
                      "write numbers with a decimal point, 0.5, and separate them by commas");
                return {};
            }
            separator = candidate;
        }
        std::vector<Field> fields;
        for (std::size_t begin = all.begin; begin <= all.end;) {
            const std::string_view rest = text({begin, all.end});
            const std::size_t end = begin + std::min(rest.find(separator), rest.size());
            const Field field = unquoted(trimmed({begin, end}));
            if (separator != ' ' || field.begin < field.end) {
                fields.push_back(field);
            }
            begin = end + 1;
        }
        return fields;
    }

    void row(const std::vector<Field>& fields) {
        std::vector<NumberTable::Number> numbers;
        for (const Field field : fields) {
            if (const auto read = number(field)) {
                numbers.push_back(*read);
            }
        }
        numbers_ += numbers.size();
        if (numbers_ > max_numbers) {
            error(at({fields.front().begin, fields.back().end}),
                  fmt::format("this table has more than {} numbers", max_numbers),
                  "keep only some of the lines, or split the table into several files");
        } else if (!numbers.empty()) {
            table_.rows.push_back(std::move(numbers));
        }
    }

    std::optional<NumberTable::Number> number(Field field) {
        std::string_view written = text(field);
        NumberTable::Number made{0.0, false, static_cast<std::uint32_t>(field.begin),
                                 static_cast<std::uint32_t>(field.end)};
        if (written.empty()) {
            error(at({field.begin, std::min(field.begin + 1, text_.size())}),
                  "there is no number between these separators",
                  "write one, or remove a separator");
            return std::nullopt;
        }
        double factor = 1.0;
        if (written.ends_with("deg") || written.ends_with("rad")) {
            made.angle = true;
            factor = written.ends_with("deg") ? std::numbers::pi / 180.0 : 1.0;
            written.remove_suffix(3);
        }
        if (written.starts_with("+")) {
            written.remove_prefix(1);
        }
        const char* end = written.data() + written.size();
        const auto [stop, status] = std::from_chars(written.data(), end, made.value);
        made.value *= factor;
        if (status != std::errc() || stop != end || !std::isfinite(made.value)) {
            error(at(field), "this is not a number",
                  "a table contains numbers such as -0.5, 2e-3 or 30deg; '#' starts a comment");
            return std::nullopt;
        }
        return made;
    }

    std::string_view text_;
    NumberTable table_;
    Diagnostics diagnostics_;
    std::size_t numbers_ = 0;
    bool first_line_;
};

}  // namespace

Result<NumberTable> read_rows(std::shared_ptr<const SourceText> source, bool may_have_header) {
    return TableReader(std::move(source), may_have_header).run();
}

Diagnostic no_numbers(const std::string& name) {
    return error(fmt::format("'{}' has no numbers", name), {},
                 "write one point per line, with its numbers separated by commas");
}

Result<NumberTable> read_table(const File& file) {
    const auto source = read_text(file, max_table, "export the table as CSV, plain text in UTF-8");
    if (!source) {
        return source.diagnostics;
    }
    Result<NumberTable> table = read_rows(*source, true);
    return table && table->rows.empty() ? Result<NumberTable>(no_numbers(file.name))
                                        : std::move(table);
}

}  // namespace balcony::data
