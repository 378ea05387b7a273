#include "solver/scene/units.hpp"

#include <fmt/format.h>
#include <udunits2.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <memory>
#include <mutex>
#include <string>
#include <utility>

#include "base/errors.hpp"
#include "base/room.hpp"

namespace crawford {

namespace {

using System = std::unique_ptr<ut_system, decltype(&ut_free_system)>;
using Unit = std::unique_ptr<ut_unit, decltype(&ut_free)>;
using Converter = std::unique_ptr<cv_converter, decltype(&cv_free)>;

Unit own(ut_unit* unit) {
    return {unit, &ut_free};
}

System read_system() {
    // What is wrong is said by our exceptions and not, a second time, on stderr.
    ut_set_error_message_handler(&ut_ignore);
    System system(ut_read_xml(nullptr), &ut_free_system);
    if (!system) {
        throw InputError(
            "cannot be read: udunits2 does not find its database of units; install the package "
            "libudunits2-data or point UDUNITS2_XML_PATH at udunits2.xml");
    }
    const Unit joule = own(ut_get_unit_by_name(system.get(), "joule"));
    const Unit calorie = own(ut_scale(4.184, joule.get()));
    for (const char* name : {"calorie", "calories"}) {
        ut_unmap_name_to_unit(system.get(), name, UT_ASCII);
        ut_map_name_to_unit(name, UT_ASCII, calorie.get());
    }
    ut_unmap_symbol_to_unit(system.get(), "cal", UT_ASCII);
    ut_map_symbol_to_unit("cal", UT_ASCII, calorie.get());
    return system;
}

/// Read once, at first use, and never changed after.
const ut_system* unit_system() {
    static const System system = read_system();
    return system.get();
}

std::string_view trimmed(std::string_view text) {
    constexpr std::string_view blanks = " \t\r\n";
    const auto first = text.find_first_not_of(blanks);
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

Unit parse_unit(std::string_view text) {
    // Where udunits2's scanner finds no memory it ends the program, with a code and a line of its own.
    look_for_room(for_a_library);
    const std::string one_over = text.starts_with('/') ? "1" : "";
    return own(ut_parse(unit_system(), (one_over + std::string(text)).c_str(), UT_ASCII));
}

/// Stricter than ut_are_convertible, to which a unit and its reciprocal are alike.
bool same_dimension(const Unit& a, const Unit& b) {
    const Unit ratio = own(ut_divide(a.get(), b.get()));
    return ratio && ut_is_dimensionless(ratio.get()) != 0;
}

/// Splits "200 cal/(s cm2)" into 200 and "cal/(s cm2)".
std::pair<double, std::string_view> split(std::string_view quantity, std::string_view unit) {
    std::string_view text = trimmed(quantity);
    if (text.starts_with('+')) text.remove_prefix(1);
    double number = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error == std::errc::result_out_of_range) {
        throw InputError("is a number too large or too small for a double");
    }
    if (error != std::errc()) {
        throw InputError(
            fmt::format("does not begin with a number; write a number and a unit, in {}", unit));
    }
    return {number, trimmed(text.substr(static_cast<std::size_t>(end - text.data())))};
}

bool is_letter(char c) {
    return std::isalpha(static_cast<unsigned char>(c)) != 0;
}

bool is_digit(char c) {
    return std::isdigit(static_cast<unsigned char>(c)) != 0;
}

/// Whether the digit at `k` belongs to an exponent: cm2, s-1, m^2, m^-2, m**2.
bool is_exponent(std::string_view unit, std::size_t k) {
    while (k > 0 && is_digit(unit[k - 1])) --k;
    const bool sign = k > 1 && unit[k - 1] == '-';
    if (sign) --k;
    if (k == 0) return false;
    const char base = unit[k - 1];
    return is_letter(base) || base == ')' || base == '^' ||
           (base == '*' && k > 1 && unit[k - 2] == '*');
}

/// udunits2 reads more than units: "200 kPa" is a unit of its own, "K @ 10" and "K since 10" have
/// another zero. A quantity that holds such a thing is a slip, never meant.
void refuse_what_is_no_unit(std::string_view text) {
    const std::string_view unit = text.starts_with("1/") ? text.substr(1) : text;
    for (std::size_t k = 0; k < unit.size(); ++k)
        if (unit[k] == '@' || (is_digit(unit[k]) && !is_exponent(unit, k)))
            throw InputError(fmt::format(
                "is more than one number and one unit: the unit would be \"{}\"", text));
    for (std::size_t begin = 0, end = 0; begin < unit.size(); begin = end + 1) {
        for (end = begin; end < unit.size() && is_letter(unit[end]);) ++end;
        std::string word(unit.substr(begin, end - begin));
        std::ranges::transform(word, word.begin(), [](unsigned char c) { return std::tolower(c); });
        for (const char* shift : {"since", "from", "after", "ref", "re"})
            if (word == shift)
                throw InputError(fmt::format(
                    "moves the zero of its unit with \"{}\"; give one number and one unit", word));
    }
}

}  // namespace

double read_quantity(std::string_view quantity, std::string_view unit) {
    const auto [number, given_text] = split(quantity, unit);
    if (given_text.empty()) {
        throw InputError(
            fmt::format("has no unit; expected {} or a unit that converts to it", unit));
    }
    refuse_what_is_no_unit(given_text);
    // udunits2 scans and converts with state of its own, which two threads must not share.
    static std::mutex library;
    const std::scoped_lock lock(library);
    const Unit given = parse_unit(given_text);
    if (!given) {
        throw InputError(fmt::format(
            "has the unit \"{}\", which is unknown; expected {} or a unit that converts to it",
            given_text, unit));
    }
    const Unit wanted = parse_unit(unit);
    const Converter converter(ut_get_converter(given.get(), wanted.get()), &cv_free);
    if (!converter || !same_dimension(given, wanted)) {
        throw InputError(fmt::format(
            "has the wrong dimension; expected {} or a unit that converts to it", unit));
    }
    const double value = cv_convert_double(converter.get(), number);
    if (!std::isfinite(value)) throw InputError("is not finite");
    return value;
}

void prepare_units() {
    try {
        unit_system();
    } catch (const InputError&) {
        // Many commands need no units.
    }
}

}  // namespace crawford
