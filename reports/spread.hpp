/// What a sample says of the whole: its mean, how far the members lie apart, and how well the mean
/// is known.
#pragma once

#include <optional>
#include <vector>

namespace crawford::reports {

struct Spread {
    long count = 0;
    double mean;                ///< NaN of none
    double standard_deviation;  ///< of the whole, estimated (over count - 1); NaN below two
    double half_width;          ///< of the confidence interval of the mean; NaN below two
};

/// \param confidence that the interval holds the mean of the whole, 0 to 1: Student's t, which is
/// exact where the members are normally distributed
/// \throws InputError if the confidence lies outside.
Spread spread(const std::vector<double>& values, double confidence);

/// The least number of members with which the half-width would be at most `interval` of the mean,
/// the standard deviation being what it is in this sample; nothing where none is known, or the mean
/// is 0, or it would be more than a billion.
std::optional<long> members_needed(const Spread& spread, double interval, double confidence);

}  // namespace crawford::reports
