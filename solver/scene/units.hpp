/// Quantities with units: "200 cal/(s cm2)" is 8.368e6 W/m2.
#pragma once

#include <string_view>

namespace crawford {

/// The number in `quantity`, for example "2 MPa", converted to `unit`, for example "Pa".
///
/// Units are those of udunits2, but for the calorie, which is the thermochemical one (4.184 J) of
/// the combustion literature and not udunits' steam table calorie. "cm2" and "cm^2", "1/K" and
/// "K-1" are the same. One number, then one unit: digits in a unit are exponents or a leading "1/".
/// \throws InputError whose message completes a sentence that begins with the quantity: no number,
///         no unit, a second number, a shifted zero ("K @ 10", "K since 10"), an unknown unit, another dimension than that of `unit`, a value not finite.
double read_quantity(std::string_view quantity, std::string_view unit);

/// Reads the database of units, which is otherwise done at the first quantity: to be called before threads are started, since
/// udunits2 ends by a signal where they take the memory that it wants for it. That there is no database is for those to say who
/// need it.
/// \throws std::bad_alloc
void prepare_units();

}  // namespace crawford
